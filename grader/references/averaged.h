// An averaged reference: the mean of many frames, and how far each of its numbers may be from the truth.
#pragma once

#include <filesystem>
#include <vector>

#include "references/frame_numbers.h"
#include "references/reference.h"

namespace rays {

struct AveragedReference {
    RgbImage mean;
    RgbImage error;  ///< of each pixel and channel: the standard error of the mean, from the spread of the replicates.
                     ///< Not in it: that frames are half floats (half_rounding(mean) at most).

    const Raster& raster() const { return mean.raster; }
};

/// The root of the mean squared standard error, over all pixels and channels.
double rms_error(const AveragedReference& reference);

/// One OpenEXR file of 32-bit floats with the channels R G B error.R error.G error.B.
void save_averaged_reference(const AveragedReference& reference, const std::filesystem::path& file);

/// Throws InputError when the file is missing, is no averaged reference, is larger than 4096 pixels in one direction,
/// or holds what is no mean: a number that is not finite, or an error below 0.
AveragedReference load_averaged_reference(const std::filesystem::path& file);

/// The sums of frames: sums of half floats are exact in double, so the order of the frames does not matter.
class FrameSums {
public:
    explicit FrameSums(Raster raster);

    /// Throws std::invalid_argument for another size, or when a number is not finite.
    void add(int replicate, const RgbImage& frame);

    /// The mean of one replicate's frames, in double, pixel by pixel and R G B within.
    std::vector<double> replicate_mean(int replicate) const;

    /// Every replicate must have frames.
    AveragedReference result() const;

private:
    Raster raster_;
    std::array<std::vector<double>, kReplicates> sums_;
    std::array<int, kReplicates> counts_{};
};

/// No number of an unchanged replicate is further from the mean of all: with n = 8 numbers of standard deviation s,
/// none is further from their mean than s (n - 1) / sqrt(n) (Samuelson, "How deviant can you be?", 1968), and the
/// standard error is s / sqrt(n). So there are no false alarms.
inline constexpr double kFurthestReplicate = kReplicates - 1;

/// What shows that the replicate is not one of the reference's, in words, or an empty text.
std::string difference_of_replicate(const AveragedReference& reference, const std::vector<double>& replicate);

}  // namespace rays
