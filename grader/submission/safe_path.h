// Names of files that somebody else wrote down, and reading what they name without leaving a folder.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "grader/sandbox.h"

namespace rays::grader {

/// Why this is not the plain name of a file below some folder; empty when it is. Refused are absolute names, "..",
/// names and folders that begin with a dot, backslashes, control characters, and more than 200 characters.
std::string path_problem(const std::string& relative);

/// The bytes of a regular file below `folder`, at most `limit` of them. No link is followed, neither in the file's
/// place nor in a folder's on the way; nothing that could make one wait is opened.
OutputFile read_inside(const std::filesystem::path& folder, const std::string& relative, std::size_t limit);

}  // namespace rays::grader
