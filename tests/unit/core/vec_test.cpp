// unit(): the same vector as v / |v|, whichever of its two ways it takes.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/vec.h"

namespace rays::tests {
namespace {

constexpr Real kEpsilon = std::numeric_limits<Real>::epsilon();

Vec3 direction(std::mt19937& random) {
    std::normal_distribution<Real> normal;
    return glm::normalize(Vec3(normal(random), normal(random), normal(random)));
}

TEST(Unit, BringsWhatIsNearlyOfUnitLengthThereAsExactlyAsARootDoes) {
    std::mt19937 random(5);
    std::uniform_real_distribution<Real> exponent(-52, -1);
    for (int i = 0; i < 100'000; ++i) {
        const Real off = std::exp2(exponent(random)) * (i % 2 == 0 ? 1 : -1);
        const Vec3 v = (1 + off) * direction(random), n = unit(v);
        ASSERT_NEAR(glm::length(n), 1, 2 * kEpsilon) << "off by " << off;
        ASSERT_LE(glm::length(n - glm::normalize(v)), 3 * kEpsilon) << "off by " << off;
    }
}

TEST(Unit, TakesAnyLength) {
    std::mt19937 random(6);
    for (const Real length : {Real(1e-15), Real(0.5), Real(3), Real(1e15)})
        for (int i = 0; i < 1000; ++i) {
            const Vec3 d = direction(random);
            ASSERT_LE(glm::length(unit(length * d) - d), 4 * kEpsilon) << "length " << length;
        }
}

TEST(Unit, DoesNotDriftOverManyBounces) {
    std::mt19937 random(7);
    Vec3 d = direction(random);
    for (int bounce = 0; bounce < 10'000; ++bounce) {
        const Vec3 n = direction(random);
        d = unit(d - 2 * glm::dot(d, n) * n);
        ASSERT_NEAR(glm::length(d), 1, 2 * kEpsilon) << "after " << bounce + 1;
    }
}

}  // namespace
}  // namespace rays::tests
