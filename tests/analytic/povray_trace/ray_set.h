// Rays that try a primitive where it is easy and where it is hard.
#pragma once

#include <array>
#include <vector>

#include "primitives.h"

namespace rays::povray_trace {

/// POV-Ray drops what lies nearer than this (MIN_ISECT_DEPTH in its source), and so do we when we compare.
inline constexpr double kNearest = 1e-4;
inline constexpr double kFarthest = 1e7;  ///< MAX_DISTANCE in its source

enum class Kind { random, inside, axis, tangent, edge, far };
inline constexpr std::array kKindNames{"random", "inside", "axis", "tangent", "edge", "far"};

struct TestRay {
    glm::dvec3 origin, direction;  ///< the direction has unit length but for rounding
    Kind kind = Kind::random;
    double nearest = kNearest;  ///< where the ray begins to count
};

/// `count` rays, the same for the same seed: random ones, from inside, parallel to an axis, almost tangent (off the
/// surface by 1e-1 to 1e-12 of its size), towards edges and corners (exactly and almost), and from up to 300 sizes
/// away.
std::vector<TestRay> make_rays(const Primitive& primitive, std::size_t count, std::uint64_t seed);

}  // namespace rays::povray_trace
