#include "bit_code.h"

#include <algorithm>
#include <cmath>

namespace rays::report {
namespace {

constexpr int kMostSeen = 40;  ///< then a chance follows the latest hundred bits or so
constexpr int kMixingRate = 24;
constexpr int kFarthest = 2047;  ///< of log odds, in units of 1/256: chances down to 1 in 3000

/// Chances of 4096 from log odds and back. No value before rounding lies within 10^-5 of a half, so that the last digit
/// of anybody's exp() does not matter.
struct LogOdds {
    std::array<std::int32_t, 2 * kFarthest + 1> chances = {};
    std::array<std::int32_t, 4096> odds = {};

    LogOdds() {
        for (int d = -kFarthest; d <= kFarthest; ++d)
            chances[static_cast<std::size_t>(d + kFarthest)] =
                std::clamp(static_cast<int>(std::lround(4096 / (1 + std::exp(-d / 256.0)))), 1, 4095);
        int d = -kFarthest;
        for (int p = 0; p < 4096; ++p) {
            while (d < kFarthest && chance(d) < p) ++d;
            odds[static_cast<std::size_t>(p)] = d;
        }
    }
    int chance(std::int64_t d) const {
        return chances[static_cast<std::size_t>(std::clamp<std::int64_t>(d, -kFarthest, kFarthest) + kFarthest)];
    }
};

const LogOdds& log_odds() {
    static const LogOdds table;
    return table;
}

}  // namespace

void Chance::learn(int bit) {
    const std::int32_t rate = 32768 / (2 * seen_ + 3);  // of 2^14: 1 / (seen + 1.5)
    one_ += (((bit ? 65535 : 0) - one_) * rate) >> 14;
    seen_ = std::min(seen_ + 1, kMostSeen);
}

void BitWriter::put(int bit, Chance& chance) {
    narrow(bit, std::clamp(chance.of_4096(), 1, 4095));
    chance.learn(bit);
}

void BitWriter::put(int bit, const Opinions& opinions, Weights& weights) {
    std::array<std::int32_t, kOpinions> odds;
    std::int64_t mixed = 0;
    for (std::size_t i = 0; i < kOpinions; ++i) {
        odds[i] = log_odds().odds[static_cast<std::size_t>(opinions[i]->of_4096())];
        mixed += std::int64_t{odds[i]} * weights.of_65536[i];
    }
    const int chance = log_odds().chance(mixed >> 16);
    narrow(bit, chance);
    const std::int32_t error = ((bit << 12) - chance) * kMixingRate;
    for (std::size_t i = 0; i < kOpinions; ++i) {
        weights.of_65536[i] += (odds[i] * error + 0x8000) >> 16;
        opinions[i]->learn(bit);
    }
}

void BitWriter::put_plain(std::uint32_t value, int count) {
    while (count-- > 0) narrow(static_cast<int>((value >> count) & 1u), 2048);
}

void BitWriter::narrow(int bit, int chance_of_4096) {
    const std::uint32_t middle = low_ + ((high_ - low_) >> 12) * static_cast<std::uint32_t>(chance_of_4096);
    if (bit)
        high_ = middle;
    else
        low_ = middle + 1;
    for (; (low_ ^ high_) >> 24 == 0; low_ <<= 8, high_ = (high_ << 8) | 0xffu)
        bytes_.push_back(static_cast<std::uint8_t>(high_ >> 24));
}

Bytes BitWriter::finish() {
    // Any number of the range will do; the reader takes zeros after the last byte.
    bytes_.push_back(static_cast<std::uint8_t>((low_ >> 24) + 1));
    return std::move(bytes_);
}

}  // namespace rays::report
