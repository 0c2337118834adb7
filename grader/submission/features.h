// What a picture may be said to show, and how the solution's program proves it.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "grader/shoot.h"

namespace rays::grader {

/// One claim about one picture, judged. Texts are for the student.
struct Proof {
    std::string feature;
    bool shown = false;
    std::string how;       ///< what was done: "rendered with --without reflection"
    std::string expected;  ///< "at least 0.2 % of the pixels change visibly"
    std::string found;     ///< "31.2 %"
};

/// The feature of seeing the third reflection and deeper ones.
inline constexpr const char* kRecursiveReflection = "recursive_reflection";

/// Proves features of one scene with the solution's program:
/// - an effect, by the names of `render-X --needs`: without it the picture changes visibly (looks.h);
/// - a kind of shapes, by the names of `render-X --seen` ("polygons" are triangles and meshes, too): enough pixels see
///   one of them first;
/// - recursive_reflection: with only three levels of rays (the camera's and two reflections) the picture changes
///   visibly. Clear things are made opaque for that, so that refraction cannot pass for it.
class FeatureProver {
public:
    FeatureProver(const Sandbox& sandbox, std::filesystem::path solution, const SceneFiles& files, Raster raster,
                  const Limits& limits, const RgbImage& whole);

    Proof prove(const std::string& feature);

private:
    Proof prove_effect(const std::string& feature);
    Proof prove_shape(const std::string& feature);
    Proof prove_depth();
    Proof changes(Proof proof, const RgbImage& before, const std::vector<std::string>& options);
    Shot shoot_with(const std::vector<std::string>& options) const;
    void ask_effects();
    void ask_shapes();

    const Sandbox& sandbox_;
    std::filesystem::path solution_;
    const SceneFiles& files_;
    Raster raster_;
    Limits limits_;
    const RgbImage& whole_;
    std::map<std::string, bool> effects_;   ///< name -> does the scene need it
    std::map<std::string, double> shapes_;  ///< name -> share of the pixels that see it first
};

}  // namespace rays::grader
