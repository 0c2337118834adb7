// Plane, disc, polygon and box: shapes made of planes.
#include <algorithm>
#include <cmath>
#include <utility>

#include "1_ray_casting/ray_casting.h"
#include "core/unfinished.h"

namespace rays {

using glm::dot;

std::optional<Root> intersect(const Plane& plane, const Ray& ray, Interval range) {
    //> 1.4 normal . (o + t d) = offset. Mind rays in the plane, which must be a miss and not a NaN.
    const Root root{(plane.offset - dot(plane.normal, ray.origin)) / dot(plane.normal, ray.direction)};
    return range.contains(root.t) ? std::optional(root) : std::nullopt;  // parallel: infinite or NaN, in no interval
    //< 1.4
}

Vec3 normal(const Plane& plane, const Vec3&, const Root&) {
    //> 1.4 As the data says.
    return plane.normal;
    //< 1.4
}

std::optional<Root> intersect(const Disc& disc, const Ray& ray, Interval range) {
    //> 1.7 A plane with limits on the distance from the centre.
    const Root root{dot(disc.normal, disc.center - ray.origin) / dot(disc.normal, ray.direction)};
    if (!range.contains(root.t)) return std::nullopt;
    const Vec3 from_center = ray.at(root.t) - disc.center;
    const Real distance2 = dot(from_center, from_center);
    const bool on_disc = distance2 >= disc.hole_radius * disc.hole_radius && distance2 <= disc.radius * disc.radius;
    return on_disc ? std::optional(root) : std::nullopt;
    //< 1.7
}

Vec3 normal(const Disc& disc, const Vec3&, const Root&) {
    //> 1.7 As the data says.
    return disc.normal;
    //< 1.7
}

//> hidden
namespace {

/// Calls edge(from, to) for every edge of every contour.
template <class Visitor>
void for_each_edge(const Polygon& polygon, Visitor edge) {
    std::uint32_t begin = 0;
    for (const std::uint32_t end : polygon.contour_ends) {
        for (std::uint32_t to = begin, from = end - 1; to < end; from = to++)
            edge(polygon.points[from], polygon.points[to]);
        begin = end;
    }
}

/// Newell's method: each component is twice the area of the contour's projection along that axis. Collinear or repeated
/// corners do no harm (Tampieri, "Newell's Method for Computing the Plane Equation of a Polygon", Graphics Gems III).
/// Taken from the first point, so that the place of the polygon does not eat the digits of its shape.
Vec3 newell_normal(const Polygon& polygon, std::uint32_t begin, std::uint32_t end) {
    const std::vector<Vec3>& p = polygon.points;
    Vec3 sum(0);
    for (std::uint32_t i = begin + 1; i + 1 < end; ++i) sum += glm::cross(p[i] - p[begin], p[i + 1] - p[begin]);
    return sum;
}

/// The contour of the largest area tells the plane best; the sum of all vanishes where holes are as large as outlines.
Vec3 polygon_normal(const Polygon& polygon) {
    Vec3 largest(0);
    std::uint32_t begin = 0;
    for (const std::uint32_t end : polygon.contour_ends) {
        const Vec3 area = newell_normal(polygon, begin, end);
        if (dot(area, area) > dot(largest, largest)) largest = area;
        begin = end;
    }
    const Real length = std::sqrt(dot(largest, largest));
    return length > 0 ? largest / length : Vec3(0);  // no area: a zero normal, and no ray meets the polygon
}

/// Even-odd rule: a point is inside when a half line from it crosses an odd number of edges (Haines, "Point in Polygon
/// Strategies", Graphics Gems IV). An edge counts for y in [low, high): corners on the half line are counted once.
bool inside_contours(const Polygon& polygon, const Vec3& point) {
    const int x = polygon.kept_axes[0], y = polygon.kept_axes[1];
    bool inside = false;
    for_each_edge(polygon, [&](const Vec3& a, const Vec3& b) {
        if ((a[y] > point[y]) == (b[y] > point[y])) return;
        // The edge's x at the height of the point, compared without a division: which side of the edge is the point on?
        const Real side = (b[x] - a[x]) * (point[y] - a[y]) - (b[y] - a[y]) * (point[x] - a[x]);
        if ((side > 0) == (b[y] > a[y])) inside = !inside;
    });
    return inside;
}

}  // namespace
//< hidden

void prepare(Polygon& polygon) {
    //> 1.6 void The plane of the points, the two axes that are left when the dominant one of its normal is dropped,
    //>   and, once you have written task 1.13, the bounding sphere.
    const Vec3 n = polygon_normal(polygon);
    polygon.plane.normal = n;
    polygon.plane.offset = 0;
    for (const Vec3& p : polygon.points) polygon.plane.offset += dot(n, p) / Real(polygon.points.size());
    const Vec3 size = glm::abs(n);
    const int dominant = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    polygon.kept_axes = {(dominant + 1) % 3, (dominant + 2) % 3};
    polygon.bound = bounding_sphere(polygon.points);
    //< 1.6
}

std::optional<Root> intersect(const Polygon& polygon, const Ray& ray, Interval range) {
    //> 1.6 A hit on the plane counts when, the dominant axis dropped, it is inside an odd number of contours.
    if (misses(polygon.bound, ray, range)) return std::nullopt;
    const auto root = intersect(polygon.plane, ray, range);
    return root && inside_contours(polygon, ray.at(root->t)) ? root : std::nullopt;
    //< 1.6
}

Vec3 normal(const Polygon& polygon, const Vec3&, const Root&) {
    //> 1.6 That of its plane.
    return polygon.plane.normal;
    //< 1.6
}

std::optional<Root> intersect(const Box& box, const Ray& ray, Interval range) {
    //> 1.7 The common part of three slabs: the last entry, then the first exit, and the side that each belongs to.
    //>   Mind directions with a zero: 0 * infinity is a NaN.
    // Kay and Kajiya, "Ray Tracing Complex Scenes", SIGGRAPH 1986.
    Root enter{-kInfinity}, leave{kInfinity};
    for (int axis = 0; axis < 3; ++axis) {
        const Real o = ray.origin[axis], inverse = 1 / ray.direction[axis];
        if (std::isinf(inverse)) {
            if (!(o >= box.min[axis] && o <= box.max[axis])) return std::nullopt;
            continue;
        }
        const auto side = 2 * static_cast<std::uint32_t>(axis);
        Root near{(box.min[axis] - o) * inverse, Vec2(0), side}, far{(box.max[axis] - o) * inverse, Vec2(0), side + 1};
        if (inverse < 0) std::swap(near, far);
        if (!(near.t <= far.t)) return std::nullopt;  // NaN
        if (near.t > enter.t) enter = near;
        if (far.t < leave.t) leave = far;
    }
    if (!(enter.t <= leave.t)) return std::nullopt;
    if (range.contains(enter.t)) return enter;
    return range.contains(leave.t) ? std::optional(leave) : std::nullopt;
    //< 1.7
}

Vec3 normal(const Box&, const Vec3&, const Root& root) {
    //> 1.7 Outwards, as Root::part says.
    Vec3 n(0);
    n[static_cast<int>(root.part / 2)] = root.part % 2 == 0 ? Real(-1) : Real(1);
    return n;
    //< 1.7
}

}  // namespace rays
