#include "renderer/radiance.h"

#include "2_phong/phong.h"

namespace rays {
namespace {

Surface surface_at(const Scene& scene, const Hit& hit, const Vec3& to_viewer) {
    const Material& material = scene.materials[hit.material];
    Surface surface;
    surface.point = hit.point;
    surface.geometric_normal = facing(hit.normal, to_viewer);
    // As POV-Ray does, an interpolated normal is turned by its own side, not by that of the true surface: along
    // silhouettes the two differ.
    surface.normal = facing(hit.shading_normal, to_viewer);
    surface.to_viewer = to_viewer;
    const Color color = pigment_at(scene, material.pigment, hit.point);
    surface.color = color.rgb;
    surface.opacity = 1 - color.filter - color.transmit;
    surface.finish = &material.finish;
    return surface;
}

}  // namespace

Radiance radiance(const Scene& scene, const Intersector& intersector, Ray ray) {
    ray.direction = glm::normalize(ray.direction);
    const auto hit = intersector.nearest(ray, {0, kFarthest});
    const Radiance result =
        hit ? direct_light(scene, intersector, surface_at(scene, *hit, -ray.direction)) : scene.background;
    if (query_log) [[unlikely]]
        query_log->queries.front().radiance = result;
    return result;
}

}  // namespace rays
