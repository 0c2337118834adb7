// The student's program beside the solution's, for the charts of speed in the report. No points depend on it.
//
// Both programs do the same in the same sandbox, in turns, and their processor times are told as a ratio, round by
// round: what the charts show was measured in another run, often on another day, and absolute times of two runs say
// little about each other.
#pragma once

#include <string>
#include <vector>

#include "grader/checks.h"

namespace rays::grader {

constexpr int kSpeedRounds = 5;

/// All that the step asks for, one after the other: nothing else may run meanwhile. Nothing when the student's program
/// is the solution's. What goes wrong in a student's program leaves out its own point.
std::vector<SpeedPoint> time_student(const Bench& bench);

/// `count` equal spheres in a unit cube, as SDL: those of the charts 4.growth, that cover a view of the cube once.
std::string cube_of_spheres(int count);

}  // namespace rays::grader
