// The hierarchy of a scene as a whole: its tree, and what has no box.
#pragma once

#include <memory>
#include <vector>

#include "4_partitioning/beyond/wide_tree.h"
#include "4_partitioning/primitive_tester.h"
#include "core/intersector.h"

namespace rays::wide {

struct Hierarchy {
    Hierarchy(const Scene& scene, std::uint32_t most_in_leaf) : tester(scene) {
        std::vector<Item> items;
        items.reserve(tester.size());
        for (std::uint32_t i = 0; i < tester.size(); ++i) {
            const Bounds bounds = bounds_of(scene, tester.primitive(i));
            if (!bounds.is_finite())
                unbounded.push_back(i);
            else
                items.push_back({widened(bounds), i, leaf_kind(scene, tester.primitive(i))});
        }
        tree = Builder(tester, std::move(items), most_in_leaf).collapsed();
    }

    PrimitiveTester tester;
    std::vector<std::uint32_t> unbounded;
    Tree tree;
};

std::shared_ptr<const Hierarchy> make_hierarchy(const Scene& scene);
/// Single rays through it.
class SingleRays : public Intersector {
public:
    /// As `occluded`. `last` is the primitive to be asked first, if any; afterwards, the one that blocks.
    virtual bool blocked(const Ray& ray, Interval range, std::uint32_t& last) const = 0;
};
std::unique_ptr<SingleRays> make_bvh(std::shared_ptr<const Hierarchy> hierarchy);

}  // namespace rays::wide
