// What random points mean: on a lens, on a light, in time, on a rough surface, in a pixel.
#include <algorithm>
#include <array>
#include <cmath>

#include "1_ray_casting/ray_casting.h"
#include "5_distributed/distributed.h"
#include "core/unfinished.h"

namespace rays {

using glm::dot;

// ---- Task 5.5: shapes -----------------------------------------------------------------------------------------------

Vec2 disc_point(Vec2 u) {
    //> 5.5 Squares around the centre become circles around it: with a, b in [-1, 1], the larger of the two (by amount) is the
    //>   radius, the other over it an eighth of the circle.
    const Real a = 2 * u.x - 1, b = 2 * u.y - 1;
    if (a == 0 && b == 0) return {0, 0};
    const bool beside = std::abs(a) > std::abs(b);
    const Real radius = beside ? a : b;
    const Real angle = beside ? kPi / 4 * (b / a) : kPi / 2 - kPi / 4 * (a / b);
    return {radius * std::cos(angle), radius * std::sin(angle)};
    //< 5.5
}

Vec2 polygon_point(Vec2 u, int corners) {
    //> 5.5 Cut it into triangles from the centre to each side. u.x says which one, and what is left of it, how far out: the
    //>   square root of it, since area grows with the square; u.y where between the two corners.
    const Real at = u.x * Real(corners);
    const Real side = std::min(std::floor(at), Real(corners - 1));
    const auto corner = [&](Real number) {
        const Real angle = 2 * kPi * number / Real(corners);
        return Vec2(std::sin(angle), std::cos(angle));
    };
    return std::sqrt(at - side) * glm::mix(corner(side), corner(side + 1), u.y);
    //< 5.5
}

Vec3 ball_point(Vec2 u, Real u3) {
    //> 5.5 sqrt(1 - u.x) (sin 2 pi u.y, cos 2 pi u.y), sqrt(u.x) sin 2 pi u3.
    const Real around = 2 * kPi * u.y;
    const Real across = std::sqrt(1 - u.x);
    return {across * std::sin(around), across * std::cos(around), std::sqrt(u.x) * std::sin(2 * kPi * u3)};
    //< 5.5
}

// ---- Task 5.6: filters ----------------------------------------------------------------------------------------------

//> hidden
namespace {

/// Mitchell and Netravali's filter (1988), B = C = 1/3, and the integral of its amount from 0 on.
class Mitchell {
public:
    static Real value(Real x) {
        x = std::abs(x);
        if (x < 1) return (21 * x * x * x - 36 * x * x + 16) / 18;
        if (x < 2) return (-7 * x * x * x + 36 * x * x - 60 * x + 32) / 18;
        return 0;
    }
    /// Of |value|, over [0, 2]; what is left of it without the amount is 1/2.
    static Real whole() { return area(2); }

    /// The x >= 0 up to which there is this much of `whole`.
    static Real where(Real part) {
        Real low = 0, high = 2;
        for (int i = 0; i < 50; ++i) {
            const Real middle = (low + high) / 2;
            (area(middle) < part ? low : high) = middle;
        }
        return (low + high) / 2;
    }

private:
    static constexpr Real kZero = Real(8) / 7;  ///< 7 x^3 - 36 x^2 + 60 x - 32 = (x - 2)^2 (7 x - 8)

