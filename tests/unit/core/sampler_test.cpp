#include "core/sampler.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rays {
namespace {

TEST(Sampler, TheSameQuestionGivesTheSameNumber) {
    Sampler a(1, 2, 3), b(1, 2, 3);
    for (int i = 0; i < 100; ++i) EXPECT_EQ(a.next(), b.next());
}

TEST(Sampler, SeedPixelAndSampleAllMatter) {
    const Real first = Sampler(1, 2, 3).next();
    EXPECT_NE(first, Sampler(2, 2, 3).next());
    EXPECT_NE(first, Sampler(1, 3, 3).next());
    EXPECT_NE(first, Sampler(1, 2, 4).next());
}

// Mean and covariance of neighbours, each within 5 standard errors of n = 2^18 independent uniform numbers.
TEST(Sampler, NeighbouringPixelsAreUniformAndUncorrelated) {
    constexpr int n = 1 << 18;
    double sum = 0, product = 0, previous = 0.5;
    for (int pixel = 0; pixel < n; ++pixel) {
        const double u = Sampler(7, std::uint32_t(pixel), 0).next();
        ASSERT_GE(u, 0);
        ASSERT_LT(u, 1);
        sum += u;
        product += (u - 0.5) * (previous - 0.5);
        previous = u;
    }
    EXPECT_NEAR(sum / n, 0.5, 5 * std::sqrt(1.0 / 12 / n));
    EXPECT_NEAR(product / n, 0, 5 * (1.0 / 12) / std::sqrt(n));
}

}  // namespace
}  // namespace rays
