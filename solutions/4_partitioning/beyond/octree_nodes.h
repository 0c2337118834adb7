// What is kept of an octree: eight nodes of eight bytes a family, on one line of the cache.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace rays::octree {

struct Node {
    std::uint32_t first = 0;  ///< of a leaf: into items; else the family of its eight children
    std::uint32_t count = 0;  ///< of a leaf: how many items; else kInner, and a bit for each child that is not empty
    bool is_leaf() const { return count < kInner; }
    bool is_empty() const { return count == 0; }
    unsigned children() const { return count & 0xff; }
    static constexpr std::uint32_t kInner = 0xffffff00;
};

struct alignas(64) Family {
    std::array<Node, 8> children;
};

struct Tree {
    static constexpr std::uint32_t kRoot = 0xffffffff;
    /// Families move while they are made, so a node is known by its place.
    struct Place {
        std::uint32_t family = kRoot;
        unsigned octant = 0;
    };

    Node root;
    LargeVector<Family> families;
    LargeVector<std::uint32_t> items;

    Node& at(Place place) { return place.family == kRoot ? root : families[place.family].children[place.octant]; }

    /// Eight empty children for the node there; returns their family.
    std::uint32_t add_family(Place place) {
        const auto family = static_cast<std::uint32_t>(families.size());
        families.emplace_back();
        at(place) = {family, Node::kInner};
        return family;
    }

    void make_leaf(Place place, const std::vector<std::uint32_t>& list) {
        at(place) = {static_cast<std::uint32_t>(items.size()), static_cast<std::uint32_t>(list.size())};
        items.insert(items.end(), list.begin(), list.end());
    }

    /// Once all is there: tells every node which of its children there are, and gives back what is left of the memory.
    void finish() {
        const auto count_children = [&](Node& node) {
            if (node.is_leaf()) return;
            for (unsigned o = 0; o < 8; ++o)
                if (!families[node.first].children[o].is_empty()) node.count |= 1u << o;
        };
        count_children(root);
        for (Family& family : families)
            for (Node& node : family.children) count_children(node);
        families.shrink_to_fit();
        items.shrink_to_fit();
    }

    /// Puts a tree that was made by itself where its root belongs.
    void attach(Place place, Tree&& subtree) {
        const auto more_families = static_cast<std::uint32_t>(families.size());
        const auto more_items = static_cast<std::uint32_t>(items.size());
        const auto moved = [&](Node node) {
            return Node{node.first + (node.is_leaf() ? more_items : more_families), node.count};
        };
        at(place) = moved(subtree.root);
        for (Family& family : subtree.families) {
            for (Node& node : family.children) node = moved(node);
            families.push_back(family);
        }
        items.insert(items.end(), subtree.items.begin(), subtree.items.end());
        subtree = {};
    }
};

}  // namespace rays::octree
