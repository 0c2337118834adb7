// Sphere, cone, cylinder and the general quadric: surfaces whose equation along a ray has degree two.
#include <algorithm>
#include <cmath>
#include <utility>

#include "1_ray_casting/ray_casting.h"
#include "core/unfinished.h"

namespace rays {

using glm::dot;

std::optional<Root> intersect(const Sphere& sphere, const Ray& ray, Interval range) {
    // Task 1.3: The roots of |o + t d - c|^2 = r^2. Mind far spheres (b^2 - c cancels), origins inside, any |d|.
    unfinished("1.3");
    return {};
}

Vec3 normal(const Sphere& sphere, const Vec3& point, const Root&) {
    // Task 1.3: Outwards.
    unfinished("1.3");
    return {};
}

std::optional<Root> intersect(const Cone& cone, const Ray& ray, Interval range) {
    // Task 1.8: The mantle, |p - its point on the axis| = radius(height), 0 <= height <= 1, and the ends unless open.
    // Mind rays along a generator (the quadratic term vanishes) and rays through the rim: none may slip in.
    unfinished("1.8");
    return {};
}

Vec3 normal(const Cone& cone, const Vec3& point, const Root& root) {
    // Task 1.8: Outwards: along the axis on the ends; half the gradient of |from axis|^2 - radius^2 on the mantle.
    unfinished("1.8");
    return {};
}

std::optional<Root> intersect(const Quadric& quadric, const Ray& ray, Interval range) {
    // Task 1.9: With p = (o, 1) and d = (d, 0): t^2 d^T Q d + 2 t d^T Q p + p^T Q p = 0.
    // Mind rays along the axis of a paraboloid or a generator of a cone, where the first term is rounding noise.
    unfinished("1.9");
    return {};
}

Vec3 normal(const Quadric& quadric, const Vec3& point, const Root&) {
    // Task 1.9: Half the gradient of p^T Q p: the first three components of Q p.
    unfinished("1.9");
    return {};
}

}  // namespace rays
