// The torus, standing for every implicit surface F(p) = 0: find all roots of one function of t, miss none.
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

/// A function and its derivative at one place.
struct Value {
    Real f, slope;
};

/// The root of f between a and b, where f has different signs. Newton's method; a step that would leave the bracket or
/// that shrinks too slowly (near a double root) is replaced by bisection (Press et al., Numerical Recipes, 9.4).
/// `guess` lies between a and b.
template <class Function>
Real bracketed_root(Function f, Real a, Real b, Real guess, bool rising) {
    const Real tolerance = kEpsilon * std::max(std::abs(a), std::abs(b));
    Real t = guess, last_step = b - a;
    bool was_newton = false;
    for (int i = 0; i < 200; ++i) {
        const Value value = f(t);
        if (value.f == 0) return t;
        ((value.f < 0) == rising ? a : b) = t;
        Real next = t - value.f / value.slope;
        const bool is_newton = next > a && next < b && 2 * std::abs(next - t) <= std::abs(last_step);
        if (!is_newton) next = a + (b - a) / 2;
        const Real step = std::abs(next - t);
        t = next;
        // Steps of Newton's method shrink quadratically: after these two, the next would be so long.
        const Real shrunk = step / std::abs(last_step);
        const Real following = is_newton && was_newton ? step * shrunk * shrunk : step;
        if (!(following > tolerance)) break;
        last_step = step;
        was_newton = is_newton;
    }
    return t;
}

/// A place on the ray, with F and F' there.
struct Sample {
    Real u;
    Value value;
};

/// Where the straight line between two samples of different signs meets zero.
Real on_chord(const Sample& a, const Sample& b) {
    const Real u = a.u + (b.u - a.u) * (a.value.f / (a.value.f - b.value.f));
    return u > a.u && u < b.u ? u : a.u + (b.u - a.u) / 2;
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
    Sample sample(Real u) const {
        const Vec3 p = o_ + u * d_;
        const Real rho = std::sqrt(p.x * p.x + p.z * p.z);
        const Real y2_r2 = (p.y - minor_) * (p.y + minor_);
        const Real inner = (rho - major_) * (rho - major_) + y2_r2;
        const Real outer = (rho + major_) * (rho + major_) + y2_r2;
        return {u, {inner * outer, slope(u).f}};
    }
    /// F', and F'' as its derivative.
    Value slope(Real u) const { return {(4 * u * u + 2 * c2_) * u + c1_, 12 * u * u + 2 * c2_}; }

    /// Where F' has its extrema: F'' = 0.
    std::optional<Real> inflection() const { return c2_ < 0 ? std::optional(std::sqrt(-c2_ / 6)) : std::nullopt; }

    /// The part of the ray from `begin` on that is near enough to matter: in a ball and between two planes, a little larger
    /// than they must be. Empty when it runs through the hole.
    Interval near_part(Real begin) const {
        const Real outer = (major_ + minor_) * Real(1.00001), tube = minor_ * Real(1.00001);
        const Real half2 = outer * outer - dot(o_, o_);
        if (!(half2 > 0)) return {0, 0};
        Real low = -std::sqrt(half2), high = -low;
        if (d_.y != 0) {
            const Real first = (-tube - o_.y) / d_.y, second = (tube - o_.y) / d_.y;
            low = std::max(low, std::min(first, second));
            high = std::min(high, std::max(first, second));
        } else if (!(std::abs(o_.y) <= tube)) {
            return {0, 0};
        }
        // Between these planes a ray that is in the hole at both of its ends stays in it.
        const Real hole = (major_ - minor_) * Real(0.99999);
        if (hole > 0 && from_axis2(low) < hole * hole && from_axis2(high) < hole * hole) return {0, 0};
        return {std::max(begin, low), high};
    }

private:
    /// The squared distance from the axis.
    Real from_axis2(Real u) const {
        const Real x = o_.x + u * d_.x, z = o_.z + u * d_.z;
        return x * x + z * z;
    }

    Real major_, minor_;
    Vec3 o_, d_;
    Real c2_, c1_;
};

