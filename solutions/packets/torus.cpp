// The torus, eight rays at once. Step 1 (torus.cpp) tells the story. Here lanes iterate in step until the last one has
// its root, and the extrema of F are found when the search for the first root gets there, not all before it starts: the
// same numbers, but most rays need one.
#include <algorithm>
#include <cmath>
#include <limits>

#include "packets/shapes.h"

namespace rays::packets {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// A function and its derivative at one place of each ray.
struct Values {
    Reals f, slope;

    /// What the sign is just behind this place.
    Mask is_negative() const {
        const Reals zero(0);
        return (f < zero) | ((f == zero) & (slope < zero));
    }
};

/// In each lane of `active` the root of f between a and b, where f has different signs.
template <class Function>
Reals bracketed_root(Function f, Mask active, Reals a, Reals b, Mask rising) {
    const Reals zero(0), half(0.5), tolerance = Reals(4 * kEpsilon) * max(abs(a), abs(b));
    Reals longest_step = (b - a) * half, t = a + longest_step;
    for (int i = 0; i < 200; ++i) {
        const Values value = f(t);
        active = active - (value.f == zero);
        const Mask is_end = (value.f < zero) ^ rising;
        a = select(is_end, a, t);
        b = select(is_end, t, b);
        const Reals newton = t - value.f / value.slope, middle = (b - a) * half, length = abs(newton - t);
        const Mask fits = (newton >= a) & (newton <= b) & (length <= longest_step);
        const Reals step = select(fits, length, middle);
        t = select(active, select(fits, newton, a + middle), t);
        longest_step = select(fits, length * half, middle);
        active = active & (step > tolerance);
        if (!active.any()) break;
    }
    return t;
}

struct Places {
    Mask are;
    Reals u;
};

/// Where f changes its sign between `from` and `to`, where it is monotone: in lanes that are `exact` the root, in
/// others `to`. `negative` is the sign behind `from`, then behind `to`.
template <class Function>
Places root_between(Function f, Mask lanes, Reals from, Reals to, Mask& negative, Mask exact) {
    const Values end = f(to);
    const Mask at_end = lanes & (end.f == Reals(0)), changes = (lanes & ((end.f < Reals(0)) ^ negative)) - at_end;
    const Mask asked = changes & exact;
    Places roots{at_end | changes, to};
    if (asked.any()) roots.u = select(asked, bracketed_root(f, asked, from, to, negative), to);
    negative = ((negative ^ changes) - at_end) | (at_end & (end.slope < Reals(0)));
    return roots;
}

/// The torus along rays whose parameter u is a length, counted from the point nearest to the centre.
class TorusOnRays {
public:
    TorusOnRays(const Torus& torus, const Vec3s& nearest, const Vec3s& unit_direction, Reals o2)
        : major_(torus.major), minor_(torus.minor), o_(nearest), d_(unit_direction) {
        const Real major2 = torus.major * torus.major;
        const Reals k = o2 + Reals(major2) - Reals(torus.minor * torus.minor);
        c2_ = Reals(2) * k - Reals(4 * major2) * (Reals(1) - d_.y * d_.y);
        c1_ = Reals(8 * major2) * o_.y * d_.y;
    }

    Values surface(Reals u) const {
        const Vec3s p = o_ + u * d_;
        const Reals rho = sqrt(p.x * p.x + p.z * p.z);
        const Reals y2_r2 = (p.y - minor_) * (p.y + minor_);
        const Reals inner = (rho - major_) * (rho - major_) + y2_r2;
        const Reals outer = (rho + major_) * (rho + major_) + y2_r2;
        return {inner * outer, slope(u).f};
    }
    Values slope(Reals u) const {
        return {(Reals(4) * u * u + Reals(2) * c2_) * u + c1_, Reals(12) * u * u + Reals(2) * c2_};
    }
    /// Where there are any.
    Places inflections() const { return {c2_ < Reals(0), sqrt(-c2_ / Reals(6))}; }

private:
    Reals major_, minor_;
    Vec3s o_, d_;
    Reals c2_, c1_;
};

/// The part of each ray from `begin` on that is near enough to matter. Level rays above and below the torus need no
/// question of their own, as in step 1: F > 0 all along them.
Span near_part(const Torus& torus, const Vec3s& o, const Vec3s& d, Reals half2, Reals begin) {
    const Real tube = torus.minor * Real(1.00001);
    const Reals high = sqrt(half2), low = -high, tubes(tube);
    const Reals inverse = Reals(1) / d.y, first = (Reals(-tube) - o.y) * inverse, second = (tubes - o.y) * inverse;
    const Mask level = abs(inverse) == Reals(kInfinity);
    return {max(begin, select(level, low, max(low, min(first, second)))),
            select(level, high, min(high, max(first, second)))};
}

/// Which rays surely have no root that counts: between the planes that touch the torus they stay around it or in its
/// hole. Most questions end here, at the price of one division. The margins are far above all rounding, that of distant
/// places too.
Mask surely_misses(const Torus& torus, const Rays& rays, const Span& span) {
    const Vec3s &o = rays.origin, &d = rays.direction;
    const Reals tube = Reals(Real(1.00001) * torus.minor) + Reals(1e-12) * abs(o.y), inverse = Reals(1) / d.y;
    const Reals first = (-tube - o.y) * inverse, second = (tube - o.y) * inverse;
    const Reals low = max(span.near, min(first, second));  // 0 / 0 changes nothing: std::max keeps its first argument
    const Reals high = min(span.far, max(first, second));

    // The distance from the axis, squared, is a t^2 + 2 b t + c.
    const Reals a = d.x * d.x + d.z * d.z, b = o.x * d.x + o.z * d.z, c = o.x * o.x + o.z * o.z, zero(0);
    const Real reach = torus.major + torus.minor, hole = std::max(torus.major - torus.minor, Real(0));
    const Reals margin = Reals(Real(1e-5) * reach * reach) + Reals(1e-12) * c;
    const Reals outer2 = Reals(reach * reach) + margin, inner2 = Reals(hole * hole) - margin;
    const Reals slope_low = a * low + b, slope_high = a * high + b;
    const Reals at_low = (slope_low + b) * low + c, at_high = (slope_high + b) * high + c;
    const Mask around = ((slope_low >= zero) & (at_low > outer2)) | ((slope_high <= zero) & (at_high > outer2)) |
                        ((c - outer2) * a > b * b);
    return (low > high) | around | ((at_low < inner2) & (at_high < inner2));
}

}  // namespace

