#include "grader/sandbox.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "support/files.h"

namespace rays::grader {
namespace {

namespace fs = std::filesystem;

void put(const fs::path& folder, const InputFile& file) {
    const fs::path target = (folder / file.name).lexically_normal();
    if (target.lexically_relative(folder).string().starts_with(".."))
        throw std::runtime_error(file.name + " leads outside");
    fs::create_directories(target.parent_path());
    std::ofstream out(target, std::ios::binary);
    out.write(file.bytes.data(), static_cast<std::streamsize>(file.bytes.size()));
    if (!out.flush()) throw std::runtime_error("cannot write " + target.string());
}

std::string why_not_to_take(const struct stat& info, std::size_t limit) {
    if (!S_ISREG(info.st_mode)) return "is not a regular file";
    if (info.st_nlink != 1) return "is a link to another file";
    if (info.st_size == 0) return "is empty";
    if (limit > 0 && static_cast<std::size_t>(info.st_size) > limit)
        return fmt::format("has {} bytes, more than the {} allowed", info.st_size, limit);
    return {};
}

OutputFile take_from(int fd, std::size_t limit) {
    OutputFile file;
    struct stat info {};
    file.problem = ::fstat(fd, &info) == 0 ? why_not_to_take(info, limit) : std::strerror(errno);
    if (!file.problem.empty()) return file;
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

OutputFile take(const fs::path& file, std::size_t limit) {
    // No links followed, and a pipe in the file's place must not make us wait.
    const int fd = ::open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (fd < 0) {
        OutputFile missing;
        missing.problem = errno == ENOENT  ? "was not written"
                          : errno == ELOOP ? "is a symbolic link"
                                           : std::strerror(errno);
        return missing;
    }
    OutputFile result = take_from(fd, limit);
    ::close(fd);
    return result;
}

class LimitsSandbox : public Sandbox {
public:
    std::string tier() const override { return "limits"; }

    JobResult run(const Job& job) const override {
        JobResult result;
        try {
            run_in(TemporaryFolder(), job, result);
        } catch (const std::exception& e) {
            result.ended.started = false;
            result.ended.problem = e.what();
        }
        return result;
    }

private:
    static void run_in(const TemporaryFolder& folder, const Job& job, JobResult& result) {
        for (const InputFile& file : job.files) put(folder.path(), file);
        Command command{{job.program.string()}, job.input, folder.path(), job.limits, false};
        command.argv.insert(command.argv.end(), job.arguments.begin(), job.arguments.end());
        result.ended = run_command(command);
        const auto limit = static_cast<std::size_t>(job.limits.output_mb) * 1024 * 1024;
        for (const std::string& name : job.outputs) result.files[name] = take(folder.path() / name, limit);
    }
};

}  // namespace

std::unique_ptr<Sandbox> make_sandbox() { return std::make_unique<LimitsSandbox>(); }

}  // namespace rays::grader
