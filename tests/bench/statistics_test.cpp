#include "statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace rays::bench {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
using Indices = std::vector<std::size_t>;

TEST(Spread, MedianOfOddAndEvenCounts) {
    EXPECT_EQ(spread({3, 1, 2}).median, 2);
    EXPECT_EQ(spread({4, 1, 3, 2}).median, 2.5);
    EXPECT_EQ(spread({7}).median, 7);
}

// The table of the sign test: 95 % intervals of the median lie between these ordered values.
TEST(Spread, IntervalOfTheSignTest) {
    const auto interval = [](int n) {
        std::vector<double> values(static_cast<std::size_t>(n));
        std::iota(values.rbegin(), values.rend(), 1.0);
        const Spread s = spread(values);
        return std::pair{s.low, s.high};
    };
    EXPECT_EQ(interval(5), (std::pair{1.0, 5.0}));  // cannot reach 95 %
    EXPECT_EQ(interval(6), (std::pair{1.0, 6.0}));
    EXPECT_EQ(interval(9), (std::pair{2.0, 8.0}));
    EXPECT_EQ(interval(11), (std::pair{2.0, 10.0}));
    EXPECT_EQ(interval(20), (std::pair{6.0, 15.0}));
    EXPECT_EQ(interval(50), (std::pair{18.0, 33.0}));
}

TEST(Spread, OneSlowRoundMovesNothing) {
    EXPECT_EQ(spread({10, 11, 12, 10, 11, 12, 10, 11, 9000}).median, 11);
    EXPECT_EQ(spread({10, 11, 12, 10, 11, 12, 10, 11, 9000}).high, 12);
}

TEST(Spread, RefusesWhatIsNoMeasurement) {
    EXPECT_THROW(spread({}), std::invalid_argument);
    EXPECT_THROW(spread({1, kNan}), std::invalid_argument);
    EXPECT_THROW(spread({1, std::numeric_limits<double>::infinity()}), std::invalid_argument);
}

TEST(ParetoFront, KeepsWhatNothingBeats) {
    //                     cheap but wrong, good, dear and worse, best, beaten at equal cost, beaten at equal error
    EXPECT_EQ(pareto_front({{1, 1}, {3, 0.1}, {4, 0.5}, {9, 0}, {3, 0.2}, {5, 0.1}}), (Indices{0, 1, 3}));
    EXPECT_EQ(pareto_front({{9, 0}, {1, 1}}), (Indices{1, 0}));
    EXPECT_EQ(pareto_front({}), Indices{});
}

TEST(ParetoFront, EqualPointsAreAllOnIt) { EXPECT_EQ(pareto_front({{1, 2}, {1, 2}, {2, 2}}), (Indices{0, 1})); }

TEST(ParetoFront, NoNanIsOnIt) {
    EXPECT_EQ(pareto_front({{1, kNan}, {kNan, 0}, {2, 1}}), Indices{2});
    EXPECT_EQ(pareto_front({{kNan, kNan}}), Indices{});
}

// By the definition, for many points of a coarse grid, so that ties are frequent.
TEST(ParetoFront, AgreesWithTheDefinition) {
    std::vector<CostAndError> points;
    unsigned state = 1;
    const auto next = [&] { return static_cast<double>((state = state * 1664525u + 1013904223u) >> 28); };
    for (int i = 0; i < 60; ++i) {
        const double cost = next();
        points.push_back({cost, next()});
    }
    const Indices front = pareto_front(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        bool beaten = false;
        for (const auto& p : points) {
            const bool no_worse = p.cost <= points[i].cost && p.error <= points[i].error;
            beaten = beaten || (no_worse && (p.cost < points[i].cost || p.error < points[i].error));
        }
        EXPECT_EQ(std::find(front.begin(), front.end(), i) == front.end(), beaten) << "point " << i;
    }
}

}  // namespace
}  // namespace rays::bench
