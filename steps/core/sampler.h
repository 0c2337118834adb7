// Randomness without state: a number is a function of (seed, pixel, dimension, sample), whoever asks, on any thread.
#pragma once

#include <cstdint>
#include <utility>

#include "core/vec.h"

namespace rays {

/// The finaliser of SplitMix64 (Steele, Lea, Flood, 2014): every bit of the input reaches every bit of the output.
constexpr std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return z ^ (z >> 31);
}

/// One key made of another and a number.
constexpr std::uint64_t mixed(std::uint64_t key, std::uint64_t number) {
    return mixed(key + 0x9e3779b97f4a7c15ull * (number + 1));
}

/// The upper 24 bits as a number in [0, 1): they survive in a float.
constexpr Real uniform(std::uint64_t bits) { return Real(bits >> 40) * Real(0x1p-24); }

/// Where number i of 0 .. n - 1 goes in a permutation chosen by the key: a Feistel network on the next power of four,
/// walked until it is back below n (Black and Rogaway, "Ciphers with Arbitrary Finite Domains", 2002).
constexpr std::uint32_t permuted(std::uint32_t i, std::uint32_t n, std::uint64_t key) {
    unsigned half = 1;
    while ((std::uint64_t{1} << 2 * half) < n) ++half;
    const std::uint32_t mask = (1u << half) - 1;
    do {
        std::uint32_t left = i >> half, right = i & mask;
        for (std::uint64_t round = 0; round < 4; ++round) {
            const auto turned = static_cast<std::uint32_t>(mixed(key + round, right)) & mask;
            left = std::exchange(right, left ^ turned);
        }
        i = left << half | right;
    } while (i >= n);
    // Turned by any amount: now every number goes everywhere equally often, also among few.
    return static_cast<std::uint32_t>((i + mixed(key, 4) % n) % n);
}

}  // namespace rays
