#include "scene_reader/number_table.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace rays::sdl {
namespace {

/// A table is fine enough when linear interpolation misses by less than this part of the number's whole range, or by
/// rounding.
constexpr double kTolerance = 2e-5;
/// Nothing in a scene is so small. What only rounding changes, where two terms cancel, is no function of the variable.
constexpr double kNothing = 1e-12;

}  // namespace

std::vector<double> NumberTable::taken(const std::vector<double>& values) {
    admit(values);
    std::vector<double> picked;
    picked.reserve(which_.size());
    for (const std::size_t i : which_) picked.push_back(values[i]);
    return picked;
}

/// Numbers that were constant so far and are not any more join the table.
void NumberTable::admit(const std::vector<double>& values) {
    std::vector<std::size_t> changed;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (values[i] != (*base_)[i]) changed.push_back(i);
    if (std::includes(which_.begin(), which_.end(), changed.begin(), changed.end())) return;
    std::vector<std::size_t> all;
    std::set_union(which_.begin(), which_.end(), changed.begin(), changed.end(), std::back_inserter(all));
    for (auto& sample : samples_) widen(sample, all);
    for (auto& sample : middles_) widen(sample, all);
    which_ = std::move(all);
}

void NumberTable::widen(std::vector<double>& sample, const std::vector<std::size_t>& all) const {
    std::vector<double> wider;
    wider.reserve(all.size());
    std::size_t old = 0;
    for (const std::size_t i : all) {
        const bool known = old < which_.size() && which_[old] == i;
        wider.push_back(known ? sample[old++] : (*base_)[i]);
    }
    sample = std::move(wider);
}

/// What a deviation of number k may be.
double NumberTable::allowed(std::size_t k) const {
    double low = samples_[0][k], high = low;
    for (const auto& sample : samples_) {
        low = std::min(low, sample[k]);
        high = std::max(high, sample[k]);
    }
    return kTolerance * (high - low) + kNumberRounding * std::max(std::abs(low), std::abs(high)) + kNothing;
}

bool NumberTable::middles_agree() const {
    for (std::size_t k = 0; k < which_.size(); ++k) {
        const double limit = allowed(k);
        for (std::size_t i = 0; i < middles_.size(); ++i) {
            const double between = (samples_[i][k] + samples_[i + 1][k]) / 2;
            if (!(std::abs(middles_[i][k] - between) <= limit)) return false;
        }
    }
    return true;
}

bool NumberTable::agrees(double part, const std::vector<double>& values) {
    const std::vector<double> mine = taken(values);
    const double at = part * static_cast<double>(intervals());
    const auto i = static_cast<std::size_t>(at);
    const double rest = at - static_cast<double>(i);
    for (std::size_t k = 0; k < which_.size(); ++k) {
        const double between = samples_[i][k] * (1 - rest) + samples_[i + 1][k] * rest;
        if (!(std::abs(mine[k] - between) <= 2 * allowed(k))) return false;
    }
    return true;
}

void NumberTable::merge_middles() {
    std::vector<std::vector<double>> finer(samples_.size() + middles_.size());
    for (std::size_t i = 0; i < samples_.size(); ++i) finer[2 * i] = std::move(samples_[i]);
    for (std::size_t i = 0; i < middles_.size(); ++i) finer[2 * i + 1] = std::move(middles_[i]);
    samples_ = std::move(finer);
    middles_.clear();
}

bool NumberTable::is_constant(std::size_t k) const {
    const double first = samples_[0][k];
    return std::all_of(samples_.begin(), samples_.end(),
                       [&](const auto& sample) { return std::abs(sample[k] - first) <= 1e-14 * std::abs(first); });
}

/// Every 2^n-th sample, as long as the left-out ones lie on the lines between the others.
Varying NumberTable::thinned(std::size_t k) const {
    const double limit = allowed(k);
    const std::size_t last = intervals();
    double error = 0;
    std::size_t step = last;
    for (; step > 1; step /= 2) {
        error = 0;
        for (std::size_t i = 0; i <= last; ++i) {
            const std::size_t left = std::min(i / step * step, last - step);
            const double rest = static_cast<double>(i - left) / static_cast<double>(step);
            const double line = samples_[left][k] * (1 - rest) + samples_[left + step][k] * rest;
            error = std::max(error, std::abs(samples_[i][k] - line));
        }
        if (error <= limit) break;
    }
    Varying varying;
    varying.variable = variable_.kind;
    varying.first = static_cast<Real>(variable_.first);
    varying.last = static_cast<Real>(variable_.last);
    // The deviation was seen at some points only; between them it is at most a little larger.
    varying.error = static_cast<Real>(2 * std::max(error, kNumberRounding * std::abs(samples_[0][k])) + kNothing);
    for (std::size_t i = 0; i <= last; i += step) varying.samples.push_back(static_cast<Real>(samples_[i][k]));
    return varying;
}

}  // namespace rays::sdl
