// A picture taken with a render program in the sandbox: only scene text goes in, one EXR and statistics come out.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grader/picture.h"
#include "grader/sandbox.h"
#include "grader/verdicts.h"

namespace rays::grader {

/// A scene as files: the first one is the scene, others are what it includes from its own folder.
using SceneFiles = std::vector<InputFile>;

/// Reads the scene and its includes. What POV-Ray's own folder provides stays there. Throws InputError.
SceneFiles scene_files(const std::filesystem::path& scene);

/// A run of a render program on these files; the caller adds arguments and outputs.
Job render_job(const std::filesystem::path& program, const SceneFiles& files, Raster raster, const Limits& limits);

struct Shot {
    std::optional<Finding> against;  ///< why there is no picture
    RgbImage picture;
    std::string exr;  ///< the file as it came
    std::vector<UnfinishedPlace> unfinished;
    double seconds = 0;
};

/// `options` are further arguments: "--without", "reflection".
Shot shoot(const Sandbox& sandbox, const std::filesystem::path& program, const SceneFiles& files, Raster raster,
           const Limits& limits, const std::vector<std::string>& options = {});

/// The ray tree of a pixel, as text or as JSON; empty when the program does not give one.
std::string ray_tree(const Sandbox& sandbox, const std::filesystem::path& program, const SceneFiles& files,
                     Raster raster, int x, int y, bool json, const Limits& limits,
                     const std::vector<std::string>& options = {});

}  // namespace rays::grader
