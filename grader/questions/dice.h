// Random numbers for questions.
#pragma once

#include <cstdint>
#include <random>

namespace rays::grader {

/// Random numbers of a seed, the same on every machine; all are doubles.
class BasicDice {
public:
    explicit BasicDice(std::uint64_t seed) : engine_(seed) {}

    double between(double low, double high);
    /// Three decimals, as one would write in a scene: easy to read, exact in every reader.
    double round_between(double low, double high);
    int whole(int low, int high);  ///< both ends included
    bool coin() { return whole(0, 1) == 1; }

private:
    std::mt19937_64 engine_;
};

}  // namespace rays::grader
