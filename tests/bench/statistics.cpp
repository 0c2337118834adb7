#include "statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace rays::bench {
namespace {

/// How many values may be dropped at each end: the largest k with P(fewer than k of n coins show heads) <= 2.5 %.
std::size_t dropped_at_each_end(std::size_t n) {
    double probability = std::pow(0.5, static_cast<double>(n)), sum = probability;
    std::size_t k = 0;
    while (sum <= 0.025) {
        ++k;
        probability *= static_cast<double>(n - k + 1) / static_cast<double>(k);
        sum += probability;
    }
    return k == 0 ? 0 : k - 1;
}

}  // namespace

Spread spread(std::vector<double> values) {
    if (values.empty()) throw std::invalid_argument("no values have no median");
    for (const double v : values)
        if (!std::isfinite(v)) throw std::invalid_argument("a measured value is not finite");
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size(), k = dropped_at_each_end(n);
    return {(values[(n - 1) / 2] + values[n / 2]) / 2, values[k], values[n - 1 - k]};
}

std::vector<std::size_t> pareto_front(const std::vector<CostAndError>& points) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (!std::isnan(points[i].cost) && !std::isnan(points[i].error)) order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return points[a].cost != points[b].cost ? points[a].cost < points[b].cost : points[a].error < points[b].error;
    });
    std::vector<std::size_t> front;
    double least_error = std::numeric_limits<double>::infinity();
    for (const std::size_t i : order) {
        const bool equal = !front.empty() && points[front.back()].cost == points[i].cost &&
                           points[front.back()].error == points[i].error;
        if (!equal && !(points[i].error < least_error)) continue;
        least_error = points[i].error;
        front.push_back(i);
    }
    return front;
}

}  // namespace rays::bench
