// Random points, directions and rays for the tests of step 1. Same seed, same numbers.
#pragma once

#include <cmath>
#include <random>

#include "core/ray.h"

namespace rays::test {

class Aim {
public:
    explicit Aim(std::uint64_t seed) : engine_(seed) {}

    Real uniform(double low, double high) { return Real(low + (high - low) * 0x1p-53 * double(engine_() >> 11)); }
    Vec3 in_cube(double half) { return {uniform(-half, half), uniform(-half, half), uniform(-half, half)}; }
    /// Unit length, all directions alike.
    Vec3 direction() {
        for (;;) {
            const Vec3 v = in_cube(1);
            const Real l2 = glm::dot(v, v);
            if (l2 > Real(1e-4) && l2 < 1) return v / std::sqrt(l2);
        }
    }
    /// From a point about `distance` away through `target`. The direction's length is anything from 0.1 to 10.
    Ray through(const Vec3& target, double distance) {
        const Vec3 d = direction();
        return {target - Real(distance) * d, Real(std::pow(10, uniform(-1, 1))) * d};
    }

private:
    std::mt19937_64 engine_;
};

}  // namespace rays::test
