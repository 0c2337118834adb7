#include "questions/dice.h"

#include <cmath>

namespace rays::grader {

double BasicDice::between(double low, double high) {
    // Not std::uniform_real_distribution: its numbers depend on the library.
    return low + (high - low) * (0x1p-53 * static_cast<double>(engine_() >> 11));
}

double BasicDice::round_between(double low, double high) { return std::round(between(low, high) * 1000) / 1000; }

int BasicDice::whole(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
}

}  // namespace rays::grader
