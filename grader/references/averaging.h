// Rendering the frames of an averaged reference.
#pragma once

#include <string>

#include "references/averaged.h"
#include "references/povray.h"

namespace rays {

/// How the frames of one scene are rendered.
struct Averaging {
    const Povray* povray = nullptr;
    Raster raster{160, 120};
    int frames = 512;      ///< of the whole mean: a multiple of kReplicates
    int jobs = 8;          ///< processes at once
    double seconds = 120;  ///< a frame's time limit
};

/// The mean of all frames; the same again bit by bit. Throws PovrayError that names the first frame that failed, or
/// whose warnings make it doubtful.
AveragedReference average_of_frames(const Averaging& how, const std::filesystem::path& scene);

/// The mean of the frames of one replicate: an eighth of the work. As FrameSums::replicate_mean.
std::vector<double> average_of_replicate(const Averaging& how, const std::filesystem::path& scene, int replicate);

/// A reference must be beyond doubt: throws PovrayError for warnings. A sheared camera is meant, though, wherever there
/// is one.
void refuse_warnings(const std::filesystem::path& scene, std::vector<std::string> warnings);

}  // namespace rays
