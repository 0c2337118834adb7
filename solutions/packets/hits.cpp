// From roots to hits: points, normals, materials, primitive by primitive.
#include <bit>

#include "packets/intersector.h"

namespace rays::packets {

void PacketIntersector::complete(const Rays& rays, const Found& found, Wanted wanted, Hits& hits) const {
    const Spread primitive(found.primitive);
    const Vec3s point = rays.at(found.t);
    hits.are = found.is().bits();
    hits.t = Spread(found.t);
    hits.point.set(Mask::of(kAllLanes), point);
    for (unsigned rest = hits.are; rest != 0;) {
        const double first = primitive[std::countr_zero(rest)];
        const Mask lanes = found.primitive == Reals(first);
        complete(static_cast<std::uint32_t>(first), lanes, rays, found, wanted, hits);
        rest &= ~lanes.bits();
    }
}

void PacketIntersector::complete(std::uint32_t primitive, Mask lanes, const Rays& rays, const Found& found,
                                 Wanted wanted, Hits& hits) const {
    const Primitive p = hierarchy_->tester.primitive(primitive);
    const Scene& s = scene();
    const Object& object = s.objects[p.object];
    if (!has_packet_test(primitive)) {
        const SpreadRays single(rays);
        each_lane(lanes.bits(), [&](int i) { hits.set(i, complete_hit(s, p.object, single[i], found.root(i))); });
        return;
    }
    const std::uint32_t material = material_of(primitive);
    each_lane(lanes.bits(), [&](int i) {
        hits.object[i] = p.object;
        hits.material[i] = material;
    });
    if (wanted == Wanted::places) return;
    const Transform* transform = object.transform == kNone ? nullptr : &s.transforms[object.transform];
    const Vec3s world = hits.point.load();
    const Vec3s point = transform ? times(transform->inverse_linear, world) + Vec3s(transform->inverse_offset) : world;
    const auto set_normals = [&](const Vec3s& n) {
        hits.normal.set(lanes, unit(lanes, transform ? times(glm::transpose(transform->inverse_linear), n) : n));
    };
    // The same for all of them: found out once.
    const auto set_normal = [&](const Vec3& n) {
        transform ? set_normals(n) : hits.normal.set(lanes, Vec3s(rays::unit(n)));
    };
    const auto flat = [](const Triangle& t) { return glm::cross(t.b - t.a, t.c - t.a); };
    switch (object.kind) {
        case ShapeKind::sphere: set_normals(normal(s.spheres[object.shape], point)); break;
        case ShapeKind::plane: set_normal(s.planes[object.shape].normal); break;
        case ShapeKind::disc: set_normal(s.discs[object.shape].normal); break;
        case ShapeKind::polygon: set_normal(s.polygons[object.shape].plane.normal); break;
        case ShapeKind::triangle: set_normal(flat(s.triangles[object.shape])); break;
        case ShapeKind::cone: set_normals(normal(s.cones[object.shape], point, found.part)); break;
        case ShapeKind::smooth_triangle: {
            const SmoothTriangle& t = s.smooth_triangles[object.shape];
            set_normals(interpolate(t.normal_a, t.normal_b, t.normal_c, found.u, found.v));
            break;
        }
        case ShapeKind::mesh: {
            const Mesh& mesh = s.meshes[object.shape];
            const Mesh::Face& face = mesh.faces[p.part];
            const auto [a, b, c] = face.normal;
            if (face.smooth)
                set_normals(interpolate(mesh.normals[a], mesh.normals[b], mesh.normals[c], found.u, found.v));
            else
                set_normal(flat(triangle_of(mesh, p.part)));
            break;
        }
        case ShapeKind::quadric: set_normals(normal(s.quadrics[object.shape], point)); break;
        case ShapeKind::torus: set_normals(normal(s.tori[object.shape], point)); break;
        default: set_normals(box_normal(found.part)); break;
    }
}

}  // namespace rays::packets
