// The uniform grid: equal cells, each with a list of what overlaps it, and a walk from cell to cell.
#include <algorithm>
#include <cmath>

#include "4_partitioning/parallel.h"
#include "4_partitioning/primitive_tester.h"
#include "4_partitioning/structures.h"
#include "core/unfinished.h"

namespace rays {

Cell grid_resolution(const Vec3& extent, std::size_t primitives) {
    // Task 4.3: Cells per length such that there are kDensity cells for each primitive: the cube root of their number over
    // the volume. An axis shorter than a cell gets one cell, and the others share by the area, or the length.
    unfinished("4.3");
    return {};
}

CellRange cells_overlapping(const GridSpace& space, const Bounds& bounds) {
    // Task 4.3: From the cell of the smaller corner to that of the larger one, none outside of the grid.
    unfinished("4.3");
    return {};
}

GridWalk start_walk(const GridSpace& space, const Ray& ray, Interval range) {
    // Task 4.4: Clip the ray; the cell of the point where it enters; for each axis the t of the next plane in its direction
    // (the far side of the cell, whatever the sign), and the t from plane to plane.
    unfinished("4.4");
    return {};
}

void step(GridWalk& walk) {
    // Task 4.4: Along the axis whose plane comes first. The walk ends where the grid or the range does.
    unfinished("4.4");
}

bool Mailbox::was_asked(std::uint32_t primitive) {
    // Task 4.5: A few slots, the primitive's number says which: whoever comes later takes the slot over.
    unfinished("4.5");
    return {};
}

std::vector<VisitedCell> cells_along(const GridSpace& space, const Ray& ray, Interval range, std::size_t most) {
    std::vector<VisitedCell> visited;
    const auto usable = without_zeros(ray);
    if (!usable) return visited;
    for (GridWalk walk = start_walk(space, *usable, range); walk.alive && visited.size() < most; step(walk))
        visited.push_back({walk.cell, {walk.enter, walk.exit}});
    return visited;
}

namespace {

/// Of the grid's extent. Small against a cell, and so large that origins a thousand million grids away are none too far.
constexpr Real kSlack = Real(1e-5);

class Grid final : public Intersector {
public:
    explicit Grid(const Scene& scene) : tester_(scene) { build(contents_of(scene, primitives_of(scene), kSlack)); }

private:
    std::optional<Hit> find_nearest(const Ray& ray, Interval range) const override {
        // Task 4.4: Ask what is outside of the grid, then cell by cell. A root may lie behind the cell in which it was found:
        // stop when the best one lies within the cells walked through, not before.
        unfinished("4.4");
        return {};
    }

    bool find_occluder(const Ray& ray, Interval range) const override {
        // Task 4.8: The same walk, with blocks() for a question: the first yes is enough.
        unfinished("4.8");
        return {};
    }

    void build(const Contents& contents) {
        // Task 4.3: Choose the cells, then list for each cell what overlaps it: count, add up, fill. One flat array for
        // all lists. Where primitives overlap so many cells that lists would explode, take fewer cells.
        unfinished("4.3");
    }

    PrimitiveTester tester_;
    GridSpace space_;
    Real slack_ = 0;
    std::vector<std::uint32_t> outside_;  ///< asked by every ray
    std::vector<std::uint32_t> begin_;    ///< cell c lists items_[begin_[c]] to items_[begin_[c + 1] - 1]
    std::vector<std::uint32_t> items_;    ///< primitives
};

}  // namespace

std::unique_ptr<Intersector> make_grid(const Scene& scene) { return std::make_unique<Grid>(scene); }

}  // namespace rays
