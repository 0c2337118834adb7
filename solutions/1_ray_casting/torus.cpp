// The torus, standing for every implicit surface F(p) = 0: find all roots of one function of t, miss none.
#include <algorithm>
#include <array>
#include <cmath>

#include "1_ray_casting/ray_casting.h"
#include "core/unfinished.h"

namespace rays {

using glm::dot;

//> hidden
namespace {

constexpr Real kEpsilon = std::numeric_limits<Real>::epsilon();

/// A function and its derivative at one place.
struct Value {
    Real f, slope;
};

/// The root of f between a and b, where f has different signs. Newton's method; a step that would leave the bracket or
/// that shrinks too slowly (near a double root) is replaced by bisection (after Press et al., Numerical Recipes, 9.4).
/// From the middle of a bracket Newton's step may be half of it: the root may lie next to an end.
template <class Function>
Real bracketed_root(Function f, Real a, Real b, bool rising) {
    // Closer to the root f is all rounding: its signs there mislead to bisect from the start.
    const Real tolerance = 4 * kEpsilon * std::max(std::abs(a), std::abs(b));
    Real t = a + (b - a) / 2, longest_step = (b - a) / 2;
    for (int i = 0; i < 200; ++i) {
        const Value value = f(t);
        if (value.f == 0) return t;
        ((value.f < 0) == rising ? a : b) = t;
        const Real newton = t - value.f / value.slope, half = (b - a) / 2;
        const bool fits = newton >= a && newton <= b && std::abs(newton - t) <= longest_step;
        const Real step = fits ? std::abs(newton - t) : half;
        t = fits ? newton : a + half;
        longest_step = fits ? step / 2 : step;
        if (!(step > tolerance)) break;
    }
    return t;
}

/// Ascending places that part a range into pieces. Seven are enough for a quartic.
struct Breaks {
    std::array<Real, 8> at{};
    int count = 0;

    void add(Real t) { at[static_cast<std::size_t>(count++)] = t; }
    Real operator[](int i) const { return at[static_cast<std::size_t>(i)]; }
};

/// Calls found(root) for the roots of f in ascending order until it says true. f is monotone between the breaks: then a
/// change of sign is a root, and there is no other. A root at the very first break counts as just before it.
template <class Function, class Visitor>
void each_root(const Breaks& breaks, Function f, Visitor found) {
    const Value start = f(breaks[0]);
    bool negative = start.f != 0 ? start.f < 0 : start.slope < 0;
    for (int i = 0; i + 1 < breaks.count; ++i) {
        const Real end = f(breaks[i + 1]).f;
        if (end == 0 || (end < 0) != negative) {
            if (found(end == 0 ? breaks[i + 1] : bracketed_root(f, breaks[i], breaks[i + 1], negative))) return;
            if (end != 0) negative = !negative;
            else negative = f(breaks[i + 1]).slope < 0;
        }
    }
}

/// The torus along a ray whose parameter u is a length, counted from the point nearest to the centre.
/// There o . d = 0, and F(u) = (u^2 + k)^2 - 4 R^2 (x^2 + z^2) = u^4 + c2 u^2 + c1 u + c0 has no cubic term.
class TorusOnRay {
public:
    TorusOnRay(const Torus& torus, const Vec3& nearest, const Vec3& unit_direction)
        : major_(torus.major), minor_(torus.minor), o_(nearest), d_(unit_direction) {
        const Real o2 = dot(o_, o_), major2 = major_ * major_;
        const Real k = o2 + major2 - minor_ * minor_;
        c2_ = 2 * k - 4 * major2 * (1 - d_.y * d_.y);
        c1_ = 8 * major2 * o_.y * d_.y;
    }

