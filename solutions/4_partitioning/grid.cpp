// The uniform grid: equal cells, each with a list of what overlaps it, and a walk from cell to cell.
#include <algorithm>
#include <cmath>

#include "4_partitioning/parallel.h"
#include "4_partitioning/primitive_tester.h"
#include "4_partitioning/structures.h"
#include "core/unfinished.h"

namespace rays {

Cell grid_resolution(const Vec3& extent, std::size_t primitives) {
    //> 4.3 Cells per length such that there are kDensity cells for each primitive: the cube root of their number over
    //>   the volume. An axis shorter than a cell gets one cell, and the others share by the area, or the length.
    constexpr Real kDensity = 2;
    const Real wanted = kDensity * static_cast<Real>(std::max<std::size_t>(primitives, 1));
    Cell cells{1, 1, 1};
    std::array<bool, 3> counts{extent.x > 0, extent.y > 0, extent.z > 0};
    for (int round = 0; round < 3; ++round) {
        Real log_measure = 0;  // volumes under- and overflow, their logarithms do not
        int axes = 0;
        for (int a = 0; a < 3; ++a)
            if (counts[a]) ++axes, log_measure += std::log(extent[a]);
        if (axes == 0) break;
        const Real log_density = (std::log(wanted) - log_measure) / static_cast<Real>(axes);
        bool all = true;
        for (int a = 0; a < 3; ++a) {
            const Real n = counts[a] ? std::exp(std::log(extent[a]) + log_density) : 1;
            cells[a] = static_cast<int>(std::clamp(std::ceil(n), Real(1), Real(kMostCells)));
            if (counts[a] && n < 1) all = counts[a] = false;
        }
        if (all) break;
    }
    return cells;
    //< 4.3
}

//> hidden
namespace {

/// The cell along one axis, with what lies beyond the ends in the last ones. NaN is in the first.
int cell_along(const GridSpace& space, int axis, Real at) {
    const Real place = (at - space.box.min[axis]) / space.cell_size()[axis];
    const Real last = static_cast<Real>(space.cells[axis] - 1);
    return place > 0 ? static_cast<int>(std::min(place, last)) : 0;
}

}  // namespace
//< hidden

CellRange cells_overlapping(const GridSpace& space, const Bounds& bounds) {
    //> 4.3 From the cell of the smaller corner to that of the larger one, none outside of the grid.
    CellRange range;
    for (int a = 0; a < 3; ++a) {
        range.first[a] = cell_along(space, a, bounds.min[a]);
        range.last[a] = cell_along(space, a, bounds.max[a]);
    }
    return range;
    //< 4.3
}

GridWalk start_walk(const GridSpace& space, const Ray& ray, Interval range) {
    //> 4.4 Clip the ray; the cell of the point where it enters; for each axis the t of the next plane in its direction
    //>   (the far side of the cell, whatever the sign), and the t from plane to plane.
    GridWalk walk;
    walk.cells = space.cells;
    const auto span = clip(ray, range, space.box);
    if (!span) return walk;
    walk.alive = true;
    walk.enter = span->enter;
    walk.end = span->exit;
    const Vec3 start = ray.at(span->enter), size = space.cell_size();
    for (int a = 0; a < 3; ++a) {
        const bool forwards = ray.direction[a] > 0;
        walk.cell[a] = cell_along(space, a, start[a]);
        walk.step[a] = forwards ? 1 : -1;
        walk.per_cell[a] = size[a] / std::abs(ray.direction[a]);
        walk.origin[a] = ((forwards ? space.box.min[a] : space.box.max[a]) - ray.origin[a]) / ray.direction[a];
        const int passed = forwards ? walk.cell[a] : space.cells[a] - 1 - walk.cell[a];
        walk.next[a] = walk.origin[a] + static_cast<Real>(passed + 1) * walk.per_cell[a];
    }
    walk.exit = std::min(walk.end, std::min(walk.next.x, std::min(walk.next.y, walk.next.z)));
    return walk;
    //< 4.4
}

void step(GridWalk& walk) {
    //> 4.4 void Along the axis whose plane comes first. The walk ends where the grid or the range does.
    const int axis = walk.next.x < walk.next.y ? (walk.next.x < walk.next.z ? 0 : 2) : (walk.next.y < walk.next.z ? 1 : 2);
    walk.enter = walk.next[axis];
    walk.cell[axis] += walk.step[axis];
    if (walk.cell[axis] < 0 || walk.cell[axis] >= walk.cells[axis] || !(walk.enter <= walk.end)) {
        walk.alive = false;
        return;
    }
    // From the count of planes, not by adding up: a thousand roundings would be a crack.
    const int passed = walk.step[axis] > 0 ? walk.cell[axis] : walk.cells[axis] - 1 - walk.cell[axis];
    walk.next[axis] = walk.origin[axis] + static_cast<Real>(passed + 1) * walk.per_cell[axis];
    walk.exit = std::min(walk.end, std::min(walk.next.x, std::min(walk.next.y, walk.next.z)));
    //< 4.4
}

bool Mailbox::was_asked(std::uint32_t primitive) {
    //> 4.5 A few slots, the primitive's number says which: whoever comes later takes the slot over.
    std::uint32_t& slot = asked_[primitive % kSlots];
    if (slot == primitive) return true;
    slot = primitive;
    return false;
    //< 4.5
}

//> given
std::vector<VisitedCell> cells_along(const GridSpace& space, const Ray& ray, Interval range, std::size_t most) {
    std::vector<VisitedCell> visited;
    const auto usable = without_zeros(ray);
    if (!usable) return visited;
    for (GridWalk walk = start_walk(space, *usable, range); walk.alive && visited.size() < most; step(walk))
        visited.push_back({walk.cell, {walk.enter, walk.exit}});
    return visited;
}
//< given

namespace {

/// Of the grid's extent. Small against a cell, and so large that origins a thousand million grids away are none too far.
constexpr Real kSlack = Real(1e-5);

class Grid final : public Intersector {
public:
    explicit Grid(const Scene& scene) : tester_(scene) { build(contents_of(scene, primitives_of(scene), kSlack)); }

private:
    std::optional<Hit> find_nearest(const Ray& ray, Interval range) const override {
        //> 4.4 Ask what is outside of the grid, then cell by cell. A root may lie behind the cell in which it was found:
        //>   stop when the best one lies within the cells walked through, not before.
        Candidate best;
        ask_cells(ray, range, [&](std::uint32_t primitive, Real& far) {
            tester_.keep_nearer(primitive, ray, range, best);
            if (best.primitive != kNone) far = best.root.t;
            return false;
        });
        return tester_.complete(ray, best);
        //< 4.4
    }

