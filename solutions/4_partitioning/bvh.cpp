// Beyond the step: a bounding volume hierarchy with eight children a node. Boxes, triangles, spheres and cones are tested
// eight at once in float; they only decide whom to ask, and the shared test of a primitive, in `Real`, gives the
// answer.
#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>

#include "4_partitioning/primitive_tester.h"
#include "4_partitioning/structures.h"
#include "core/unfinished.h"
//> hidden
#include "4_partitioning/beyond/box_ray.h"
#include "4_partitioning/beyond/hierarchy.h"
//< hidden


namespace rays {

//> hidden
namespace {

using namespace wide;

constexpr std::uint32_t kMostInLeaf = 8;  ///< triangles or spheres; measured (NOTES.md)

class Bvh final : public SingleRays {
public:
    explicit Bvh(std::shared_ptr<const Hierarchy> hierarchy)
        : hierarchy_(std::move(hierarchy)),
          tester_(hierarchy_->tester),
          unbounded_(hierarchy_->unbounded),
          tree_(hierarchy_->tree) {}

    bool blocked(const Ray& ray, Interval range, std::uint32_t& last) const override {
        if (!is_ray(ray) || !(range.min < range.max)) return false;
        if (last != kNone && tester_.blocks(last, ray, range)) return true;
        const auto blocks = [&](std::uint32_t primitive) {
            if (!tester_.blocks(primitive, ray, range)) return false;
            last = primitive;
            return true;
        };
        return walk<false>(ray, range, {}, [&](std::uint32_t i, BoxRay&, float&) { return blocks(i); }) ||
               std::any_of(unbounded_.begin(), unbounded_.end(), blocks);
    }

private:
    struct LastOccluder {
        std::uint64_t of = 0;  ///< whose: an address could be a later structure's
        std::uint32_t primitive = kNone;
    };

    static std::uint64_t next_number() {
        static std::atomic<std::uint64_t> last{0};
        return ++last;
    }

    /// Still to be looked at.
    struct Open {
        float enters;
        Child child;
    };
    struct Stack {
        Open open[8 * 80];  ///< splits stop being uneven at depth 64; then halves of 2^32 items
        int size = 0;
    };

    std::optional<Hit> find_nearest(const Ray& ray, Interval range) const override {
        if (!is_ray(ray)) return std::nullopt;
        Candidate best;
        for (const std::uint32_t i : unbounded_) tester_.keep_nearer(i, ray, range, best);
        walk<true>(ray, range, best, [&](std::uint32_t primitive, BoxRay& box_ray, float& far) {
            const std::uint32_t before = best.primitive;
            tester_.keep_nearer(primitive, ray, range, best);
            if (best.primitive != before) {
                box_ray.shorten(best.root.t);
                far = above(best.root.t);
            }
            return false;
        });
        return tester_.complete(ray, best);
    }

    bool find_occluder(const Ray& ray, Interval range) const override {
        // Neighbouring points tend to lie in the same shadow: who blocked last is asked first.
        thread_local LastOccluder last;
        if (last.of != number_) last = {number_, kNone};
        return blocked(ray, range, last.primitive);
    }

