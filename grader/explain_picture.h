// What single change would make a wrong picture right? Only to explain a failure, never to forgive it.
#pragma once

#include <optional>
#include <string>

#include "grader/compare.h"

namespace rays::grader {

/// "the picture is mirrored left to right", "the picture is shifted by 1 pixel to the right", "every value is 2 times
/// too bright", "the values are gamma encoded", "red and blue are swapped", "the picture is black"; nothing when no
/// single change explains nearly all of the pixels that are wrong.
std::optional<std::string> explain_picture(const RgbImage& picture, const Reference& truth, const Tolerance& tolerance);

}  // namespace rays::grader
