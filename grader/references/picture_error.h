// One number for how far two pictures are apart: for charts. Grades look at every pixel.
#pragma once

#include "references/averaged.h"
#include "references/reference.h"

namespace rays {

/// The root of the mean squared difference to the reference, over all pixels and lanes, as a share of the reference's
/// own root mean square. Both are rounded to half floats first, as POV-Ray's pictures are. Infinite where a picture is
/// no number. Throws std::invalid_argument when the sizes differ.
double picture_error(const RgbImage& picture, const RgbImage& reference);

/// The same of a picture that is a mean, as it stands; what the reference itself may be off by is taken away (at least
/// a quarter of it is left).
double picture_error(const RgbImage& picture, const AveragedReference& reference);

}  // namespace rays
