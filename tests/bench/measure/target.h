// What a method is measured on: rays, and how its answers are judged in long double.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/hit.h"
#include "core/ray.h"

namespace rays::bench {

/// 64 bits of mantissa: 2048 times finer than double, so that its own rounding does not show.
using Exact = long double;
using ExactVec = glm::vec<3, Exact>;

/// The very ray that a method gets, its rounded numbers taken as exact.
struct ExactRay {
    ExactVec origin, direction;

    explicit ExactRay(const Ray& ray) : origin(ray.origin), direction(ray.direction) {}
    ExactVec at(Exact t) const { return origin + t * direction; }
};

using ExactRoot = std::function<std::optional<Exact>(const ExactRay&)>;

/// Shapes are rounded to `Real` first, and the truth is that of the rounded shape: what is judged is the method.
struct Target {
    double size = 1;        ///< radius of the shape about the origin: errors are counted in it
    std::vector<Ray> rays;  ///< with directions of unit length but for rounding
    std::function<Exact(const ExactVec& point, const Root&)> off_surface;  ///< distance to it; empty: along the ray
    ExactRoot nearest;  ///< the truth; empty: only what is hit is judged
};

struct Accuracy {
    double median = 0, mean = 0, largest = 0;  ///< errors as shares of the size; a wrong answer counts as 1
    double wrong = 0;                          ///< share of the rays: hit for miss, miss for hit, or another root
};

using Answers = std::vector<std::optional<Root>>;

/// Judges the answers to target.rays, in their order.
Accuracy judge(const Target& target, const Answers& answers);

/// `count` rays from `sizes_away` sizes towards points of a ball somewhat larger than the shape: about half of them
/// hit. With a truth, rays are left out that pass within a thousandth of the size of an edge or a silhouette: there
/// both answers are right. The same for the same arguments.
std::vector<Ray> rays_around(double size, double sizes_away, std::size_t count, const ExactRoot& truth);

}  // namespace rays::bench
