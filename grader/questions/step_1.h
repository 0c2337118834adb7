// The questions of step 1, by task.
#pragma once

#include "questions/construct.h"

namespace rays::grader::step_1 {

using namespace construct;

std::vector<Question> perspective_cameras(std::uint64_t seed);   // 1.1
std::vector<Question> orthographic_cameras(std::uint64_t seed);  // 1.2
std::vector<Question> spheres(std::uint64_t seed);               // 1.3
std::vector<Question> planes(std::uint64_t seed);                // 1.4
std::vector<Question> triangles(std::uint64_t seed);             // 1.5
std::vector<Question> polygons(std::uint64_t seed);              // 1.6
std::vector<Question> boxes_and_discs(std::uint64_t seed);       // 1.7
std::vector<Question> cones(std::uint64_t seed);                 // 1.8
std::vector<Question> quadrics(std::uint64_t seed);              // 1.9
std::vector<Question> tori(std::uint64_t seed);                  // 1.10
std::vector<Question> patches(std::uint64_t seed);               // 1.11
std::vector<Question> transforms(std::uint64_t seed);            // 1.12
std::vector<Question> bounds(std::uint64_t seed);                // 1.13
std::vector<Question> meshes(std::uint64_t seed);                // 1.14
std::vector<Question> nearest_hits(std::uint64_t seed);          // 1.15

}  // namespace rays::grader::step_1
