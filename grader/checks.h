// The checks of one step. Each runs the student's program in the sandbox and judges what comes out of it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "grader/project.h"
#include "grader/questions.h"
#include "grader/results.h"
#include "grader/sandbox.h"
#include "grader/step_data.h"

namespace rays::grader {

/// What all checks of a step share.
struct Bench {
    const Project& project;
    const Sandbox& sandbox;
    const Step& step;
    std::filesystem::path solution;  ///< the render program of the solutions
    std::filesystem::path student;   ///< this step the student's, all others the solution's
    std::filesystem::path out;       ///< folder of results.json; empty: no pictures are kept
    std::uint64_t seed = 1;
    Limits limits;
    bool explain = true;  ///< ray trees and picture-level explanations of failures
};

/// 0 at half of the answers right, the full points at all of them right, a straight line between. An always equal
/// answer ("miss") is right about half of the time: it earns nothing.
double points_for(double share_right, double max);

Check unit_check(const Bench& bench, const Task& task, const std::vector<Question>& questions, double max);

/// `naive` are committed measurements of the naive method for this sweep, if there are any.
Check sweep_check(const Bench& bench, const Sweep& sweep, const std::vector<ChartSeries>& naive, double max);

Check image_check(const Bench& bench, const SceneTask& scene);

/// The same scene with all steps the student's: no points, but where yours do not work together it shows.
Check all_mine_check(const Bench& bench, const SceneTask& scene, const std::filesystem::path& all_mine);

/// A noisy scene: its mean over seeds against an averaged reference, its noise against the solution's.
Check statistical_check(const Bench& bench, const SceneTask& scene);
/// The same with all steps the student's, without the noise.
Check statistical_all_mine_check(const Bench& bench, const SceneTask& scene, const std::filesystem::path& all_mine);

/// Fresh scenes of a task, the student's pictures against the solution's.
Check fresh_check(const Bench& bench, const Task& task, double max);
bool has_fresh_scenes(const std::string& task);

}  // namespace rays::grader
