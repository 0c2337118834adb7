// The first difference of two ray trees, in words.
#pragma once

#include <string>

namespace rays::grader {

/// Two answers of `--explain X,Y --json`. "depth 1: the shadow ray's direction differs by 3.1 degrees"; empty when they
/// do not differ by more than float rounding. The student's is hostile: anything that is not a tree is said to be none.
std::string first_difference(const std::string& student_json, const std::string& solution_json);

}  // namespace rays::grader
