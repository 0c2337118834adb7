// One ray's way through the hierarchy, or through a part of it.
#pragma once

#include <bit>
#include <optional>

#include "4_partitioning/beyond/box_ray.h"
#include "4_partitioning/beyond/wide_tree.h"
#include "4_partitioning/effort.h"

namespace rays::wide {

class SingleWalk {
public:
    /// Of a ray that goes forward: 0 <= range.min. The ray must outlive it.
    SingleWalk(const Tree& tree, const Ray& ray, Interval range)
        : tree_(tree), ray_(ray), range_(range), box_ray_(ray, range) {
        far_ = above(range.max);
    }

    /// Somebody has a root at t: nothing behind it counts any more.
    void shorten(Real t) {
        found_ = t;
        end_at(std::min(far_, above(t)));
    }

    /// Asks the primitives below `from` that the ray may meet until ask(primitive) says enough, and says whether it
    /// did.
    template <class Ask>
    bool any_below(Child from, const Ask& ask) {
        return visit<false>(from, ask);
    }

    /// Asks all primitives below `from` that may have the nearest root, near boxes first; ask(primitive) shortens.
    ///
    /// Triangles are asked last of all. A block that is certain of a root ends the walk there at once, and while the
    /// walk goes on, what the question needs is fetched: among millions, asking takes longer than the block. If nobody
    /// turns out to have a root where a block was certain (a clip, a back face, a student's own triangles), everything
    /// is asked once more, by blocks that are certain of nothing.
    template <class Ask>
    void nearest_below(Child from, const Ask& ask) {
        const float before = far_;
        certain_until_ = kMaxFloat;
        for (is_trusting_ = true;; is_trusting_ = false) {
            visit<true>(from, [&](std::uint32_t primitive, const PrimitiveTester::Dispatch& d) {
                return ask(primitive, d), false;
            });
            ask_postponed(ask);
            if (!is_trusting_ || certain_until_ == kMaxFloat || found_ <= certain_until_) return;
            end_at(std::min(before, above(found_)));
        }
    }

private:
    struct Stack {
        Waiting waiting[kMostWaiting];
        int size = 0;
    };
    /// A triangle that is still to be asked, and where its root is at the earliest.
    struct Postponed {
        float earliest;
        int lane;
        const TriangleBlock* block;
    };
    static constexpr int kMostPostponed = 8;

    void end_at(float far) {
        far_ = far;
        box_ray_.end_at(far);
    }

    template <bool sorted, class Ask>
    bool visit(Child from, const Ask& ask) {
        Stack stack;
        Waiting next(0, from.bits());
        do {
            if (!descend<sorted>(next, stack)) break;
            if (effort_ && effort_->visited) [[unlikely]]
                watch(Child(next.what()));
            if (ask_leaf<sorted>(Child(next.what()), ask)) return true;
        } while (pop(next, stack));
        return false;
    }

    bool pop(Waiting& next, Stack& stack) const {
        do {
            if (stack.size == 0) return false;
            next = stack.waiting[--stack.size];
        } while (next.is_behind(far_));
        return true;
    }

    /// Down from `next` to a leaf, always to the nearest child when sorted; the other children that the ray meets wait
    /// on the stack, nearer ones on top. False when it meets no leaf: then there is nothing in hand.
    template <bool sorted>
    bool descend(Waiting& next, Stack& stack) const {
        while (Child(next.what()).kind() == Child::Kind::node) {
            if (effort_) [[unlikely]]
                ++effort_->nodes;
            const Node& node = tree_.node(Child(next.what()));
            alignas(32) float enters[kWidth];
            unsigned mask = box_ray_.meets(node, enters);
            if (mask == 0) {
                if (!pop(next, stack)) return false;
                continue;
            }
            const auto next_child = [&] {
                const int i = std::countr_zero(mask);
                mask &= mask - 1;
                tree_.fetch(node.child[i]);
                return Waiting(enters[i], node.child[i].bits());
            };
            next = next_child();
            const int first = stack.size;
            while (mask != 0) {
                Waiting other = next_child();
                if (sorted && other.is_nearer_than(next)) std::swap(other, next);
                int place = stack.size++;
                if constexpr (sorted)
                    for (; place > first && stack.waiting[place - 1].is_nearer_than(other); --place)
                        stack.waiting[place] = stack.waiting[place - 1];
                stack.waiting[place] = other;
            }
        }
        return true;
    }

