// The torus, standing for every implicit surface F(p) = 0: find all roots of one function of t, miss none.
#include <algorithm>
#include <array>
#include <cmath>

#include "1_ray_casting/ray_casting.h"
#include "core/unfinished.h"

namespace rays {

using glm::dot;

std::optional<Root> intersect(const Torus& torus, const Ray& ray, Interval range) {
    // Task 1.10: The roots of F(p) = (|p|^2 + R^2 - r^2)^2 - 4 R^2 (x^2 + z^2). Bracket them: the roots of F'' part the
    // range into pieces where F' is monotone, the roots of F' into pieces where F is. Two roots close together
    // must both be found, and no root must be found twice.
    unfinished("1.10");
    return {};
}

Vec3 normal(const Torus& torus, const Vec3& point, const Root&) {
    // Task 1.10: From the nearest point of the circle in the middle of the tube.
    unfinished("1.10");
    return {};
}

}  // namespace rays