    bool find_occluder(const Ray& ray, Interval range) const override {
        //> 4.8 The same walk, with blocks() for a question: the first yes is enough.
        return ask_cells(ray, range,
                         [&](std::uint32_t primitive, Real&) { return tester_.blocks(primitive, ray, range); });
        //< 4.8
    }

    void build(const Contents& contents) {
        //> 4.3 void Choose the cells, then list for each cell what overlaps it: count, add up, fill. One flat array for
        //>   all lists. Where primitives overlap so many cells that lists would explode, take fewer cells.
        outside_ = contents.outside;
        if (contents.inside.empty()) return;
        space_.box = contents.box;
        slack_ = contents.slack;
        space_.cells = grid_resolution(contents.box.max - contents.box.min, contents.inside.size());
        while (entries(contents) > kMostCopies * contents.inside.size() && space_.count() > 1)
            for (int& n : space_.cells) n = (n + 1) / 2;
        fill(contents);
        //< 4.3
    }

    //> hidden
    /// Lists hold at most this many entries for each primitive, or the grid gets coarser.
    static constexpr std::size_t kMostCopies = 16;

    std::size_t entries(const Contents& contents) const {
        std::size_t n = 0;
        for (const std::uint32_t i : contents.inside) n += cells_overlapping(space_, contents.bounds[i]).count();
        return n;
    }