    static Real inner(Real x) { return (Real(21) / 4 * x * x * x * x - 12 * x * x * x + 16 * x) / 18; }
    static Real outer(Real x) { return (-Real(7) / 4 * x * x * x * x + 12 * x * x * x - 30 * x * x + 32 * x) / 18; }
    static Real area(Real x) {
        if (x < 1) return inner(x);
        const Real up_to_1 = inner(1) - outer(1);
        if (x < kZero) return up_to_1 + outer(x);
        return up_to_1 + 2 * outer(kZero) - outer(x);
    }
};

/// One axis of a filter.
struct Along {
    Real offset;
    Real weight;
};

Along tent(Real u) { return {u < Real(0.5) ? std::sqrt(2 * u) - 1 : 1 - std::sqrt(2 - 2 * u), 1}; }

Along mitchell(Real u) {
    const Real side = u < Real(0.5) ? -1 : 1, part = std::abs(2 * u - 1);
    const Real x = Mitchell::where(part * Mitchell::whole());
    return {side * x, (Mitchell::value(x) < 0 ? -2 : 2) * Mitchell::whole()};
}

}  // namespace
//< hidden

//> given
std::optional<Filter> filter_named(std::string_view name) {
    constexpr std::array<std::string_view, 3> kNames{"box", "tent", "mitchell"};
    const auto found = std::find(kNames.begin(), kNames.end(), name);
    if (found == kNames.end()) return std::nullopt;
    return static_cast<Filter>(found - kNames.begin());
}
//< given

FilterPoint filter_point(Filter filter, Vec2 u) {
    //> 5.6 Both axes alike. box: u - 1/2. tent: invert the integral of 1 - |x|. mitchell: invert the integral of |f| (by halving
    //>   an interval: it grows all the way); the weight of an axis is the sign of f times the integral of |f| over that of f.
    if (filter == Filter::box) return {u - Real(0.5), 1};
    const auto along = filter == Filter::tent ? tent : mitchell;
    const Along x = along(u.x), y = along(u.y);
    return {{x.offset, y.offset}, static_cast<float>(x.weight * y.weight)};
    //< 5.6
}

// ---- Task 5.7: the lens ---------------------------------------------------------------------------------------------

Ray lens_ray(const Camera& camera, const Raster& raster, int column, int row, Vec2 offset, Vec2 u) {
    //> 5.7 Where does the pinhole's ray meet the plane in focus? From a point of the lens, go there.
    const Ray pinhole = camera_ray(camera, raster, column, row, offset);
    if (!(camera.aperture > 0)) return pinhole;
    const Vec3 axis = glm::cross(camera.right, camera.up);
    const Vec3 in_focus = pinhole.at(dot(camera.focal_point - pinhole.origin, axis) / dot(pinhole.direction, axis));
    const Vec2 point = camera.aperture / 4 *
                       (camera.aperture_blades > 0 ? polygon_point(u, camera.aperture_blades) : disc_point(u));
    const Vec3 on_lens = pinhole.origin + point.x * glm::normalize(camera.right) + point.y * glm::normalize(camera.up);
    return {on_lens, in_focus - on_lens};
    //< 5.7
}

// ---- Task 5.8: lights -----------------------------------------------------------------------------------------------

Light light_at(const Light& light, Vec2 u, Real u3) {
    //> 5.8 Move it.
    if (!light.area) return light;
    Vec3 move;
    if (light.orient) {
        move = glm::length(light.axis_u) / 2 * ball_point(u, u3);
    } else {
        const Vec2 at = light.circular ? Real(0.5) * disc_point(u) : u - Real(0.5);
        move = at.x * light.axis_u + at.y * light.axis_v;
    }
    Light point = light;
    point.area = false;
    point.location += move;
    point.point_at += move;
    return point;
    //< 5.8
}

// ---- Task 5.9: time -------------------------------------------------------------------------------------------------

Real shutter_time(const Camera& camera, Real u) {
    //> 5.9 From open to close, evenly.
    return camera.shutter_open + u * (camera.shutter_close - camera.shutter_open);
    //< 5.9
}

Real value_at(const Varying& varying, Real at) {
    //> 5.9 Which two samples is it between, and how far from one to the other? There are samples.size() - 1 steps from
    //>   `first` to `last`.
    const auto steps = static_cast<Real>(varying.samples.size() - 1);
    const Real place = std::clamp((at - varying.first) / (varying.last - varying.first) * steps, Real(0), steps);
    const auto before = std::min(static_cast<std::size_t>(place), varying.samples.size() - 1);
    const std::size_t after = std::min(before + 1, varying.samples.size() - 1);
    return glm::mix(varying.samples[before], varying.samples[after], place - Real(before));
    //< 5.9
}

// ---- Task 5.10: rough surfaces --------------------------------------------------------------------------------------

//> hidden
namespace {

/// Two unit vectors that are orthogonal to each other and to n (Duff et al., "Building an Orthonormal Basis,
/// Revisited", JCGT 6(1), 2017).
std::array<Vec3, 2> across(const Vec3& n) {
    const Real sign = std::copysign(Real(1), n.z);
    const Real a = -1 / (sign + n.z), b = n.x * n.y * a;
    return {Vec3(1 + sign * n.x * n.x * a, sign * b, -sign * n.x), Vec3(b, sign + n.y * n.y * a, -n.y)};
}

}  // namespace
//< hidden

Vec3 tilted_normal(const Surface& surface, Vec2 u) {
    //> 5.10 Tilt by the angle, to the side 2 pi u.y. Turned from the viewer: take the other side. Mirror ray below the true
    //>   surface: mirror it there, and return the normal that makes it, halfway between it and the viewer.
    const Real exponent = 1 / Real(surface.finish->glossy);
    const Real cosine = std::pow(1 - u.x, 1 / (exponent + 2));
    const Real sine = std::sqrt(std::max(Real(0), 1 - cosine * cosine)), side = 2 * kPi * u.y;
    const auto [a, b] = across(surface.normal);
    const Vec3 along = cosine * surface.normal, beside = sine * (std::cos(side) * a + std::sin(side) * b);
    const Vec3& viewer = surface.to_viewer;
    const Vec3 tilted = dot(along + beside, viewer) > 0 ? along + beside : along - beside;
    const Vec3 mirrored = 2 * dot(tilted, viewer) * tilted - viewer;
    const Real above = dot(mirrored, surface.geometric_normal);
    if (above >= 0) return glm::normalize(tilted);
    return glm::normalize(mirrored - 2 * above * surface.geometric_normal + viewer);
    //< 5.10
}

}  // namespace rays
