#include "renderer/radiance.h"

#include "1_ray_casting/ray_casting.h"
#include "4_partitioning/partitioning.h"

namespace rays {
namespace {

/// POV-Ray asks an object's box first, and an inverse one has the box of what it is the outside of.
bool may_surround(const Scene& scene, std::uint32_t object, const Vec3& point) {
    return !scene.objects[object].inverse || bounds_of(scene, {object, 0}).overlaps({point, point});
}

}  // namespace

Inside media_around(const Scene& scene, const Vec3& point) {
    Inside media;
    for (std::uint32_t i = 0; i < scene.objects.size(); ++i)
        if (inside(scene, scene.objects[i], point) && may_surround(scene, i, point)) media.enter(medium_of(scene, i));
    return media;
}

Radiance radiance(World& world, Ray ray, const Inside& inside) {
    Branch branch;
    branch.ray = {ray.origin, glm::normalize(ray.direction)};
    branch.inside = inside;
    return trace(world, branch);
}

}  // namespace rays
