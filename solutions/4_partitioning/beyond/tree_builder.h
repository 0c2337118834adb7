// How the hierarchy is built.
//
// Binary first, then collapsed to eight children in the way that costs least (Ylitie, Karras, Laine, "Efficient
// Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs", 2017, section 3.1).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <future>
#include <utility>
#include <vector>

#include "4_partitioning/beyond/best_split.h"
#include "4_partitioning/beyond/wide_tree.h"

namespace rays::wide {

class Builder {
public:
    /// At most `most_in_block` triangles, spheres or cones go into a leaf, up to kWidth.
    Builder(const PrimitiveTester& tester, std::vector<Item> items, std::uint32_t most_in_block)
        : tester_(tester), items_(std::move(items)), nodes_(2 * items_.size()), most_in_block_(most_in_block) {
        if (!items_.empty()) split(0, 0, static_cast<std::uint32_t>(items_.size()), 0);
    }

    Tree collapsed() {
        Tree tree(tester_);
        if (!items_.empty()) {
            plan(0);
            tree.reserve(Tree::lines_of<List> + lines_below(0));
            tree.add(Child::Kind::list, List());
            collapse(0, tree);
        }
        items_ = {};
        nodes_ = {};
        return tree;
    }

private:
    struct BinaryNode {
        FloatBox box;
        std::uint32_t begin = 0, end = 0;  ///< of a leaf
        std::uint32_t right = 0;           ///< of an inner node, whose left one comes after it; 0: a leaf
        /// Of an inner node that may become up to k children of a wide one: how many of them come from its left side,
        /// at k - 1; 0 where it is best a child itself.
        std::array<std::uint8_t, kWidth> from_left{1, 1, 1, 1, 1, 1, 1, 1};
    };
    static constexpr std::uint32_t kParallelFrom = 8192;  ///< below, a thread costs more than it saves

    /// Of asking a primitive, where opening a pair of boxes is 1; measured (NOTES.md).
    static constexpr float cost_of(LeafKind kind) {
        return kind == LeafKind::list ? 1.0f : kind == LeafKind::cones ? 0.5f : 0.3f;
    }
    std::uint32_t most_in_leaf(LeafKind kind) const { return kind == LeafKind::list ? 2 : most_in_block_; }

    // A subtree of n items needs at most 2 n - 1 nodes, so the place of each follows from where its items begin:
    // threads share nothing, and the tree does not depend on them.
    void split(std::uint32_t index, std::uint32_t begin, std::uint32_t end, int depth) {
        BinaryNode& node = nodes_[index];
        node = {};
        Corners corners, centers;
        std::optional<LeafKind> kind = items_[begin].kind();
        for (std::uint32_t i = begin; i < end; ++i) {
            corners.add(items_[i].corners());
            centers.add(items_[i].center());
            if (kind) kind = together(*kind, items_[i].kind());
        }
        node.box = corners.box();
        node.begin = begin;
        node.end = end;
        const std::uint32_t count = end - begin;
        if (count == 1 || (kind && count <= most_in_leaf(*kind))) return;
        const Bins bins(centers, count);
        const Split best = bins.best_split({&items_[begin], count}, cost_of);
        std::uint32_t middle = begin + count / 2;
        if (best.axis >= 0 && depth < 64) {
            const auto first = items_.begin() + begin, last = items_.begin() + end;
            const auto mid = std::partition(first, last, [&](const Item& item) { return bins.is_before(best, item); });
            middle = static_cast<std::uint32_t>(mid - items_.begin());
        }  // else all centres coincide: any halves will do
        node.right = index + 2 * (middle - begin);
        if (count >= kParallelFrom && depth < 4) {
            auto other = std::async(std::launch::async, [this, index, begin, middle, depth] {
                split(index + 1, begin, middle, depth + 1);
            });
            split(node.right, middle, end, depth + 1);
            other.get();
        } else {
            split(index + 1, begin, middle, depth + 1);
            split(node.right, middle, end, depth + 1);
        }
    }

    bool is_leaf(std::uint32_t index) const { return nodes_[index].right == 0; }

    /// What a subtree costs at least when it becomes up to 1, 2, .. kWidth - 1 children of a wide node: the areas of
    /// the wide nodes and leaves that it consists of.
    using Costs = std::array<float, kWidth - 1>;

    Costs plan(std::uint32_t index) {
        BinaryNode& node = nodes_[index];
        Costs costs;
        costs.fill(node.box.half_area());
        if (is_leaf(index)) return costs;
        const Costs left = plan(index + 1), right = plan(node.right);
        const auto cheapest = [&](int children) {
            float least = kMaxFloat;
            for (int l = std::max(1, children + 1 - kWidth); l < std::min(children, kWidth); ++l) {
                const float cost = left[l - 1] + right[children - l - 1];
                if (cost < least) least = cost, node.from_left[children - 1] = static_cast<std::uint8_t>(l);
            }
            return least;
        };
        costs[0] += cheapest(kWidth);  // a wide node of its own
        for (int most = 2; most < kWidth; ++most) {
            costs[most - 1] = cheapest(most);
            if (costs[most - 1] < costs[most - 2]) continue;
            costs[most - 1] = costs[most - 2];
            node.from_left[most - 1] = most == 2 ? 0 : node.from_left[most - 2];
        }
        return costs;
    }

