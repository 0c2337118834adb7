// Questions asked in this very process: a debugger can stop at the mistake.
#pragma once

#include <vector>

#include "questions.h"

namespace rays::tests {

/// One answer for each question; missing where the answers ended early.
std::vector<grader::Answer> asked(const std::vector<grader::Question>& questions);

}  // namespace rays::tests
