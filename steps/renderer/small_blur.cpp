// Blur that nobody would see is not modelled: what step 5's bounds say about a whole scene.
#include <algorithm>
#include <cmath>
#include <optional>

#include "5_distributed/distributed.h"
#include "core/unfinished.h"
#include "renderer/needs.h"

namespace rays {
namespace {

constexpr Real kSmallPx = Real(0.5);
/// An area light is seen under this angle at most, times the root of the largest highlight's exponent, to light like a
/// point: cosines and highlights then change by less than a thousandth.
constexpr Real kSmallAngle = Real(0.05);

/// Boxes around everything; nothing when something has no bounds.
std::optional<std::vector<Bounds>> all_bounds(const Scene& scene) {
    std::vector<Bounds> all;
    for (const Primitive primitive : primitives_of(scene)) {
        all.push_back(bounds_of(scene, primitive));
        if (!all.back().is_finite()) return std::nullopt;
    }
    return all;
}

Real distance(const Vec3& point, const Bounds& box) {
    return glm::length(glm::max(Vec3(0), glm::max(box.min - point, point - box.max)));
}

/// The smallest and largest depth of the boxes' corners along the camera's axis; not below 0.
struct Depths {
    Real nearest = kInfinity, farthest = 0;
};
Depths depths_of(const Camera& camera, const std::vector<Bounds>& boxes) {
    const Vec3 across = glm::normalize(glm::cross(camera.right, camera.up));
    const Vec3 axis = glm::dot(across, camera.direction) < 0 ? -across : across;
    Depths depths;
    for (const Bounds& box : boxes) {
        const Vec3 center = Real(0.5) * (box.min + box.max);
        const Real middle = glm::dot(center - camera.location, axis);
        const Real reach = glm::dot(box.max - center, glm::abs(axis));
        depths.nearest = std::min(depths.nearest, std::max(Real(0), middle - reach));
        depths.farthest = std::max(depths.farthest, middle + reach);
    }
    return depths;
}

/// The width of a pixel at a distance of 1, or anywhere for an orthographic camera.
Real pixel_width(const Camera& camera, const Raster& raster) {
    return std::min(glm::length(camera.right) / raster.width, glm::length(camera.up) / raster.height) /
           (camera.kind == Camera::Kind::orthographic ? 1 : glm::length(camera.direction));
}

Real largest_exponent(const Scene& scene) {
    Real largest = 1;
    for (const Material& m : scene.materials) {
        if (m.finish.phong != 0) largest = std::max(largest, Real(m.finish.phong_size));
        if (m.finish.specular != 0) largest = std::max(largest, 1 / Real(m.finish.roughness));
    }
    return largest;
}

bool lights_like_a_point(const Scene& scene, const Light& light, const std::vector<Bounds>& boxes, Real pixel) {
    const Real diameter = glm::length(light.axis_u) + glm::length(light.axis_v);
    Real nearest = kInfinity;
    Bounds whole;
    for (const Bounds& box : boxes) {
        nearest = std::min(nearest, distance(light.location, box) - diameter / 2);
        whole.add(box);
    }
    if (!(diameter * std::sqrt(largest_exponent(scene)) <= kSmallAngle * nearest)) return false;
    return widest_penumbra(diameter, nearest, glm::length(whole.max - whole.min)) <= kSmallPx * pixel;
}

}  // namespace

void drop_small_blur(Scene& scene, Raster raster) {
    const bool has_area = std::any_of(scene.lights.begin(), scene.lights.end(), [](const Light& l) { return l.area; });
    if (!scene.varying.empty() || (!has_area && !(scene.camera.aperture > 0))) return;
    for (Light& light : scene.lights)
        if (light.area && glm::length(light.axis_u) == 0 && glm::length(light.axis_v) == 0) light.area = false;
    const auto boxes = all_bounds(scene);
    if (boxes && !boxes->empty()) {
        const Depths depths = depths_of(scene.camera, *boxes);
        if (largest_blur_px(scene.camera, raster, depths.nearest, depths.farthest) <= kSmallPx)
            scene.camera.aperture = 0;
        // Mirrors and glass enlarge: only what is seen directly has a known size.
        const bool enlarges = std::any_of(scene.materials.begin(), scene.materials.end(), [](const Material& m) {
            return !m.finish.reflection.max.is_black() || lets_light_through(m.pigment);
        });
        const Real near = scene.camera.kind == Camera::Kind::orthographic ? 1 : depths.nearest;
        for (Light& light : scene.lights)
            if (light.area && !enlarges &&
                lights_like_a_point(scene, light, *boxes, near * pixel_width(scene.camera, raster)))
                light.area = false;
    }
    take_unfinished_task();
}

}  // namespace rays
