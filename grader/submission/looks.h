// How pictures look: display levels, what counts as the same picture, and what as a visible difference.
#pragma once

#include <array>
#include <string>

#include "references/reference.h"

namespace rays::grader {

/// The level from 0 to 255 that a display shows for a linear value (sRGB, IEC 61966-2-1); -1 for NaN.
int display_level(float linear);

/// A difference that one sees without looking for it: one display level is below what the eye tells apart, 8 of 255
/// are a step of about 3 % in brightness at mid grey, where side by side about 1 % is told apart.
inline constexpr int kVisibleLevels = 8;

/// An effect must change at least this share of all pixels visibly: 38 of 160 x 120, a spot of 6 x 6, which is the
/// smallest highlight or mirror image that one would call "shown". Differences of rounding reach no pixel at all.
inline constexpr double kVisibleShare = 0.002;

/// The share of pixels that differ visibly in a channel. 1 when the sizes differ. Pixels with NaN differ.
double visible_share(const RgbImage& a, const RgbImage& b);

struct Likeness {
    std::string problem;  ///< why the file is no picture to compare; empty when it was compared
    int pixels = 0, differing = 0;

    /// As many pixels as a silhouette may cost between two machines (compare.h), at least three.
    bool same() const;
};

/// Is this file the rendered picture, within the rounding of its format? An .exr may hold half floats, so it is held
/// to their rounding; a .png to one display level, since 8 bits are rounded once.
Likeness likeness(const std::string& file_name, const std::string& bytes, const RgbImage& rendered);

}  // namespace rays::grader
