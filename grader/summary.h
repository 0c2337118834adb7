// What a terminal shows of a result.
#pragma once

#include <filesystem>
#include <string>

#include "grader/results.h"

namespace rays::grader {

/// Verdicts by step and task, what was found for each check that is not passed, its pictures, the rubric, the score.
/// Every text in it is plain: no control characters, whatever a student's program printed.
std::string summary(const Results& results, const std::filesystem::path& out);

}  // namespace rays::grader
