// What reading an expression and working it out have in common.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace rays::sdl {

/// POV-Ray's conversion to int, defined for every double.
inline int to_int(double value) {
    if (!(value > -2147483649.0 && value < 2147483648.0)) return std::numeric_limits<int>::min();
    return static_cast<int>(value);
}

/// The stream that seed() gave this number; null: none.
inline std::uint32_t* random_stream(std::vector<std::uint32_t>& streams, double number) {
    if (!(number >= 0 && number < static_cast<double>(streams.size()))) return nullptr;
    return &streams[static_cast<std::size_t>(number)];
}

/// POV-Ray's generator: 32 bits, linear congruential, both ends included.
inline double draw_random(std::uint32_t& state) {
    state = state * 1812433253u + 12345u;
    return state / 4294967295.0;
}

}  // namespace rays::sdl
