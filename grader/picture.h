// A picture in memory, and how one that a student's program wrote is read: as hostile bytes.
#pragma once

#include <string>
#include <string_view>

#include "references/reference.h"

namespace rays::grader {

struct DecodedPicture {
    RgbImage picture;     ///< without pixels when there is a problem
    std::string problem;  ///< for the student: what is wrong with the file
};

/// Why these bytes are not an EXR file of the given size with R, G, B in one part of scan lines; empty when they may
/// be. Looks at the header only, byte by byte, and reserves nothing by what it says.
std::string exr_header_problem(std::string_view bytes, int width, int height);

/// Reads an EXR file whose header is as promised. NaN and infinity come through: the comparison judges them.
DecodedPicture decode_exr(const std::string& bytes, int width, int height);

}  // namespace rays::grader