    /// F as a product, [(rho - R)^2 + y^2 - r^2] [(rho + R)^2 + y^2 - r^2]: the terms of the expanded quartic cancel to
    /// few digits for a thin tube, those of the first factor do not. The derivative comes from the quartic: Newton's
    /// method does not need more.
    Value surface(Real u) const {
        const Vec3 p = o_ + u * d_;
        const Real rho = std::sqrt(p.x * p.x + p.z * p.z);
        const Real y2_r2 = (p.y - minor_) * (p.y + minor_);
        const Real inner = (rho - major_) * (rho - major_) + y2_r2;
        const Real outer = (rho + major_) * (rho + major_) + y2_r2;
        return {inner * outer, slope(u).f};
    }
    /// F', and F'' as its derivative.
    Value slope(Real u) const { return {(4 * u * u + 2 * c2_) * u + c1_, 12 * u * u + 2 * c2_}; }

    /// Where F' has its extrema: F'' = 0.
    std::optional<Real> inflection() const {
        return c2_ < 0 ? std::optional(std::sqrt(-c2_ / 6)) : std::nullopt;
    }

    /// The part of the ray from `begin` on that is near enough to matter: in a ball and between two planes, a little larger
    /// than they must be.
    Interval near_part(Real begin) const {
        const Real outer = (major_ + minor_) * Real(1.00001), tube = minor_ * Real(1.00001);
        const Real half2 = outer * outer - dot(o_, o_);
        if (!(half2 > 0)) return {0, 0};
        Real low = -std::sqrt(half2), high = -low;
        if (const Real inverse = 1 / d_.y; !std::isinf(inverse)) {
            const Real first = (-tube - o_.y) * inverse, second = (tube - o_.y) * inverse;
            low = std::max(low, std::min(first, second));
            high = std::min(high, std::max(first, second));
        } else if (!(std::abs(o_.y) <= tube)) {
            return {0, 0};
        }
        return {std::max(begin, low), high};
    }

private:
    Real major_, minor_;
    Vec3 o_, d_;
    Real c2_, c1_;
};

}  // namespace
//< hidden

std::optional<Root> intersect(const Torus& torus, const Ray& ray, Interval range) {
    //> 1.10 The roots of F(p) = (|p|^2 + R^2 - r^2)^2 - 4 R^2 (x^2 + z^2). Bracket them: the roots of F'' part the
    //>   range into pieces where F' is monotone, the roots of F' into pieces where F is. Two roots close together
    //>   must both be found, and no root must be found twice.
    if (torus.major == 0) return intersect(Sphere{Vec3(0), torus.minor}, ray, range);  // F is a square: no sign changes
    const Real length = glm::length(ray.direction), inverse_length = 1 / length;
    const Real shift = -dot(ray.origin, ray.direction) * (inverse_length * inverse_length);
    const TorusOnRay on_ray(torus, ray.at(shift), inverse_length * ray.direction);
    const Interval near = on_ray.near_part((range.min - shift) * length);
    if (!(near.min < std::min(near.max, (range.max - shift) * length))) return std::nullopt;

    // Brackets do not end where the range does: what was found before must not move the last bits of a root.
    Breaks inflections;
    inflections.add(near.min);
    if (const auto w = on_ray.inflection())
        for (const Real u : {-*w, *w})
            if (near.contains(u)) inflections.add(u);
    inflections.add(near.max);

    Breaks extrema;
    extrema.add(near.min);
    each_root(inflections, [&](Real u) { return on_ray.slope(u); }, [&](Real u) {
        if (near.contains(u)) extrema.add(u);
        return false;
    });
    extrema.add(near.max);

    std::optional<Root> first;
    each_root(extrema, [&](Real u) { return on_ray.surface(u); }, [&](Real u) {
        const Root root{shift + u * inverse_length};
        if (range.contains(root.t)) first = root;
        return root.t >= range.max || first.has_value();
    });
    return first;
    //< 1.10
}

Vec3 normal(const Torus& torus, const Vec3& point, const Root&) {
    //> 1.10 From the nearest point of the circle in the middle of the tube.
    const Real rho = std::hypot(point.x, point.z);
    if (!(rho > 0)) return {0, point.y < 0 ? Real(-1) : Real(1), 0};
    const Vec3 on_circle = torus.major * Vec3(point.x / rho, 0, point.z / rho);
    return point - on_circle;
    //< 1.10
}

}  // namespace rays
