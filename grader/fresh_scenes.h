// Random scenes made for one run, so that nothing can be learned by heart.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grader/questions.h"

namespace rays::grader {

struct FreshScene {
    std::string sdl;
    std::vector<std::string> rays;  ///< "OX OY OZ DX DY DZ": some rays that look at what the scene is about
};

inline constexpr int kFreshWidth = 56, kFreshHeight = 42;
inline constexpr int kFreshScenesPerTask = 2;
inline constexpr int kFreshAttempts = 8;
inline constexpr int kProbes = 8, kProbeScenes = 4;  ///< rays of a scene and scenes of a task for fingerprints

/// A small scene about one task ("1.3": spheres), with as little else as possible. Nothing for a task without fresh
/// scenes. The same seed gives the same text.
std::optional<FreshScene> fresh_scene(const std::string& task, std::uint64_t seed);

/// Are the pictures of this task's fresh scenes noisy? Then they are held against the mean of many by the solution.
bool has_noisy_fresh_scenes(const std::string& task);

/// Of the scene in its place, 0 to kFreshScenesPerTask - 1. Now and then a plane fills the view (7 % of the scenes of
/// 1.1 and 1.2): where the solution's picture has one colour only, which tests nothing, the grader takes the next
/// attempt.
constexpr std::uint64_t seed_of_fresh_scene(std::uint64_t seed, int place, int attempt) {
    return seed + static_cast<std::uint64_t>(place + attempt * kFreshScenesPerTask);
}

/// Rays through fresh scenes of the given tasks, as questions without a judge: for fingerprints.
std::vector<Question> probe_questions(const std::vector<std::string>& tasks, std::uint64_t seed);

}  // namespace rays::grader
