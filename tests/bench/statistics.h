// What many measurements say together.
#pragma once

#include <cstddef>
#include <vector>

namespace rays::bench {

/// The median and an interval that holds the true one with at least 95 % confidence, whatever the distribution: between
/// two of the ordered values (sign test; Conover, Practical Nonparametric Statistics, 3.2). Fewer than six values
/// cannot say so much: then it reaches from the smallest to the largest.
struct Spread {
    double median = 0, low = 0, high = 0;
};

/// Throws std::invalid_argument when there are no values, or one is not finite.
Spread spread(std::vector<double> values);

struct CostAndError {
    double cost = 0, error = 0;
};

/// Which points no other beats: none is at most as costly and at most as wrong and better in one of the two. Equal
/// points are all on the front; points with a NaN never are. Indices in ascending cost.
std::vector<std::size_t> pareto_front(const std::vector<CostAndError>& points);

}  // namespace rays::bench
