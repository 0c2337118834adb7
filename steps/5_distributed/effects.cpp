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
    // Task 5.5: Squares around the centre become circles around it: with a, b in [-1, 1], the larger of the two (by amount) is the
    // radius, the other over it an eighth of the circle.
    unfinished("5.5");
    return {};
}

Vec2 polygon_point(Vec2 u, int corners) {
    // Task 5.5: Cut it into triangles from the centre to each side. u.x says which one, and what is left of it, how far out: the
    // square root of it, since area grows with the square; u.y where between the two corners.
    unfinished("5.5");
    return {};
}

Vec3 ball_point(Vec2 u, Real u3) {
    // Task 5.5: sqrt(1 - u.x) (sin 2 pi u.y, cos 2 pi u.y), sqrt(u.x) sin 2 pi u3.
    unfinished("5.5");
    return {};
}

// ---- Task 5.6: filters ----------------------------------------------------------------------------------------------

std::optional<Filter> filter_named(std::string_view name) {
    constexpr std::array<std::string_view, 3> kNames{"box", "tent", "mitchell"};
    const auto found = std::find(kNames.begin(), kNames.end(), name);
    if (found == kNames.end()) return std::nullopt;
    return static_cast<Filter>(found - kNames.begin());
}

FilterPoint filter_point(Filter filter, Vec2 u) {
    // Task 5.6: Both axes alike. box: u - 1/2. tent: invert the integral of 1 - |x|. mitchell: invert the integral of |f| (by halving
    // an interval: it grows all the way); the weight of an axis is the sign of f times the integral of |f| over that of f.
    unfinished("5.6");
    return {};
}

// ---- Task 5.7: the lens ---------------------------------------------------------------------------------------------

Ray lens_ray(const Camera& camera, const Raster& raster, int column, int row, Vec2 offset, Vec2 u) {
    // Task 5.7: Where does the pinhole's ray meet the plane in focus? From a point of the lens, go there.
    unfinished("5.7");
    return {};
}

// ---- Task 5.8: lights -----------------------------------------------------------------------------------------------

Light light_at(const Light& light, Vec2 u, Real u3) {
    // Task 5.8: Move it.
    unfinished("5.8");
    return {};
}

// ---- Task 5.9: time -------------------------------------------------------------------------------------------------

Real shutter_time(const Camera& camera, Real u) {
    // Task 5.9: From open to close, evenly.
    unfinished("5.9");
    return {};
}

Real value_at(const Varying& varying, Real at) {
    // Task 5.9: Which two samples is it between, and how far from one to the other? There are samples.size() - 1 steps from
    // `first` to `last`.
    unfinished("5.9");
    return {};
}

// ---- Task 5.10: rough surfaces --------------------------------------------------------------------------------------

Vec3 tilted_normal(const Surface& surface, Vec2 u) {
    // Task 5.10: Tilt by the angle, to the side 2 pi u.y. Turned from the viewer: take the other side. Mirror ray below the true
    // surface: mirror it there, and return the normal that makes it, halfway between it and the viewer.
    unfinished("5.10");
    return {};
}

}  // namespace rays
