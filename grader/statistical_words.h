// What a statistical verdict found, in words.
#pragma once

#include <optional>
#include <string>

#include "grader/statistical_verdict.h"

namespace rays::grader {

/// "too dark by 9.8 % (0.412 instead of 0.457)"
std::string difference_text(const Difference& difference);

/// "the tile of pixels (40, 16) to (47, 23), upper left"
std::string tile_text(const Tile& tile, Raster raster);

/// "R", "G" or "B".
std::string channel_name(std::size_t channel);

/// Why the mean is wrong, or how right it is.
std::string bias_text(const BiasVerdict& verdict, Raster raster);

std::string noise_text(const NoiseVerdict& verdict, const VerdictOptions& options);

/// One change that makes the wrong pictures right, if one of the usual mistakes is such a change.
std::optional<std::string> explain_bias(const Pictures& pictures, const AveragedReference& truth,
                                        const VerdictOptions& options);

}  // namespace rays::grader
