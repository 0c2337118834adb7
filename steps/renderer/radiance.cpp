#include "renderer/radiance.h"

#include "1_ray_casting/ray_casting.h"

namespace rays {

Inside media_around(const Scene& scene, const Vec3& point) {
    Inside media;
    for (std::uint32_t i = 0; i < scene.objects.size(); ++i)
        if (inside(scene, scene.objects[i], point)) media.enter(medium_of(scene, i));
    return media;
}

Radiance radiance(World& world, Ray ray, const Inside& inside) {
    Branch branch;
    branch.ray = {ray.origin, glm::normalize(ray.direction)};
    branch.inside = inside;
    return trace(world, branch);
}

}  // namespace rays
