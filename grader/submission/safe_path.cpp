#include "grader/submission/safe_path.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace rays::grader {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestName = 200;

class Descriptor {
public:
    explicit Descriptor(int fd) : fd_(fd) {}
    ~Descriptor() {
        if (fd_ >= 0) ::close(fd_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    void reset(int fd) {
        if (fd_ >= 0) ::close(fd_);
        fd_ = fd;
    }
    int get() const { return fd_; }

private:
    int fd_;
};

std::string open_problem(int error) {
    if (error == ENOENT) return "was not found";
    if (error == ELOOP || error == ENOTDIR) return "is a link, or lies behind one";
    return std::strerror(error);
}

OutputFile problem(const std::string& text) {
    OutputFile file;
    file.problem = text;
    return file;
}

OutputFile read_all(int fd, std::size_t limit) {
    struct stat info {};
    if (::fstat(fd, &info) != 0) return problem(std::strerror(errno));
    if (!S_ISREG(info.st_mode)) return problem("is not a regular file");
    if (info.st_size == 0) return problem("is empty");
    if (static_cast<std::size_t>(info.st_size) > limit)
        return problem(fmt::format("has {} bytes, more than the {} allowed", info.st_size, limit));
    OutputFile file;
    file.bytes.resize(static_cast<std::size_t>(info.st_size));
    std::size_t got = 0;
    while (got < file.bytes.size()) {
        const auto n = ::read(fd, file.bytes.data() + got, file.bytes.size() - got);
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) break;
        got += static_cast<std::size_t>(n);
    }
    file.bytes.resize(got);
    file.taken = true;
    return file;
}

}  // namespace

std::string path_problem(const std::string& relative) {
    if (relative.empty()) return "is empty";
    if (relative.size() > kLongestName) return fmt::format("is longer than {} characters", kLongestName);
    const auto odd = [](unsigned char c) { return c < 0x20 || c == 0x7f || c == '\\'; };
    if (std::any_of(relative.begin(), relative.end(), odd)) return "has a control character or a backslash in it";
    const fs::path path(relative);
    if (path.is_absolute()) return "is absolute: name it from the submission's own folder";
    if (relative.back() == '/' || relative.find("//") != std::string::npos) return "names a folder";
    for (const fs::path& part : path)
        if (part.empty() || part.string().starts_with('.'))
            return "leads outside, or is hidden: no part of it may begin with a dot";
    return {};
}

OutputFile read_inside(const fs::path& folder, const std::string& relative, std::size_t limit) {
    if (const std::string why = path_problem(relative); !why.empty()) return problem(why);
    Descriptor at(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    const fs::path path(relative);
    for (const fs::path& part : path.parent_path()) {
        if (at.get() < 0) break;
        at.reset(::openat(at.get(), part.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
    }
    if (at.get() < 0) return problem(open_problem(errno));
    const Descriptor file(::openat(at.get(), path.filename().c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    return file.get() < 0 ? problem(open_problem(errno)) : read_all(file.get(), limit);
}

}  // namespace rays::grader
