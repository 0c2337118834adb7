// The methods that come to mind first, beside which the solution's are charted.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "1_ray_casting/ray_casting.h"
#include "bezier.h"

namespace rays::bench {

inline std::optional<Root> smaller_in_range(Real a, Real b, Interval range) {
    if (range.contains(std::min(a, b))) return Root{std::min(a, b)};
    if (range.contains(std::max(a, b))) return Root{std::max(a, b)};
    return std::nullopt;
}

/// The textbook's b^2 - c from the ray's origin, for directions of unit length.
inline std::optional<Root> textbook_sphere(const Sphere& sphere, const Ray& ray, Interval range) {
    const Vec3 oc = ray.origin - sphere.center;
    const Real b = glm::dot(oc, ray.direction);
    const Real discriminant = b * b - (glm::dot(oc, oc) - sphere.radius * sphere.radius);
    if (!(discriminant > 0)) return std::nullopt;
    const Real root = std::sqrt(discriminant);
    return smaller_in_range(-b - root, -b + root, range);
}

/// (-b -+ sqrt(b^2 - a c)) / a from the ray's origin.
inline std::optional<Root> textbook_quadric(const Quadric& quadric, const Ray& ray, Interval range) {
    const Vec4 o(ray.origin, 1), d(ray.direction, 0), qo = quadric.q * o;
    const Real a = glm::dot(d, quadric.q * d), b = glm::dot(d, qo), c = glm::dot(o, qo);
    const Real discriminant = b * b - a * c;
    if (!(discriminant >= 0)) return std::nullopt;
    const Real root = std::sqrt(discriminant);
    return smaller_in_range((-b - root) / a, (-b + root) / a, range);
}

/// The distance to the torus at equal steps through the ball around it; a change of sign is bisected to the last bit.
inline std::optional<Root> stepped_torus(const Torus& torus, const Ray& ray, Interval range, int steps) {
    const auto distance = [&](Real t) {
        const Vec3 p = ray.at(t);
        const Real across = std::sqrt(p.x * p.x + p.z * p.z) - torus.major;
        return across * across + p.y * p.y - torus.minor * torus.minor;
    };
    const Real ball = torus.major + torus.minor, middle = -glm::dot(ray.origin, ray.direction);
    const Vec3 nearest = ray.at(middle);
    const Real half2 = ball * ball - glm::dot(nearest, nearest);
    if (!(half2 > 0)) return std::nullopt;
    const Real from = middle - std::sqrt(half2), step = 2 * std::sqrt(half2) / Real(steps);
    Real before = distance(from);
    for (int i = 1; i <= steps; ++i) {
        const Real after = distance(from + Real(i) * step);
        if ((before < 0) != (after < 0)) {
            Real low = from + Real(i - 1) * step, high = from + Real(i) * step;
            for (Real half = (low + high) / 2; half > low && half < high; half = (low + high) / 2)
                ((distance(half) < 0) == (before < 0) ? low : high) = half;
            if (range.contains(low)) return Root{low};
        }
        before = after;
    }
    return std::nullopt;
}

/// Newton's method from starts x starts points of the patch; the nearest of what they find.
inline std::optional<Root> newton_patch(const BicubicPatch& patch, const Ray& ray, Interval range, int starts) {
    if (misses(patch.bound, ray, range)) return std::nullopt;
    std::optional<Root> first;
    for (int i = 0; i < starts * starts; ++i) {
        const Real u = (Real(i / starts) + Real(0.5)) / Real(starts), v = (Real(i % starts) + Real(0.5)) / Real(starts);
        const auto root = newton_from<Real>(patch.control, ray.origin, ray.direction, u, v, 12);
        if (!(root.u >= 0 && root.u <= 1 && root.v >= 0 && root.v <= 1)) continue;
        // Not every end of twelve steps is a root: it must lie on the ray, up to rounding at ten sizes.
        const Vec3 off = patch_point<Real>(patch.control, root.u, root.v).p - ray.at(root.t);
        constexpr Real kOff = 1000 * std::numeric_limits<Real>::epsilon();
        if (!(glm::dot(off, off) <= kOff * kOff)) continue;
        if (range.contains(root.t) && (!first || root.t < first->t)) first = Root{root.t, {root.u, root.v}};
    }
    return first;
}

/// The patch as 2 steps^2 triangles, to be asked as a mesh.
inline Mesh tessellated(const BicubicPatch& patch, std::uint32_t steps) {
    Mesh mesh;
    for (std::uint32_t i = 0; i <= steps; ++i)
        for (std::uint32_t j = 0; j <= steps; ++j)
            mesh.positions.push_back(patch_point<Real>(patch.control, Real(i) / Real(steps), Real(j) / Real(steps)).p);
    for (std::uint32_t i = 0; i < steps; ++i) {
        for (std::uint32_t j = 0; j < steps; ++j) {
            const std::uint32_t a = i * (steps + 1) + j, b = a + steps + 1;
            mesh.faces.push_back({.position = {a, b, b + 1}});
            mesh.faces.push_back({.position = {a, b + 1, a + 1}});
        }
    }
    prepare(mesh);
    return mesh;
}

}  // namespace rays::bench