    /// For pictures: leaves do not know their boxes, so all nodes are searched for who does.
    void watch(Child leaf, Child from = Tree::root()) const {
        const Node& node = tree_.node(from);
        for (int i = 0; i < kWidth; ++i) {
            if (node.lo(0)[i] > node.hi(0)[i]) continue;  // nobody
            if (node.child[i].kind() == Child::Kind::node) watch(leaf, node.child[i]);
            if (node.child[i].bits() != leaf.bits()) continue;
            const auto corner = [i](const auto& planes) { return Vec3(planes(0)[i], planes(1)[i], planes(2)[i]); };
            effort_->visited->push_back(
                {corner([&](int a) { return node.lo(a); }), corner([&](int a) { return node.hi(a); })});
        }
    }

    template <bool sorted, class Ask>
    bool ask_leaf(Child leaf, const Ask& ask) {
        switch (leaf.kind()) {
            case Child::Kind::triangles:
                if constexpr (sorted) return postpone(tree_.triangles(leaf), ask), false;
                return ask_triangles(tree_.triangles(leaf), ask);
            case Child::Kind::spheres: return ask_round(tree_.spheres(leaf), tree_.spheres(leaf).primitive, ask);
            case Child::Kind::cones: return ask_round(tree_.cones(leaf), tree_.cones(leaf).around.primitive, ask);
            default: break;
        }
        const List& list = tree_.list(leaf);
        for (std::uint32_t k = 0; k < list.count; ++k)
            if (ask(list.primitive[k], tree_.dispatch(list.primitive[k]))) return true;
        return false;
    }

    template <class Block, class Numbers, class Ask>
    bool ask_round(const Block& block, const Numbers& numbers, const Ask& ask) {
        if (!sphere_ray_) sphere_ray_.emplace(ray_, range_);
        for (unsigned mask = sphere_ray_->may_meet(block, far_); mask != 0; mask &= mask - 1)
            if (const auto p = numbers[std::countr_zero(mask)]; ask(p, tree_.dispatch(p))) return true;
        return false;
    }

    template <class Ask>
    bool ask_triangles(const TriangleBlock& block, const Ask& ask) {
        if (!triangle_ray_) triangle_ray_.emplace(ray_, range_);
        for (unsigned mask = triangle_ray_->may_meet(block, far_); mask != 0; mask &= mask - 1)
            if (const int i = std::countr_zero(mask); ask(block.primitive[i], tree_.dispatch(block, i))) return true;
        return false;
    }

    template <class Ask>
    void postpone(const TriangleBlock& block, const Ask& ask) {
        if (!triangle_ray_) triangle_ray_.emplace(ray_, range_);
        const TriangleRoots roots = triangle_ray_->roots(block, far_);
        for (unsigned mask = roots.may; mask != 0; mask &= mask - 1) {
            const int i = std::countr_zero(mask);
            if (postponed_count_ == kMostPostponed) ask_postponed(ask);
            postponed_[postponed_count_++] = {roots.earliest[i], i, &block};
            tree_.fetch(block, i);
            if (is_trusting_ && (roots.must >> i & 1) && roots.latest[i] < far_) {
                certain_until_ = roots.latest[i];
                end_at(certain_until_);
            }
        }
    }

    /// The last first: it ended the walk.
    template <class Ask>
    void ask_postponed(const Ask& ask) {
        while (postponed_count_ > 0) {
            const Postponed next = postponed_[--postponed_count_];
            if (next.earliest <= far_) ask(next.block->primitive[next.lane], tree_.dispatch(*next.block, next.lane));
        }
    }

    const Tree& tree_;
    const Ray& ray_;
    Effort* const effort_ = effort;  ///< looked up once: it is the thread's
    Interval range_;
    BoxRay box_ray_;
    float far_;
    Real found_ = kInfinity;
    float certain_until_ = kMaxFloat;  ///< the latest that the root can be of which blocks are certain
    bool is_trusting_ = true;          ///< believes them
    int postponed_count_ = 0;
    Postponed postponed_[kMostPostponed];  // without values: those up to the count have them
    std::optional<TriangleRay> triangle_ray_;
    std::optional<SphereRay> sphere_ray_;
};

}  // namespace rays::wide
