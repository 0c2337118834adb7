// Sphere, cone, cylinder and the general quadric: surfaces whose equation along a ray has degree two.
#include <algorithm>
#include <cmath>
#include <utility>

#include "1_ray_casting/ray_casting.h"
#include "core/unfinished.h"

namespace rays {

using glm::dot;

//> hidden
namespace {

constexpr Real kEpsilon = std::numeric_limits<Real>::epsilon();

/// Two parameters of a ray, first <= second.
struct RootPair {
    Real first, second;
};

/// a b - c d without cancellation: the rounding of c d is caught by a fused multiply-add and given back.
/// Kahan's algorithm; error below 1.5 ulp (Jeannerod, Louvet, Muller, Math. Comp. 82, 2013).
Real difference_of_products(Real a, Real b, Real c, Real d) {
    const Real cd = c * d;
    return std::fma(a, b, -cd) + std::fma(-c, d, cd);
}

/// The real roots of a t^2 + 2 b t + c. The two terms of q have the same sign, so nothing cancels, and both roots
/// follow from it by Vieta's formulas (Press et al., Numerical Recipes, 5.6). As a goes to 0 one root goes to infinity,
/// where no interval accepts it, and the other to -c / 2b: the linear case needs no branch.
std::optional<RootPair> quadratic_roots(Real a, Real b, Real c) {
    const Real discriminant = difference_of_products(b, b, a, c);
    if (!(discriminant >= 0)) return std::nullopt;  // NaN comes here as well
    const Real q = -(b + std::copysign(std::sqrt(discriminant), b));
    if (q == 0) return a != 0 ? std::optional(RootPair{0, 0}) : std::nullopt;
    const Real t0 = q / a, t1 = c / q;
    return t0 < t1 ? RootPair{t0, t1} : RootPair{t1, t0};
}

std::optional<Root> first_in_range(const RootPair& roots, Interval range) {
    std::optional<Root> root;  // filled in place: who copies it at once waits for its parts
    if (range.contains(roots.first))
        root.emplace().t = roots.first;
    else if (range.contains(roots.second))
        root.emplace().t = roots.second;
    return root;
}

/// The parameter of the ray's point nearest to `point`. Equations set up there have coefficients of the size of the
/// shape, not of its distance: what Haines et al. do for the sphere helps every quadric.
Real nearest_parameter(const Ray& ray, const Vec3& point) {
    return dot(point - ray.origin, ray.direction) * (1 / dot(ray.direction, ray.direction));
}

}  // namespace
//< hidden

std::optional<Root> intersect(const Sphere& sphere, const Ray& ray, Interval range) {
    //> 1.3 The roots of |o + t d - c|^2 = r^2. Mind far spheres (b^2 - c cancels), origins inside, any |d|.
    // Haines, Guenther, Akenine-Moeller, "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems, ch. 7:
    // r^2 - |l|^2, l from the centre to the ray, instead of b^2 - |d|^2 c, which loses all digits for far spheres.
    const Vec3 to_center = sphere.center - ray.origin;
    const Real d2 = dot(ray.direction, ray.direction), inverse_d2 = 1 / d2;
    const Real b = dot(to_center, ray.direction);
    const Vec3 l = to_center - (b * inverse_d2) * ray.direction;
    const Real half_chord2 = sphere.radius * sphere.radius - dot(l, l);
    if (!(half_chord2 > 0)) return std::nullopt;
    const Real q = b + std::copysign(std::sqrt(d2 * half_chord2), b);
    const Real c = dot(to_center, to_center) - sphere.radius * sphere.radius;
    const auto [first, second] = std::minmax({q * inverse_d2, c / q});
    return first_in_range({first, second}, range);
    //< 1.3
}

Vec3 normal(const Sphere& sphere, const Vec3& point, const Root&) {
    //> 1.3 Outwards.
    return (point - sphere.center) * (1 / sphere.radius);
    //< 1.3
}

//> hidden
namespace {

/// What a cone or cylinder is along a ray, as functions of u, the ray's parameter from `shift` on: the height
/// s(u) = s0 + u ds from 0 (base) to 1 (cap), the vector from the axis, and the radius of the surface at that height.
struct ConeOnRay {
    Real shift;
    Real s0, ds;
    Vec3 from_axis, across;
    Real radius, widening;

    ConeOnRay(const Cone& cone, const Ray& ray) {
        const Vec3 axis = cone.cap - cone.base;
        const Real inverse_height2 = 1 / dot(axis, axis);
        shift = nearest_parameter(ray, cone.base + Real(0.5) * axis);
        const Vec3 from_base = ray.at(shift) - cone.base;
        s0 = dot(from_base, axis) * inverse_height2;
        ds = dot(ray.direction, axis) * inverse_height2;
        from_axis = from_base - s0 * axis;
        across = ray.direction - ds * axis;
        const Real slope = cone.cap_radius - cone.base_radius;
        radius = cone.base_radius + slope * s0;
        widening = slope * ds;
    }
};

/// An end of the part of a ray that is inside a convex solid, and the surface there.
struct End {
    Real u;
    std::uint32_t part;
};
struct Chord {
    End enter{-kInfinity, 0}, leave{kInfinity, 0};

