// Rays that leave their packet where few go on.
#pragma once

#include <array>
#include <optional>

#include "4_partitioning/beyond/hierarchy.h"
#include "4_partitioning/beyond/single_walk.h"
#include "packets/asked.h"

namespace rays::packets {

/// What a ray has found so far, as single rays have it.
inline Candidate candidate_of(const Found& found, int lane) {
    if (!(found.is().bits() >> lane & 1)) return {};
    return {found.root(lane), static_cast<std::uint32_t>(Spread(found.primitive)[lane])};
}

/// And back.
inline Roots in_lane(const Candidate& best, int lane) {
    return {Mask::of(1u << lane), Reals(best.root.t), Reals(best.root.uv.x), Reals(best.root.uv.y),
            Reals(static_cast<double>(best.root.part))};
}

/// Rays of a packet that go through parts of the hierarchy one by one. Its functions stay out of line: inlined, they
/// take registers from the walk of those that go together, 1.1 of the time.
class Lone {
public:
    Lone(const wide::Hierarchy& hierarchy, const Asked& asked) : hierarchy_(hierarchy), asked_(asked) {}

    /// Which of the rays meet something in this part that casts a shadow; `suspect` becomes what.
    [[gnu::noinline]] unsigned blocked_below(wide::Child part, unsigned rays, std::uint32_t& suspect) {
        unsigned blocked = 0;
        each_lane(rays, [&](int i) {
            Lane& own = lane(i);  // no structured binding: Clang 14 does not let lambdas see one
            const Ray& ray = own.ray;
            wide::SingleWalk& walk = own.walk;
            const bool is_blocked =
                walk.any_below(part, [&](std::uint32_t primitive, const PrimitiveTester::Dispatch& d) {
                    if (!hierarchy_.tester.blocks(d, ray, asked_.range(i))) return false;
                    suspect = primitive;
                    return true;
                });
            if (is_blocked) blocked |= 1u << i;
        });
        return blocked;
    }

    /// True when one of the rays found something nearer.
    [[gnu::noinline]] bool keep_nearer_below(wide::Child part, unsigned rays, Found& found) {
        bool nearer = false;
        each_lane(rays, [&](int i) {
            Lane& own = lane(i);  // no structured binding: Clang 14 does not let lambdas see one
            const Ray& ray = own.ray;
            wide::SingleWalk& walk = own.walk;
            Candidate best = candidate_of(found, i);
            if (best.primitive != kNone) walk.shorten(best.root.t);
            const std::uint32_t before = best.primitive;
            walk.nearest_below(part, [&](std::uint32_t primitive, const PrimitiveTester::Dispatch& d) {
                const std::uint32_t previous = best.primitive;
                hierarchy_.tester.keep_nearer(primitive, d, ray, asked_.range(i), best);
                if (best.primitive != previous) walk.shorten(best.root.t);
            });
            if (best.primitive != before)
                nearer |= found.keep_nearer(in_lane(best, i), Mask::of(1u << i), best.primitive);
        });
        return nearer;
    }

private:
    struct Lane {
        Lane(const wide::Tree& tree, const Ray& r, Interval range) : ray(r), walk(tree, ray, range) {}
        const Ray ray;
        wide::SingleWalk walk;
    };
    using Lanes = std::array<std::optional<Lane>, kLanes>;

    Lane& lane(int i) {
        if (!lanes_) lanes_.emplace();
        auto& lane = (*lanes_)[static_cast<std::size_t>(i)];
        if (!lane) lane.emplace(hierarchy_.tree, asked_.single()[i], asked_.range(i));
        return *lane;
    }

    const wide::Hierarchy& hierarchy_;
    const Asked& asked_;
    std::optional<Lanes> lanes_;
};

}  // namespace rays::packets
