// A ray against an axis-aligned box, between its pairs of parallel planes.
#include <algorithm>
#include <cmath>

#include "4_partitioning/structures.h"
#include "core/unfinished.h"

namespace rays {

std::optional<Span> clip(const Ray& ray, Interval range, const Bounds& box) {
    //> 4.2 Between the two planes of each axis the ray is in a slab; in the box it is in all three. A direction of 0
    //>   divides by 0 there: such a ray is in the slab for ever, or never. Push both ends outwards by some roundings.
    if (!is_finite(ray.origin) || !is_finite(ray.direction)) return std::nullopt;
    // Subtraction and division round once each; a last time what is compared with it.
    constexpr Real kOutwards = 2 * std::numeric_limits<Real>::epsilon();
    const auto earlier = [](Real t) { return t * (t > 0 ? 1 - kOutwards : 1 + kOutwards); };
    const auto later = [](Real t) { return t * (t > 0 ? 1 + kOutwards : 1 - kOutwards); };
    Span span{range.min, range.max};
    for (int a = 0; a < 3; ++a) {
        const Real o = ray.origin[a], d = ray.direction[a];
        if (d == 0) {
            if (!(box.min[a] <= o && o <= box.max[a])) return std::nullopt;
            continue;
        }
        span.enter = std::max(span.enter, earlier(((d > 0 ? box.min[a] : box.max[a]) - o) / d));
        span.exit = std::min(span.exit, later(((d > 0 ? box.max[a] : box.min[a]) - o) / d));
    }
    return span.enter <= span.exit ? std::optional(span) : std::nullopt;
    //< 4.2
}

//> given
Real rounding_of(const Ray& ray, const Bounds& box) {
    const auto largest = [](const Vec3& v) { return std::max(std::abs(v.x), std::max(std::abs(v.y), std::abs(v.z))); };
    const Real reach = std::max(largest(box.min), largest(box.max));
    return 8 * std::numeric_limits<Real>::epsilon() * (largest(ray.origin) + reach);
}

std::optional<Ray> without_zeros(const Ray& ray) {
    if (!is_ray(ray)) return std::nullopt;
    const Vec3 size = glm::abs(ray.direction);
    const Real largest = std::max(size.x, std::max(size.y, size.z));
    Ray result = ray;
    const Real least = std::numeric_limits<Real>::epsilon() / 4 * largest;
    for (int a = 0; a < 3; ++a)
        if (size[a] < least) result.direction[a] = std::copysign(least, ray.direction[a]);
    return result;
}
//< given

}  // namespace rays
