#include "renderer/picture_file.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "core/error.h"
#include "core/exr_file.h"

namespace rays {
namespace {

/// rays-formats at work on one picture, at the other end of a socket.
class Formats {
public:
    Formats(const std::string& path, const Raster& raster) {
        // Beside the program itself, wherever it was started from.
        const std::string program = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "rays-formats";
        int ends[2];
        if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
            throw InputError(std::string("no socket: ") + std::strerror(errno));
        socket_ = ends[0];
        posix_spawn_file_actions_t actions;
        ::posix_spawn_file_actions_init(&actions);
        ::posix_spawn_file_actions_adddup2(&actions, ends[1], STDIN_FILENO);
        ::posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
        std::string words[] = {program, path, std::to_string(raster.width), std::to_string(raster.height)};
        char* argv[] = {words[0].data(), words[1].data(), words[2].data(), words[3].data(), nullptr};
        const int problem = ::posix_spawn(&child_, program.c_str(), &actions, nullptr, argv, environ);
        ::posix_spawn_file_actions_destroy(&actions);
        ::close(ends[1]);
        if (problem != 0) {
            ::close(socket_);
            throw InputError("only .exr can be written: " + program + ": " + std::strerror(problem) +
                             "; ./rays render builds it");
        }
    }
    ~Formats() { ::close(socket_); }
    Formats(const Formats&) = delete;
    Formats& operator=(const Formats&) = delete;

    /// What went wrong; empty when nothing did.
    std::string write(const char* pixels, std::size_t size) {
        while (size > 0) {
            const auto sent = ::send(socket_, pixels, size, MSG_NOSIGNAL);
            if (sent < 0 && errno == EINTR) continue;
            if (sent <= 0) break;  // it says why, or how it ended does
            pixels += sent;
            size -= static_cast<std::size_t>(sent);
        }
        ::shutdown(socket_, SHUT_WR);
        std::string problem;
        char text[512];
        for (ssize_t got = 0; (got = ::read(socket_, text, sizeof text)) > 0 || (got < 0 && errno == EINTR);)
            if (got > 0) problem.append(text, static_cast<std::size_t>(got));
        int status = 0;
        while (::waitpid(child_, &status, 0) < 0 && errno == EINTR) {
        }
        return problem.empty() && status != 0 ? "rays-formats failed" : problem;
    }

private:
    int socket_ = -1;
    pid_t child_ = -1;
};

/// Kept in memory to the end.
class OtherFile final : public PictureFile {
public:
    OtherFile(std::string path, const Raster& raster) : path_(std::move(path)), whole_(raster) {}

    void take(const Film& lines, int first) noexcept override { whole_.take(lines, first); }
    void finish() override {
        const auto [width, height] = whole_.film.raster();
        const auto* pixels = reinterpret_cast<const char*>(whole_.film.at(0, 0).lane);
        const std::size_t size = sizeof(Radiance) * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
        const std::string problem = Formats(path_, whole_.film.raster()).write(pixels, size);
        if (!problem.empty()) throw InputError(path_ + ": cannot write the picture (" + problem + ")");
    }

private:
    std::string path_;
    WholeFilm whole_;
};

}  // namespace

std::unique_ptr<PictureFile> make_picture_file(const std::string& path, const Raster& raster) {
    if (std::filesystem::path(path).extension() == ".exr") return std::make_unique<ExrFile>(path, raster);
    return std::make_unique<OtherFile>(path, raster);
}

}  // namespace rays
