// The verdict on a picture: every pixel within the rounding of the reference, but for a few on silhouettes.
#pragma once

#include <string>

#include "grader/picture.h"

namespace rays::grader {

/// How far a right pixel may lie from the reference's: absolute + relative * |reference|, channel by channel.
struct Tolerance {
    double relative = 0, absolute = 0;
};

/// References are POV-Ray's half floats. Rounding to nearest costs at most half a unit in the last of 11 bits: 2^-11 of
/// the value, or 2^-25 where halves are denormal. Both renderers add up colours in 32-bit floats (a few 2^-24 of the
/// value for each of some ten operations, more where a highlight raises a cosine to the 100th power): 2e-5 of the
/// value and 1e-5 absolute are the slack for that, far below what can be seen (1/255 = 4e-3).
inline constexpr Tolerance kReferenceTolerance{1.0 / 2048 + 2e-5, 1e-5};

/// Student against solution, both 32-bit floats from possibly different, equally good arithmetic (single or double
/// geometry). A direction good to 2^-22 moves the cosine by as much, and phong_size 200 multiplies that by 200.
inline constexpr Tolerance kFreshTolerance{2e-4, 5e-5};

/// The largest share of pixels that may lie beyond the tolerance, all of them on silhouettes.
inline constexpr double kSilhouetteShare = 0.0005;

struct Comparison {
    bool passed = false;
    std::string problem;  ///< what is wrong, in a sentence; empty when it passed
    int pixels = 0;
    int not_finite = 0;            ///< pixels with a NaN or an infinity
    int beyond = 0;                ///< pixels beyond the tolerance, those not finite included
    int on_silhouettes = 0;        ///< those of them that the surroundings explain
    double max_error = 0;          ///< largest absolute difference, silhouettes left out
    double rmse = 0;               ///< shown, never judged; over the finite pixels
    int worst_x = 0, worst_y = 0;  ///< the pixel that is farthest out in units of its tolerance, silhouettes last
};

/// `least_allowed`: pixels on silhouettes that are forgiven however small the picture is.
Comparison compare(const RgbImage& picture, const Reference& truth, const Tolerance& tolerance, int least_allowed = 0);

/// Is every channel within the tolerance? Written so that NaN is not.
bool within(const Rgb& value, const Rgb& reference, const Tolerance& tolerance);

}  // namespace rays::grader
