// The roots and normals of step 1, for eight rays and one shape: the same formulas in the same order, so the same bits.
// Why they are what they are stands there.
#pragma once

#include <array>
#include <cstdint>

#include "1_ray_casting/ray_casting.h"
#include "packets/rays.h"

namespace rays::packets {

// ---- Quadratic equations --------------------------------------------------------------------------------------------

struct RootPairs {
    Mask are;
    Reals first, second;  ///< first <= second

    static RootPairs none() { return {Mask::of(0), Reals(0.0), Reals(0.0)}; }
    Roots smallest_in(const Span& span) const {
        const Mask takes_first = span.contains(first);
        return {are & (takes_first | span.contains(second)), select(takes_first, first, second)};
    }
};

/// The real roots of a t^2 + 2 b t + c.
inline RootPairs quadratic_roots(Reals a, Reals b, Reals c) {
    const Reals ac = a * c, zero(0);
    const Reals discriminant = fma(b, b, -ac) + fma(-a, c, ac);
    const Mask are = discriminant >= zero;
    if (!are.any()) return {are, zero, zero};
    const Reals q = -(b + copysign(sqrt(discriminant), b));
    const Mask at_zero = q == zero;
    const Reals t0 = select(at_zero, zero, q / a), t1 = select(at_zero, zero, c / q);
    const Mask ordered = t0 < t1;
    return {are - (at_zero & (a == zero)), select(ordered, t0, t1), select(ordered, t1, t0)};
}

// ---- Spheres and planes ---------------------------------------------------------------------------------------------

inline RootPairs root_pairs(const Sphere& sphere, const Rays& rays) {
    const Vec3s to_center = Vec3s(sphere.center) - rays.origin;
    const Reals b = dot(to_center, rays.direction);
    const Vec3s l = to_center - (b * rays.inverse_direction2) * rays.direction;
    const Reals half_chord2 = Reals(sphere.radius * sphere.radius) - dot(l, l);
    const Mask are = half_chord2 > Reals(0);
    if (!are.any()) return RootPairs::none();
    const Reals q = b + copysign(sqrt(rays.direction2 * half_chord2), b);
    const Reals c = dot(to_center, to_center) - Reals(sphere.radius * sphere.radius);
    const Reals t0 = q * rays.inverse_direction2, t1 = c / q;
    const Mask ordered = t0 < t1;
    return {are, select(ordered, t0, t1), select(ordered, t1, t0)};
}
inline Roots intersect(const Sphere& sphere, const Rays& rays, const Span& span) {
    return root_pairs(sphere, rays).smallest_in(span);
}
inline Vec3s normal(const Sphere& sphere, const Vec3s& point) {
    return Reals(1 / sphere.radius) * (point - Vec3s(sphere.center));
}

inline Roots intersect(const Plane& plane, const Rays& rays, const Span& span) {
    const Vec3s n(plane.normal);
    const Reals t = (Reals(plane.offset) - dot(n, rays.origin)) / dot(n, rays.direction);
    return {span.contains(t), t};
}

inline Roots intersect(const Disc& disc, const Rays& rays, const Span& span) {
    const Vec3s n(disc.normal);
    const Reals t = dot(n, Vec3s(disc.center) - rays.origin) / dot(n, rays.direction);
    const Mask in_span = span.contains(t);
    if (!in_span.any()) return Roots::none();
    const Vec3s from_center = rays.at(t) - Vec3s(disc.center);
    const Reals distance2 = dot(from_center, from_center);
    return {in_span & (distance2 >= Reals(disc.hole_radius * disc.hole_radius)) &
                (distance2 <= Reals(disc.radius * disc.radius)),
            t};
}

// ---- Triangles ------------------------------------------------------------------------------------------------------

/// Rays sheared so that they run along their longest axis.
class ShearedRays {
public:
    /// Rays that are not `active` do not count.
    ShearedRays(const Rays& rays, Mask active) : axes_(rays.direction, active), origin_(axes_.turned(rays.origin)) {
        const Vec3s direction = axes_.turned(rays.direction);
        scale_ = Reals(1) / direction.z;
        shear_x_ = direction.x * scale_;
        shear_y_ = direction.y * scale_;
    }

