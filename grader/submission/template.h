// What a hand-in starts from.
#pragma once

#include <string>
#include <vector>

#include "grader/submission/format.h"

namespace rays::grader {

/// submission.json with three pictures of the course's scenes that together show what the assignment asks for.
std::string submission_template();

/// report.md with a section and a command for every picture; what only the student can write is marked as such.
std::string report_template(const std::vector<SubmittedPicture>& pictures);

}  // namespace rays::grader
