// The bicubic Bezier patch: a system of two equations in (u, v), with no root missed.
#include <algorithm>
#include <array>
#include <cmath>

#include "1_ray_casting/ray_casting.h"
#include "core/unfinished.h"

namespace rays {

using glm::dot;

void prepare(BicubicPatch& patch) {
    // Task 1.11: The bounding sphere of the control points, once you have written task 1.13.
    unfinished("1.11");
}

std::optional<Root> intersect(const BicubicPatch& patch, const Ray& ray, Interval range) {
    // Task 1.11: P(u, v) = o + t d, 0 <= u, v <= 1. Two planes through the ray give two equations in u and v for
    // Newton's method; subdivide until it cannot miss: there may be up to 18 roots, two meet at silhouettes.
    unfinished("1.11");
    return {};
}

Vec3 normal(const BicubicPatch& patch, const Vec3&, const Root& root) {
    // Task 1.11: dP/du x dP/dv; where an edge is collapsed to a point, that of a point close by.
    unfinished("1.11");
    return {};
}

}  // namespace rays
