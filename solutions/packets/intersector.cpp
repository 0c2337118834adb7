#include "packets/intersector.h"

#include <algorithm>
#include <bit>
#include <optional>

namespace rays::packets {

using wide::Child;
using Way = PrimitiveTester::Way;

/// What primitives are asked about.
class PacketIntersector::Asked {
public:
    Asked(const Rays& rays_, Mask active_, Real near_, Reals far, const Beam& beam)
        : rays(rays_), active(active_), near(near_), span{Reals(near_), far}, longest_axis_(beam.longest_axis()) {}

    const ShearedRays& sheared() const {
        if (!sheared_) sheared_.emplace(rays, longest_axis_);
        return *sheared_;
    }
    const SpreadRays& single() const {
        if (!single_) single_.emplace(rays);
        return *single_;
    }

    const Rays& rays;
    const Mask active;
    const Real near;
    const Span span;

private:
    int longest_axis_;
    mutable std::optional<ShearedRays> sheared_;
    mutable std::optional<SpreadRays> single_;
};

PacketIntersector::PacketIntersector(const Scene& scene)
    : hierarchy_(wide::make_hierarchy(scene)), single_(wide::make_bvh(hierarchy_)) {
    for (const Material& m : scene.materials) clear_materials_.push_back(lets_light_through(m.pigment));
}

// ---- The walk -------------------------------------------------------------------------------------------------------

/// Asks the primitives that some ray of the beam may meet, nearer boxes first, until ask(primitive) says enough.
template <class Ask>
void PacketIntersector::walk(Beam& beam, Ask ask) const {
    for (const std::uint32_t primitive : hierarchy_->unbounded)
        if (ask(primitive)) return;
    const wide::Tree& tree = hierarchy_->tree;
    if (tree.nodes.empty()) return;

    const auto ask_block = [&](const auto& block) {
        for (unsigned mask = beam.meets(block); mask != 0; mask &= mask - 1)
            if (ask(block.primitive[std::countr_zero(mask)])) return true;
        return false;
    };
    const auto ask_leaf = [&](Child leaf) {
        if (leaf.kind() == Child::Kind::triangles) return ask_block(tree.triangles[leaf.place()]);
        if (leaf.kind() == Child::Kind::spheres) return ask_block(tree.spheres[leaf.place()]);
        const std::uint32_t* list = &tree.lists[leaf.place()];
        for (std::uint32_t k = 1; k <= list[0]; ++k)
            if (ask(list[k])) return true;
        return false;
    };

    struct Open {
        float enters;
        Child child;
    };
    Open stack[8 * 80];  // as deep as the hierarchy can be
    int size = 0;
    for (Open open{0, Child(Child::Kind::node, 0)};;) {
        if (open.child.kind() != Child::Kind::node) {
            if (ask_leaf(open.child)) return;
        } else {
            const wide::Node& node = tree.nodes[open.child.place()];
            alignas(32) float enters[wide::kWidth];
            const int first = size;
            for (unsigned mask = beam.meets(node, enters); mask != 0; mask &= mask - 1) {
                const int i = std::countr_zero(mask);
                int place = size++;
                for (; place > first && stack[place - 1].enters < enters[i]; --place) stack[place] = stack[place - 1];
                stack[place] = {enters[i], node.child[i]};
            }
        }
        do {
            if (size == 0) return;
            open = stack[--size];
        } while (open.enters > beam.far_end());
    }
}

Hits PacketIntersector::nearest(const Rays& rays, Mask active, Real near, Real far) const {
    Hits hits;
    Beam beam(rays, active, near, far);
    if (!beam.is_coherent()) {
        const SpreadRays single(rays);
        each_lane(active.bits(), [&](int i) {
            if (const auto hit = single_->nearest(single[i], {near, far})) hits.set(i, *hit);
        });
        return hits;
    }
    const Asked asked(rays, active, near, Reals(far), beam);
    Found found;
    found.t = select(active, found.t, Reals(-kInfinity));  // who does not ask finds nothing nearer
    walk(beam, [&](std::uint32_t primitive) {
        if (keep_nearer(primitive, asked, found)) beam.shorten(std::min(far, largest(found.t)));
        return false;
    });
    complete(rays, found, hits);
    return hits;
}

Mask PacketIntersector::occluded(const Rays& rays, Mask active, Real near, Reals far, std::uint32_t& last) const {
    Mask open = active & (Reals(near) < far);
    if (!open.any()) return open;
    Beam beam(rays, open, near, largest(select(open, far, Reals(near))));
    if (!beam.is_coherent()) {
        const SpreadRays single(rays);
        const Spread ends(far);
        unsigned blocked = 0;
        each_lane(open.bits(), [&](int i) {
            if (single_->occluded(single[i], {near, ends[i]})) blocked |= 1u << i;
        });
        return Mask::of(blocked);
    }
    const Asked asked(rays, open, near, far, beam);
    const Mask asking = open;
    const auto ask = [&](std::uint32_t primitive) {
        const Mask blocked = blocked_by(primitive, asked, open);
        if (!blocked.any()) return false;
        last = primitive;
        open = open - blocked;
        return !open.any();
    };
    if (last != kNone && ask(last)) return asking;
    walk(beam, ask);
    return asking - open;
}

Obstacles PacketIntersector::obstacles(const Rays& rays, Mask active, Real near, Reals far) const {
    Obstacles met;
    Mask open = active & (Reals(near) < far);
    if (!open.any()) return met;
    Beam beam(rays, open, near, largest(select(open, far, Reals(near))));
    if (!beam.is_coherent()) {
        met.clear = open;  // whoever walks from hit to hit finds out
        return met;
    }
    const Asked asked(rays, open, near, far, beam);
    walk(beam, [&](std::uint32_t primitive) {
        const Mask blocked = blocked_by(primitive, asked, open);
        if (!blocked.any()) return false;
        if (!is_clear(primitive)) {
            met.opaque = met.opaque | blocked;
            return false;
        }
        met.clear = met.clear | blocked;
        open = open - blocked;
        return !open.any();
    });
    met.opaque = met.opaque - met.clear;
    return met;
}

// ---- Asking one primitive -------------------------------------------------------------------------------------------

bool PacketIntersector::is_clear(std::uint32_t primitive) const {
    const Primitive p = hierarchy_->tester.primitives()[primitive];
    const Object& object = scene().objects[p.object];
    std::uint32_t material = object.material;
    if (object.kind == ShapeKind::mesh) {
        const std::uint32_t own = scene().meshes[object.shape].faces[p.part].material;
        if (own != Mesh::kObjectMaterial) material = own;
    }
    return clear_materials_[material];
}

/// Of a shape with a packet test.
Roots PacketIntersector::roots_of(std::uint32_t primitive, const Asked& asked) const {
    const auto& dispatch = hierarchy_->tester.dispatch(primitive);
    const Scene& s = scene();
    switch (dispatch.way) {
        case Way::sphere: return intersect(s.spheres[dispatch.shape], asked.rays, asked.span);
        case Way::cone: return intersect(s.cones[dispatch.shape], asked.rays, asked.span);
        case Way::plane: return intersect(s.planes[dispatch.shape], asked.rays, asked.span);
        case Way::triangle: return asked.sheared().intersect(s.triangles[dispatch.shape], asked.span);
        case Way::face:
            return intersect(s.meshes[dispatch.shape], hierarchy_->tester.primitives()[primitive].part, asked.rays,
                             asked.sheared(), asked.span);
        case Way::other: break;
    }
    const Primitive p = hierarchy_->tester.primitives()[primitive];
    return intersect_placed(s, s.objects[p.object], p.part, asked.rays, asked.span,
                            [&]() -> const ShearedRays& { return asked.sheared(); });
}

bool PacketIntersector::has_packet_test(std::uint32_t primitive) const {
    const PrimitiveTester& tester = hierarchy_->tester;
    return tester.dispatch(primitive).way != Way::other ||
           packets::has_packet_test(scene(), scene().objects[tester.primitives()[primitive].object]);
}

bool PacketIntersector::keep_nearer(std::uint32_t primitive, const Asked& asked, Found& found) const {
    const PrimitiveTester& tester = hierarchy_->tester;
    if (has_packet_test(primitive)) return found.keep_nearer(roots_of(primitive, asked), primitive);
    bool changed = false;
    const Spread ends(asked.span.far);
    each_lane(asked.active.bits(), [&](int i) {
        Candidate best;
        if (found.is().bits() >> i & 1)
            best = {found.root(i), static_cast<std::uint32_t>(Spread(found.primitive)[i])};
        tester.keep_nearer(primitive, asked.single()[i], {asked.near, ends[i]}, best);
        if (best.primitive == primitive)
            changed |= found.keep_nearer({Mask::of(1u << i), Reals(best.root.t), Reals(best.root.uv.x), Reals(best.root.uv.y),
                               Reals(static_cast<double>(best.root.part))},
                              primitive);
    });
    return changed;
}

Mask PacketIntersector::blocked_by(std::uint32_t primitive, const Asked& asked, Mask open) const {
    const PrimitiveTester& tester = hierarchy_->tester;
    if (!tester.dispatch(primitive).casts) return Mask::of(0);
    if (has_packet_test(primitive)) return roots_of(primitive, asked).is & open;
    unsigned blocked = 0;
    const Spread ends(asked.span.far);
    each_lane(open.bits(), [&](int i) {
        if (tester.blocks(primitive, asked.single()[i], {asked.near, ends[i]})) blocked |= 1u << i;
    });
    return Mask::of(blocked);
}

// ---- From roots to hits ---------------------------------------------------------------------------------------------

void PacketIntersector::complete(const Rays& rays, const Found& found, Hits& hits) const {
    const Spread primitive(found.primitive);
    const Vec3s point = rays.at(found.t);
    hits.are = found.is().bits();
    hits.t = Spread(found.t);
    hits.point.set(Mask::of(kAllLanes), point);
    for (unsigned rest = hits.are; rest != 0;) {
        const double first = primitive[std::countr_zero(rest)];
        const Mask lanes = found.primitive == Reals(first);
        complete(static_cast<std::uint32_t>(first), lanes, rays, found, hits);
        rest &= ~lanes.bits();
    }
}

void PacketIntersector::complete(std::uint32_t primitive, Mask lanes, const Rays& rays, const Found& found,
                                 Hits& hits) const {
    const Primitive p = hierarchy_->tester.primitives()[primitive];
    const Scene& s = scene();
    const Object& object = s.objects[p.object];
    if (!has_packet_test(primitive)) {
        const SpreadRays single(rays);
        each_lane(lanes.bits(), [&](int i) { hits.set(i, complete_hit(s, p.object, single[i], found.root(i))); });
        return;
    }
    std::uint32_t material = object.material;
    const Transform* transform = object.transform == kNone ? nullptr : &s.transforms[object.transform];
    const Vec3s world = hits.point.load();
    const Vec3s point =
        transform ? times(transform->inverse_linear, world) + Vec3s(transform->inverse_offset) : world;
    const auto set_normals = [&](Vec3s n) {
        if (transform) n = normalize(times(glm::transpose(transform->inverse_linear), n));
        hits.normal.set(lanes, n);
        hits.shading_normal.set(lanes, n);
    };
    // Of unit length in the world: a normal that is still to be moved need not be.
    const auto unit = [&](const Vec3s& n) { return transform ? n : normalize(n); };
    const auto flat = [](const Triangle& t) { return Vec3s(glm::normalize(glm::cross(t.b - t.a, t.c - t.a))); };
    switch (object.kind) {
        case ShapeKind::sphere:
            set_normals(unit(normal(s.spheres[object.shape], point)));
            break;
        case ShapeKind::plane: set_normals(unit(s.planes[object.shape].normal)); break;
        case ShapeKind::disc: set_normals(unit(s.discs[object.shape].normal)); break;
        case ShapeKind::polygon: set_normals(unit(s.polygons[object.shape].plane.normal)); break;
        case ShapeKind::triangle: set_normals(flat(s.triangles[object.shape])); break;
        case ShapeKind::cone:
            set_normals(unit(normal(s.cones[object.shape], point, found.part)));
            break;
        case ShapeKind::smooth_triangle: {
            const SmoothTriangle& t = s.smooth_triangles[object.shape];
            hits.normal.set(lanes, flat(t.triangle));
            hits.shading_normal.set(lanes,
                                    normalize(interpolate(t.normal_a, t.normal_b, t.normal_c, found.u, found.v)));
            break;
        }
        case ShapeKind::mesh: {
            const Mesh& mesh = s.meshes[object.shape];
            const Mesh::Face& face = mesh.faces[p.part];
            if (face.material != Mesh::kObjectMaterial) material = face.material;
            set_normals(flat(triangle_of(mesh, p.part)));
            if (face.smooth) {
                const auto [a, b, c] = face.normal;
                hits.shading_normal.set(
                    lanes, normalize(interpolate(mesh.normals[a], mesh.normals[b], mesh.normals[c], found.u, found.v)));
            }
            break;
        }
        case ShapeKind::quadric: set_normals(unit(normal(s.quadrics[object.shape], point))); break;
        default: set_normals(unit(box_normal(found.part))); break;
    }
    each_lane(lanes.bits(), [&](int i) {
        hits.object[i] = p.object;
        hits.material[i] = material;
    });
}

}  // namespace rays::packets
