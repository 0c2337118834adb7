#include "scene_reader/source.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <system_error>

#include "core/error.h"
#include "scene_reader/limits.h"

namespace rays::sdl {

namespace fs = std::filesystem;

std::string to_string(const Place& place) {
    if (!place.source) return "scene";
    const char* at = std::min(place.at, place.source->end());
    const char* line_start = place.source->begin();
    long line = 1;
    for (const char* p = line_start; p < at; ++p) {
        const bool ends_line = *p == '\n' || (*p == '\r' && p[1] != '\n');  // old Macs end lines by \r alone
        if (ends_line) {
            ++line;
            line_start = p + 1;
        }
    }
    return fmt::format("{}:{}:{}", place.source->name, line, at - line_start + 1);
}

namespace {

/// Inside a folder: `path` (canonical) has all of the folder's components in front.
bool lies_inside(const fs::path& folder, const fs::path& path) {
    return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

void require_harmless(const std::string& name) {
    const fs::path path(name);
    const bool climbs = std::find(path.begin(), path.end(), fs::path("..")) != path.end();
    if (name.empty() || path.is_absolute() || climbs || name.find('\0') != std::string::npos) {
        throw InputError(
            fmt::format("'{}' leads outside of the scene's folder; name a file inside it or one of POV-Ray's include "
                        "files",
                        name));
    }
}

}  // namespace

Sources::Sources(fs::path scene_folder, const std::vector<fs::path>& include_folders) {
    std::error_code error;
    if (scene_folder.empty()) scene_folder = ".";
    folders_.push_back(fs::canonical(scene_folder, error));
    if (error) folders_.clear();
    for (const fs::path& folder : include_folders) {
        const fs::path real = fs::canonical(folder, error);
        if (!error) folders_.push_back(real);
    }
}

const Source& Sources::add_text(std::string name, std::string_view text) {
    sources_.push_back({std::move(name), std::string(text), false});
    return sources_.back();
}

const Source& Sources::add_file(const fs::path& file) {
    sources_.push_back({file.string(), read_bytes(file, kMostBytesOfText), false});
    return sources_.back();
}

fs::path Sources::find_file(const std::string& name) const {
    require_harmless(name);
    for (const fs::path& folder : folders_) {
        std::error_code error;
        const fs::path real = fs::canonical(folder / name, error);
        if (error || !fs::is_regular_file(real, error)) continue;
        if (!lies_inside(folder, real)) {
            throw InputError(
                fmt::format("'{}' is a link that leads outside of its folder; copy the file instead", name));
        }
        return real;
    }
    return {};
}

bool Sources::is_library(const fs::path& found) const {
    return !folders_.empty() && !lies_inside(folders_.front(), found);
}

const Source* Sources::find_include(const std::string& name) {
    const fs::path path = find_file(name);
    if (path.empty()) return nullptr;
    const Source*& known = included_[path];
    if (!known) {
        sources_.push_back({name, read_bytes(path, kMostBytesOfText), is_library(path)});
        known = &sources_.back();
    }
    return known;
}

std::string read_bytes(const fs::path& file, std::uintmax_t limit) {
    std::error_code error;
    const bool regular = fs::is_regular_file(file, error);
    std::ifstream in(file, std::ios::binary);
    if (!regular || !in) {
        throw InputError(fmt::format("{}:1:1: cannot be read; give the path of a scene file", file.string()));
    }
    const std::uintmax_t size = fs::file_size(file, error);
    if (error || size > limit) {
        throw InputError(
            fmt::format("{}:1:1: has more than {} bytes; split the scene or use mesh2", file.string(), limit));
    }
    std::string bytes(size, '\0');
    in.read(bytes.data(), static_cast<std::streamsize>(size));
    bytes.resize(static_cast<std::size_t>(in.gcount()));
    return bytes;
}

}  // namespace rays::sdl
