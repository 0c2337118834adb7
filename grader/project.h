// Where things are: the project's sources and one build of it.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace rays::grader {

struct Project {
    std::filesystem::path root;                ///< the sources
    std::filesystem::path build;               ///< the build this program belongs to
    std::map<std::string, std::string> cache;  ///< of CMake: name -> value
    std::string version;

    std::filesystem::path program(const std::string& name) const { return build / "bin" / name; }
    std::filesystem::path steps() const { return root / "steps"; }
    std::filesystem::path scenes() const { return root / "scenes"; }
    std::filesystem::path references() const { return root / "scenes" / "references"; }
    std::filesystem::path mutants() const { return root / "grader" / "mutants"; }
    std::string setting(const std::string& name) const;  ///< of the CMake cache; empty when there is none
    bool sanitized() const { return !setting("RAYSTEPS_SANITIZE").empty(); }
};

/// The build is the folder above this program's own; its CMake cache knows the sources. Throws InputError when this
/// program does not stand in a build of the project.
Project find_project();

}  // namespace rays::grader
