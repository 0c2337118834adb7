#include "step_3_subjects.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "3_recursion/recursion.h"

namespace rays::bench {
namespace {

constexpr std::size_t kCosines = 1024;  ///< with their answers they stay in the first caches
constexpr Real kGlass = Real(1.5);

/// As a diffuse surface meets light: cosines whose squares are evenly spread.
std::vector<Real> cosines() {
    std::vector<Real> result;
    for (std::size_t i = 0; i < kCosines; ++i)
        result.push_back(std::sqrt((static_cast<Real>(i) + Real(0.5)) / static_cast<Real>(kCosines)));
    // Not in order: a branch that goes one way for long is easily foreseen.
    for (std::size_t i = 0; i < kCosines; ++i) std::swap(result[i], result[i * 389 % kCosines]);
    return result;
}

/// By the amplitudes of both polarisations (Born and Wolf, Principles of Optics, 1.5.2): another way than the
/// solution's.
long double truth(Real cosine, Real index) {
    const long double c = cosine, n = index, sin2 = (1 - c * c) / (n * n);
    if (!(sin2 < 1)) return 1;
    const long double d = std::sqrt(1 - sin2);
    const long double s = (c - n * d) / (c + n * d), p = (n * c - d) / (n * c + d);
    return (s * s + p * p) / 2;
}

template <class Formula>
void add_formula(const std::string& name, const char* settings, Real index, Formula formula) {
    std::vector<double> errors;
    const std::vector<Real> angles = cosines();
    for (const Real c : angles) errors.push_back(static_cast<double>(std::abs(formula(c, index) - truth(c, index))));
    std::sort(errors.begin(), errors.end());
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
        for ([[maybe_unused]] auto _ : state) {
            Real sum = 0;
            for (const Real c : angles) sum += formula(c, index);
            benchmark::DoNotOptimize(sum);
        }
        state.SetLabel(settings);
        state.counters["rays"] = static_cast<double>(angles.size());
        state.counters["error_median"] = errors[errors.size() / 2];
        state.counters["error_mean"] =
            std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size());
        state.counters["error_largest"] = errors.back();
        state.counters["wrong"] = 0;
    });
}

}  // namespace

void add_fresnel() {
    for (const bool inside : {false, true}) {
        const std::string place = inside ? "fresnel/inside/" : "fresnel/outside/";
        const Real index = inside ? 1 / kGlass : kGlass;
        add_formula(place + "exact", "exact, unpolarised", index, [](Real c, Real n) { return fresnel(c, n); });
        add_formula(place + "schlick", "Schlick's (1 - c)^5", index, [](Real c, Real n) { return schlick(c, n); });
    }
}

}  // namespace rays::bench
