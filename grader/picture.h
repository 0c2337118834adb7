// A picture in memory, and how one that a student's program wrote is read: as hostile bytes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "references/reference.h"

namespace rays::grader {

struct DecodedPicture {
    RgbImage picture;     ///< without pixels when there is a problem
    std::string problem;  ///< for the student: what is wrong with the file
};

using ChannelNames = std::vector<std::string>;

/// Why these bytes are not an EXR file of the given size with these channels (and at most one more) in one part of scan
/// lines; empty when they may be. Looks at the header only, byte by byte, and reserves nothing by what it says.
std::string exr_header_problem(std::string_view bytes, int width, int height,
                               const ChannelNames& channels = {"R", "G", "B"});

/// Reads an EXR file whose header is as promised. NaN and infinity come through: the comparison judges them.
DecodedPicture decode_exr(const std::string& bytes, int width, int height);

struct DecodedCosts {
    std::vector<float> tests, nodes;  ///< a pixel, rows from top to bottom; finite, >= 0; empty when there is a problem
    std::string problem;
};

/// Reads what `--cost-map` writes.
DecodedCosts decode_cost_map(const std::string& bytes, int width, int height);

}  // namespace rays::grader
