#include "support/files.h"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>

#include "core/error.h"

namespace rays {
namespace fs = std::filesystem;

std::string read_file(const fs::path& file) {
    // A folder opens, too; only reading it fails, and then without a word from the stream.
    if (fs::is_directory(file)) throw InputError(fmt::format("{}: is a folder, not a file", file.string()));
    std::ifstream in(file, std::ios::binary);
    std::string bytes;
    if (in) bytes.assign(std::istreambuf_iterator<char>(in), {});
    if (!in.good() && !in.eof()) {
        throw InputError(fmt::format("{}: cannot be read: {}", file.string(), std::strerror(errno)));
    }
    return bytes;
}

void write_atomically(const fs::path& file, const std::function<void(const fs::path&)>& write) {
    // The name is unlike any other's, of this process and of others that write the same file.
    static std::atomic<unsigned> count{0};
    fs::path partial = file;
    partial += fmt::format(".{}-{}.partial", getpid(), count++);
    if (file.has_parent_path()) fs::create_directories(file.parent_path());
    try {
        write(partial);
        fs::rename(partial, file);
    } catch (...) {
        std::error_code ignored;
        fs::remove(partial, ignored);
        throw;
    }
}

void write_atomically(const fs::path& file, std::string_view bytes) {
    write_atomically(file, [&](const fs::path& partial) {
        std::ofstream out(partial, std::ios::binary);
        out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        out.close();
        if (!out) throw InputError(fmt::format("{}: cannot be written: {}", file.string(), std::strerror(errno)));
    });
}

TemporaryFolder::TemporaryFolder() {
    std::string pattern = (fs::temp_directory_path() / "raysteps-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) {
        throw InputError(fmt::format("{}: cannot make a temporary folder: {}", pattern, std::strerror(errno)));
    }
    path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

}  // namespace rays
