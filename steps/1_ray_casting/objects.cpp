// Objects of a scene: transforms, bounds, clips, and the nearest of all.
#include <algorithm>
#include <cmath>
#include <utility>

#include "1_ray_casting/ray_casting.h"
#include "core/unfinished.h"

namespace rays {

using glm::dot;

Ray ray_to_local(const Transform& transform, const Ray& ray) {
    // Task 1.12: A point takes the offset, a direction does not. Do not normalise: t must stay what it is.
    unfinished("1.12");
    return {};
}

Vec3 normal_to_world(const Transform& transform, const Vec3& normal) {
    // Task 1.12: By the transpose of the inverse: what is orthogonal to all tangents must stay so.
    unfinished("1.12");
    return {};
}

BoundingSphere bounding_sphere(std::span<const Vec3> points) {
    // Task 1.13: Any ball with all points in it, the smaller the better; a negative radius for no points. Round up.
    unfinished("1.13");
    return {};
}

bool misses(const BoundingSphere& bound, const Ray& ray, Interval range) {
    // Task 1.13: Compare the distance between centre and the nearest point of the ray within the range with the radius.
    // Rounding must err on the side of false; a ray that starts inside does not miss.
    unfinished("1.13");
    return {};
}

namespace {

std::uint32_t material_of(const Scene& scene, const Object& object, const Root& root) {
    if (object.kind != ShapeKind::mesh) return object.material;
    const std::uint32_t own = scene.meshes[object.shape].faces[root.part].material;
    return own == Mesh::kObjectMaterial ? object.material : own;
}

/// Calls what(shape) with the object's shape, in its own type.
template <class What>
auto with_shape(const Scene& scene, const Object& object, What what) {
    switch (object.kind) {
        case ShapeKind::sphere: return what(scene.spheres[object.shape]);
        case ShapeKind::plane: return what(scene.planes[object.shape]);
        case ShapeKind::triangle: return what(scene.triangles[object.shape]);
        case ShapeKind::smooth_triangle: return what(scene.smooth_triangles[object.shape]);
        case ShapeKind::polygon: return what(scene.polygons[object.shape]);
        case ShapeKind::mesh: return what(scene.meshes[object.shape]);
        case ShapeKind::box: return what(scene.boxes[object.shape]);
        case ShapeKind::disc: return what(scene.discs[object.shape]);
        case ShapeKind::cone: return what(scene.cones[object.shape]);
        case ShapeKind::quadric: return what(scene.quadrics[object.shape]);
        case ShapeKind::torus: return what(scene.tori[object.shape]);
        case ShapeKind::bicubic_patch: break;
    }
    return what(scene.patches[object.shape]);
}

}  // namespace

bool inside(const Scene& scene, const Object& object, const Vec3& point) {
    // Task 1.15: In the shape's own space; `inverse` exchanges inside and outside. POV-Ray says: triangles, polygons,
    // meshes and patches have no inside, inverse or not; that of a disc is the half space behind it; a clip of the
    // object must contain the point as well.
    unfinished("1.15");
    return {};
}

namespace {

/// The smallest root, in the range and inside of all clips. Clips stand in world space.
template <class NextRoot>
std::optional<Root> first_unclipped(const Scene& scene, const ClipList& clips, const Ray& ray, Interval range,
                                    NextRoot next_root) {
    // Task 1.15: next_root(range) gives the smallest root in a range. When it is clipped away, ask again behind it.
    unfinished("1.15");
    return {};
}

}  // namespace

namespace {

/// In the object's own space, and not where a clip cuts it away. intersect_shape(shape, local ray, range) finds roots.
template <class IntersectShape>
std::optional<Root> intersect_placed(const Scene& scene, const Object& object, const Ray& ray, Interval range,
                                     const IntersectShape& intersect_shape) {
    std::optional<Ray> moved;
    if (object.transform != kNone) moved = ray_to_local(scene.transforms[object.transform], ray);
    const Ray& local = moved ? *moved : ray;
    return with_shape(scene, object, [&](const auto& shape) -> std::optional<Root> {
        if (object.clip == kNone) return intersect_shape(shape, local, range);
        return first_unclipped(scene, scene.clips[object.clip], ray, range,
                               [&](Interval rest) { return intersect_shape(shape, local, rest); });
    });
}

}  // namespace

std::optional<Root> intersect(const Scene& scene, const Object& object, const Ray& ray, Interval range) {
    return intersect_placed(scene, object, ray, range, [](const auto& shape, const Ray& local, Interval rest) {
        return intersect(shape, local, rest);
    });
}

std::optional<Root> intersect_part(const Scene& scene, const Object& object, std::uint32_t part, const Ray& ray,
                                   Interval range) {
    return intersect_placed(scene, object, ray, range, [&](const auto& shape, const Ray& local, Interval rest) {
        if constexpr (requires { shape.faces; }) return intersect(shape, part, local, rest);
        else return intersect(shape, local, rest);
    });
}

Hit complete_hit(const Scene& scene, std::uint32_t object_index, const Ray& ray, const Root& root) {
    const Object& object = scene.objects[object_index];
    const Transform* transform = object.transform == kNone ? nullptr : &scene.transforms[object.transform];
    const auto to_world = [&](const Vec3& n) { return unit(transform ? normal_to_world(*transform, n) : n); };

    Hit hit{root.t, ray.at(root.t)};
    hit.object = object_index;
    hit.material = material_of(scene, object, root);
    const Vec3 point = transform ? transform->point_to_local(hit.point) : hit.point;
    with_shape(scene, object, [&](const auto& shape) {
        hit.shading_normal = hit.normal = to_world(normal(shape, point, root));
        if constexpr (requires { shading_normal(shape, root); })
            hit.shading_normal = to_world(shading_normal(shape, root));
    });
    return hit;
}

std::optional<Hit> nearest_hit(const Scene& scene, const Ray& ray, Interval range) {
    // Task 1.15: Ask every object, and keep the smallest t: a hit so far shortens the range for all that follow.
    unfinished("1.15");
    return {};
}

}  // namespace rays
