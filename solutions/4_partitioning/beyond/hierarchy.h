// The hierarchy of a scene as a whole: its tree, and what has no box.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "4_partitioning/beyond/tree_builder.h"
#include "4_partitioning/primitive_tester.h"
#include "core/intersector.h"

namespace rays::wide {

/// The part of a box on the inner side of a plane, or a little more: how far it reaches along an axis when it reaches
/// as far as it can along the others. Not along axes that nearly run in the plane: a root that is a little off would be
/// far off there.
inline Bounds below_plane(Bounds box, const Plane& plane) {
    const Vec3& n = plane.normal;
    const Vec3 least = glm::min(n * box.min, n * box.max);
    for (int a = 0; a < 3; ++a) {
        const Real farthest = (plane.offset - (least[(a + 1) % 3] + least[(a + 2) % 3])) / n[a];
        if (n[a] > Real(0.1) && farthest < box.max[a]) box.max[a] = std::max(box.min[a], farthest);
        if (n[a] < Real(-0.1) && farthest > box.min[a]) box.min[a] = std::min(box.max[a], farthest);
    }
    return box;
}

/// Of models cut open a plane takes away what rays would ask most.
inline Bounds without_clipped(const Scene& scene, const Object& object, Bounds box) {
    if (object.clip == kNone) return box;
    for (const Object& clip : scene.clips[object.clip]) {
        if (clip.kind != ShapeKind::plane || clip.transform != kNone) continue;
        const Plane& plane = scene.planes[clip.shape];
        box = below_plane(box, clip.inverse ? Plane{-plane.normal, -plane.offset} : plane);
    }
    return box;
}

struct Hierarchy {
    Hierarchy(const Scene& scene, std::uint32_t most_in_leaf) : tester(scene) {
        std::vector<Item> items;
        items.reserve(tester.size());
        for (std::uint32_t i = 0; i < tester.size(); ++i) {
            const Bounds bounds = bounds_of(scene, tester.primitive(i));
            if (!bounds.is_finite())
                unbounded.push_back(i);
            else
                items.emplace_back(widened(without_clipped(scene, scene.objects[tester.primitive(i).object], bounds)),
                                   i, leaf_kind(scene, tester.primitive(i)));
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
