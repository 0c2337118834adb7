// The submissions under tests/grader/submissions, made whole: step files from the solutions, pictures from their
// program.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "grader/project.h"

namespace rays::grader {

/// The source of a solution with one task's region put back as the starter has it (ARCHITECTURE.md, "Marked regions").
/// Throws std::runtime_error when there is no such region.
std::string without_task(const std::string& source, const std::string& task);

/// The step files of the example that differ from the solutions', by "1_ray_casting/camera.cpp".
std::map<std::string, std::string> changed_files(const Project& project, const std::filesystem::path& example);

/// Writes the whole working copy of an example: `folder`/N_name/*.cpp and `folder`/submission/ with what its author
/// wrote.
void write_example(const Project& project, const std::string& name, const std::filesystem::path& folder);

/// The render program of the step files in `folder`: those that differ from the solutions' are compiled.
std::filesystem::path example_program(const Project& project, const std::string& name,
                                      const std::filesystem::path& folder);

}  // namespace rays::grader
