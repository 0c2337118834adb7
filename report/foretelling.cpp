#include "foretelling.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

namespace rays::report {
namespace {

constexpr std::size_t kLengths = 30;  ///< a residual has fewer bits
constexpr std::size_t kDoubts = 24;   ///< classes, see class_of
constexpr std::int32_t kFarOff = 1 << 20;
constexpr int kLearntDigits = 3;  ///< of a residual, after the leading one; those below are taken as they come

std::size_t length_of(std::int32_t value) {
    return static_cast<std::size_t>(std::bit_width(static_cast<std::uint32_t>(value)));
}

/// Every number up to 3 by itself, then powers of two.
std::size_t class_of(std::int32_t value) {
    return value < 4 ? static_cast<std::size_t>(value) : std::min(kDoubts - 1, 2 + length_of(value));
}

std::size_t sign_of(std::int32_t value) { return value < 0 ? 0 : value == 0 ? 1 : 2; }

std::int32_t median_edge(std::int32_t left, std::int32_t above, std::int32_t corner) {
    const auto [low, high] = std::minmax(left, above);
    if (corner >= high) return low;
    if (corner <= low) return high;
    return left + above - corner;
}

std::int32_t weighted(std::int32_t w, std::int32_t n, std::int32_t nw, std::int32_t ne) {
    return 2 * w + 2 * n + nw + ne;
}

}  // namespace

Around around(std::size_t i, std::size_t width, std::size_t none) {
    const std::size_t x = i % width;
    const bool has_above = i >= width;
    Around at{};
    at.w = x > 0 ? i - 1 : has_above ? i - width : none;
    at.n = has_above ? i - width : at.w;
    at.nw = x > 0 && has_above ? i - width - 1 : at.n;
    at.ne = has_above && x + 1 < width ? i - width + 1 : at.n;
    at.ww = x > 1 ? i - 2 : at.w;
    at.nn = i >= 2 * width ? i - 2 * width : at.n;
    return at;
}

Foretelling::Foretelling(const Planes& planes, const Planes* base, int width)
    : width_(static_cast<std::size_t>(width)),
      none_(planes[0].size()),
      planes_(planes),
      base_(base),
      by_doubt_(3 * kDoubts * 16 * 6 * kLengths),
      by_residuals_(3 * kDoubts * 16 * kLengths),
      by_neighbours_(3 * 12 * 12 * 8 * kLengths),
      signs_(3 * 3 * 3 * 2),
      digits_(kLengths << kLearntDigits),
      weights_(3 * kLengths * kDoubts) {
    for (std::size_t c = 0; c < 3; ++c) {
        planes_[c].push_back(0);
        residuals_[c].resize(none_ + 1);
        off_[c].resize(none_ + 1);
    }
}

std::size_t Foretelling::guesses_of(std::size_t channel, std::size_t pixel, const Around& at, Guesses& guesses) const {
    const Plane& own = planes_[channel];
    std::size_t count = 0;
    if (base_) guesses[count++] = (*base_)[channel][pixel];
    guesses[count++] = median_edge(own[at.w], own[at.n], own[at.nw]);
    if (channel == 0) {
        guesses[count++] = own[at.w];
        guesses[count++] = own[at.n];
        guesses[count++] = own[at.w] + own[at.n] - own[at.nw];
        guesses[count++] = own[at.ne];
        guesses[count++] = own[at.nw];
        return count;
    }
    for (std::size_t known = 0; known < channel; ++known) {
        const Plane& other = planes_[known];
        const auto less = [&](std::size_t i) { return own[i] - other[i]; };
        guesses[count++] = other[pixel] + median_edge(less(at.w), less(at.n), less(at.nw));
    }
    const Plane &green = planes_[0], &red = planes_[1];
    std::size_t closest = at.w;
    std::int32_t least = -1;
    for (const std::size_t i : {at.w, at.n, at.ne, at.nw, at.ww, at.nn}) {
        std::int32_t distance = std::abs(green[pixel] - green[i]);
        if (channel == 2) distance += std::abs(red[pixel] - red[i] - (green[pixel] - green[i]));
        if (least < 0 || distance < least) least = distance, closest = i;
    }
    guesses[count++] = own[closest] + green[pixel] - green[closest];
    return count;
}

Foretelling::Guessed Foretelling::best(std::size_t channel, const Around& at, const Guesses& guesses,
                                       std::size_t count) const {
    const auto& off = off_[channel];
    Guessed found{0, -1, false};
    for (std::size_t k = 0; k < count; ++k) {
        const std::int32_t doubt = weighted(off[at.w][k], off[at.n][k], off[at.nw][k], off[at.ne][k]);
        if (found.doubt < 0 || doubt < found.doubt) found = {guesses[k], doubt, base_ && k == 0};
    }
    return found;
}

void Foretelling::put(BitWriter& writer, std::size_t channel, std::size_t pixel) {
    const Around at = around(pixel, width_, none_);
    Guesses guesses{};
    const std::size_t count = guesses_of(channel, pixel, at, guesses);
    put_residual(writer, channel, pixel, at, best(channel, at, guesses, count));
    for (std::size_t k = 0; k < count; ++k)
        off_[channel][pixel][k] = std::min(std::abs(planes_[channel][pixel] - guesses[k]), kFarOff);
}

void Foretelling::put_residual(BitWriter& writer, std::size_t channel, std::size_t pixel, const Around& at,
                               const Guessed& guessed) {
    Plane& own = residuals_[channel];
    const std::int32_t residual = planes_[channel][pixel] - guessed.value, size = std::abs(residual);
    own[pixel] = residual;
    const auto sized = [&](std::size_t i) { return std::min(std::abs(own[i]), kFarOff); };
    std::int32_t others = 0;  // of the channels before, here
    for (std::size_t known = 0; known < channel; ++known)
        others += std::min(std::abs(residuals_[known][pixel]), kFarOff);

    const std::size_t doubt = class_of(guessed.doubt), beside = std::min<std::size_t>(15, length_of(others));
    const std::size_t still = (own[at.w] == 0 ? 1u : 0u) + (own[at.n] == 0 ? 1u : 0u);
    const std::size_t busy = class_of(weighted(sized(at.w), sized(at.n), sized(at.nw), sized(at.ne)));
    const std::size_t west = std::min<std::size_t>(11, length_of(sized(at.w))),
                      north = std::min<std::size_t>(11, length_of(sized(at.n)));
    const std::size_t based = guessed.from_base ? 1 : 0;
    const std::size_t first = ((((channel * kDoubts + doubt) * 16 + beside) * 3 + still) * 2 + based) * kLengths;
    const std::size_t second = ((channel * kDoubts + busy) * 16 + beside) * kLengths;
    const std::size_t third = (((channel * 12 + west) * 12 + north) * 8 + std::min<std::size_t>(7, beside)) * kLengths;
    const std::size_t length = length_of(size);
    for (std::size_t k = 0; k < kLengths; ++k) {
        writer.put(k < length ? 1 : 0, {&by_doubt_[first + k], &by_residuals_[second + k], &by_neighbours_[third + k]},
                   weights_[(channel * kLengths + k) * kDoubts + doubt]);
        if (k == length) break;
    }
    if (length == 0) return;
    const std::size_t before = channel == 0 ? 1 : sign_of(residuals_[channel - 1][pixel]);
    writer.put(residual < 0 ? 1 : 0, signs_[((channel * 3 + sign_of(own[at.w])) * 3 + before) * 2 + based]);
    int left = static_cast<int>(length) - 1;
    std::size_t digits = 1;
    for (int k = 0; k < kLearntDigits && left > 0; ++k) {
        const int bit = (size >> --left) & 1;
        writer.put(bit, digits_[(length << kLearntDigits) + digits]);
        digits = digits << 1 | static_cast<std::size_t>(bit);
    }
    writer.put_plain(static_cast<std::uint32_t>(size), left);
}

}  // namespace rays::report
