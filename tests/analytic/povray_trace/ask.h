// The same rays asked of POV-Ray's trace() and of the solution's render program.
#pragma once

#include <optional>
#include <vector>

#include "ray_set.h"
#include "references/povray.h"

namespace rays::povray_trace {

struct Met {
    glm::dvec3 point, normal;
};
/// One a ray; nothing where the ray misses.
using Meetings = std::vector<std::optional<Met>>;

/// Throws PovrayError.
Meetings ask_povray(const Povray& povray, const Primitive& primitive, const std::vector<TestRay>& rays);

/// Throws std::runtime_error when the program fails or answers anything but hits and misses.
Meetings ask_solution(const std::filesystem::path& program, const Primitive& primitive,
                      const std::vector<TestRay>& rays);

}  // namespace rays::povray_trace
