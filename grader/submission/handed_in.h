// The assignment as it is handed in: pictures, what they demonstrate, and the written report.
#pragma once

#include "grader/results.h"
#include "grader/step_data.h"
#include "grader/submission/demonstrate.h"

namespace rays::grader {

/// All checks of a hand-in. The rubric says what has to be shown and what it is worth: each feature of the row
/// "pictures" is a check "pictures.<feature>", with an equal share of the row's points, and passed when one picture
/// that counts shows it.
HandedIn grade_handed_in(const HandInBench& bench, const Rubric& rubric);

/// The name of the row that a check of a hand-in counts for: "pictures" of "pictures.spheres"; else empty.
std::string row_of(const Check& check);

}  // namespace rays::grader
