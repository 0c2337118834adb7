// What the tests of the grader share.
#pragma once

#include <string>

#include "references/reference.h"
#include "support/files.h"

namespace rays::grader {

/// A picture with an edge, a gradient and three different channels: no symmetry maps it onto itself.
RgbImage test_picture(int width = 64, int height = 48);

/// The picture with surroundings that are the picture itself, but for the edge between columns `edge - 1` and `edge`.
Reference test_reference(const RgbImage& picture, int edge);

/// The bytes of an EXR file as the render programs write it.
std::string exr_bytes(const RgbImage& picture);

/// Is this a part of the text?
inline bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A shell script, executable, in the folder.
std::filesystem::path script(const TemporaryFolder& folder, const std::string& text);

}  // namespace rays::grader
