// Float pictures in few bytes. A float is cut to a number of mantissa bits and seen as an ordinal: integers in the
// order of the values, one apart for neighbouring values. What is stored is the ordinal less what the pixels before it
// foretell, in the arithmetic code of bit_code.h; the page's pixels.js reads it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "bit_code.h"

namespace rays::report {

/// Three floats a pixel, rows from top to bottom.
struct Picture {
    int width = 0, height = 0;
    std::vector<float> rgb;

    std::size_t pixels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
};

constexpr int kHalfMantissa = 10;  ///< of a half float: what POV-Ray's pictures have

/// True when cutting to that many mantissa bits changes no value of the picture.
bool exact_with(const Picture& picture, int mantissa);

/// Round to nearest; below 2^-24, the smallest half float, is 0; every NaN is the same one.
std::int32_t ordinal(float value, int mantissa);
float from_ordinal(std::int32_t ordinal, int mantissa);

/// Whole numbers, a plane a channel, in the order G R B: what is green often tells the others.
using Plane = std::vector<std::int32_t>;
using Planes = std::array<Plane, 3>;

Planes ordinals(const Picture& picture, int mantissa);
/// The values themselves. Throws std::invalid_argument unless they are whole and below 2^24.
Planes counts(const Picture& picture);

/// `base`: a picture of the same size in the same numbers that may resemble this one, or null. Numbers are smaller
/// than 2^28.
void put_planes(BitWriter& writer, const Planes& planes, int width, const Planes* base);

/// One bit a pixel.
using Bitmap = std::vector<bool>;
void put_bitmap(BitWriter& writer, const Bitmap& bitmap, int width);

/// For pixels that the bitmap names: `more` further bits of mantissa, as the difference to what the coarse ordinals
/// say.
void put_finer(BitWriter& writer, const Picture& picture, const Bitmap& where, int mantissa, int more);

}  // namespace rays::report
