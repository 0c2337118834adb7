// Shapes as they stand in the scene, moved and clipped, for eight rays: tasks 1.12 and 1.15.
#pragma once

#include "packets/shapes.h"

namespace rays::packets {

/// Can eight rays ask this object at once? In a patch each ray goes its own way.
bool has_packet_test(const Scene& scene, const Object& object);

/// The smallest roots in the span that no clip cuts away. Of objects with a packet test; `sheared` is asked for flat
/// ones that stand in world space only: sheared() gives ShearedRays.
template <class Sheared>
Roots intersect_placed(const Scene& scene, const Object& object, std::uint32_t part, const Rays& rays, const Span& span,
                       const Sheared& sheared);

/// Which points are inside? Of objects that clip others.
Mask inside(const Scene& scene, const Object& object, const Vec3s& points);

/// The points and the directions in the object's own space, and normals of it in the world's.
Vec3s times(const Mat3& matrix, const Vec3s& v);

// ---- Quadrics -------------------------------------------------------------------------------------------------------

RootPairs root_pairs(const Quadric& quadric, const Rays& rays);
inline Roots intersect(const Quadric& quadric, const Rays& rays, const Span& span) {
    return root_pairs(quadric, rays).smallest_in(span);
}
Vec3s normal(const Quadric& quadric, const Vec3s& point);

// ---------------------------------------------------------------------------------------------------------------------

/// In the shape's own space, clips not considered.
template <class Sheared>
Roots intersect_shape(const Scene& scene, const Object& object, std::uint32_t part, const Rays& rays, const Span& span,
                      const Sheared& sheared) {
    const std::uint32_t shape = object.shape;
    switch (object.kind) {
        case ShapeKind::sphere: return intersect(scene.spheres[shape], rays, span);
        case ShapeKind::plane: return intersect(scene.planes[shape], rays, span);
        case ShapeKind::triangle: return sheared().intersect(scene.triangles[shape], span);
        case ShapeKind::smooth_triangle: return sheared().intersect(scene.smooth_triangles[shape].triangle, span);
        case ShapeKind::mesh: return intersect(scene.meshes[shape], part, rays, sheared(), span);
        case ShapeKind::polygon: return intersect(scene.polygons[shape], rays, span);
        case ShapeKind::disc: return intersect(scene.discs[shape], rays, span);
        case ShapeKind::cone: return intersect(scene.cones[shape], rays, span);
        case ShapeKind::quadric: return intersect(scene.quadrics[shape], rays, span);
        case ShapeKind::torus: return intersect(scene.tori[shape], rays, span);
        default: return intersect(scene.boxes[shape], rays, span);
    }
}

/// The smallest root in the span that inside(points) lets stand: what asking again behind each root that is cut away
/// comes to, where there are two.
template <class Inside>
Roots first_unclipped(const RootPairs& roots, const Rays& rays, const Span& span, const Inside& inside) {
    Mask first = roots.are & span.contains(roots.first);
    if (first.any()) first = first & inside(rays.at(roots.first));
    Mask second = (roots.are & span.contains(roots.second)) - first;
    if (second.any()) second = second & inside(rays.at(roots.second));
    return {first | second, select(first, roots.first, roots.second)};
}

/// In the shape's own space; `rays` are those of the world, in which clips stand.
template <class Sheared>
Roots intersect_clipped(const Scene& scene, const Object& object, std::uint32_t part, const Rays& rays,
                        const Rays& local, const Span& span, const Sheared& sheared) {
    if (object.clip == kNone) return intersect_shape(scene, object, part, local, span, sheared);
    const auto inside_all = [&](const Vec3s& points) {
        Mask in = Mask::of(kAllLanes);
        for (const Object& clip : scene.clips[object.clip]) in = in & inside(scene, clip, points);
        return in;
    };
    if (object.kind == ShapeKind::sphere)
        return first_unclipped(root_pairs(scene.spheres[object.shape], local), rays, span, inside_all);
    if (object.kind == ShapeKind::quadric)
        return first_unclipped(root_pairs(scene.quadrics[object.shape], local), rays, span, inside_all);
    // As in step 1: a root that is cut away sends the question on behind it.
    Span rest = span;
    rest.any = false;
    Mask open = Mask::of(kAllLanes);
    Roots unclipped = Roots::none();
    for (int i = 0; i < 1000 && open.any(); ++i) {
        const Roots roots = intersect_shape(scene, object, part, local, rest, sheared);
        const Mask met = roots.is & open;
        if (!met.any()) break;
        const Mask stand = met & inside_all(rays.at(roots.t));
        unclipped.is = unclipped.is | stand;
        unclipped.t = select(stand, roots.t, unclipped.t);
        unclipped.u = select(stand, roots.u, unclipped.u);
        unclipped.v = select(stand, roots.v, unclipped.v);
        unclipped.part = select(stand, roots.part, unclipped.part);
        open = met - stand;
        rest.near = select(open, roots.t, rest.near);
        rest.far = select(open, rest.far, Reals(-kInfinity));
    }
    return unclipped;
}

template <class Sheared>
Roots intersect_placed(const Scene& scene, const Object& object, std::uint32_t part, const Rays& rays, const Span& span,
                       const Sheared& sheared) {
    if (object.transform == kNone) return intersect_clipped(scene, object, part, rays, rays, span, sheared);
    const Transform& t = scene.transforms[object.transform];
    const Rays local(times(t.inverse_linear, rays.origin) + Vec3s(t.inverse_offset),
                     times(t.inverse_linear, rays.direction));
    return intersect_clipped(scene, object, part, rays, local, span, sheared);
}

}  // namespace rays::packets
