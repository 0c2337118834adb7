// Scene text in memory, places in it for messages, and the search for include files.
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace rays::sdl {

/// One file (or text) of a scene. The text ends with a NUL that does not belong to it, so a scanner may always look at
/// the byte under its cursor.
struct Source {
    std::string name;  ///< as shown in messages
    std::string text;
    bool is_library = false;  ///< one of POV-Ray's include files

    const char* begin() const { return text.data(); }
    const char* end() const { return text.data() + text.size(); }
};

/// A byte of a source. Line and column are counted only when a message needs them.
struct Place {
    const Source* source = nullptr;
    const char* at = nullptr;
};

/// "file:line:column", both from 1.
std::string to_string(const Place& place);

/// All files that a scene consists of. References stay valid while it lives.
class Sources {
public:
    /// `scene_folder`: where the scene stands; `include_folders`: searched after it. Nothing outside of them is read.
    Sources(std::filesystem::path scene_folder, const std::vector<std::filesystem::path>& include_folders);

    const Source& add_text(std::string name, std::string_view text);
    /// The scene itself. Throws InputError when it cannot be read.
    const Source& add_file(const std::filesystem::path& file);
    /// A file that the scene names. Null when there is none; throws InputError, with a reason and without a place, for
    /// a path that is absolute, leads outside or is too large.
    const Source* find_include(const std::string& name);
    /// The same search for data (density files). Empty when there is none.
    std::filesystem::path find_file(const std::string& name) const;
    bool is_library(const std::filesystem::path& found) const;

private:
    std::vector<std::filesystem::path> folders_;  ///< canonical
    std::deque<Source> sources_;
    std::map<std::filesystem::path, const Source*> included_;
};

/// The bytes of a file. Throws InputError for what cannot be read or is larger than `limit` bytes.
std::string read_bytes(const std::filesystem::path& file, std::uintmax_t limit);

}  // namespace rays::sdl
