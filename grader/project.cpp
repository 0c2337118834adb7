#include "grader/project.h"

#include <fmt/format.h>

#include <fstream>

#include "core/error.h"

namespace rays::grader {
namespace {

namespace fs = std::filesystem;

std::map<std::string, std::string> read_cache(const fs::path& file) {
    std::map<std::string, std::string> cache;
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
        const auto colon = line.find(':');
        const auto equals = line.find('=', colon == std::string::npos ? 0 : colon);
        if (line.empty() || line[0] == '#' || line[0] == '/' || colon == std::string::npos ||
            equals == std::string::npos)
            continue;
        cache[line.substr(0, colon)] = line.substr(equals + 1);
    }
    return cache;
}

}  // namespace

std::string Project::setting(const std::string& name) const {
    const auto found = cache.find(name);
    return found == cache.end() ? std::string() : found->second;
}

Project find_project() {
    Project project;
    fs::path folder = fs::read_symlink("/proc/self/exe").parent_path();
    // Tests of the grader stand in the same build, but not in its bin/.
    while (folder.has_relative_path() && !fs::exists(folder / "CMakeCache.txt")) folder = folder.parent_path();
    project.build = folder;
    project.cache = read_cache(folder / "CMakeCache.txt");
    project.root = project.setting("CMAKE_HOME_DIRECTORY");
    project.version = project.setting("CMAKE_PROJECT_VERSION");
    if (project.root.empty() || !fs::exists(project.steps()))
        throw InputError(fmt::format("{} is no build of Raysteps: run ./rays, or the rays-grader of a build folder",
                                     folder.string()));
    return project;
}

}  // namespace rays::grader
