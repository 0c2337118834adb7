// Random numbers that are the same with every standard library.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include "core/vec.h"

namespace rays::povray_trace {

class Random {
public:
    explicit Random(std::uint64_t seed) : bits_(seed) {}

    /// In [low, high).
    double uniform(double low = 0, double high = 1) {
        return low + (high - low) * static_cast<double>(bits_() >> 11) * 0x1p-53;
    }
    /// 10^uniform: every decade is as likely as every other.
    double decades(double low, double high) { return std::pow(10.0, uniform(low, high)); }
    double sign() { return (bits_() & 1) != 0 ? 1.0 : -1.0; }
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(bits_() % count); }

    glm::dvec3 direction() {
        const double z = uniform(-1, 1);
        const double phi = uniform(0, 2 * std::numbers::pi);
        const double r = std::sqrt(1 - z * z);
        return {r * std::cos(phi), r * std::sin(phi), z};
    }
    glm::dvec3 in_ball(double radius) { return direction() * (radius * std::cbrt(uniform())); }
    /// Of unit length, at right angles to `axis`.
    glm::dvec3 across(const glm::dvec3& axis) {
        for (;;) {
            const glm::dvec3 side = glm::cross(axis, direction());
            if (glm::length(side) > 0.1 * glm::length(axis)) return glm::normalize(side);
        }
    }

private:
    std::mt19937_64 bits_;
};

}  // namespace rays::povray_trace
