// A hierarchy of boxes with eight children a node: what it consists of, and how that lies in memory.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "4_partitioning/beyond/float_box.h"
#include "4_partitioning/beyond/leaf_blocks.h"
#include "4_partitioning/primitive_tester.h"
#include "core/large_pages.h"

namespace rays::wide {

/// What a child is, in one number: the line of the cache that it begins with, and in the lower three bits its kind. A
/// node's number is an eighth of its place in bytes, which is an address without any arithmetic.
class Child {
public:
    enum class Kind : std::uint32_t { node, list, triangles, spheres, cones };

    Child() = default;
    explicit Child(std::uint32_t bits) : bits_(bits) {}
    Child(Kind kind, std::size_t line)
        : bits_(static_cast<std::uint32_t>(line << 3) | static_cast<std::uint32_t>(kind)) {}
    Kind kind() const { return static_cast<Kind>(bits_ & 7); }
    /// In bytes from where the tree begins.
    std::size_t place() const { return std::size_t(bits_ & ~7u) * 8; }
    std::uint32_t bits() const { return bits_; }

private:
    std::uint32_t bits_;  // without a value of its own: stacks of these cost nothing to make
};

/// What is still to be looked at, and where a ray enters it. One word: who loads at once what was stored in two waits.
/// Of floats that are not negative, the greater has the greater bits, and words compare sooner. (-0 comes first of
/// all.)
class Waiting {
public:
    Waiting() = default;
    Waiting(float enters, std::uint32_t what)
        : both_(static_cast<std::int64_t>(std::uint64_t(std::bit_cast<std::uint32_t>(enters)) << 32 | what)) {}
    float enters() const { return std::bit_cast<float>(static_cast<std::uint32_t>(both_ >> 32)); }
    std::uint32_t what() const { return static_cast<std::uint32_t>(both_); }
    bool is_nearer_than(Waiting other) const { return both_ < other.both_; }
    bool is_behind(float t) const { return static_cast<std::int32_t>(both_ >> 32) > std::bit_cast<std::int32_t>(t); }

private:
    std::int64_t both_;  // without a value of its own, either
};
inline constexpr int kMostWaiting = 8 * 80;  ///< splits stop being uneven at depth 64; then halves of 2^32 items

/// Eight children and their boxes.
struct alignas(64) Node : Boxes {
    Child child[kWidth];
};

/// What fits into no block.
struct List {
    std::uint32_t count = 0;
    std::uint32_t primitive[2] = {};
};

/// Nodes and leaves, one after the other, each in lines of the cache of its own.
class Tree {
public:
    Tree() = default;
    explicit Tree(const PrimitiveTester& tester) : tester_(&tester) {}

    struct alignas(64) Line {
        std::byte bytes[64];
    };
    template <class Part>
    static constexpr std::size_t lines_of = (sizeof(Part) + sizeof(Line) - 1) / sizeof(Line);

    bool empty() const { return node_count_ == 0; }
    std::size_t node_count() const { return node_count_; }
    bool has_triangles() const { return has_triangles_; }
    /// The list that everything begins with: it is empty. Where a node has fewer than eight children, a ray from beyond
    /// float may still meet what is not there.
    static Child nobody() { return {Child::Kind::list, 0}; }
    static Child root() { return {Child::Kind::node, lines_of<List>}; }

    const Node& node(Child child) const { return at<Node>(child); }
    const List& list(Child child) const { return at<List>(child); }
    const TriangleBlock& triangles(Child child) const { return at<TriangleBlock>(child); }
    const SphereBlock& spheres(Child child) const { return at<SphereBlock>(child); }
    const ConeBlock& cones(Child child) const { return at<ConeBlock>(child); }

    template <class Part>
    Child add(Child::Kind kind, const Part& part) {
        node_count_ += kind == Child::Kind::node;
        has_triangles_ |= kind == Child::Kind::triangles;
        const Child child(kind, lines_.size());
        lines_.resize(lines_.size() + lines_of<Part>);
        set(child, part);
        return child;
    }
    template <class Part>
    void set(Child child, const Part& part) {
        static_assert(std::is_trivially_copyable_v<Part>);
        std::memcpy(reinterpret_cast<std::byte*>(lines_.data()) + child.place(), &part, sizeof part);
    }
    void reserve(std::size_t lines) { lines_.reserve(lines); }

    const PrimitiveTester::Dispatch& dispatch(std::uint32_t primitive) const { return tester_->dispatch(primitive); }
    /// Of a triangle. What lies in the block already is not looked up.
    PrimitiveTester::Dispatch dispatch(const TriangleBlock& block, int lane) const {
        if (!block.is_of_one_mesh) return dispatch(block.primitive[lane]);
        PrimitiveTester::Dispatch face = block.first;
        face.primitive.part += block.primitive[lane] - block.primitive[0];
        return face;
    }

    /// Among millions, what a ray meets is waited for: asked for all at once, it comes side by side. As many lines as a
    /// node has, whatever it is: a branch would cost more than what is left of a block of triangles. In line, because
    /// GCC drops calls of functions that do nothing but this.
    [[gnu::always_inline]] void fetch(Child child) const {
        const std::byte* const part = bytes() + child.place();
        for (std::size_t i = 0; i < sizeof(Node); i += sizeof(Line)) __builtin_prefetch(part + i);
    }

    /// What asking a triangle begins with.
    [[gnu::always_inline]] void fetch(const TriangleBlock& block, int lane) const {
        if (!block.is_of_one_mesh) return __builtin_prefetch(&tester_->dispatch(block.primitive[lane]));
        const Mesh& mesh = tester_->scene().meshes[block.first.shape];
        __builtin_prefetch(&mesh.faces[block.first.primitive.part + (block.primitive[lane] - block.primitive[0])]);
        for (const auto& position : block.position) {
            const Vec3& corner = mesh.positions[position[lane]];
            __builtin_prefetch(&corner.x);
            __builtin_prefetch(&corner.z);  // on the next line, perhaps
        }
    }

private:
    const std::byte* bytes() const { return reinterpret_cast<const std::byte*>(lines_.data()); }

    template <class Part>
    const Part& at(Child child) const {
        return *reinterpret_cast<const Part*>(bytes() + child.place());
    }

    LargeVector<Line> lines_;
    std::size_t node_count_ = 0;
    bool has_triangles_ = false;
    const PrimitiveTester* tester_ = nullptr;
};

}  // namespace rays::wide
