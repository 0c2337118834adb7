#include "packets/intersector.h"

#include <algorithm>
#include <bit>
#include <type_traits>

#include "2_phong/phong.h"
#include "packets/asked.h"
#include "packets/beam.h"
#include "packets/lone.h"
#include "packets/spray.h"

namespace rays::packets {

using wide::Child;
using Way = PrimitiveTester::Way;

PacketIntersector::PacketIntersector(const Scene& scene)
    : hierarchy_(wide::make_hierarchy(scene)), single_(wide::make_bvh(hierarchy_)) {
    for (const Material& m : scene.materials) clear_materials_.push_back(lets_light_through(m.pigment));
    takes_any_way_ = hierarchy_->tree.node_count() <= 1;
    has_triangles_ = hierarchy_->tree.has_triangles();
}

// ---- The walk -------------------------------------------------------------------------------------------------------

/// Asks the primitives that some ray of a beam, or of a spray, may meet until ask(primitive) says enough; near boxes
/// first, when sorted.
template <bool sorted, class Front, class Ask, class AskAlone>
void PacketIntersector::walk(Front& front, const Ask& ask, const AskAlone& ask_alone) const {
    for (const std::uint32_t primitive : hierarchy_->unbounded)
        if (ask(primitive)) return;
    const wide::Tree& tree = hierarchy_->tree;
    if (tree.empty()) return;

    const auto ask_block = [&](const auto& block, const auto& numbers) {
        for (unsigned mask = front.meets(block); mask != 0; mask &= mask - 1) {
            const int i = std::countr_zero(mask);
            if (front.rays_that_meet(block, i) != 0 && ask(numbers[i])) return true;
        }
        return false;
    };
    const auto ask_leaf = [&](Child leaf) {
        if (leaf.kind() == Child::Kind::triangles)
            return ask_block(tree.triangles(leaf), tree.triangles(leaf).primitive);
        if (leaf.kind() == Child::Kind::spheres) return ask_block(tree.spheres(leaf), tree.spheres(leaf).primitive);
        if (leaf.kind() == Child::Kind::cones) return ask_block(tree.cones(leaf), tree.cones(leaf).around.primitive);
        const wide::List& list = tree.list(leaf);
        for (std::uint32_t k = 0; k < list.count; ++k)
            if (ask(list.primitive[k])) return true;
        return false;
    };

    wide::Waiting stack[wide::kMostWaiting];  // what: a node's bits, of which the lower three are 0, and there the
                                              // number of the child
    int size = 0;
    for (Child next = tree.root();;) {
        const wide::Node& node = tree.node(next);
        alignas(32) float enters[wide::kWidth];
        const int first = size;
        for (unsigned mask = front.meets(node, enters); mask != 0; mask &= mask - 1) {
            const int i = std::countr_zero(mask);
            int place = size++;
            if constexpr (sorted)
                for (; place > first && stack[place - 1].enters() < enters[i]; --place) stack[place] = stack[place - 1];
            stack[place] = wide::Waiting(enters[i], next.bits() | static_cast<unsigned>(i));
        }
        for (;;) {
            if (size == 0) return;
            const wide::Waiting open = stack[--size];
            if (open.enters() > front.far_end()) continue;
            const wide::Node& parent = tree.node(Child(open.what() & ~7u));
            const unsigned rays = front.rays_that_meet(parent, open.what() % 8);
            if (rays == 0) continue;
            const Child child = parent.child[open.what() % 8];
            if constexpr (!std::is_null_pointer_v<AskAlone>) {
                if (child.kind() == Child::Kind::node && std::popcount(rays) < kFewestBelow) {
                    if (ask_alone(rays, child)) return;
                    continue;
                }
            }
            if (child.kind() == Child::Kind::node) {
                next = child;
                break;
            }
            if (ask_leaf(child)) return;
        }
    }
}

namespace {

/// Rays whose numbers floats can hold with room to spare. What is no ray is not among them: a NaN fails every
/// comparison.
Mask fit_for_floats(const Rays& rays) {
    const Reals most(1e60), least(1e-60);
    return (dot(rays.origin, rays.origin) < most) & (rays.direction2 > least) & (rays.direction2 < most);
}

}  // namespace

/// Calls together(lanes, way) for rays that go the same way, if they are enough, and returns the others. Where there is
/// little to meet the way does not matter: null.
template <class Together>
unsigned PacketIntersector::grouped(const Rays& rays, Mask active, const Together& together) const {
    const Mask fit = active & fit_for_floats(rays);
    unsigned alone = (active - fit).bits();
    if (takes_any_way_ && !has_triangles_) {
        if (fit.any()) together(fit, nullptr);
        return alone;
    }
    const Directions directions(rays.direction);
    if (takes_any_way_ && fit.any()) {  // a beam tells triangles apart at once
        const int first = std::countr_zero(fit.bits());
        const Directions::Way way = directions.way(first);
        together(fit, directions.like_the_first(fit.bits()) == fit.bits() ? &way : nullptr);
        return alone;
    }
    for (unsigned rest = fit.bits(); rest != 0;) {
        const unsigned group = directions.like_the_first(rest);
        if (std::popcount(group) < kFewestTogether)
            alone |= group;
        else {
            const Directions::Way way = directions.way(std::countr_zero(group));
            together(Mask::of(group), &way);
        }
        rest &= ~group;
    }
    return alone;
}

/// Calls walk_with(front) with what boxes see of the rays.
template <class WalkWith>
void PacketIntersector::with_front(const Rays& rays, Mask lanes, const Directions::Way* way, const Span& span,
                                   const WalkWith& walk_with) const {
    if (way) {
        Beam beam(rays, lanes, *way, span);
        walk_with(beam);
    } else {
        Spray spray(rays, lanes, span);
        walk_with(spray);
    }
}

Hits PacketIntersector::nearest(const Rays& rays, Mask active, const Span& span, Wanted wanted) const {
    Found found;
    const unsigned alone = grouped(rays, active, [&](Mask lanes, const Directions::Way* way) {
        const Asked asked(rays, span, lanes, lanes, found.t);
        Lone lone(*hierarchy_, asked);
        with_front(rays, lanes, way, span, [&](auto& front) {
            const auto ask = [&](std::uint32_t primitive) {
                if (keep_nearer(primitive, asked, found)) front.end_at(found.t, lanes);
                return false;
            };
            walk<true>(front, ask, [&](unsigned few, Child part) {
                if (lone.keep_nearer_below(part, few, found)) front.end_at(found.t, lanes);
                return false;
            });
        });
    });
    Hits hits;
    if (found.is().any()) complete(rays, found, wanted, hits);
    if (alone != 0) {
        const SpreadRays single(rays);
        const Spread starts(span.near), ends(span.far);
        each_lane(alone, [&](int i) {
            if (const auto hit = single_->nearest(single[i], {starts[i], ends[i]})) hits.set(i, *hit);
        });
    }
    return hits;
}

Mask PacketIntersector::occluded(const Rays& rays, Mask active, const Span& span, const ObjectNumbers& lit,
                                 Suspects& suspects) const {
    const Mask asking = active & (span.near < span.far);
    Mask blocked = Mask::of(0);
    const unsigned alone = grouped(rays, asking, [&](Mask lanes, const Directions::Way* way) {
        std::uint32_t& suspect = suspects.of(lit[std::countr_zero(lanes.bits())]);
        Mask open = lanes;
        const Asked asked(rays, {span.near, span.far, true}, lanes, open, span.far);
        const auto blocks_all = [&](std::uint32_t primitive) {
            const Mask now = blocked_by(primitive, asked, open);
            if (!now.any()) return false;
            suspect = primitive;
            open = open - now;
            return !open.any();
        };
        if (suspect == kNone || !blocks_all(suspect)) {
            with_front(rays, open, way, span, [&](auto& front) {
                const auto ask = [&](std::uint32_t primitive) {
                    const Mask before = open;
                    if (blocks_all(primitive)) return true;
                    if (before.bits() != open.bits()) front.leave_out(before - open);
                    return false;
                };
                Lone lone(*hierarchy_, asked);
                walk<false>(front, ask, [&](unsigned few, Child part) {
                    const unsigned now = lone.blocked_below(part, few & open.bits(), suspect);
                    if (now == 0) return false;
                    open = open - Mask::of(now);
                    front.leave_out(Mask::of(now));
                    return !open.any();
                });
            });
        }
        blocked = blocked | (lanes - open);
    });
    if (alone == 0) return blocked;
    const SpreadRays single(rays);
    const Spread starts(span.near), ends(span.far);
    unsigned bits = 0;
    each_lane(alone, [&](int i) {
        if (single_->blocked(single[i], {starts[i], ends[i]}, suspects.of(lit[i]))) bits |= 1u << i;
    });
    return blocked | Mask::of(bits);
}

/// Behind something clear a shadow ray passes over what is nearer than kShadowTolerance (FilteredShadows). So what is
/// opaque blocks, unless something clear is so near before it; a little more, for rounding.
constexpr double kPassedOver = 1.1 * kShadowTolerance;

Obstacles PacketIntersector::obstacles(const Rays& rays, Mask active, const Span& span) const {
    Obstacles met;
    const Mask asking = active & (span.near < span.far);
    const unsigned alone = grouped(rays, asking, [&](Mask lanes, const Directions::Way* way) {
        Mask open = lanes;
        const Asked asked(rays, {span.near, span.far, true}, lanes, open, span.far);
        with_front(rays, lanes, way, span, [&](auto& front) {
            walk<false>(
                front,
                [&](std::uint32_t primitive) {
                    const PrimitiveTester::Dispatch& dispatch = hierarchy_->tester.dispatch(primitive);
                    if (!dispatch.casts) return false;
                    const bool tells_where = has_packet_test(primitive) && !dispatch.iterated;
                    const Roots roots =
                        tells_where ? roots_of(primitive, asked) : Roots{blocked_by(primitive, asked, open)};
                    const Mask now = roots.is & open;
                    if (!now.any()) return false;
                    if (!clear_materials_[material_of(primitive)]) {
                        met.opaque = met.opaque | now;
                        if (tells_where) front.look_between(now, roots.t - Reals(kPassedOver), roots.t);
                        return false;
                    }
                    met.clear = met.clear | now;
                    open = open - now;
                    front.leave_out(now);
                    return !open.any();
                },
                nullptr);
        });
    });
    met.clear = met.clear | Mask::of(alone);  // whoever walks from hit to hit finds out
    met.opaque = met.opaque - met.clear;
    return met;
}

// ---- Asking one primitive -------------------------------------------------------------------------------------------

std::uint32_t PacketIntersector::material_of(std::uint32_t primitive) const {
    const Primitive p = hierarchy_->tester.primitive(primitive);
    const Object& object = scene().objects[p.object];
    if (object.kind != ShapeKind::mesh) return object.material;
    const std::uint32_t own = scene().meshes[object.shape].faces[p.part].material;
    return own == Mesh::kObjectMaterial ? object.material : own;
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
            return intersect(s.meshes[dispatch.shape], dispatch.primitive.part, asked.rays, asked.sheared(),
                             asked.span);
        case Way::other: break;
    }
    const Primitive p = dispatch.primitive;
    return intersect_placed(s, s.objects[p.object], p.part, asked.rays, asked.narrow_span(),
                            [&]() -> const ShearedRays& { return asked.sheared(); });
}

