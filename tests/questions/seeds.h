// For which seeds the grader is tried for false alarms.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <random>
#include <vector>

namespace rays::tests {

/// Seeds that once called the solution wrong: weights that meet adc_bailout to the last digit, a tint darker than it.
inline constexpr std::uint64_t kOnceUnfair[] = {20718, 21171, 39938, 3238947696};

/// These, and seeds as the grader draws them: 32 bits, always the same ones here. RAYSTEPS_FAIR_SEEDS=1000 tries more
/// than the tests have time for.
inline std::vector<std::uint64_t> fair_seeds() {
    const char* wanted = std::getenv("RAYSTEPS_FAIR_SEEDS");
    std::vector<std::uint64_t> seeds(std::begin(kOnceUnfair), std::end(kOnceUnfair));
    std::mt19937 engine;
    for (std::size_t n = wanted ? std::strtoul(wanted, nullptr, 10) : 2; n > 0; --n) seeds.push_back(engine());
    return seeds;
}

}  // namespace rays::tests
