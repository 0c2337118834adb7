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
    const auto set_normals = [&](Vec3s n) {
        if (transform) n = normalize(times(glm::transpose(transform->inverse_linear), n));
        hits.normal.set(lanes, n);
    };
    // Of unit length in the world: a normal that is still to be moved need not be.
    const auto unit = [&](const Vec3s& n) { return transform ? n : normalize(n); };
    const auto flat = [](const Triangle& t) { return Vec3s(glm::normalize(glm::cross(t.b - t.a, t.c - t.a))); };
    switch (object.kind) {
        case ShapeKind::sphere: set_normals(unit(normal(s.spheres[object.shape], point))); break;
        case ShapeKind::plane: set_normals(unit(s.planes[object.shape].normal)); break;
        case ShapeKind::disc: set_normals(unit(s.discs[object.shape].normal)); break;
        case ShapeKind::polygon: set_normals(unit(s.polygons[object.shape].plane.normal)); break;
        case ShapeKind::triangle: set_normals(flat(s.triangles[object.shape])); break;
        case ShapeKind::cone: set_normals(unit(normal(s.cones[object.shape], point, found.part))); break;
        case ShapeKind::smooth_triangle: {
            const SmoothTriangle& t = s.smooth_triangles[object.shape];
            set_normals(normalize(interpolate(t.normal_a, t.normal_b, t.normal_c, found.u, found.v)));
            break;
        }
        case ShapeKind::mesh: {
            const Mesh& mesh = s.meshes[object.shape];
            const Mesh::Face& face = mesh.faces[p.part];
            const auto [a, b, c] = face.normal;
            set_normals(face.smooth ? normalize(interpolate(mesh.normals[a], mesh.normals[b], mesh.normals[c], found.u,
                                                            found.v))
                                    : flat(triangle_of(mesh, p.part)));
            break;
        }
        case ShapeKind::quadric: set_normals(unit(normal(s.quadrics[object.shape], point))); break;
        case ShapeKind::torus: set_normals(unit(normal(s.tori[object.shape], point))); break;
        default: set_normals(unit(box_normal(found.part))); break;
    }
}

}  // namespace rays::packets
