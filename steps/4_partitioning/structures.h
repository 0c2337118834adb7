// The structures of step 4, one a file, and the small functions that they are made of: each can be asked by itself.
// make_structure (partitioning.h) is the way in.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "4_partitioning/partitioning.h"
#include "core/intersector.h"
#include "core/scene.h"

namespace rays {

// ---- Task 4.2: a ray and a box ---------------------------------------------------------------------------------------

/// From t = enter to t = exit, both included.
struct Span {
    Real enter = 0;
    Real exit = 0;
};

/// The part of the range that the ray spends in the box (kept as a closed span); nothing when it misses. The faces
/// belong to the box, and rounding errs towards a longer span: what touches is never lost. Directions may have zeros of
/// either sign; the box may be flat, but not empty. A NaN anywhere misses.
std::optional<Span> clip(const Ray& ray, Interval range, const Bounds& box);

// ---- Task 4.3: what a structure holds --------------------------------------------------------------------------------

/// The primitives of a scene, as structures need them.
struct Contents {
    std::vector<Bounds> bounds;          ///< of every primitive
    std::vector<std::uint32_t> inside;   ///< these go into the structure, in ascending order
    std::vector<std::uint32_t> outside;  ///< these are asked by every ray: unbounded ones, and a few that are huge
    Bounds box;                          ///< around all that are inside, a little larger; empty when there are none
    /// The bounds of what is inside have been widened by this much, and the box by twice as much: roots are rounded,
    /// and rays are.
    Real slack = 0;
};

/// `slack_of_extent`: the slack is at least this share of the largest extent of the box.
Contents contents_of(const Scene& scene, const std::vector<Primitive>& primitives, Real slack_of_extent);

/// How far computed points of a ray in this box may be off the true ones.
Real rounding_of(const Ray& ray, const Bounds& box);

/// False for what is no ray: a NaN or an infinity in it, no direction, or one so long or short that its square is no
/// number. Structures answer such questions with a miss, at once.
inline bool is_ray(const Ray& ray) {
    constexpr Real kLargest = sizeof(Real) == 8 ? Real(1e50) : Real(1e7);  // their products are numbers, too
    const Real direction2 = glm::dot(ray.direction, ray.direction), origin2 = glm::dot(ray.origin, ray.origin);
    // A NaN fails every comparison.
    return direction2 > 1 / (kLargest * kLargest) && direction2 < kLargest * kLargest && origin2 < kLargest * kLargest;
}

/// The ray with every component of the direction at least a rounding error of the largest: what is computed from its
/// inverse is finite then. The point at t moves by less than rounding_of. Nothing unless it is_ray.
std::optional<Ray> without_zeros(const Ray& ray);

// ---- Tasks 4.3, 4.4, 4.5: the uniform grid ---------------------------------------------------------------------------

using Cell = std::array<int, 3>;

/// A box cut into equal cells.
struct GridSpace {
    Bounds box;
    Cell cells{1, 1, 1};  ///< along each axis, >= 1

