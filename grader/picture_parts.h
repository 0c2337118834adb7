// What checks of pictures share: the scene with its reference, what is kept of pictures, and words.
#pragma once

#include <string>

#include "grader/checks.h"
#include "grader/shoot.h"

namespace rays::grader {

/// "1_ray_casting/one_sphere.pov" -> "one_sphere"
std::string stem(const std::string& scene);

/// A check of this scene's picture, which has found nothing yet. `mode` is "isolated" or "all mine", which earns
/// nothing.
Check new_picture_check(const Bench& bench, const SceneTask& scene, const std::string& kind, const std::string& mode);

struct ReferenceFiles {
    SceneFiles scene;
    std::filesystem::path reference;  ///< the file
};

/// Throws InputError when scene and reference do not belong together, or when the reference is a mean of frames and one
/// frame is wanted, or the other way round: nobody's mistake but the course's.
ReferenceFiles reference_files(const Bench& bench, const std::string& scene, bool averaged);

/// Writes the EXR's bytes where the report finds them, if anything is kept: the path for results.json, or nothing.
std::string kept_picture(const Bench& bench, const std::string& name, const std::string& exr);
std::string kept_picture(const Bench& bench, const std::string& name, const RgbImage& picture);

/// "1.3 (ray_casting.cpp:40), ..."
std::string unfinished_text(const std::vector<UnfinishedPlace>& places);

/// Further arguments for a render program that is to use this structure.
std::vector<std::string> options_of(const std::string& partition);

}  // namespace rays::grader
