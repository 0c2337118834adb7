#include "renderer/radiance.h"

#include "2_phong/phong.h"

namespace rays {
namespace {

Surface surface_at(const Scene& scene, const Hit& hit, const Vec3& to_viewer) {
    const Material& material = scene.materials[hit.material];
    Surface surface;
    surface.point = hit.point;
    surface.geometric_normal = facing(hit.normal, to_viewer);
    // An interpolated normal keeps to the side of the true surface, even where it would look away from the viewer.
    surface.normal = glm::dot(hit.shading_normal, hit.normal) * glm::dot(surface.geometric_normal, hit.normal) < 0
                         ? -hit.shading_normal
                         : hit.shading_normal;
    surface.to_viewer = to_viewer;
    surface.color = pigment_at(scene, material.pigment, hit.point).rgb;
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