    Vec3 cell_size() const { return (box.max - box.min) / Vec3(cells[0], cells[1], cells[2]); }
    std::size_t count() const { return std::size_t(cells[0]) * std::size_t(cells[1]) * std::size_t(cells[2]); }
    std::size_t index(const Cell& c) const {
        return (std::size_t(c[2]) * std::size_t(cells[1]) + std::size_t(c[1])) * std::size_t(cells[0]) +
               std::size_t(c[0]);
    }
};

/// How many cells along each axis for this many primitives (Cleary and Wyvill, 1988): about equally long in all
/// directions, a few for each primitive; 1 along an axis in which the box is flat. At most kMostCells each way.
Cell grid_resolution(const Vec3& extent, std::size_t primitives);
inline constexpr int kMostCells = 1024;

/// All cells from `first` to `last`, both included.
struct CellRange {
    Cell first{0, 0, 0}, last{0, 0, 0};
    std::size_t count() const {
        std::size_t n = 1;
        for (int a = 0; a < 3; ++a) n *= std::size_t(last[a] - first[a] + 1);
        return n;
    }
};

/// The cells that a box overlaps; never one that does not exist. What lies on the far face of the grid is in the last
/// cell.
CellRange cells_overlapping(const GridSpace& space, const Bounds& bounds);

/// A ray on its way from cell to cell (Amanatides and Woo, 1987).
struct GridWalk {
    bool alive = false;  ///< false: the ray is not, or no longer, in the grid within its range
    Cell cell{0, 0, 0};
    Real enter = 0;  ///< the t at which the ray comes into the cell
    Real exit = 0;   ///< and leaves it
    // How it goes on:
    Real end = 0;  ///< the t at which range or grid ends
    Cell cells{1, 1, 1};
    Cell step{1, 1, 1};  ///< +1 or -1 along each axis
    Vec3 next{0};        ///< for each axis the t at which the ray meets the next plane between cells
    Vec3 per_cell{0};    ///< the t between two planes, positive
    Vec3 origin{0};      ///< the t of the plane at which counting of planes begins
};

/// The first cell of a ray of without_zeros within the range. The range may begin before or in the box.
GridWalk start_walk(const GridSpace& space, const Ray& ray, Interval range);
/// On to the next cell: one step along one axis. The span of a cell begins where that of the one before ended.
void step(GridWalk& walk);

/// Which primitives this ray has asked already (Arnaldi et al., 1987). It belongs to one ray, so threads share nothing.
/// It may forget, since asking twice only costs time; it must never claim what is not so.
class Mailbox {
public:
    Mailbox() { asked_.fill(kNone); }
    /// True when the primitive was asked before; takes it down as asked.
    bool was_asked(std::uint32_t primitive);

private:
    static constexpr std::size_t kSlots = 16;
    std::array<std::uint32_t, kSlots> asked_;
};

/// The cells of a walk, in order, for whoever wants to look; gives up after `most` steps.
struct VisitedCell {
    Cell cell;
    Span span;
};
std::vector<VisitedCell> cells_along(const GridSpace& space, const Ray& ray, Interval range, std::size_t most = 4096);

// ---- Tasks 4.6, 4.7: the octree --------------------------------------------------------------------------------------

// Octant o of a box: bit 0 of o is set in its upper half along x, bit 1 along y, bit 2 along z.
Bounds octant_of(const Bounds& node, unsigned octant);
/// Bit o is set when octant o of the node, faces included, overlaps the bounds.
unsigned octants_overlapping(const Bounds& node, const Bounds& bounds);

/// For each axis the t at which a ray passes the two faces of a box, the near one first.
struct Slabs {
    Vec3 near{0}, far{0};

    Real enter() const { return std::max(near.x, std::max(near.y, near.z)); }
    Real exit() const { return std::min(far.x, std::min(far.y, far.z)); }
};

/// A ray of without_zeros, as an octree sees it (Revelles, Urena, Lastra, 2000).
struct OctreeRay {
    Slabs root;
    /// Bit a is set when the direction along axis a is negative: then the near half along it is the upper one.
    unsigned mirror = 0;
};
OctreeRay octree_ray(const Bounds& root, const Ray& ray);

struct Octant {
    unsigned octant = 0;
    Slabs slabs;
};
/// Those octants of a node that the ray passes within the span, in the order of the ray; returns how many (0 to 4).
int octants_along(const Slabs& node, unsigned mirror, Span span, std::array<Octant, 4>& octants);

// ---- The ways in -----------------------------------------------------------------------------------------------------

std::unique_ptr<Intersector> make_grid(const Scene& scene);
std::unique_ptr<Intersector> make_octree(const Scene& scene);
std::unique_ptr<Intersector> make_bvh(const Scene& scene);

/// No structure: every primitive is asked. The yardstick for all others.
std::unique_ptr<Intersector> make_exhaustive(const Scene& scene);

}  // namespace rays
