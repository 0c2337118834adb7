// Numbers, points and shapes by chance, the same in every run.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "core/shapes.h"

namespace rays::tests {

struct Chance {
    std::mt19937_64 bits;
    explicit Chance(std::uint64_t seed) : bits(seed) {}
    Real unit() { return Real(double(bits() >> 11) * 0x1p-53); }
    Real between(Real low, Real high) { return low + (high - low) * unit(); }
    /// Sizes of all orders.
    Real order(Real low, Real high) { return low * std::pow(high / low, unit()); }
    Vec3 in_cube(Real half) {
        const Real x = between(-half, half), y = between(-half, half);
        return {x, y, between(-half, half)};
    }
    Vec3 direction() {
        for (;;) {
            const Vec3 v = in_cube(1);
            if (const Real l = glm::length(v); l > Real(0.1) && l < 1) return v / l;
        }
    }
    /// A unit vector across.
    Vec3 across(const Vec3& axis) { return glm::normalize(glm::cross(axis, direction())); }
};

/// Three in ten are open.
inline Cone cone(Chance& c, const Vec3& base, Real length, Real base_radius, Real cap_radius) {
    return {base, base_radius, base + length * c.direction(), cap_radius, c.unit() < Real(0.3)};
}

}  // namespace rays::tests
