#include <fmt/format.h>

#include <algorithm>

#include "grader/fresh_pictures.h"

namespace rays::grader {
namespace {

bool of_one_colour(const RgbImage& picture) {
    return std::all_of(picture.pixels.begin(), picture.pixels.end(),
                       [&](const Rgb& p) { return p == picture.pixels.front(); });
}

/// What the first scene that is not right has to say stands for all.
void take_over(Check& check, Check&& one, const std::string& sdl, bool noisy) {
    check.verdict = one.verdict;
    check.message = "; " + one.message;
    check.diagnosis = std::move(one.diagnosis);
    check.image = std::move(one.image);
    check.statistics = std::move(one.statistics);
    check.questions.push_back({"the scene", "", sdl,
                               noisy ? "the solution's picture, but for noise" : "the solution's picture",
                               "another picture", false});
}

}  // namespace

FreshPick pick_fresh_scene(const Bench& bench, const std::string& task, int place) {
    FreshPick pick;
    pick.name = fmt::format("fresh scene {} of task {}", place + 1, task);
    for (int attempt = 0; attempt < kFreshAttempts; ++attempt) {
        pick.sdl = fresh_scene(task, seed_of_fresh_scene(bench.seed, place, attempt))->sdl;
        pick.files = {{"fresh.pov", pick.sdl}};
        pick.frame = shoot(bench.sandbox, bench.solution, pick.files, {kFreshWidth, kFreshHeight}, bench.limits);
        if (pick.frame.against || !of_one_colour(pick.frame.picture)) break;
    }
    return pick;
}

bool has_fresh_scenes(const std::string& task) { return fresh_scene(task, 1).has_value(); }

Check fresh_check(const Bench& bench, const Task& task, double max) {
    Check check = new_check(task.id + ".fresh", task.id, "fresh", task.title + ": fresh scenes", max);
    const bool noisy = has_noisy_fresh_scenes(task.id);
    int right = 0;
    for (int place = 0; place < kFreshScenesPerTask; ++place) {
        const FreshPick pick = pick_fresh_scene(bench, task.id, place);
        Check one =
            noisy ? noisy_fresh_picture(bench, task, pick, place) : exact_fresh_picture(bench, task, pick, place);
        if (one.verdict == Verdict::infrastructure_error) {
            check.verdict = one.verdict;
            check.message = one.message;
            return check;
        }
        check.seconds += one.seconds;
        right += one.verdict == Verdict::pass;
        if (one.verdict != Verdict::pass && !check.image) take_over(check, std::move(one), pick.sdl, noisy);
    }
    check.message = fmt::format("{} of {} fresh scenes equal to the solution's{}", right, kFreshScenesPerTask,
                                noisy ? " but for noise" : "") +
                    check.message;
    check.points = max * right / kFreshScenesPerTask;
    if (right == kFreshScenesPerTask)
        check.verdict = Verdict::pass;
    else if (right > 0 && check.verdict == Verdict::fail)
        check.verdict = Verdict::partial;
    return check;
}

}  // namespace rays::grader
