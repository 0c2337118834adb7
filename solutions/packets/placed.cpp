#include "packets/placed.h"

#include <algorithm>

namespace rays::packets {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

bool can_clip(const Object& object) {
    switch (object.kind) {
        case ShapeKind::sphere:
        case ShapeKind::plane:
        case ShapeKind::box:
        case ShapeKind::disc:
        case ShapeKind::cone:
        case ShapeKind::quadric: return object.clip == kNone;
        default: return false;
    }
}

/// Of triangles: rays are sheared for them.
bool is_faceted(ShapeKind kind) {
    return kind == ShapeKind::triangle || kind == ShapeKind::smooth_triangle || kind == ShapeKind::mesh;
}

/// (p, w) as the columns of a matrix see it: in GLM's order of operations.
struct Vec4s {
    Reals x, y, z, w;
};
[[gnu::always_inline]] inline Vec4s times(const Mat4& m, const Vec4s& v) {
    const auto row = [&](int i) {
        return (Reals(m[0][i]) * v.x + Reals(m[1][i]) * v.y) + (Reals(m[2][i]) * v.z + Reals(m[3][i]) * v.w);
    };
    return {row(0), row(1), row(2), row(3)};
}
Reals dot(const Vec4s& a, const Vec4s& b) { return (a.x * b.x + a.y * b.y) + (a.z * b.z + a.w * b.w); }

Mask contains(const Scene& scene, const Object& object, const Vec3s& p) {
    switch (object.kind) {
        case ShapeKind::sphere: {
            const Sphere& s = scene.spheres[object.shape];
            const Vec3s from_center = p - Vec3s(s.center);
            return dot(from_center, from_center) < Reals(s.radius * s.radius);
        }
        case ShapeKind::plane: {
            const Plane& s = scene.planes[object.shape];
            return dot(Vec3s(s.normal), p) < Reals(s.offset);
        }
        case ShapeKind::disc: {
            const Disc& s = scene.discs[object.shape];
            return dot(Vec3s(s.normal), p - Vec3s(s.center)) < Reals(0);
        }
        case ShapeKind::quadric: {
            const Vec4s point{p.x, p.y, p.z, Reals(1)};
            return dot(point, times(scene.quadrics[object.shape].q, point)) <= Reals(0);
        }
        case ShapeKind::cone: {
            const Cone& s = scene.cones[object.shape];
            const Vec3 axis = s.cap - s.base;
            const Vec3s from_base = p - Vec3s(s.base);
            const Reals height = dot(from_base, Vec3s(axis)) / Reals(glm::dot(axis, axis));
            const Vec3s from_axis = from_base - height * Vec3s(axis);
            const Reals radius = Reals(s.base_radius) + height * Reals(s.cap_radius - s.base_radius);
            return (height >= Reals(0)) & (height <= Reals(1)) & (dot(from_axis, from_axis) <= radius * radius);
        }
        default: {
            const Box& s = scene.boxes[object.shape];
            Mask in = Mask::of(kAllLanes);
            for (int a = 0; a < 3; ++a) in = in & (p[a] >= Reals(s.min[a])) & (p[a] <= Reals(s.max[a]));
            return in;
        }
    }
}

}  // namespace

Vec3s times(const Mat3& m, const Vec3s& v) {
    const auto row = [&](int i) { return Reals(m[0][i]) * v.x + Reals(m[1][i]) * v.y + Reals(m[2][i]) * v.z; };
    return {row(0), row(1), row(2)};
}

bool has_packet_test(const Scene& scene, const Object& object) {
    if (object.kind == ShapeKind::bicubic_patch) return false;
    if (object.transform != kNone && is_faceted(object.kind)) return false;  // sheared in world space only
    if (object.clip == kNone) return true;
    const ClipList& clips = scene.clips[object.clip];
    return std::all_of(clips.begin(), clips.end(), can_clip);
}

Mask inside(const Scene& scene, const Object& object, const Vec3s& points) {
    Vec3s local = points;
    if (object.transform != kNone) {
        const Transform& t = scene.transforms[object.transform];
        local = times(t.inverse_linear, points) + Vec3s(t.inverse_offset);
    }
    const Mask in = contains(scene, object, local);
    return object.inverse ? Mask::of(kAllLanes) - in : in;
}

RootPairs root_pairs(const Quadric& quadric, const Rays& rays) {
    const Vec3 zero(0);
    const Vec3s& direction = rays.direction;
    const Reals shift = dot(Vec3s(zero) - rays.origin, direction) * rays.inverse_direction2;
    const Vec3s at_shift = rays.at(shift);
    const Vec4s p{at_shift.x, at_shift.y, at_shift.z, Reals(1)}, d{direction.x, direction.y, direction.z, Reals(0)};
    const Vec4s qp = times(quadric.q, p);
    Reals a = dot(d, times(quadric.q, d)), rounding(0);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) rounding = rounding + abs(direction[i] * Reals(quadric.q[i][j]) * direction[j]);
    a = select(abs(a) <= Reals(4 * kEpsilon) * rounding, Reals(0), a);
    const RootPairs roots = quadratic_roots(a, dot(d, qp), dot(p, qp));
    return {roots.are, shift + roots.first, shift + roots.second};
}

Vec3s normal(const Quadric& quadric, const Vec3s& point) {
    const Vec4s g = times(quadric.q, Vec4s{point.x, point.y, point.z, Reals(1)});
    const Vec3s gradient(g.x, g.y, g.z);
    return select(dot(gradient, gradient) > Reals(0), gradient, Vec3s(Vec3(1, 0, 0)));
}

}  // namespace rays::packets