    Roots intersect(const Triangle& triangle, const Span& span) const {
        const Vec3s a = from_world(triangle.a), b = from_world(triangle.b), c = from_world(triangle.c);
        const auto edge = [](const Vec3s& p, const Vec3s& q) { return p.x * q.y - p.y * q.x; };
        const Reals wa = edge(b, c), wb = edge(c, a), wc = edge(a, b), zero(0);
        const Mask outside = ((wa < zero) | (wb < zero) | (wc < zero)) & ((wa > zero) | (wb > zero) | (wc > zero));
        if (outside.bits() == kAllLanes) return Roots::none();
        const Reals inverse = Reals(1) / (wa + wb + wc);
        const Reals t = (wa * (scale_ * a.z) + wb * (scale_ * b.z) + wc * (scale_ * c.z)) * inverse;
        return {span.contains(t) - outside, t, inverse * wb, inverse * wc};
    }

private:
    /// Which axis becomes z; x and y are the next ones, in a circle.
    class Axes {
    public:
        Axes(const Vec3s& direction, Mask active) {
            const Reals x = abs(direction.x), y = abs(direction.y), z = abs(direction.z);
            x_is_longest_ = (x >= y) & (x >= z);
            y_is_longest_ = (y >= z) - x_is_longest_;
            const auto all = [&](Mask mask) { return !(active - mask).any(); };
            if (all(x_is_longest_))
                of_all_ = 0;
            else if (all(y_is_longest_))
                of_all_ = 1;
            else if (!(active & (x_is_longest_ | y_is_longest_)).any())
                of_all_ = 2;
        }

        template <class Vector>
        Vec3s turned(const Vector& v) const {
            if (of_all_ != kDiffers)
                return {Reals(v[(of_all_ + 1) % 3]), Reals(v[(of_all_ + 2) % 3]), Reals(v[of_all_])};
            const auto one = [&](Reals x, Reals y, Reals z) {
                return select(x_is_longest_, x, select(y_is_longest_, y, z));
            };
            const Reals x(v.x), y(v.y), z(v.z);
            return {one(y, z, x), one(z, x, y), one(x, y, z)};
        }

    private:
        static constexpr int kDiffers = -1;
        Mask x_is_longest_, y_is_longest_;
        int of_all_ = kDiffers;
    };

    Vec3s from_world(const Vec3& point) const {
        const Vec3s from_origin = axes_.turned(point) - origin_;
        const Reals z = from_origin.z;
        return {from_origin.x - shear_x_ * z, from_origin.y - shear_y_ * z, z};
    }

