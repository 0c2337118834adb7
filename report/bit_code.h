// Bits in less than a bit each: arithmetic coding of what learnt chances foresee. The page's bits.js reads what this
// writes and must do the very same arithmetic: integers throughout.
//
// G. N. N. Martin: Range encoding (1979); M. Mahoney: Adaptive weighing of context models for lossless data compression
// (2005), for the mixing.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "encoding.h"

namespace rays::report {

/// How likely the next bit of one context is 1, from the bits that stood there before.
class Chance {
public:
    int of_4096() const { return one_ >> 4; }
    void learn(int bit);

private:
    std::int32_t one_ = 1 << 15;  ///< of 2^16
    int seen_ = 0;
};

/// Several chances of one bit, each with a weight that grows as it is right.
constexpr std::size_t kOpinions = 3;
using Opinions = std::array<Chance*, kOpinions>;
struct Weights {
    std::array<std::int32_t, kOpinions> of_65536 = {23000, 23000, 23000};
};

class BitWriter {
public:
    void put(int bit, Chance& chance);
    void put(int bit, const Opinions& opinions, Weights& weights);
    /// The lowest `count` bits of value, highest first, nothing foreseen.
    void put_plain(std::uint32_t value, int count);

    /// Nothing may be put afterwards.
    Bytes finish();

private:
    void narrow(int bit, int chance_of_4096);

    Bytes bytes_;
    std::uint32_t low_ = 0, high_ = 0xffffffffu;
};

}  // namespace rays::report
