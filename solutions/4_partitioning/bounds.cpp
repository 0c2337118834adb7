// Boxes around primitives.
#include <algorithm>
#include <cmath>

#include "4_partitioning/partitioning.h"
#include "core/unfinished.h"

namespace rays {

//> hidden
namespace {

Bounds around(std::initializer_list<Vec3> points) {
    Bounds bounds;
    for (const Vec3& p : points) bounds.add({p, p});
    return bounds;
}

constexpr Bounds everywhere() { return {Vec3(-kInfinity), Vec3(kInfinity)}; }

/// Of a disc: along each axis it reaches radius * sin(angle between the axis and the normal).
Bounds of_disc(const Vec3& center, const Vec3& unit_normal, Real radius) {
    const Vec3 reach = radius * glm::sqrt(glm::max(Vec3(0), Real(1) - unit_normal * unit_normal));
    return {center - reach, center + reach};
}

Bounds of(const Sphere& s) { return {s.center - s.radius, s.center + s.radius}; }
Bounds of(const Triangle& s) { return around({s.a, s.b, s.c}); }
Bounds of(const SmoothTriangle& s) { return of(s.triangle); }
Bounds of(const Box& s) { return {s.min, s.max}; }
Bounds of(const Disc& s) { return of_disc(s.center, s.normal, s.radius); }
Bounds of(const Torus& s) {
    const Vec3 reach(s.major + s.minor, s.minor, s.major + s.minor);
    return {-reach, reach};
}
Bounds of(const Cone& s) {
    const Vec3 axis = glm::normalize(s.cap - s.base);
    Bounds bounds = of_disc(s.base, axis, s.base_radius);
    bounds.add(of_disc(s.cap, axis, s.cap_radius));
    return bounds;
}
Bounds of(const Polygon& s) {
    Bounds bounds;
    for (const Vec3& p : s.points) bounds.add({p, p});
    return bounds;
}
/// A Bezier patch lies in the convex hull of its control points.
Bounds of(const BicubicPatch& s) {
    Bounds bounds;
    for (const Vec3& p : s.control) bounds.add({p, p});
    return bounds;
}

Bounds of_face(const Mesh& mesh, std::uint32_t face) {
    const auto [a, b, c] = mesh.faces[face].position;
    return around({mesh.positions[a], mesh.positions[b], mesh.positions[c]});
}

Bounds of_shape(const Scene& scene, const Object& object, std::uint32_t part) {
    switch (object.kind) {
        case ShapeKind::sphere: return of(scene.spheres[object.shape]);
        case ShapeKind::triangle: return of(scene.triangles[object.shape]);
        case ShapeKind::smooth_triangle: return of(scene.smooth_triangles[object.shape]);
        case ShapeKind::polygon: return of(scene.polygons[object.shape]);
        case ShapeKind::mesh: return of_face(scene.meshes[object.shape], part);
        case ShapeKind::box: return of(scene.boxes[object.shape]);
        case ShapeKind::disc: return of(scene.discs[object.shape]);
        case ShapeKind::cone: return of(scene.cones[object.shape]);
        case ShapeKind::torus: return of(scene.tori[object.shape]);
        case ShapeKind::bicubic_patch: return of(scene.patches[object.shape]);
        case ShapeKind::plane:
        case ShapeKind::quadric: return everywhere();
    }
    return everywhere();
}

/// The box around a transformed box: each column of the matrix reaches as far as the box is wide (Arvo, "Transforming
/// Axis-Aligned Bounding Boxes", Graphics Gems, 1990).
Bounds transformed(const Transform& transform, const Bounds& bounds) {
    if (!bounds.is_finite()) return everywhere();
    const Vec3 center = transform.point_to_world(Real(0.5) * (bounds.min + bounds.max));
    const Vec3 half = Real(0.5) * (bounds.max - bounds.min);
    Vec3 reach(0);
    for (int i = 0; i < 3; ++i) reach += half[i] * glm::abs(transform.linear[i]);
    return {center - reach, center + reach};
}

Bounds of_placed(const Scene& scene, const Object& object, std::uint32_t part) {
    const Bounds bounds = of_shape(scene, object, part);
    return object.transform == kNone ? bounds : transformed(scene.transforms[object.transform], bounds);
}

/// What a clip leaves can only be inside of it. An inverse clip, a plane or a quadric bounds nothing.
Bounds clipped(const Scene& scene, const Object& object, Bounds bounds) {
    if (object.clip == kNone) return bounds;
    for (const Object& clip : scene.clips[object.clip]) {
        const bool is_solid = clip.kind != ShapeKind::mesh && clip.kind != ShapeKind::disc;
        if (clip.inverse || !is_solid) continue;
        const Bounds inside = of_placed(scene, clip, 0);
        bounds.min = glm::max(bounds.min, inside.min);
        bounds.max = glm::min(bounds.max, inside.max);
    }
    return bounds;
}

/// Roots and corners are rounded; a box must contain them all the same.
Bounds rounded_outwards(const Bounds& bounds) {
    const Real relative = 64 * std::numeric_limits<Real>::epsilon();
    const Vec3 slack = relative * glm::max(glm::abs(bounds.min), glm::abs(bounds.max)) + std::numeric_limits<Real>::min();
    return {bounds.min - slack, bounds.max + slack};
}

}  // namespace
//< hidden

Bounds bounds_of(const Scene& scene, Primitive primitive) {
    //> 4.1 The box of the shape in its own space (of a mesh: of the face), moved by the object's transform, cut down to
    //>   the boxes of its clips.
    const Object& object = scene.objects[primitive.object];
    const Bounds bounds = clipped(scene, object, of_placed(scene, object, primitive.part));
    return bounds.is_finite() ? rounded_outwards(bounds) : everywhere();
    //< 4.1
}

}  // namespace rays