    /// Asks the primitives that the ray may meet until ask(...) says enough; near boxes first, when sorted.
    template <bool sorted, class Ask>
    bool walk(const Ray& ray, Interval range, const Candidate& best, Ask ask) const {
        if (tree_.nodes.empty()) return false;
        if (range.min < 0) return ask_all(ray, range, ask);
        BoxRay box_ray(ray, range);
        float far = range.max < kMaxFloat ? above(range.max) : kMaxFloat;
        if (best.primitive != kNone) {
            box_ray.shorten(best.root.t);
            far = above(best.root.t);
        }
        std::optional<TriangleRay> triangle_ray;
        std::optional<SphereRay> sphere_ray;
        const auto ask_block = [&](const auto& block, const auto& numbers, auto& block_ray) {
            if (!block_ray) block_ray.emplace(ray, range);
            for (unsigned mask = block_ray->may_meet(block, far); mask != 0; mask &= mask - 1)
                if (ask(numbers[std::countr_zero(mask)], box_ray, far)) return true;
            return false;
        };
        const auto ask_leaf = [&](Child leaf) {
            const auto blocks = [&](const auto& all) -> const auto& { return all[leaf.place()]; };
            if (leaf.kind() == Child::Kind::triangles)
                return ask_block(blocks(tree_.triangles), blocks(tree_.triangles).primitive, triangle_ray);
            if (leaf.kind() == Child::Kind::spheres)
                return ask_block(blocks(tree_.spheres), blocks(tree_.spheres).primitive, sphere_ray);
            if (leaf.kind() == Child::Kind::cones)
                return ask_block(blocks(tree_.cones), blocks(tree_.cones).around.primitive, sphere_ray);
            const std::uint32_t* list = &tree_.lists[leaf.place()];
            for (std::uint32_t k = 1; k <= list[0]; ++k)
                if (ask(list[k], box_ray, far)) return true;
            return false;
        };
        Stack stack;
        for (Open open{0, Child(Child::Kind::node, 0)};;) {
            if (descend<sorted>(box_ray, open, stack) && ask_leaf(open.child)) return true;
            do {
                if (stack.size == 0) return false;
                open = stack.open[--stack.size];
            } while (open.enters > far);
        }
    }

    /// Down from `open` to a leaf, always to the nearest child when sorted; the other children that the ray meets wait
    /// on the stack, nearer ones on top. False when it meets no leaf: then there is nothing in hand.
    template <bool sorted>
    bool descend(const BoxRay& box_ray, Open& open, Stack& stack) const {
        while (open.child.kind() == Child::Kind::node) {
            if (effort) [[unlikely]]
                ++effort->nodes;
            const Node& node = tree_.nodes[open.child.place()];
            alignas(32) float enters[kWidth];
            unsigned mask = box_ray.meets(node, enters);
            if (mask == 0) return false;
            const auto next_child = [&] {
                const int i = std::countr_zero(mask);
                mask &= mask - 1;
                return Open{enters[i], node.child[i]};
            };
            open = next_child();
            for (const int first = stack.size; mask != 0;) {
                Open other = next_child();
                if (sorted && other.enters < open.enters) std::swap(other, open);
                int place = stack.size++;
                if constexpr (sorted)
                    for (; place > first && stack.open[place - 1].enters < other.enters; --place)
                        stack.open[place] = stack.open[place - 1];
                stack.open[place] = other;
            }
        }
        return true;
    }

    /// Boxes are for rays that go forward. Whoever looks back is rare enough to be asked everything.
    template <class Ask>
    bool ask_all(const Ray& ray, Interval range, Ask ask) const {
        BoxRay box_ray(ray, range);
        float far = kMaxFloat;
        for (std::uint32_t i = 0; i < tester_.size(); ++i)
            if (ask(i, box_ray, far)) return true;
        return false;
    }

    const std::shared_ptr<const Hierarchy> hierarchy_;
    const PrimitiveTester& tester_;
    const std::vector<std::uint32_t>& unbounded_;
    const Tree& tree_;
    const std::uint64_t number_ = next_number();
};

}  // namespace

std::shared_ptr<const Hierarchy> wide::make_hierarchy(const Scene& scene) {
    return std::make_shared<const Hierarchy>(scene, kMostInLeaf);
}

std::unique_ptr<SingleRays> wide::make_bvh(std::shared_ptr<const Hierarchy> hierarchy) {
    return std::make_unique<Bvh>(std::move(hierarchy));
}
//< hidden

std::unique_ptr<Intersector> make_bvh(const Scene& scene) {
    //> 4.10 Beyond the step: any structure of your own, the faster the better. Until then, the octree stands in.
    return wide::make_bvh(wide::make_hierarchy(scene));
    //< 4.10
}

}  // namespace rays
