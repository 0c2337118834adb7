#include "core/sampler.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace rays {
namespace {

TEST(Sampler, TheSameQuestionGivesTheSameNumber) {
    EXPECT_EQ(mixed(1, 2), mixed(1, 2));
    EXPECT_NE(mixed(1, 2), mixed(2, 2));
    EXPECT_NE(mixed(1, 2), mixed(1, 3));
}

TEST(Sampler, NumbersAreUniformAndNeighboursUncorrelated) {
    double sum = 0, squares = 0, products = 0, before = 0;
    constexpr int kNumbers = 100'000;
    for (std::uint64_t i = 0; i < kNumbers; ++i) {
        const double u = uniform(mixed(7, i));
        ASSERT_GE(u, 0);
        ASSERT_LT(u, 1);
        sum += u - 0.5;
        squares += (u - 0.5) * (u - 0.5);
        products += (u - 0.5) * (before - 0.5);
        before = u;
    }
    // Standard errors: 0.29 / sqrt(n) = 9e-4, 0.075 / sqrt(n) = 2.4e-4, 0.083 / sqrt(n) = 2.6e-4; five of each.
    EXPECT_NEAR(sum / kNumbers, 0, 4.6e-3);
    EXPECT_NEAR(squares / kNumbers, 1.0 / 12, 1.2e-3);
    EXPECT_NEAR(products / kNumbers, 0, 1.3e-3);
}

TEST(Sampler, PermutationsMeetEveryNumberOnce) {
    for (const std::uint32_t n : {1u, 2u, 3u, 5u, 16u, 17u, 97u, 1000u, 4096u})
        for (std::uint64_t key = 0; key < 5; ++key) {
            std::set<std::uint32_t> met;
            for (std::uint32_t i = 0; i < n; ++i) met.insert(permuted(i, n, mixed(key)));
            EXPECT_EQ(met.size(), n);
            EXPECT_LT(*met.rbegin(), n);
        }
}

TEST(Sampler, PermutationsPutEveryNumberEverywhere) {
    constexpr std::uint32_t kCount = 7;
    std::vector<std::vector<int>> met(kCount, std::vector<int>(kCount));
    constexpr int kKeys = 70'000;
    for (std::uint64_t key = 0; key < kKeys; ++key)
        for (std::uint32_t i = 0; i < kCount; ++i) ++met[i][permuted(i, kCount, mixed(key))];
    for (const auto& row : met)
        for (const int count : row) EXPECT_NEAR(count, kKeys / double(kCount), 5 * 93);  // sqrt(n p (1 - p)) = 93
}

}  // namespace
}  // namespace rays
