// Which questions belong to which step.
#pragma once

#include <cstdint>
#include <vector>

#include "grader/questions.h"

namespace rays::grader {

/// Empty for a step without questions.
std::vector<Question> questions_of(int step, std::uint64_t seed);
std::vector<Sweep> sweeps_of(int step, std::uint64_t seed);

}  // namespace rays::grader
