// What every pixel costs with each structure: pictures for the report. No points depend on them.
#pragma once

#include <string>
#include <vector>

#include "grader/checks.h"

namespace rays::grader {

/// Maps of the scenes that the step names, with the solution's program and, where it is another one, the student's.
/// Writes them to images/ of Bench::out. Nothing without such a folder. What goes wrong in a student's program leaves
/// out its own map.
std::vector<CostScene> map_costs(const Bench& bench, int workers);

/// The boxes of an answer to `--explain X,Y --visited`, rounded to seven digits; at most `most` of them, and how many
/// there were beyond. The answer is hostile: what is no list of boxes of finite numbers counts as no box.
struct VisitedBoxes {
    std::vector<std::array<double, 6>> boxes;
    std::size_t left_out = 0;
};
VisitedBoxes visited_boxes(const std::string& answer, std::size_t most);

}  // namespace rays::grader
