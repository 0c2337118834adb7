// A hierarchy of boxes with eight children a node: its nodes, and how it is built.
//
// Binned surface area heuristic (Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", 2007), binary
// first, then collapsed to eight children in the way that costs least (Ylitie, Karras, Laine, "Efficient Incoherent Ray
// Traversal on GPUs Through Compressed Wide BVHs", 2017, section 3.1).
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <future>
#include <type_traits>
#include <utility>
#include <vector>

#include "4_partitioning/beyond/float_box.h"
#include "4_partitioning/beyond/leaf_blocks.h"
#include "4_partitioning/primitive_tester.h"
#include "core/large_pages.h"

namespace rays::wide {

/// What a child is, in one number: its kind in the upper three bits, its place in the rest.
class Child {
public:
    enum class Kind : std::uint32_t { node, list, triangles, spheres, cones };

    Child() = default;
    explicit Child(std::uint32_t bits) : bits_(bits) {}
    Child(Kind kind, std::size_t place)
        : bits_(static_cast<std::uint32_t>(kind) << 29 | static_cast<std::uint32_t>(place)) {}
    Kind kind() const { return static_cast<Kind>(bits_ >> 29); }
    std::uint32_t place() const { return bits_ & 0x1fffffff; }
    std::uint32_t bits() const { return bits_; }

private:
    std::uint32_t bits_;  // without a value of its own: stacks of these cost nothing to make
};

/// What is still to be looked at, and where a ray enters it. One word: who loads at once what was stored in two waits.
class Waiting {
public:
    Waiting() = default;
    Waiting(float enters, std::uint32_t what)
        : both_(std::uint64_t(std::bit_cast<std::uint32_t>(enters)) << 32 | what) {}
    float enters() const { return std::bit_cast<float>(static_cast<std::uint32_t>(both_ >> 32)); }
    std::uint32_t what() const { return static_cast<std::uint32_t>(both_); }

private:
    std::uint64_t both_;  // without a value of its own, either
};
inline constexpr int kMostWaiting = 8 * 80;  ///< splits stop being uneven at depth 64; then halves of 2^32 items

/// Eight children and their boxes.
struct alignas(64) Node : Boxes {
    Child child[kWidth];
};

struct Tree {
    LargeVector<Node> nodes;
    std::vector<std::uint32_t> lists;  ///< leaf by leaf: how many, and then the primitives
    LargeVector<TriangleBlock> triangles;
    LargeVector<SphereBlock> spheres;
    LargeVector<ConeBlock> cones;
    const PrimitiveTester::Dispatch* dispatch = nullptr;  ///< of all primitives

    static Child root() { return {Child::Kind::node, 0}; }

    /// Among millions, what a ray meets is waited for: asked for all at once, it comes side by side. In line, because
    /// GCC drops calls of functions that do nothing but this.
    [[gnu::always_inline]] void fetch(Child child) const {
        switch (child.kind()) {
            case Child::Kind::node: return fetch(nodes[child.place()]);
            case Child::Kind::triangles: return fetch(triangles[child.place()]);
            case Child::Kind::spheres: return fetch(spheres[child.place()]);
            case Child::Kind::cones: return fetch(cones[child.place()]);
            case Child::Kind::list: return;
        }
    }

    /// What asking a triangle begins with.
    [[gnu::always_inline]] void fetch(const TriangleBlock& block, int lane) const {
        const std::uint32_t primitive = block.primitive[lane];
        __builtin_prefetch(dispatch + primitive);
        if (block.faces) __builtin_prefetch(block.faces + (primitive - block.first_face));
    }

private:
    template <class Lines>
    [[gnu::always_inline]] static void fetch(const Lines& lines) {
        for (std::size_t i = 0; i < sizeof lines; i += 64)
            __builtin_prefetch(reinterpret_cast<const char*>(&lines) + i);
    }
};

/// What goes into the tree.
struct Item {
    FloatBox box;
    std::uint32_t primitive;
    LeafKind kind;
    float center(int a) const { return box.lo[a] + box.hi[a]; }  // twice the centre: only compared
};

class Builder {
public:
    /// At most `most_in_block` triangles, spheres or cones go into a leaf, up to kWidth.
    Builder(const PrimitiveTester& tester, std::vector<Item> items, std::uint32_t most_in_block)
        : tester_(tester), items_(std::move(items)), nodes_(2 * items_.size()), most_in_block_(most_in_block) {
        if (!items_.empty()) split(0, 0, static_cast<std::uint32_t>(items_.size()), 0);
    }

