// PNG pictures as students hand them in, read as hostile bytes.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/camera.h"

namespace rays::grader {

/// Display levels (sRGB, 0 to 255), rows from top to bottom.
struct PngPicture {
    std::vector<std::array<std::uint8_t, 3>> pixels;  ///< empty when there is a problem
    std::string problem;                              ///< for the student: "is ..."
};

/// Reads a PNG of exactly this size: 8 bits, RGB or RGBA (alpha is ignored), not interlaced. Reserves memory only by
/// the size that is asked for. Source: PNG specification, W3C, 2003.
PngPicture decode_png(const std::string& bytes, Raster raster);

}  // namespace rays::grader