bool PacketIntersector::has_packet_test(std::uint32_t primitive) const {
    const PrimitiveTester& tester = hierarchy_->tester;
    return tester.dispatch(primitive).way != Way::other ||
           packets::has_packet_test(scene(), scene().objects[tester.primitive(primitive).object]);
}

// Flattened, like blocked_by: roots are 320 bytes, and handing them through memory cost up to 3 % of a picture.
[[gnu::flatten]] bool PacketIntersector::keep_nearer(std::uint32_t primitive, const Asked& asked, Found& found) const {
    const PrimitiveTester& tester = hierarchy_->tester;
    if (has_packet_test(primitive)) return found.keep_nearer(roots_of(primitive, asked), asked.active, primitive);
    bool changed = false;
    each_lane(asked.active.bits(), [&](int i) {
        Candidate best = candidate_of(found, i);
        tester.keep_nearer(primitive, asked.single()[i], asked.range(i), best);
        if (best.primitive == primitive) changed |= found.keep_nearer(in_lane(best, i), asked.active, primitive);
    });
    return changed;
}

[[gnu::flatten]] Mask PacketIntersector::blocked_by(std::uint32_t primitive, const Asked& asked, Mask open) const {
    const PrimitiveTester& tester = hierarchy_->tester;
    if (!tester.dispatch(primitive).casts) return Mask::of(0);
    if (has_packet_test(primitive)) return roots_of(primitive, asked).is & open;
    unsigned blocked = 0;
    each_lane(open.bits(), [&](int i) {
        if (tester.blocks(primitive, asked.single()[i], asked.range(i))) blocked |= 1u << i;
    });
    return Mask::of(blocked);
}

}  // namespace rays::packets
