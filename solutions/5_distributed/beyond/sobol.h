// Tables of Sobol's sequence.
#pragma once

#include <cstddef>
#include <cstdint>

namespace rays {

/// Sobol's third and fourth dimension, byte by byte of the index: what its bits add up to (Joe and Kuo, "Constructing Sobol
/// Sequences with Better Two-Dimensional Projections", 2008, dimensions 3 and 4).
class ThirdAndFourth {
public:
    constexpr ThirdAndFourth() {
        std::uint32_t third[32] = {1u << 31, 3u << 30}, fourth[32] = {1u << 31, 3u << 30, 1u << 29};
        for (int i = 2; i < 32; ++i) third[i] = third[i - 1] ^ third[i - 2] ^ third[i - 2] >> 2;
        for (int i = 3; i < 32; ++i) fourth[i] = fourth[i - 2] ^ fourth[i - 3] ^ fourth[i - 3] >> 3;
        for (std::size_t byte = 0; byte < 4; ++byte)
            for (std::uint32_t value = 0; value < 256; ++value)
                for (std::size_t bit = 0; bit < 8; ++bit)
                    if (value >> bit & 1) {
                        of_[0][byte][value] ^= third[8 * byte + bit];
                        of_[1][byte][value] ^= fourth[8 * byte + bit];
                    }
    }
    constexpr std::uint32_t at(std::size_t dimension, std::uint32_t index) const {
        const auto& of = of_[dimension];
        return of[0][index & 255] ^ of[1][index >> 8 & 255] ^ of[2][index >> 16 & 255] ^ of[3][index >> 24];
    }

private:
    std::uint32_t of_[2][4][256] = {};
};
inline constexpr ThirdAndFourth kSobol;

}  // namespace rays