    /// Each part of the cores fills layers of its own, so the lists do not depend on how many there are.
    void fill(const Contents& contents) {
        begin_.assign(space_.count() + 1, 0);
        in_layers(contents, [&](std::size_t cell, std::uint32_t) { ++begin_[cell + 1]; });
        for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
        items_.resize(begin_.back());
        std::vector<std::uint32_t> at(begin_.begin(), begin_.end() - 1);
        in_layers(contents, [&](std::size_t cell, std::uint32_t primitive) { items_[at[cell]++] = primitive; });
    }

    template <class What>
    void in_layers(const Contents& contents, What what) const {
        const auto layers = static_cast<std::size_t>(space_.cells[2]);
        const std::size_t parallel_from = contents.inside.size() < kParallelFrom ? layers + 1 : 2;
        in_parallel_parts(layers, parallel_from, [&](std::size_t, std::size_t begin, std::size_t end) {
            for (const std::uint32_t i : contents.inside) {
                const CellRange r = cells_overlapping(space_, contents.bounds[i]);
                const int first = std::max(r.first[2], static_cast<int>(begin));
                const int last = std::min(r.last[2], static_cast<int>(end) - 1);
                for (int z = first; z <= last; ++z)
                    for (int y = r.first[1]; y <= r.last[1]; ++y)
                        for (int x = r.first[0]; x <= r.last[0]; ++x) what(space_.index({x, y, z}), i);
            }
        });
    }

    /// Calls ask(primitive, far) until it says true; `far` is how far the ray still has to go.
    template <class Ask>
    bool ask_cells(const Ray& ray, Interval range, Ask ask) const {
        const auto usable = without_zeros(ray);
        if (!usable) return false;
        Real far = range.max;
        for (const std::uint32_t i : outside_)
            if (ask(i, far)) return true;
        if (begin_.empty()) return false;
        // So far away that the grid is a blur: cells cannot be told apart.
        if (!(rounding_of(ray, space_.box) < slack_)) return ask_every_one(far, ask);
        return effort ? walk<true>(*usable, range, far, ask) : walk<false>(*usable, range, far, ask);
    }

    template <bool kWatched, class Ask>
    bool walk(const Ray& ray, Interval range, Real far, Ask ask) const {
        Mailbox mailbox;
        for (GridWalk at = start_walk(space_, ray, {range.min, far}); at.alive && at.enter <= far; step(at)) {
            if constexpr (kWatched) watch(at.cell);
            const std::size_t cell = space_.index(at.cell);
            for (std::uint32_t k = begin_[cell]; k < begin_[cell + 1]; ++k)
                if (!mailbox.was_asked(items_[k]) && ask(items_[k], far)) return true;
        }
        return false;
    }

    template <class Ask>
    bool ask_every_one(Real far, Ask ask) const {
        for (const std::uint32_t i : items_)
            if (ask(i, far)) return true;
        return false;
    }

    void watch(const Cell& cell) const {
        ++effort->nodes;
        if (!effort->visited) return;
        const Vec3 size = space_.cell_size(), corner = space_.box.min + Vec3(cell[0], cell[1], cell[2]) * size;
        effort->visited->push_back({corner, corner + size});
    }
    //< hidden

    PrimitiveTester tester_;
    GridSpace space_;
    Real slack_ = 0;
    std::vector<std::uint32_t> outside_;  ///< asked by every ray
    std::vector<std::uint32_t> begin_;    ///< cell c lists items_[begin_[c]] to items_[begin_[c + 1] - 1]
    std::vector<std::uint32_t> items_;    ///< primitives
};

}  // namespace

//> given
std::unique_ptr<Intersector> make_grid(const Scene& scene) { return std::make_unique<Grid>(scene); }
//< given

}  // namespace rays
