// Plane, disc, polygon and box: shapes made of planes.
#include <algorithm>
#include <cmath>
#include <utility>

#include "1_ray_casting/ray_casting.h"
#include "core/unfinished.h"

namespace rays {

using glm::dot;

std::optional<Root> intersect(const Plane& plane, const Ray& ray, Interval range) {
    // Task 1.4: normal . (o + t d) = offset. Mind rays in the plane, which must be a miss and not a NaN.
    unfinished("1.4");
    return {};
}

Vec3 normal(const Plane& plane, const Vec3&, const Root&) {
    // Task 1.4: As the data says.
    unfinished("1.4");
    return {};
}

std::optional<Root> intersect(const Disc& disc, const Ray& ray, Interval range) {
    // Task 1.7: A plane with limits on the distance from the centre.
    unfinished("1.7");
    return {};
}

Vec3 normal(const Disc& disc, const Vec3&, const Root&) {
    // Task 1.7: As the data says.
    unfinished("1.7");
    return {};
}

void prepare(Polygon& polygon) {
    // Task 1.6: The plane of the points, the two axes that are left when the dominant one of its normal is dropped,
    // and, once you have written task 1.13, the bounding sphere.
    unfinished("1.6");
}

std::optional<Root> intersect(const Polygon& polygon, const Ray& ray, Interval range) {
    // Task 1.6: A hit on the plane counts when, the dominant axis dropped, it is inside an odd number of contours.
    unfinished("1.6");
    return {};
}

Vec3 normal(const Polygon& polygon, const Vec3&, const Root&) {
    // Task 1.6: That of its plane.
    unfinished("1.6");
    return {};
}

std::optional<Root> intersect(const Box& box, const Ray& ray, Interval range) {
    // Task 1.7: The common part of three slabs: the last entry, then the first exit, and the side that each belongs to.
    // Mind directions with a zero: 0 * infinity is a NaN.
    unfinished("1.7");
    return {};
}

Vec3 normal(const Box&, const Vec3&, const Root& root) {
    // Task 1.7: Outwards, as Root::part says.
    unfinished("1.7");
    return {};
}

}  // namespace rays