Roots intersect(const Torus& torus, const Rays& rays, const Span& span) {
    if (torus.major == 0) return intersect(Sphere{Vec3(0), torus.minor}, rays, span);
    Mask open = Mask::of(kAllLanes) - surely_misses(torus, rays, span);
    if (!open.any()) return Roots::none();
    const Reals length = sqrt(rays.direction2), inverse_length = Reals(1) / length;
    const Reals shift = -dot(rays.origin, rays.direction) * (inverse_length * inverse_length);
    const Vec3s o = rays.at(shift);
    const Reals o2 = dot(o, o);
    const Real outer = (torus.major + torus.minor) * Real(1.00001);
    const Reals half2 = Reals(outer * outer) - o2;
    const Vec3s d = inverse_length * rays.direction;
    const Span near = near_part(torus, o, d, half2, (span.near - shift) * length);
    open = open & (half2 > Reals(0)) & (near.near < min(near.far, (span.far - shift) * length));
    if (!open.any()) return Roots::none();

    const auto t_at = [&](Reals u) { return shift + u * inverse_length; };
    const TorusOnRays on_rays(torus, o, d, o2);
    const auto slope = [&](Reals u) { return on_rays.slope(u); };
    const auto surface = [&](Reals u) { return on_rays.surface(u); };
    const Places w = on_rays.inflections();
    const Mask first = w.are & near.contains(-w.u), second = w.are & near.contains(w.u);
    const Reals breaks[] = {near.near, select(first, -w.u, select(second, w.u, near.far)),
                            select(first & second, w.u, near.far), near.far};
    const Mask all = Mask::of(kAllLanes), are_pieces[] = {all, first | second, first & second};

    Roots roots = Roots::none();
    Mask falling = slope(near.near).is_negative(), inside = surface(near.near).is_negative();
    Reals from = near.near;
    for (int i = 0; i < 4 && open.any(); ++i) {
        Places to{open, near.far};
        if (i < 3) {
            to = root_between(slope, open & are_pieces[i], breaks[i], breaks[i + 1], falling, all);
            to.are = to.are & near.contains(to.u);
        }
        if (!to.are.any()) continue;
        const Mask in_span = span.any ? (t_at(from) > span.near) & (t_at(to.u) < span.far) : Mask::of(0);
        const Places places = root_between(surface, to.are, from, to.u, inside, all - in_span);
        const Reals t = t_at(places.u);
        const Mask found = places.are & span.contains(t);
        roots.is = roots.is | found;
        roots.t = select(found, t, roots.t);
        from = select(to.are, to.u, from);
        open = (open - found) & (t_at(from) < span.far);
    }
    return roots;
}

Vec3s normal(const Torus& torus, const Vec3s& point) {
    const Spread x(point.x), z(point.z);
    Spread distances;
    for (int i = 0; i < kLanes; ++i) distances.lane[i] = std::hypot(x[i], z[i]);  // no formula of ours has its bits
    const Reals rho = Reals::load(distances.lane), major(torus.major), zero(0);
    const Vec3s from_circle{point.x - major * (point.x / rho), point.y, point.z - major * (point.z / rho)};
    return select(rho > zero, from_circle, {zero, select(point.y < zero, Reals(-1), Reals(1)), zero});
}

}  // namespace rays::packets
