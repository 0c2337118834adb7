// Step 4, spatial partitioning: the contract. From asking every primitive to asking the few that a ray may meet.
//
// All structures answer with the same bytes as brute force: they share one test of a primitive and one rule for ties
// (at equal t the primitive with the smaller number wins), and differ only in which primitives they ask.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "1_ray_casting/ray_casting.h"
#include "core/intersector.h"
#include "core/scene.h"

namespace rays {

// ---- Given: what is partitioned --------------------------------------------------------------------------------------

/// The smallest thing that is asked: an object, or one face of a mesh. Numbered by objects, then faces: that order
/// breaks ties.
struct Primitive {
    std::uint32_t object = 0;
    std::uint32_t part = 0;  ///< a mesh's face; else 0
};

/// All primitives of a scene, in their order.
std::vector<Primitive> primitives_of(const Scene& scene);

/// An axis-aligned box, faces included. Empty when min > max; unbounded things have infinite ones.
struct Bounds {
    Vec3 min{kInfinity};
    Vec3 max{-kInfinity};

    void add(const Bounds& other) {
        min = glm::min(min, other.min);
        max = glm::max(max, other.max);
    }
    bool is_finite() const { return rays::is_finite(min) && rays::is_finite(max); }
    bool overlaps(const Bounds& other) const {
        return glm::all(glm::lessThanEqual(min, other.max)) && glm::all(glm::lessThanEqual(other.min, max));
    }
};

// ---- Task 4.1: bounds -------------------------------------------------------------------------------------------------

/// A box around all points of a primitive, as its object is placed and clipped. Loose is right, tight is fast; rounding
/// errs outwards. Unbounded: planes, quadrics, unless a clip bounds them.
Bounds bounds_of(const Scene& scene, Primitive primitive);

// ---- The structures --------------------------------------------------------------------------------------------------

/// none: every object is asked, by step 1's nearest_hit and step 2's any_occluder.
enum class Partition { automatic, none, grid, octree, bvh };

/// "auto", "none", "grid", "octree", "bvh".
std::optional<Partition> partition_named(std::string_view name);

/// Up to this many primitives asking all is fastest (measured: NOTES.md).
inline constexpr std::size_t kCrossover = 1;

/// What `automatic` stands for in this scene: none below the measured crossover (NOTES.md).
Partition choose_partition(const Scene& scene);

/// Builds a structure; not for `automatic` and `none`. The scene must outlive it.
std::unique_ptr<Intersector> make_structure(const Scene& scene, Partition partition);

}  // namespace rays
