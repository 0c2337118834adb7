// Sampling patterns: where the n-th of N points lies.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "5_distributed/distributed.h"
#include "core/unfinished.h"

namespace rays {

std::optional<Pattern> pattern_named(std::string_view name) {
    constexpr std::array<std::string_view, 5> kNames{"regular", "random", "jittered", "multi_jittered", "sobol"};
    const auto found = std::find(kNames.begin(), kNames.end(), name);
    if (found == kNames.end()) return std::nullopt;
    return static_cast<Pattern>(found - kNames.begin());
}

Vec2 point_of(Pattern pattern, const Draw& draw) {
    switch (pattern) {
        case Pattern::regular: return regular_point(draw);
        case Pattern::random: return random_point(draw);
        case Pattern::jittered: return jittered_point(draw);
        case Pattern::multi_jittered: return multi_jittered_point(draw);
        case Pattern::sobol: return sobol_point(draw);
    }
    return {};
}

Real number_of(Pattern pattern, const Draw& draw) {
    const std::uint64_t key = key_of(draw);
    const auto strip = [&] { return permuted(draw.sample, draw.samples, key); };
    switch (pattern) {
        case Pattern::regular: return (strip() + Real(0.5)) / draw.samples;
        case Pattern::jittered: return (strip() + uniform(mixed(mixed(key), draw.sample))) / draw.samples;
        default: return point_of(pattern, draw).x;
    }
}

Vec2 regular_point(const Draw& draw) {
    // Task 5.1: Columns: the largest divisor of `samples` that is not above its root. Take the permuted sample's cell.
    unfinished("5.1");
    return {};
}

Vec2 random_point(const Draw& draw) {
    // Task 5.1: Two numbers made of the pattern's key and the sample by `mixed` and `uniform`.
    unfinished("5.1");
    return {};
}

Vec2 jittered_point(const Draw& draw) {
    // Task 5.2: Columns: the root of `samples`, rounded down; rows: as many as it takes. The sample's cell is permuted among all
    // cells, so that the empty ones are anywhere; in it any point.
    unfinished("5.2");
    return {};
}

Vec2 multi_jittered_point(const Draw& draw) {
    // Task 5.3: As jittered, but the place within the cell is taken so that no two points share one of the columns x rows strips
    // in either direction: within its column of cells, a cell in row j gets strip number permutation(j), one permutation
    // a column; likewise for rows. In the strip: anywhere.
    unfinished("5.3");
    return {};
}

Vec2 sobol_point(const Draw& draw) {
    // Task 5.4: Shuffle the sample by scrambling its bits, with one key for two neighbouring dimensions 2k and 2k + 1: that makes
    // them four dimensions of one sequence. The even one gets Sobol's first two: the shuffled index with its bits
    // reversed, and the second dimension of it; the odd one Sobol's third and fourth. Scramble each number with a key of
    // its own. Owen's scrambling turns a bit depending on all bits above it: on reversed numbers a hash does it in which
    // every bit depends on those below.
    unfinished("5.4");
    return {};
}

}  // namespace rays
