// What goes into a structure, and what stays outside.
#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include "4_partitioning/parallel.h"
#include "4_partitioning/structures.h"
#include "core/unfinished.h"

namespace rays {

//> hidden
namespace {

Real diagonal(const Bounds& b) { return glm::length(b.max - b.min); }

Bounds around(const Contents& contents, const std::vector<std::uint32_t>& primitives) {
    std::vector<Bounds> of_part(std::max(1u, std::thread::hardware_concurrency()));
    in_parallel_parts(primitives.size(), kParallelFrom, [&](std::size_t part, std::size_t begin, std::size_t end) {
        Bounds box;
        for (std::size_t k = begin; k < end; ++k) box.add(contents.bounds[primitives[k]]);
        of_part[part] = box;
    });
    Bounds box;
    for (const Bounds& part : of_part) box.add(part);
    return box;
}

/// A ground of a kilometre under a thousand pebbles would make one cell of all pebbles. So the largest few primitives
/// stay outside when the box of the others is much smaller.
constexpr std::size_t kMostHuge = 8;
constexpr Real kMuchSmaller = Real(0.5);

void set_huge_aside(Contents& contents) {
    while (contents.inside.size() > 2 * kMostHuge) {
        const auto is_huge = [&, limit = kMuchSmaller * diagonal(contents.box)](std::uint32_t i) {
            return diagonal(contents.bounds[i]) >= limit;
        };
        std::vector<std::uint32_t> huge, rest;
        std::copy_if(contents.inside.begin(), contents.inside.end(), std::back_inserter(huge), is_huge);
        if (huge.empty() || huge.size() + contents.outside.size() > kMostHuge) return;
        std::copy_if(contents.inside.begin(), contents.inside.end(), std::back_inserter(rest), std::not_fn(is_huge));
        const Bounds box = around(contents, rest);
        if (!(diagonal(box) < kMuchSmaller * diagonal(contents.box))) return;
        contents.outside.insert(contents.outside.end(), huge.begin(), huge.end());
        contents.inside = std::move(rest);
        contents.box = box;
    }
}

/// Above the rounding of a ray that starts near the box (rounding_of), and small against every detail.
Real slack_for(const Bounds& box, Real of_extent) {
    Real extent = 0, reach = 0;
    for (int a = 0; a < 3; ++a) {
        extent = std::max(extent, box.max[a] - box.min[a]);
        reach = std::max({reach, std::abs(box.min[a]), std::abs(box.max[a])});
    }
    constexpr Real eps = std::numeric_limits<Real>::epsilon();
    return std::max(of_extent * extent, 128 * eps * reach) + std::sqrt(std::numeric_limits<Real>::min());
}

}  // namespace
//< hidden

Contents contents_of(const Scene& scene, const std::vector<Primitive>& primitives, Real slack_of_extent) {
    //> 4.3 Unbounded primitives stay outside; set huge ones aside, too, when they are few and the rest is much smaller.
    //>   Widen all boxes by a little more than roots are off, and the box around them once more.
    Contents contents;
    contents.bounds.resize(primitives.size());
    in_parallel_each(primitives.size(), [&](std::size_t i) { contents.bounds[i] = bounds_of(scene, primitives[i]); });
    for (std::uint32_t i = 0; i < primitives.size(); ++i)
        (contents.bounds[i].is_finite() ? contents.inside : contents.outside).push_back(i);
    contents.box = around(contents, contents.inside);
    if (contents.inside.empty()) return contents;
    set_huge_aside(contents);
    contents.slack = slack_for(contents.box, slack_of_extent);
    in_parallel_each(contents.inside.size(), [&](std::size_t k) {
        Bounds& bounds = contents.bounds[contents.inside[k]];
        bounds.min -= contents.slack;
        bounds.max += contents.slack;
    });
    contents.box.min -= 2 * contents.slack;
    contents.box.max += 2 * contents.slack;
    return contents;
    //< 4.3
}

}  // namespace rays
