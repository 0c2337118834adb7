// Boxes in float around things in Real. They only decide whom to ask, so they may be coarse as long as they never hide
// a root: every rounding errs outwards.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "4_partitioning/partitioning.h"

namespace rays::wide {

inline constexpr float kMaxFloat = std::numeric_limits<float>::max();
/// u: what a rounding changes at most, relatively. When Real is float itself, what is asked afterwards is rounded as
/// well.
inline constexpr float kU = sizeof(Real) < sizeof(double) ? 0x1p-22f : 0x1p-24f;

// One unit in the last place and more, without a call of nextafter: this is done for every ray.
inline float below(Real v) {
    const auto f = static_cast<float>(v);
    return f - (std::abs(f) * 0x1p-23f + std::numeric_limits<float>::denorm_min());
}
inline float above(Real v) {
    const auto f = static_cast<float>(v);
    return f + (std::abs(f) * 0x1p-23f + std::numeric_limits<float>::denorm_min());
}

struct FloatBox {
    std::array<float, 3> lo{kMaxFloat, kMaxFloat, kMaxFloat}, hi{-kMaxFloat, -kMaxFloat, -kMaxFloat};

    void add(const FloatBox& o) {
        for (int a = 0; a < 3; ++a) {
            lo[a] = std::min(lo[a], o.lo[a]);
            hi[a] = std::max(hi[a], o.hi[a]);
        }
    }
    float half_area() const {
        const float x = hi[0] - lo[0], y = hi[1] - lo[1], z = hi[2] - lo[2];
        return x < 0 ? 0 : x * y + y * z + z * x;
    }
};

inline FloatBox rounded_outwards(const Bounds& b) {
    FloatBox box;
    for (int a = 0; a < 3; ++a) {
        box.lo[static_cast<std::size_t>(a)] = below(b.min[a]);
        box.hi[static_cast<std::size_t>(a)] = above(b.max[a]);
    }
    return box;
}

/// Widened so that a root computed a little outside of the true box is still found: relative to the coordinates, and by
/// an absolute sliver for boxes that touch a coordinate plane and rays that run in it.
inline FloatBox widened(const Bounds& b) {
    FloatBox box;
    for (int a = 0; a < 3; ++a) {
        const Real slack = Real(1e-7) * std::max(std::abs(b.min[a]), std::abs(b.max[a])) + Real(1e-18);
        box.lo[a] = below(b.min[a] - slack);
        box.hi[a] = above(b.max[a] + slack);
    }
    return box;
}

}  // namespace rays::wide