    void start_at(End end) {
        if (end.u > enter.u) enter = end;
    }
    void stop_at(End end) {
        if (end.u < leave.u) leave = end;
    }
    bool is_empty() const { return !(enter.u <= leave.u); }
};

/// Between the planes of base and cap.
std::optional<Chord> between_the_ends(const ConeOnRay& c) {
    Chord chord;
    const Real inverse_ds = 1 / c.ds;
    if (std::isinf(inverse_ds)) return c.s0 >= 0 && c.s0 <= 1 ? std::optional(chord) : std::nullopt;
    const End base{-c.s0 * inverse_ds, 1}, cap{(1 - c.s0) * inverse_ds, 2};
    chord.enter = c.ds > 0 ? base : cap;
    chord.leave = c.ds > 0 ? cap : base;
    return chord;
}

/// Cuts the chord down to the inside of the mantle: a u^2 + 2 b u + c <= 0, on the sheet with a positive radius.
std::optional<Chord> within_the_mantle(const ConeOnRay& cone, Chord chord) {
    const Real across2 = dot(cone.across, cone.across), widening2 = cone.widening * cone.widening;
    const Real b = dot(cone.from_axis, cone.across) - cone.radius * cone.widening;
    const Real c = dot(cone.from_axis, cone.from_axis) - cone.radius * cone.radius;
    Real a = across2 - widening2;
    if (std::abs(a) <= 4 * kEpsilon * (across2 + widening2)) a = 0;  // along a generator: nothing but rounding is left

    if (a == 0 && b == 0) return c <= 0 ? std::optional(chord) : std::nullopt;
    auto roots = quadratic_roots(a, b, c);
    if (!roots && a < 0) roots = RootPair{-b / a, -b / a};  // through the apex: the double root was rounded away
    if (!roots) return std::nullopt;

    if (a > 0) {
        chord.start_at({roots->first, 0});
        chord.stop_at({roots->second, 0});
    } else if (a == 0) {
        const End only{-c / (2 * b), 0};
        b < 0 ? chord.start_at(only) : chord.stop_at(only);
    } else {
        // Steeper than the mantle: inside of one sheet before the first root, of the other after the second.
        cone.widening > 0 ? chord.start_at({roots->second, 0}) : chord.stop_at({roots->first, 0});
    }
    return chord;
}

}  // namespace
//< hidden

std::optional<Root> intersect(const Cone& cone, const Ray& ray, Interval range) {
    //> 1.8 The mantle, |p - its point on the axis| = radius(height), 0 <= height <= 1, and the ends unless open.
    //>   Mind rays along a generator (the quadratic term vanishes) and rays through the rim: none may slip in.
    // The closed frustum is convex, so the ray is inside of it on one chord: what both slab and mantle leave of it.
    // Comparing the ends of chords, not points with discs, leaves no gap at the rim (compare Kay, Kajiya 1986).
    const ConeOnRay on_ray(cone, ray);
    const auto slab = between_the_ends(on_ray);
    const auto chord = slab ? within_the_mantle(on_ray, *slab) : std::nullopt;
    if (!chord || chord->is_empty()) return std::nullopt;
    for (const End end : {chord->enter, chord->leave}) {
        const Root root{on_ray.shift + end.u, Vec2(0), end.part};
        if ((end.part == 0 || !cone.open) && range.contains(root.t)) return root;
    }
    return std::nullopt;
    //< 1.8
}

Vec3 normal(const Cone& cone, const Vec3& point, const Root& root) {
    //> 1.8 Outwards: along the axis on the ends; half the gradient of |from axis|^2 - radius^2 on the mantle.
    const Vec3 axis = cone.cap - cone.base;
    if (root.part == 1) return -axis;
    if (root.part == 2) return axis;
    const Real inverse_height2 = 1 / dot(axis, axis);
    const Real s = dot(point - cone.base, axis) * inverse_height2;
    const Real slope = cone.cap_radius - cone.base_radius;
    const Vec3 from_axis = point - cone.base - s * axis;
    const Vec3 gradient = from_axis - ((cone.base_radius + slope * s) * (slope * inverse_height2)) * axis;
    return dot(gradient, gradient) > 0 ? gradient : (slope > 0 ? -axis : axis);  // the apex has no normal: any will do
    //< 1.8
}

//> hidden
namespace {

/// The size of the rounding in d^T Q d.
Real rounding_of_form(const Mat4& q, const Vec3& d) {
    Real sum = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) sum += std::abs(d[i] * q[i][j] * d[j]);
    return 4 * kEpsilon * sum;
}

}  // namespace
//< hidden

std::optional<Root> intersect(const Quadric& quadric, const Ray& ray, Interval range) {
    //> 1.9 With p = (o, 1) and d = (d, 0): t^2 d^T Q d + 2 t d^T Q p + p^T Q p = 0.
    //>   Mind rays along the axis of a paraboloid or a generator of a cone, where the first term is rounding noise.
    const Real shift = nearest_parameter(ray, Vec3(0));
    const Vec4 p(ray.at(shift), 1), d(ray.direction, 0);
    const Vec4 qp = quadric.q * p;
    Real a = dot(d, quadric.q * d);
    if (std::abs(a) <= rounding_of_form(quadric.q, ray.direction)) a = 0;
    const auto roots = quadratic_roots(a, dot(d, qp), dot(p, qp));
    if (!roots) return std::nullopt;
    return first_in_range({shift + roots->first, shift + roots->second}, range);
    //< 1.9
}

Vec3 normal(const Quadric& quadric, const Vec3& point, const Root&) {
    //> 1.9 Half the gradient of p^T Q p: the first three components of Q p.
    const Vec3 gradient(quadric.q * Vec4(point, 1));
    return dot(gradient, gradient) > 0 ? gradient : Vec3(1, 0, 0);  // at the apex of a cone: POV-Ray's choice
    //< 1.9
}

}  // namespace rays
