#include "references/frame_numbers.h"

#include <fmt/format.h>

#include <cstdint>

namespace rays {
namespace {

constexpr std::uint64_t kSeed = 1984;  // any; another one makes other, equally good references
constexpr int kBits = 32;

/// The order in which the groups take Sobol's four dimensions.
constexpr std::array<std::array<std::size_t, 4>, 4> kGroups{
    {{0, 1, 2, 3}, {5, 6, 7, 4}, {8, 9, 10, 15}, {11, 12, 13, 14}}};

/// The finalizer of SplitMix64 (Steele, Lea, Flood, 2014): a hash.
std::uint64_t mixed(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

/// Owen's nested scrambling: whether a digit is flipped is a coin for each text of the digits before it.
std::uint32_t scrambled(std::uint32_t x, std::uint64_t seed) {
    std::uint32_t flips = 0;
    for (int digit = 0; digit < kBits; ++digit) {
        const std::uint64_t before = (std::uint64_t{1} << digit) | (std::uint64_t{x} >> (kBits - digit));
        flips = (flips << 1) | static_cast<std::uint32_t>(mixed(seed ^ mixed(before)) & 1);
    }
    return x ^ flips;
}

std::uint32_t reversed(std::uint32_t x) {
    std::uint32_t result = 0;
    for (int i = 0; i < kBits; ++i) result = (result << 1) | ((x >> i) & 1);
    return result;
}

using Directions = std::array<std::uint32_t, kBits>;

/// A primitive polynomial of degree `degree` with the inner coefficients `a`, and the first `degree` numbers m.
Directions directions(std::size_t degree, std::uint32_t a, std::array<std::uint32_t, 3> m) {
    Directions v{};
    for (std::size_t i = 0; i < kBits; ++i) {
        if (i < degree) {
            v[i] = m[i] << (kBits - 1 - i);
            continue;
        }
        v[i] = v[i - degree] ^ (v[i - degree] >> degree);
        for (std::size_t k = 1; k < degree; ++k) {
            if ((a >> (degree - 1 - k)) & 1) v[i] ^= v[i - k];
        }
    }
    return v;
}

/// Dimension 0 is the radical inverse in base 2; the others are the first lines of Joe and Kuo's table.
std::uint32_t sobol(std::uint32_t index, std::size_t dimension) {
    static const std::array<Directions, 3> kTable{directions(1, 0, {1}), directions(2, 1, {1, 3}),
                                                  directions(3, 1, {1, 3, 1})};
    if (dimension == 0) return reversed(index);
    std::uint32_t result = 0;
    for (std::size_t i = 0; i < kBits; ++i) {
        if ((index >> i) & 1) result ^= kTable[dimension - 1][i];
    }
    return result;
}

}  // namespace

FrameNumbers frame_numbers(int frame, int frames) {
    const int each = frames / kReplicates;
    const auto replicate = static_cast<std::uint64_t>(frame / each);
    FrameNumbers result{};
    for (std::size_t group = 0; group < kGroups.size(); ++group) {
        const std::uint64_t seed = mixed(mixed(kSeed + replicate) + group);
        // Scrambled itself, an index stays in a block of 2^k numbers with all others of its block of 2^k, for every k.
        const std::uint32_t index = scrambled(static_cast<std::uint32_t>(frame % each), seed);
        for (std::size_t d = 0; d < kGroups[group].size(); ++d) {
            const std::uint64_t number = scrambled(sobol(index, d), mixed(seed + 1 + d));
            result[kGroups[group][d]] = static_cast<int>((number * 1000000) >> kBits);
        }
    }
    return result;
}

std::vector<std::string> frame_declarations(int frame, int frames) {
    std::vector<std::string> result{fmt::format("Declare=Frame={}", frame)};
    const FrameNumbers numbers = frame_numbers(frame, frames);
    for (std::size_t i = 0; i < numbers.size(); ++i)
        result.push_back(fmt::format("Declare=Frame_u{}=0.{:06}", i, numbers[i]));
    return result;
}

}  // namespace rays
