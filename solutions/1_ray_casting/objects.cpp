// Objects of a scene: transforms, bounds, clips, and the nearest of all.
#include <algorithm>
#include <cmath>
#include <utility>

#include "1_ray_casting/ray_casting.h"
#include "core/unfinished.h"

namespace rays {

using glm::dot;

Ray ray_to_local(const Transform& transform, const Ray& ray) {
    //> 1.12 A point takes the offset, a direction does not. Do not normalise: t must stay what it is.
    return {transform.point_to_local(ray.origin), transform.vector_to_local(ray.direction)};
    //< 1.12
}

Vec3 normal_to_world(const Transform& transform, const Vec3& normal) {
    //> 1.12 By the transpose of the inverse: what is orthogonal to all tangents must stay so.
    return glm::transpose(transform.inverse_linear) * normal;
    //< 1.12
}

BoundingSphere bounding_sphere(std::span<const Vec3> points) {
    //> 1.13 Any ball with all points in it, the smaller the better; a negative radius for no points. Round up.
    if (points.empty()) return {};
    Vec3 low = points[0], high = points[0];
    for (const Vec3& p : points) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    const Vec3 center = Real(0.5) * (low + high);
    Real radius2 = 0;
    for (const Vec3& p : points) radius2 = std::max(radius2, dot(p - center, p - center));
    const Real rounding = 8 * std::numeric_limits<Real>::epsilon();
    return {center, std::sqrt(radius2) * (1 + rounding) + glm::length(center) * rounding};
    //< 1.13
}

bool misses(const BoundingSphere& bound, const Ray& ray, Interval range) {
    //> 1.13 Compare the distance between centre and the nearest point of the ray within the range with the radius.
    //>   Rounding must err on the side of false; a ray that starts inside does not miss.
    if (bound.radius < 0) return false;
    const Vec3 to_center = bound.center - ray.origin;
    const Real nearest = dot(to_center, ray.direction) / dot(ray.direction, ray.direction);
    const Vec3 l = to_center - std::clamp(nearest, range.min, range.max) * ray.direction;
    // l is off by up to e = 8 eps |to_center|. For every s > 0: (radius + e)^2 <= (1 + s) radius^2 + (1 + 1 / s) e^2.
    constexpr Real eps = std::numeric_limits<Real>::epsilon();
    const Real s = std::sqrt(eps), e2 = 64 * eps * eps * dot(to_center, to_center);
    return dot(l, l) > (1 + s) * bound.radius * bound.radius + (1 + 1 / s) * e2;
    //< 1.13
}

//> given
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
//< given

//> hidden
namespace {

// Inside of each kind of shape, as POV-Ray says. Points of the surface go either way.
bool contains(const Sphere& s, const Vec3& p) { return dot(p - s.center, p - s.center) < s.radius * s.radius; }
bool contains(const Plane& s, const Vec3& p) { return dot(s.normal, p) < s.offset; }
bool contains(const Disc& s, const Vec3& p) { return dot(s.normal, p - s.center) < 0; }  // the half space behind it
bool contains(const Quadric& s, const Vec3& p) { return dot(Vec4(p, 1), s.q * Vec4(p, 1)) <= 0; }
bool contains(const Box& s, const Vec3& p) {
    return glm::all(glm::greaterThanEqual(p, s.min)) && glm::all(glm::lessThanEqual(p, s.max));
}
bool contains(const Cone& s, const Vec3& p) {
    const Vec3 axis = s.cap - s.base, from_base = p - s.base;
    const Real height = dot(from_base, axis) / dot(axis, axis);
    const Vec3 from_axis = from_base - height * axis;
    const Real radius = s.base_radius + height * (s.cap_radius - s.base_radius);
    return height >= 0 && height <= 1 && dot(from_axis, from_axis) <= radius * radius;
}
bool contains(const Torus& s, const Vec3& p) {
    const Real from_circle = std::hypot(p.x, p.z) - s.major;
    return from_circle * from_circle + p.y * p.y <= s.minor * s.minor;
}

bool is_flat(ShapeKind kind) {
    return kind == ShapeKind::triangle || kind == ShapeKind::smooth_triangle || kind == ShapeKind::polygon ||
           kind == ShapeKind::mesh || kind == ShapeKind::bicubic_patch;
}

bool inside_all(const Scene& scene, const ClipList& clips, const Vec3& point) {
    return std::all_of(clips.begin(), clips.end(), [&](const Object& clip) { return inside(scene, clip, point); });
}

}  // namespace
//< hidden

bool inside(const Scene& scene, const Object& object, const Vec3& point) {
    //> 1.15 In the shape's own space; `inverse` exchanges inside and outside. POV-Ray says: triangles, polygons,
    //>   meshes and patches have no inside, inverse or not; that of a disc is the half space behind it; a clip of the
    //>   object must contain the point as well.
    if (is_flat(object.kind)) return false;
    if (object.clip != kNone && !inside_all(scene, scene.clips[object.clip], point)) return false;
    const Vec3 p = object.transform == kNone ? point : scene.transforms[object.transform].point_to_local(point);
    const bool in_shape = with_shape(scene, object, [&](const auto& shape) {
        if constexpr (requires { contains(shape, p); }) return contains(shape, p);
        else return false;
    });
    return in_shape != object.inverse;
    //< 1.15
}

namespace {

/// The smallest root, in the range and inside of all clips. Clips stand in world space.
template <class NextRoot>
std::optional<Root> first_unclipped(const Scene& scene, const ClipList& clips, const Ray& ray, Interval range,
                                    NextRoot next_root) {
    //> 1.15 next_root(range) gives the smallest root in a range. When it is clipped away, ask again behind it.
    // Every root lies behind the last, so this ends; the limit is for shapes that give a root again, ulp by ulp.
    for (int i = 0; i < 1000; ++i) {
        const std::optional<Root> root = next_root(range);
        if (!root || inside_all(scene, clips, ray.at(root->t))) return root;
        range.min = root->t;
    }
    return std::nullopt;
    //< 1.15
}

}  // namespace

//> given
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
//< given

std::optional<Hit> nearest_hit(const Scene& scene, const Ray& ray, Interval range) {
    //> 1.15 Ask every object, and keep the smallest t: a hit so far shortens the range for all that follow.
    std::optional<Root> nearest;
    std::uint32_t object = 0;
    for (std::uint32_t i = 0; i < scene.objects.size(); ++i) {
        if (const auto root = intersect(scene, scene.objects[i], ray, range)) {
            range.max = root->t;
            nearest = root;
            object = i;
        }
    }
    return nearest ? std::optional(complete_hit(scene, object, ray, *nearest)) : std::nullopt;
    //< 1.15
}

}  // namespace rays
