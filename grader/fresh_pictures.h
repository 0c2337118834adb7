// Pictures of fresh scenes: which scene, and how one of them is judged.
#pragma once

#include <string>

#include "grader/checks.h"
#include "grader/fresh_scenes.h"
#include "grader/shoot.h"

namespace rays::grader {

/// A fresh scene and the solution's frame of it, which says when there is none.
struct FreshPick {
    std::string name, sdl;
    SceneFiles files;
    Shot frame;
};
FreshPick pick_fresh_scene(const Bench& bench, const std::string& task, int place);

/// The student's picture against the solution's: pixel by pixel, or by its mean over seeds. Out of 1 point; an
/// infrastructure error when the solution has no picture.
Check exact_fresh_picture(const Bench& bench, const Task& task, const FreshPick& pick, int place);
Check noisy_fresh_picture(const Bench& bench, const Task& task, const FreshPick& pick, int place);

}  // namespace rays::grader