    Tree collapsed() {
        Tree tree;
        if (!items_.empty()) {
            tree.dispatch = &tester_.dispatch(0);
            plan(0);
            collapse(0, tree);
        }
        items_ = {};
        nodes_ = {};
        tree.nodes.shrink_to_fit();
        tree.lists.shrink_to_fit();
        tree.triangles.shrink_to_fit();
        tree.spheres.shrink_to_fit();
        tree.cones.shrink_to_fit();
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
    struct Bin {
        FloatBox box;
        std::uint32_t count = 0;
        float cost = 0;
    };
    struct Plane {
        int axis = -1;
        std::uint32_t bin = 0;
        float cost = kMaxFloat;
    };

    static constexpr std::uint32_t kBins = 16;
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
        FloatBox centers;
        std::optional<LeafKind> kind = items_[begin].kind;
        for (std::uint32_t i = begin; i < end; ++i) {
            node.box.add(items_[i].box);
            FloatBox c;
            for (int a = 0; a < 3; ++a) c.lo[a] = c.hi[a] = items_[i].center(a);
            centers.add(c);
            if (kind) kind = together(*kind, items_[i].kind);
        }
        node.begin = begin;
        node.end = end;
        const std::uint32_t count = end - begin;
        if (count == 1 || (kind && count <= most_in_leaf(*kind))) return;
        const Plane plane = best_plane(begin, end, centers);
        std::uint32_t middle = begin + count / 2;
        if (plane.axis >= 0 && depth < 64) {
            const auto first = items_.begin() + begin, last = items_.begin() + end;
            const auto mid = std::partition(
                first, last, [&](const Item& item) { return bin_of(item, plane.axis, centers) <= plane.bin; });
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

    static std::uint32_t bin_of(const Item& item, int axis, const FloatBox& centers) {
        const float extent = centers.hi[axis] - centers.lo[axis];
        const float place = (item.center(axis) - centers.lo[axis]) / extent * kBins;
        return std::min(kBins - 1, static_cast<std::uint32_t>(place));
    }

    Plane best_plane(std::uint32_t begin, std::uint32_t end, const FloatBox& centers) const {
        Plane best;
        for (int axis = 0; axis < 3; ++axis) {
            const float extent = centers.hi[axis] - centers.lo[axis];
            if (!(extent > 0) || !(extent < kMaxFloat)) continue;
            std::array<Bin, kBins> bins;
            for (std::uint32_t i = begin; i < end; ++i) {
                Bin& bin = bins[bin_of(items_[i], axis, centers)];
                bin.box.add(items_[i].box);
                ++bin.count;
                bin.cost += cost_of(items_[i].kind);
            }
            std::array<float, kBins> from_right{};
            Bin right;
            for (std::uint32_t i = kBins - 1; i > 0; --i) {
                right.box.add(bins[i].box);
                right.cost += bins[i].cost;
                from_right[i] = right.cost * right.box.half_area();
            }
            Bin left;
            for (std::uint32_t i = 0; i + 1 < kBins; ++i) {
                left.box.add(bins[i].box);
                left.count += bins[i].count;
                left.cost += bins[i].cost;
                const float cost = left.cost * left.box.half_area() + from_right[i + 1];
                if (left.count > 0 && left.count < end - begin && cost < best.cost) best = {axis, i, cost};
            }
        }
        return best;
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

    std::uint32_t collapse(std::uint32_t root, Tree& tree) {
        Children children;
        gather(root, kWidth, children);
        const auto index = static_cast<std::uint32_t>(tree.nodes.size());
        tree.nodes.emplace_back();
        for (int i = 0; i < kWidth; ++i) {
            const FloatBox box = i < children.count ? nodes_[children.of[i]].box : FloatBox{};
            tree.nodes[index].set(static_cast<std::size_t>(i), box);
            if (i >= children.count) continue;
            const BinaryNode& node = nodes_[children.of[i]];
            const Child child =
                is_leaf(children.of[i]) ? leaf(node, tree) : Child(Child::Kind::node, collapse(children.of[i], tree));
            tree.nodes[index].child[i] = child;
        }
        return index;
    }

    Child leaf(const BinaryNode& leaf, Tree& tree) const {
        LeafKind kind = items_[leaf.begin].kind;
        for (std::uint32_t k = leaf.begin; k < leaf.end; ++k) kind = *together(kind, items_[k].kind);
        switch (kind) {
            case LeafKind::triangles: return {Child::Kind::triangles, add_block(tree.triangles, leaf)};
            case LeafKind::spheres: return {Child::Kind::spheres, add_block(tree.spheres, leaf)};
            case LeafKind::cones: return {Child::Kind::cones, add_block(tree.cones, leaf)};
            case LeafKind::list: break;
        }
        const Child child(Child::Kind::list, tree.lists.size());
        tree.lists.push_back(leaf.end - leaf.begin);
        for (std::uint32_t k = leaf.begin; k < leaf.end; ++k) tree.lists.push_back(items_[k].primitive);
        return child;
    }

    template <class Block>
    std::size_t add_block(LargeVector<Block>& blocks, const BinaryNode& leaf) const {
        Block& block = blocks.emplace_back();
        for (std::uint32_t k = leaf.begin; k < leaf.end; ++k) {
            const std::uint32_t primitive = items_[k].primitive;
            const std::uint32_t shape = tester_.dispatch(primitive).shape;
            if constexpr (std::is_same_v<Block, TriangleBlock>)
                put(block, triangle_of(tester_.scene(), tester_.primitive(primitive)), primitive);
            else if (items_[k].kind == LeafKind::spheres)
                put(block, tester_.scene().spheres[shape], primitive);
            else if constexpr (std::is_same_v<Block, ConeBlock>)
                put(block, tester_.scene().cones[shape], primitive);
        }
        if constexpr (std::is_same_v<Block, TriangleBlock>) set_faces(block);
        return blocks.size() - 1;
    }

    void set_faces(TriangleBlock& block) const {
        const auto of = [&](std::uint32_t lane) { return tester_.primitive(block.primitive[lane]); };
        const Object& object = tester_.scene().objects[of(0).object];
        if (object.kind != ShapeKind::mesh) return;
        for (std::uint32_t lane = 1; lane < block.count; ++lane)
            if (of(lane).object != of(0).object) return;
        block.faces = tester_.scene().meshes[object.shape].faces.data();
        block.first_face = block.primitive[0] - of(0).part;
    }

    const PrimitiveTester& tester_;
    std::vector<Item> items_;
    std::vector<BinaryNode> nodes_;
    std::uint32_t most_in_block_;
};

}  // namespace rays::wide
