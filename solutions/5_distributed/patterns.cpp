// Sampling patterns: where the n-th of N points lies.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "5_distributed/distributed.h"
#include "core/unfinished.h"
//> hidden
#include "5_distributed/beyond/sobol.h"
//< hidden

namespace rays {

//> hidden
namespace {

std::uint32_t square_root(std::uint32_t n) {
    auto root = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(n)));
    while (std::uint64_t{root} * root > n) --root;
    while (std::uint64_t{root + 1} * (root + 1) <= n) ++root;
    return std::max(root, 1u);
}

/// Two numbers that belong to one sample and to nothing else.
Vec2 dice(std::uint64_t key, std::uint32_t sample) {
    const std::uint64_t bits = mixed(key, sample);
    return {uniform(bits), uniform(bits << 32)};
}

/// At least `samples` cells.
struct Cells {
    std::uint32_t columns, rows;
    std::uint32_t count() const { return columns * rows; }
};
Cells cells_for(std::uint32_t samples) {
    const std::uint32_t columns = square_root(samples);
    return {columns, (samples + columns - 1) / columns};
}

constexpr std::uint32_t reversed(std::uint32_t x) {
    x = (x & 0x55555555u) << 1 | (x >> 1 & 0x55555555u);
    x = (x & 0x33333333u) << 2 | (x >> 2 & 0x33333333u);
    x = (x & 0x0f0f0f0fu) << 4 | (x >> 4 & 0x0f0f0f0fu);
    return __builtin_bswap32(x);
}

/// Owen's scrambling of a reversed number: every bit is turned or not by what stands below it (Laine and Karras,
/// "Stratified Sampling for Stochastic Transparency", 2011; the constants are Vegdahl's, 2021).
constexpr std::uint32_t turned(std::uint32_t x, std::uint32_t key) {
    x ^= x * 0x3d20adeau;
    x += key;
    x *= key >> 16 | 1;
    x ^= x * 0x05526c56u;
    return x ^ x * 0x53a22864u;
}
constexpr std::uint32_t scrambled(std::uint32_t x, std::uint32_t key) { return reversed(turned(reversed(x), key)); }

/// Sobol's second dimension but for the order of bits: Pascal's triangle modulo 2, where C(j, i) is odd exactly when i's
/// bits are among j's (Lucas), so that five steps do it.
constexpr std::uint32_t pascal(std::uint32_t x) {
    x ^= x >> 1 & 0x55555555u;
    x ^= x >> 2 & 0x33333333u;
    x ^= x >> 4 & 0x0f0f0f0fu;
    x ^= x >> 8 & 0x00ff00ffu;
    return x ^ (x >> 16 & 0x0000ffffu);
}

/// The upper 24 bits: the rest would round to 1.
Real fraction(std::uint32_t x) { return Real(x >> 8) * Real(0x1p-24); }

}  // namespace
//< hidden

//> given
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
//< given

Vec2 regular_point(const Draw& draw) {
    //> 5.1 Columns: the largest divisor of `samples` that is not above its root. Take the permuted sample's cell.
    std::uint32_t columns = square_root(draw.samples);
    while (draw.samples % columns != 0) --columns;
    const std::uint32_t rows = draw.samples / columns;
    const std::uint32_t cell = permuted(draw.sample, draw.samples, key_of(draw));
    return {(cell % columns + Real(0.5)) / columns, (cell / columns + Real(0.5)) / rows};
    //< 5.1
}

Vec2 random_point(const Draw& draw) {
    //> 5.1 Two numbers made of the pattern's key and the sample by `mixed` and `uniform`.
    return dice(key_of(draw), draw.sample);
    //< 5.1
}

Vec2 jittered_point(const Draw& draw) {
    //> 5.2 Columns: the root of `samples`, rounded down; rows: as many as it takes. The sample's cell is permuted among all
    //>   cells, so that the empty ones are anywhere; in it any point.
    const Cells cells = cells_for(draw.samples);
    const std::uint64_t key = key_of(draw);
    const std::uint32_t cell = permuted(draw.sample, cells.count(), key);
    const Vec2 jitter = dice(mixed(key), draw.sample);
    return {(cell % cells.columns + jitter.x) / cells.columns, (cell / cells.columns + jitter.y) / cells.rows};
    //< 5.2
}

Vec2 multi_jittered_point(const Draw& draw) {
    //> 5.3 As jittered, but the place within the cell is taken so that no two points share one of the columns x rows strips
    //>   in either direction: within its column of cells, a cell in row j gets strip number permutation(j), one permutation
    //>   a column; likewise for rows. In the strip: anywhere.
    const Cells cells = cells_for(draw.samples);
    const std::uint64_t key = key_of(draw);
    const std::uint32_t cell = permuted(draw.sample, cells.count(), key);
    const std::uint32_t column = cell % cells.columns, row = cell / cells.columns;
    const std::uint32_t x = permuted(row, cells.rows, mixed(mixed(key, 1), column));
    const std::uint32_t y = permuted(column, cells.columns, mixed(mixed(key, 2), row));
    const Vec2 jitter = dice(mixed(key, 3), draw.sample);
    return {(column + (x + jitter.x) / cells.rows) / cells.columns, (row + (y + jitter.y) / cells.columns) / cells.rows};
    //< 5.3
}

Vec2 sobol_point(const Draw& draw) {
    //> 5.4 Shuffle the sample by scrambling its bits, with one key for two neighbouring dimensions 2k and 2k + 1: that makes
    //>   them four dimensions of one sequence. The even one gets Sobol's first two: the shuffled index with its bits
    //>   reversed, and the second dimension of it; the odd one Sobol's third and fourth. Scramble each number with a key of
    //>   its own. Owen's scrambling turns a bit depending on all bits above it: on reversed numbers a hash does it in which
    //>   every bit depends on those below.
    const std::uint64_t keys = mixed(key_of(draw), 1);
    Draw both = draw;
    both.dimension &= ~1u;
    const std::uint32_t index = scrambled(draw.sample, static_cast<std::uint32_t>(key_of(both)));
    const auto x = static_cast<std::uint32_t>(keys), y = static_cast<std::uint32_t>(keys >> 32);
    if (draw.dimension % 2 == 0) return {fraction(reversed(turned(index, x))), fraction(reversed(turned(pascal(index), y)))};
    return {fraction(scrambled(kSobol.at(0, index), x)), fraction(scrambled(kSobol.at(1, index), y))};
    //< 5.4
}

}  // namespace rays
