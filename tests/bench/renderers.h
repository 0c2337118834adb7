// Raysteps and POV-Ray as commands that make the same picture: one thread, start and writing of an EXR file included.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/camera.h"
#include "references/picture_error.h"
#include "references/reference.h"
#include "support/process.h"

namespace rays::bench {

struct Picture {
    std::filesystem::path scene;  ///< an absolute path
    Raster raster;
};

/// A trusted program and its arguments in a working folder; stopped only when it takes more than twenty minutes.
Command trusted(std::vector<std::string> argv, const std::filesystem::path& folder);

/// `program`: a render program. Writes folder/output.
Command raysteps_command(const std::filesystem::path& program, const Picture& picture,
                         const std::filesystem::path& folder, const std::string& output,
                         const std::vector<std::string>& more = {});

/// One sample a pixel unless `more` says otherwise. Writes folder/output, half floats.
/// Throws std::runtime_error when POV-Ray is not installed.
Command povray_command(const Picture& picture, const std::filesystem::path& folder, const std::string& output,
                       const std::vector<std::string>& more = {});

/// Writes folder/name.pov: the scene with other global settings at its end, which count for both renderers. The scene
/// must not include files of its own folder.
std::filesystem::path with_settings(const std::filesystem::path& scene, const std::string& global_settings,
                                    const std::filesystem::path& folder, const std::string& name);

/// The number of rays, shadow rays left out, in the statistics (+GS) that POV-Ray has written. Throws
/// std::runtime_error when there is none.
double povray_rays(const std::string& statistics);

/// The mean over blocks of side x side pixels. Throws std::invalid_argument when they do not fit.
RgbImage averaged(const RgbImage& fine, int side);

}  // namespace rays::bench
