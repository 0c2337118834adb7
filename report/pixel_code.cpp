#include "pixel_code.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "foretelling.h"

namespace rays::report {
namespace {

constexpr int kFloatMantissa = 23;
constexpr float kSmallest = 0x1p-24f;
constexpr float kMostCounted = 0x1p24f;  ///< whole numbers above may not be floats

constexpr std::array<std::size_t, 3> kChannelOrder = {1, 0, 2};

template <class ToNumber>
Planes planes_of(const Picture& picture, ToNumber to_number) {
    Planes planes;
    for (std::size_t c = 0; c < 3; ++c) {
        planes[c].reserve(picture.pixels());
        for (std::size_t i = 0; i < picture.pixels(); ++i)
            planes[c].push_back(to_number(picture.rgb[3 * i + kChannelOrder[c]]));
    }
    return planes;
}

}  // namespace

std::int32_t ordinal(float value, int mantissa) {
    const int shift = kFloatMantissa - mantissa;
    if (std::isnan(value)) return (0x7fc00000 >> shift);
    if (std::abs(value) < kSmallest) return 0;
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(value) & 0x7fffffffu;
    // Infinity is exact and stays; a finite value may round up to it.
    const std::uint32_t half_step = shift > 0 && bits < 0x7f800000u ? 1u << (shift - 1) : 0u;
    const auto magnitude = static_cast<std::int32_t>((bits + half_step) >> shift);
    return std::signbit(value) ? -magnitude : magnitude;
}

float from_ordinal(std::int32_t ordinal, int mantissa) {
    const int shift = kFloatMantissa - mantissa;
    const auto magnitude = static_cast<std::uint32_t>(std::abs(ordinal)) << shift;
    return std::bit_cast<float>(magnitude | (ordinal < 0 ? 0x80000000u : 0u));
}

bool exact_with(const Picture& picture, int mantissa) {
    return std::all_of(picture.rgb.begin(), picture.rgb.end(),
                       [&](float v) { return std::isnan(v) || from_ordinal(ordinal(v, mantissa), mantissa) == v; });
}

Planes ordinals(const Picture& picture, int mantissa) {
    return planes_of(picture, [&](float v) { return ordinal(v, mantissa); });
}

Planes counts(const Picture& picture) {
    return planes_of(picture, [](float v) {
        if (!(std::abs(v) < kMostCounted && v == std::trunc(v))) throw std::invalid_argument("not a count");
        return static_cast<std::int32_t>(v);
    });
}

void put_planes(BitWriter& writer, const Planes& planes, int width, const Planes* base) {
    Foretelling foretelling(planes, base, width);
    for (std::size_t i = 0; i < planes[0].size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) foretelling.put(writer, c, i);
}

void put_bitmap(BitWriter& writer, const Bitmap& bitmap, int width) {
    std::vector<Chance> chances(64);
    const auto bit = [&](std::size_t i) { return i < bitmap.size() && bitmap[i] ? 1u : 0u; };
    for (std::size_t i = 0; i < bitmap.size(); ++i) {
        const Around at = around(i, static_cast<std::size_t>(width), bitmap.size());
        std::size_t context = 0;
        for (const std::size_t neighbour : {at.w, at.n, at.nw, at.ne, at.ww, at.nn})
            context = context << 1 | bit(neighbour);
        writer.put(bitmap[i] ? 1 : 0, chances[context]);
    }
}

void put_finer(BitWriter& writer, const Picture& picture, const Bitmap& where, int mantissa, int more) {
    for (std::size_t i = 0; i < where.size(); ++i)
        for (std::size_t c = 0; c < 3 && where[i]; ++c) {
            const float value = picture.rgb[3 * i + kChannelOrder[c]];
            // Both are rounded, so the difference is at most half a coarse step.
            const std::int32_t rest = ordinal(value, mantissa + more) - (ordinal(value, mantissa) << more);
            writer.put_plain(static_cast<std::uint32_t>(rest + (1 << (more - 1))), more + 1);
        }
}

}  // namespace rays::report
