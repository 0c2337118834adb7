#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "grader/checks.h"
#include "grader/compare.h"
#include "grader/explain_picture.h"
#include "grader/fresh_pictures.h"
#include "grader/picture_parts.h"
#include "grader/ray_trees.h"
#include "grader/text.h"

namespace rays::grader {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kShownTree = 6000;

void fill(ImageResult& image, const Comparison& c, const Reference& truth, const RgbImage& picture,
          const Tolerance& tolerance) {
    image.width = truth.raster().width;
    image.height = truth.raster().height;
    image.pixels = c.pixels;
    image.beyond_rounding = c.beyond;
    image.on_silhouettes = c.on_silhouettes;
    image.max_error = c.max_error;
    image.rmse = c.rmse;
    image.tolerance = tolerance.relative + tolerance.absolute;
    image.tolerance_absolute = tolerance.absolute;
    image.worst_x = c.worst_x;
    image.worst_y = c.worst_y;
    image.worst_student = picture.at(c.worst_x, c.worst_y);
    image.worst_reference = truth.frame.at(c.worst_x, c.worst_y);
}

/// One picture held against the truth, with everything that explains it.
struct Viewing {
    const Bench& bench;
    const fs::path& program;
    const SceneFiles& files;
    const Reference& truth;
    Tolerance tolerance;
    int least_allowed = 0;
};

void explain(const Viewing& v, const RgbImage& picture, Check& check) {
    if (const auto text = explain_picture(picture, v.truth, v.tolerance))
        check.diagnosis.push_back({"picture", *text, {}});
    ImageResult& image = *check.image;
    const auto tree = [&](const fs::path& program, bool json) {
        return ray_tree(v.bench.sandbox, program, v.files, v.truth.raster(), image.worst_x, image.worst_y, json,
                        v.bench.limits, options_of(image.partition));
    };
    RayTrees trees{plain_lines(tree(v.program, false), kShownTree),
                   plain_lines(tree(v.bench.solution, false), kShownTree),
                   first_difference(tree(v.program, true), tree(v.bench.solution, true))};
    if (!trees.first_difference.empty())
        check.diagnosis.push_back(
            {"tree", fmt::format("pixel ({}, {}), {}", image.worst_x, image.worst_y, trees.first_difference), {}});
    image.trees = std::move(trees);
}

// Sets verdict, message, points, and the image's numbers.
void judge(const Viewing& v, const Shot& shot, Check& check) {
    check.seconds += shot.seconds;
    if (shot.against) {
        check.verdict = shot.against->verdict;
        check.message = shot.against->message;
        return;
    }
    const Comparison c = compare(shot.picture, v.truth, v.tolerance, v.least_allowed);
    fill(*check.image, c, v.truth, shot.picture, v.tolerance);
    if (c.passed) {
        check.verdict = Verdict::pass;
        check.points = check.max;
        check.message = fmt::format("{} within the rounding of the reference; largest difference {:.2g}",
                                    c.on_silhouettes == 0 ? "every pixel"
                                                          : fmt::format("every pixel but {} of {}, on silhouettes,",
                                                                        c.on_silhouettes, c.pixels),
                                    c.max_error);
    } else if (!shot.unfinished.empty()) {
        check.verdict = Verdict::not_started;
        check.message = "the picture waits for task " + unfinished_text(shot.unfinished);
    } else {
        check.verdict = Verdict::fail;
        check.message = c.problem;
        if (v.bench.explain && v.program != v.bench.solution) explain(v, shot.picture, check);
    }
}

Check picture_check(const Bench& bench, const SceneTask& scene, const fs::path& program, const std::string& mode) {
    Check check = new_picture_check(bench, scene, "image", mode);
    try {
        const ReferenceFiles files = reference_files(bench, scene.scene, false);
        const Reference truth = load_reference(files.reference);
        const Shot shot =
            shoot(bench.sandbox, program, files.scene, truth.raster(), bench.limits, options_of(scene.partition));
        check.image->student = kept_picture(bench, check.id, shot.exr);
        if (!bench.out.empty()) check.image->reference = fs::relative(files.reference, bench.out).string();
        check.image->width = truth.raster().width;
        check.image->height = truth.raster().height;
        judge({bench, program, files.scene, truth, kReferenceTolerance}, shot, check);
    } catch (const InputError& e) {
        check.verdict = Verdict::infrastructure_error;
        check.message = e.what();
    }
    return check;
}

}  // namespace

Check image_check(const Bench& bench, const SceneTask& scene) {
    return picture_check(bench, scene, bench.student, "isolated");
}

Check all_mine_check(const Bench& bench, const SceneTask& scene, const fs::path& all_mine) {
    return picture_check(bench, scene, all_mine, "all mine");
}

Check exact_fresh_picture(const Bench& bench, const Task& task, const FreshPick& pick, int place) {
    // Small pictures: 0.05 % is about one pixel, and two equally good roundings may part on more than one edge pixel.
    constexpr int kLeastAllowed = 3;
    Check check =
        new_check(fmt::format("{}.fresh.{}", task.id, place + 1), task.id, "fresh", task.title + ": fresh scenes", 1);
    check.image.emplace().scene = pick.name;
    check.image->partition = task.partition;
    // What lies around each pixel of the solution's frame.
    const Shot around = pick.frame.against ? pick.frame
                                           : shoot(bench.sandbox, bench.solution, pick.files,
                                                   {4 * kFreshWidth, 4 * kFreshHeight}, bench.limits);
    if (around.against) {
        check.verdict = Verdict::infrastructure_error;
        check.message = "the solution cannot render a fresh scene: " + around.against->message;
        return check;
    }
    const Reference truth = make_reference(pick.frame.picture, around.picture);
    const Shot shot = shoot(bench.sandbox, bench.student, pick.files, {kFreshWidth, kFreshHeight}, bench.limits,
                            options_of(task.partition));
    judge({bench, bench.student, pick.files, truth, kFreshTolerance, kLeastAllowed}, shot, check);
    if (check.verdict == Verdict::pass) return check;
    check.image->student = kept_picture(bench, check.id, shot.exr);
    check.image->reference = check.image->solution = kept_picture(bench, check.id + ".solution", pick.frame.exr);
    return check;
}

}  // namespace rays::grader
