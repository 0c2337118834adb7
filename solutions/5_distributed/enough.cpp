// How much is enough: for a pixel, and for a scene.
#include <algorithm>
#include <cmath>
#include <limits>

#include "5_distributed/distributed.h"
#include "core/unfinished.h"

namespace rays {

// ---- Task 5.11: enough? ---------------------------------------------------------------------------------------------

float standard_error(const Estimate& estimate) {
    //> 5.11 The variance of the groups' means (divided by one less than their number: their own mean is an estimate, too)
    //>   over their number is that of the mean. Fewer samples than groups: nothing is known, the error is infinite.
    if (estimate.samples < Estimate::kGroups) return std::numeric_limits<float>::infinity();
    const float each = static_cast<float>(estimate.samples) / Estimate::kGroups;
    const Radiance mean = estimate.mean();
    float largest = 0;
    for (int lane = 0; lane < 4; ++lane) {
        float squares = 0;
        for (const Radiance& sum : estimate.sum) {
            const float off = sum[lane] / each - mean[lane];
            squares += off * off;
        }
        largest = std::max(largest, squares);
    }
    return std::sqrt(largest / (Estimate::kGroups * (Estimate::kGroups - 1)));
    //< 5.11
}

bool is_enough(float own, std::span<const float> around, float wanted) {
    //> 5.11 Its own error is small enough, and those around it are not more than four times that.
    return own <= wanted && std::all_of(around.begin(), around.end(), [&](float error) { return error <= 4 * wanted; });
    //< 5.11
}

// ---- Task 5.12: dimensions ------------------------------------------------------------------------------------------

std::uint32_t dimension_of(Purpose purpose, std::uint32_t number, const Purposes& scene) {
    //> 5.12 The pixel is 0. Then the lens, if there is one; each light's point; the time; a second dimension for each light,
    //>   which only balls need; and all above are for rough surfaces, of which nobody knows how many there will be.
    const std::uint32_t lights = scene.lens ? 2 : 1, time = lights + scene.lights, balls = time + 1;
    switch (purpose) {
        case Purpose::pixel: return 0;
        case Purpose::lens: return 1;
        case Purpose::light: return lights + number;
        case Purpose::time: return time;
        case Purpose::ball_light: return balls + number;
        case Purpose::rough_surface: return balls + scene.lights + number;
    }
    return 0;
    //< 5.12
}

// ---- Task 5.13: no more than a scene needs --------------------------------------------------------------------------

Real largest_blur_px(const Camera& camera, const Raster& raster, Real nearest, Real farthest) {
    //> 5.13 A point at depth z blurs over the lens's width times |z - f| / z in the plane of focus at f, where a pixel is f / d
    //>   times as wide as on the film at distance d. It grows towards both ends: the larger one counts.
    if (!(camera.aperture > 0)) return 0;
    const Vec3 axis = glm::normalize(glm::cross(camera.right, camera.up));
    const Real in_focus = std::abs(glm::dot(camera.focal_point - camera.location, axis));
    const Real film = std::abs(glm::dot(camera.direction, axis));
    const Real scale = camera.kind == Camera::Kind::orthographic ? 1 : in_focus / film;
    const Real pixel = scale * std::min(glm::length(camera.right) / raster.width, glm::length(camera.up) / raster.height);
    const auto blur = [&](Real depth) { return std::abs(1 - in_focus / depth); };
    return camera.aperture / 2 * std::max(blur(std::max(nearest, std::numeric_limits<Real>::min())), blur(farthest)) / pixel;
    //< 5.13
}

Real widest_penumbra(Real light_diameter, Real light_to_edge, Real edge_to_receiver) {
    //> 5.13 Similar triangles at the edge.
    return light_diameter * edge_to_receiver / light_to_edge;
    //< 5.13
}

}  // namespace rays
