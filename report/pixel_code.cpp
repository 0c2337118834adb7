#include "pixel_code.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace rays::report {
namespace {

constexpr int kFloatMantissa = 23;
constexpr float kSmallest = 0x1p-24f;

// Unsigned, for the arithmetic may wrap: the page does the same modulo 2^32.
using Plane = std::vector<std::uint32_t>;
using Planes = std::array<Plane, 3>;
constexpr std::array<std::size_t, 3> kChannelOrder = {1, 0, 2};  // green first: the others may refer to it

Planes ordinals(const Picture& picture, int mantissa) {
    Planes planes;
    for (std::size_t c = 0; c < 3; ++c) {
        planes[c].reserve(picture.pixels());
        for (std::size_t i = 0; i < picture.pixels(); ++i)
            planes[c].push_back(static_cast<std::uint32_t>(ordinal(picture.rgb[3 * i + kChannelOrder[c]], mantissa)));
    }
    return planes;
}

// M. Weinberger, G. Seroussi, G. Sapiro: The LOCO-I lossless image compression algorithm (2000), equation 1.
std::uint32_t median_edge(std::int32_t left, std::int32_t above, std::int32_t corner) {
    const auto [low, high] = std::minmax(left, above);
    if (corner >= high) return static_cast<std::uint32_t>(low);
    if (corner <= low) return static_cast<std::uint32_t>(high);
    return static_cast<std::uint32_t>(left) + static_cast<std::uint32_t>(above) - static_cast<std::uint32_t>(corner);
}

Plane less_neighbours(const Plane& plane, int width) {
    const auto w = static_cast<std::size_t>(width);
    Plane residual(plane.size());
    const auto at = [&](std::size_t i) { return static_cast<std::int32_t>(plane[i]); };
    for (std::size_t i = 0; i < plane.size(); ++i) {
        const bool has_left = i % w != 0, has_above = i >= w;
        std::uint32_t guess = 0;
        if (has_left && has_above)
            guess = median_edge(at(i - 1), at(i - w), at(i - w - 1));
        else if (has_left)
            guess = plane[i - 1];
        else if (has_above)
            guess = plane[i - w];
        residual[i] = plane[i] - guess;
    }
    return residual;
}

void subtract(Plane& from, const Plane& what, int shift) {
    for (std::size_t i = 0; i < from.size(); ++i) from[i] -= what[i] << shift;
}

Bytes byte_planes(const Planes& planes) {
    Bytes bytes;
    bytes.reserve(planes[0].size() * 12);
    for (const Plane& plane : planes)
        for (int shift = 0; shift < 32; shift += 8)
            for (const std::uint32_t v : plane) {
                const std::uint32_t zigzag = (v << 1) ^ (v >> 31 ? ~std::uint32_t{0} : 0u);
                bytes.push_back(static_cast<std::uint8_t>(zigzag >> shift));
            }
    return bytes;
}

PixelCode coded(Planes planes, int width, bool gradient, bool color, bool base) {
    if (color) {
        subtract(planes[1], planes[0], 0);
        subtract(planes[2], planes[0], 0);
    }
    if (gradient)
        for (Plane& plane : planes) plane = less_neighbours(plane, width);
    return {gradient, color, base, byte_planes(planes)};
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

PixelCode encode(const Picture& picture, int mantissa, const Picture* base, int base_mantissa) {
    const Planes own = ordinals(picture, mantissa);
    PixelCode best;
    std::size_t best_size = 0;
    const auto consider = [&](PixelCode code) {
        const std::size_t size = deflate(code.bytes, Effort::quick).size();
        if (best.bytes.empty() || size < best_size) best = std::move(code), best_size = size;
    };
    if (base) {
        Planes less_base = own;
        const Planes other = ordinals(*base, base_mantissa);
        for (std::size_t c = 0; c < 3; ++c) subtract(less_base[c], other[c], mantissa - base_mantissa);
        consider(coded(less_base, picture.width, false, false, true));
    }
    for (const bool gradient : {false, true})
        for (const bool color : {false, true}) consider(coded(own, picture.width, gradient, color, false));
    return best;
}

}  // namespace rays::report
