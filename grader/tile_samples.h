// What several seeds' pictures show in a rectangle, and in the tiles around it: differences from the reference, and how
// sure they are.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "references/averaged.h"

namespace rays::grader {

struct Rectangle {
    int x = 0, y = 0, width = 0, height = 0;  ///< pixels
};

/// Over the seeds, of a rectangle's mean in one channel.
struct Sample {
    double difference = 0;            ///< mean over the seeds of picture - reference
    double reference = 0, error = 0;  ///< means of the reference's pixels and of their errors
    double variance = 0;              ///< of a seed's mean
    double fourth_powers = 0;         ///< sum of the fourth powers of the seeds' deviations from their mean
};

Sample sample_of(const Rectangle& area, const std::vector<RgbImage>& pictures, const AveragedReference& truth,
                 std::size_t channel);

/// A variance that was estimated, and how well.
struct Variance {
    double value = 0;
    double freedom = 1;  ///< degrees of freedom
};

/// The samples of all tiles of a picture, row by row; at the right and lower edge tiles may be smaller.
class TileSamples {
public:
    /// At least two pictures, all of the truth's size.
    TileSamples(const std::vector<RgbImage>& pictures, const AveragedReference& truth, int tile_px);

    const std::vector<Rectangle>& rectangles() const { return rectangles_; }
    std::size_t count() const { return rectangles_.size(); }
    const Sample& sample(std::size_t tile, std::size_t channel) const { return samples_[channel][tile]; }

    /// The tile's own variance, the mean of the 3 x 3 tiles around it, and where light is rare also of the 5 x 5: what
    /// all seeds of a tile have missed shows beside it.
    std::vector<Variance> variances(std::size_t tile, std::size_t channel) const;

private:
    template <class F>
    void each_near(std::size_t tile, int reach, F f) const;
    Variance mean_variance(std::size_t tile, std::size_t channel, int reach) const;
    double events(std::size_t tile, std::size_t channel) const;

    double freedom_;  ///< of one tile's variance
    int columns_, rows_;
    std::vector<Rectangle> rectangles_;
    std::array<std::vector<Sample>, 3> samples_;
};

}  // namespace rays::grader