    struct Children {
        std::array<std::uint32_t, kWidth> of;
        int count = 0;
    };

    /// What a node becomes where a wide node has room for `most` children, as planned.
    void gather(std::uint32_t index, int most, Children& children) const {
        const BinaryNode& node = nodes_[index];
        const int from_left = most == 1 || is_leaf(index) ? 0 : node.from_left[most - 1];
        if (from_left == 0) {
            children.of[children.count++] = index;
            return;
        }
        gather(index + 1, from_left, children);
        gather(node.right, most - from_left, children);
    }

    std::size_t lines_below(std::uint32_t root) const {
        Children children;
        gather(root, kWidth, children);
        std::size_t lines = Tree::lines_of<Node>;
        for (int i = 0; i < children.count; ++i) {
            const std::uint32_t child = children.of[i];
            lines += is_leaf(child) ? lines_of(kind_of(nodes_[child])) : lines_below(child);
        }
        return lines;
    }

    static std::size_t lines_of(LeafKind kind) {
        switch (kind) {
            case LeafKind::triangles: return Tree::lines_of<TriangleBlock>;
            case LeafKind::spheres: return Tree::lines_of<SphereBlock>;
            case LeafKind::cones: return Tree::lines_of<ConeBlock>;
            case LeafKind::list: break;
        }
        return Tree::lines_of<List>;
    }

    LeafKind kind_of(const BinaryNode& leaf) const {
        LeafKind kind = items_[leaf.begin].kind();
        for (std::uint32_t k = leaf.begin; k < leaf.end; ++k) kind = *together(kind, items_[k].kind());
        return kind;
    }

    Child collapse(std::uint32_t root, Tree& tree) {
        Children children;
        gather(root, kWidth, children);
        Node node;
        const Child place = tree.add(Child::Kind::node, node);
        for (int i = 0; i < kWidth; ++i) {
            const bool is_there = i < children.count;
            node.set(static_cast<std::size_t>(i), is_there ? nodes_[children.of[i]].box : FloatBox{});
            node.child[i] = !is_there                 ? Tree::nobody()
                            : is_leaf(children.of[i]) ? leaf(nodes_[children.of[i]], tree)
                                                      : collapse(children.of[i], tree);
        }
        tree.set(place, node);
        return place;
    }

    Child leaf(const BinaryNode& leaf, Tree& tree) const {
        switch (kind_of(leaf)) {
            case LeafKind::triangles: return tree.add(Child::Kind::triangles, triangles(leaf));
            case LeafKind::spheres: return tree.add(Child::Kind::spheres, block_of<SphereBlock>(leaf));
            case LeafKind::cones: return tree.add(Child::Kind::cones, block_of<ConeBlock>(leaf));
            case LeafKind::list: break;
        }
        List list;
        for (std::uint32_t k = leaf.begin; k < leaf.end; ++k) list.primitive[list.count++] = items_[k].primitive();
        return tree.add(Child::Kind::list, list);
    }

    template <class Block>
    Block block_of(const BinaryNode& leaf) const {
        Block block;
        for (std::uint32_t k = leaf.begin; k < leaf.end; ++k) {
            const std::uint32_t primitive = items_[k].primitive();
            const std::uint32_t shape = tester_.dispatch(primitive).shape;
            if (items_[k].kind() == LeafKind::spheres)
                put(block, tester_.scene().spheres[shape], primitive);
            else if constexpr (std::is_same_v<Block, ConeBlock>)
                put(block, tester_.scene().cones[shape], primitive);
        }
        return block;
    }

    TriangleBlock triangles(const BinaryNode& leaf) const {
        TriangleBlock block;
        for (std::uint32_t k = leaf.begin; k < leaf.end; ++k) {
            const std::uint32_t primitive = items_[k].primitive();
            put(block, triangle_of(tester_.scene(), tester_.primitive(primitive)), primitive);
        }
        put_faces(block);
        return block;
    }

    /// Where all are faces of one mesh.
    void put_faces(TriangleBlock& block) const {
        const auto of = [&](std::uint32_t lane) { return tester_.primitive(block.primitive[lane]); };
        const Object& object = tester_.scene().objects[of(0).object];
        block.is_of_one_mesh = object.kind == ShapeKind::mesh;
        for (std::uint32_t lane = 1; lane < block.count; ++lane)
            block.is_of_one_mesh = block.is_of_one_mesh && of(lane).object == of(0).object;
        if (!block.is_of_one_mesh) return;
        block.first = tester_.dispatch(block.primitive[0]);
        for (std::uint32_t lane = 0; lane < block.count; ++lane)
            for (std::size_t c = 0; c < 3; ++c)
                block.position[c][lane] = tester_.scene().meshes[object.shape].faces[of(lane).part].position[c];
    }

    const PrimitiveTester& tester_;
    std::vector<Item> items_;
    std::vector<BinaryNode> nodes_;
    std::uint32_t most_in_block_;
};

}  // namespace rays::wide
