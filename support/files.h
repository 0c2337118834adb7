// Files that are read whole and appear whole.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace rays {

/// All bytes of a file. Throws InputError naming the file.
std::string read_file(const std::filesystem::path& file);

/// Calls `write` with a name beside `file`, then renames: whoever looks sees the old file, the new one, or none, never
/// a half. Folders on the way are made. When `write` throws, nothing is left behind.
void write_atomically(const std::filesystem::path& file,
                      const std::function<void(const std::filesystem::path&)>& write);
void write_atomically(const std::filesystem::path& file, std::string_view bytes);

/// A new empty folder for temporary files, removed with all that is in it.
class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

}  // namespace rays