/// Looks for roots of F piece by piece, in ascending order. Between its inflections F bends to one side only.
class RootSearch {
public:
    /// `slack` is more than rounding does to F. A root at `start` itself counts as just before it.
    RootSearch(const TorusOnRay& on_ray, Real start, Real slack)
        : on_ray_(on_ray), left_(on_ray.sample(start)), slack_(slack) {
        negative_ = left_.value.f != 0 ? left_.value.f < 0 : left_.value.slope < 0;
    }

    /// Goes on to `end`, the next inflection or the end of the range, and calls found(u) for the roots until it says
    /// true.
    template <class Visitor>
    bool up_to(Real end, Visitor found) {
        const Sample right = on_ray_.sample(end);
        if (may_turn_across_zero(right)) {
            const auto slope = [this](Real u) { return on_ray_.slope(u); };
            const Real middle = left_.u + (right.u - left_.u) / 2;
            const bool rising = left_.value.slope < 0;
            const Sample extremum = on_ray_.sample(bracketed_root(slope, left_.u, right.u, middle, rising));
            if (cross(extremum, found)) return true;
        }
        return cross(right, found);
    }

private:
    /// Both ends lie on one side of zero and F turns between them: it may have been on the other side meanwhile. It
    /// stays on its tangents' side, so where these meet short of zero, it was not.
    bool may_turn_across_zero(const Sample& right) const {
        const Value a = left_.value, b = right.value;
        const Real side = negative_ ? -1 : 1;
        const bool turns_back = side * b.f >= 0 && side * a.slope < 0 && side * b.slope > 0;
        if (!turns_back) return false;
        const Real meet = (b.f - b.slope * (right.u - left_.u) - a.f) / (a.slope - b.slope);
        return !(side * (a.f + a.slope * meet) > slack_);
    }

    /// At most one root lies between left and right.
    template <class Visitor>
    bool cross(const Sample& right, Visitor found) {
        const Sample left = std::exchange(left_, right);
        const Real f = right.value.f;
        if (f == 0) {
            negative_ = right.value.slope < 0;
            return found(right.u);
        }
        if ((f < 0) == negative_) return false;
        const auto surface = [this](Real u) { return on_ray_.sample(u).value; };
        const bool rising = std::exchange(negative_, !negative_);
        return found(bracketed_root(surface, left.u, right.u, on_chord(left, right), rising));
    }

    const TorusOnRay& on_ray_;
    Sample left_;
    Real slack_;
    bool negative_ = false;  ///< F just after left
};

}  // namespace
//< hidden

std::optional<Root> intersect(const Torus& torus, const Ray& ray, Interval range) {
    //> 1.10 The roots of F(p) = (|p|^2 + R^2 - r^2)^2 - 4 R^2 (x^2 + z^2). Bracket them: the roots of F'' part the
    //>   range into pieces where F' is monotone, the roots of F' into pieces where F is. Two roots close together
    //>   must both be found, and no root must be found twice.
    if (torus.major == 0) return intersect(Sphere{Vec3(0), torus.minor}, ray, range);  // F is a square: no sign changes
    const Real length = glm::length(ray.direction);
    const Real shift = -dot(ray.origin, ray.direction) / (length * length);
    const TorusOnRay on_ray(torus, ray.at(shift), ray.direction / length);
    const Interval near = on_ray.near_part((range.min - shift) * length);
    if (!(near.min < std::min(near.max, (range.max - shift) * length))) return std::nullopt;

    // Brackets do not end where the range does: what was found before must not move the last bits of a root.
    const Real size = torus.major + torus.minor;
    RootSearch search(on_ray, near.min, Real(1e6) * kEpsilon * size * size * size * size);
    std::optional<Root> first;
    const auto found = [&](Real u) {
        const Root root{shift + u / length};
        if (range.contains(root.t)) first = root;
        return root.t >= range.max || first.has_value();
    };
    if (const auto w = on_ray.inflection())
        for (const Real u : {-*w, *w})
            if (near.contains(u) && search.up_to(u, found)) return first;
    search.up_to(near.max, found);
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