    Axes axes_;
    Vec3s origin_;
    Reals shear_x_, shear_y_, scale_;
};

inline Triangle triangle_of(const Mesh& mesh, std::uint32_t face) {
    const auto [a, b, c] = mesh.faces[face].position;
    return {mesh.positions[a], mesh.positions[b], mesh.positions[c]};
}

/// A face of a mesh, culled as in step 1.
inline Roots intersect(const Mesh& mesh, std::uint32_t face, const Rays& rays, const ShearedRays& sheared,
                       const Span& span) {
    const Triangle triangle = triangle_of(mesh, face);
    Roots roots = sheared.intersect(triangle, span);
    if (mesh.outward_winding != 0 && roots.is.any()) {
        const Vec3s n(glm::cross(triangle.b - triangle.a, triangle.c - triangle.a));
        const Mask back = dot(n, Reals(mesh.outward_winding) * rays.direction) > Reals(0);
        const Vec3s from_center = rays.at(span.near) - Vec3s(mesh.bound.center);
        const Mask from_outside = dot(from_center, from_center) > Reals(mesh.bound.radius * mesh.bound.radius);
        roots.is = roots.is - (back & from_outside);
    }
    roots.part = Reals(static_cast<double>(face));
    return roots;
}

inline Vec3s interpolate(const Vec3& a, const Vec3& b, const Vec3& c, Reals u, Reals v) {
    const Vec3s n = (Reals(1) - u - v) * Vec3s(a) + u * Vec3s(b) + v * Vec3s(c);
    return select(dot(n, n) > Reals(0), n, Vec3s(a));
}

// ---- Polygons -------------------------------------------------------------------------------------------------------

inline Roots intersect(const Polygon& polygon, const Rays& rays, const Span& span) {
    Roots roots = intersect(polygon.plane, rays, span);
    if (!roots.is.any()) return roots;
    const Vec3s point = rays.at(roots.t);
    const Reals px = point[polygon.kept_axes[0]], py = point[polygon.kept_axes[1]];
    Mask inside = Mask::of(0);
    std::uint32_t begin = 0;
    for (const std::uint32_t end : polygon.contour_ends) {
        for (std::uint32_t to = begin, from = end - 1; to < end; from = to++) {
            const Vec3 &a = polygon.points[from], &b = polygon.points[to];
            const Real ax = a[polygon.kept_axes[0]], ay = a[polygon.kept_axes[1]];
            const Real bx = b[polygon.kept_axes[0]], by = b[polygon.kept_axes[1]];
            const Mask from_above = Reals(ay) > py, to_above = Reals(by) > py;
            const Mask crosses = (from_above - to_above) | (to_above - from_above);
            const Reals side = Reals(bx - ax) * (py - Reals(ay)) - Reals(by - ay) * (px - Reals(ax));
            const Mask positive = side > Reals(0);
            const Mask flips = by > ay ? crosses & positive : crosses - positive;
            inside = (inside - flips) | (flips - inside);
        }
        begin = end;
    }
    roots.is = roots.is & inside;
    return roots;
}

// ---- Boxes ----------------------------------------------------------------------------------------------------------

inline Roots intersect(const Box& box, const Rays& rays, const Span& span) {
    Reals enter(-kInfinity), leave(kInfinity), enter_side(0.0), leave_side(0.0);
    Mask outside = Mask::of(0);
    for (int axis = 0; axis < 3; ++axis) {
        const Reals o = rays.origin[axis], inverse = Reals(1) / rays.direction[axis], lo(box.min[axis]),
                    hi(box.max[axis]);
        const Mask backwards = inverse < Reals(0), still = abs(inverse) == Reals(kInfinity);
        const Reals t_lo = (lo - o) * inverse, t_hi = (hi - o) * inverse;
        Reals near = select(backwards, t_hi, t_lo), far = select(backwards, t_lo, t_hi);
        if (still.any()) {
            outside = outside | (still - ((o >= lo) & (o <= hi)));
            near = select(still, Reals(-kInfinity), near);
            far = select(still, Reals(kInfinity), far);
        }
        outside = outside | (Mask::of(kAllLanes) - (near <= far));
        const Mask later = near > enter, sooner = far < leave;
        const Reals lo_side(2.0 * axis), hi_side(2.0 * axis + 1);
        enter = select(later, near, enter);
        enter_side = select(later, select(backwards, hi_side, lo_side), enter_side);
        leave = select(sooner, far, leave);
        leave_side = select(sooner, select(backwards, lo_side, hi_side), leave_side);
    }
    const Mask meets = (enter <= leave) - outside;
    if (!meets.any()) return Roots::none();
    const Mask enters = span.contains(enter);
    return {meets & (enters | span.contains(leave)), select(enters, enter, leave), Reals(0.0), Reals(0.0),
            select(enters, enter_side, leave_side)};
}
inline Vec3s box_normal(Reals part) {
    const auto along = [&](double axis) {
        const Mask low = part == Reals(2 * axis), high = part == Reals(2 * axis + 1);
        return select(low, Reals(-1), select(high, Reals(1), Reals(0.0)));
    };
    return {along(0), along(1), along(2)};
}

// ---- Cones and cylinders --------------------------------------------------------------------------------------------

Roots intersect(const Cone& cone, const Rays& rays, const Span& span);
Vec3s normal(const Cone& cone, const Vec3s& point, Reals part);

// ---- Tori -----------------------------------------------------------------------------------------------------------

Roots intersect(const Torus& torus, const Rays& rays, const Span& span);
Vec3s normal(const Torus& torus, const Vec3s& point);

}  // namespace rays::packets
