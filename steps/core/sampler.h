// Explicit randomness: a number is a function of (seed, pixel, sample, dimension), whoever asks, on any thread.
#pragma once

#include <cstdint>

#include "core/vec.h"

namespace rays {

/// A counter-based generator: no state is shared, so pictures do not depend on the order of pixels.
class Sampler {
public:
    Sampler(std::uint64_t seed, std::uint32_t pixel, std::uint32_t sample)
        : key_(mix(mix(seed ^ 0x9e3779b97f4a7c15ull) ^ (std::uint64_t{pixel} << 32 | sample))) {}

    /// The next dimension, uniform in [0, 1).
    Real next() { return Real((mix(key_ + 0x9e3779b97f4a7c15ull * ++dimension_) >> 40) * 0x1p-24); }
    Vec2 next_2d() {
        const Real u = next();
        return {u, next()};
    }

private:
    // The finaliser of SplitMix64 (Steele, Lea, Flood 2014): every input bit reaches every output bit.
    static constexpr std::uint64_t mix(std::uint64_t z) {
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
        return z ^ (z >> 31);
    }
    std::uint64_t key_;
    std::uint64_t dimension_ = 0;
};

}  // namespace rays
