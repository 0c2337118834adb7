// Float pictures in few bytes. A float is cut to a number of mantissa bits and seen as an ordinal: integers in the
// order of the values, one apart for neighbouring values. What is stored is the ordinal less a prediction, as bytes
// of equal weight side by side, for deflate.
#pragma once

#include <cstdint>
#include <vector>

#include "encoding.h"

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

/// How the residuals of a picture were made; the page undoes it.
struct PixelCode {
    bool gradient = false;  ///< predicted from the neighbours left, above and left above (median edge detector)
    bool color = false;     ///< red and blue stored less green
    bool base = false;      ///< stored less the ordinals of the other picture
    Bytes bytes;            ///< not yet deflated: zigzag residuals, 3 channels (G R B) x 4 byte planes x pixels
};

/// The cheapest of the codes after deflate. `base` (of the same size, any mantissa not above this one) may be null.
PixelCode encode(const Picture& picture, int mantissa, const Picture* base, int base_mantissa);

}  // namespace rays::report
