#include "grader/submission/demonstrate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "grader/compare.h"
#include "grader/explain_picture.h"
#include "grader/ray_trees.h"
#include "grader/submission/looks.h"
#include "grader/submission/safe_path.h"
#include "grader/text.h"
#include "support/files.h"

namespace rays::grader {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestScene = 4u << 20;
constexpr const char* kCourseScenes = "scenes/";

std::string file_stem(const std::string& file) {
    std::string stem = fs::path(file).replace_extension().string();
    std::replace_if(
        stem.begin(), stem.end(), [](unsigned char c) { return !std::isalnum(c) && c != '_' && c != '-'; }, '.');
    return stem;
}

std::string kept(const HandInBench& bench, const std::string& name, const std::string& exr) {
    if (bench.out.empty() || exr.empty()) return {};
    write_atomically(bench.out / "images" / (name + ".exr"), exr);
    return "images/" + name + ".exr";
}

/// How far the student's picture is from the solution's.
struct Distance {
    int beyond = 0;
    double max_error = 0, worst = -1, square = 0;
    std::size_t worst_at = 0;

    bool agrees(std::size_t pixels) const {
        // As for fresh scenes: two equally good roundings may part on a few pixels of edges.
        return beyond <= std::max(3, static_cast<int>(double(pixels) * kSilhouetteShare));
    }
};

Distance distance(const RgbImage& student, const RgbImage& solution) {
    Distance d;
    for (std::size_t i = 0; i < solution.pixels.size(); ++i) {
        d.beyond += !within(student.pixels[i], solution.pixels[i], kFreshTolerance);
        double error = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            const double e = std::abs(double(student.pixels[i][c]) - solution.pixels[i][c]);
            error = e <= error ? error : e;  // NaN comes through
        }
        if (!(error <= d.worst)) d.worst = std::isfinite(error) ? error : d.worst, d.worst_at = i;
        if (!std::isfinite(error)) continue;
        d.max_error = std::max(d.max_error, error);
        d.square += error * error / double(solution.pixels.size());
    }
    return d;
}

void fill(ImageResult& image, const Distance& d, const RgbImage& student, const RgbImage& solution) {
    image.width = solution.raster.width;
    image.height = solution.raster.height;
    image.pixels = static_cast<int>(solution.pixels.size());
    image.beyond_rounding = d.beyond;
    image.max_error = d.max_error;
    image.rmse = std::sqrt(d.square);
    image.tolerance = kFreshTolerance.relative + kFreshTolerance.absolute;
    image.tolerance_absolute = kFreshTolerance.absolute;
    image.worst_x = static_cast<int>(d.worst_at) % image.width;
    image.worst_y = static_cast<int>(d.worst_at) / image.width;
    image.worst_student = student.pixels[d.worst_at];
    image.worst_reference = solution.pixels[d.worst_at];
}

/// One picture on its way to a verdict. Each step returns false when there is no use in going on.
class Demonstrator {
public:
    Demonstrator(const HandInBench& bench, Demonstration& result) : bench_(bench), result_(result) {}

    void run() {
        if (read() && render() && reproduce() && agree()) prove();
        conclude();
    }

private:
    bool stop(Verdict verdict, const std::string& message) {
        result_.check.verdict = verdict;
        result_.check.message = message;
        return false;
    }

    bool read() {
        const SubmittedPicture& p = result_.picture;
        const OutputFile file = read_inside(bench_.folder, p.file, kLargestPicture);
        if (!file.taken) return stop(Verdict::fail, fmt::format("{} {}", plain(p.file), file.problem));
        bytes_ = file.bytes;
        try {
            files_ = submitted_scene(bench_, p.scene);
        } catch (const InputError& e) {
            return stop(Verdict::fail, plain(e.what(), 400));
        }
        return true;
    }

    bool render() {
        if (bench_.student.empty())
            return stop(Verdict::build_error, "your steps do not build, so nothing can be rendered again");
        student_ = shoot(bench_.sandbox, bench_.student, files_, result_.picture.raster, bench_.limits);
        result_.check.seconds += student_.seconds;
        if (student_.against)
            return stop(student_.against->verdict, "your program, given this scene: " + student_.against->message);
        result_.check.image->student = kept(bench_, result_.check.id, student_.exr);
        return true;
    }

    bool reproduce() {
        const Likeness like = likeness(result_.picture.file, bytes_, student_.picture);
        result_.reproduced = like.same();
        if (result_.reproduced) return true;
        if (!like.problem.empty())
            return stop(Verdict::fail, fmt::format("{} {}", plain(result_.picture.file), like.problem));
        return stop(Verdict::fail,
                    fmt::format("not reproduced: {} of {} pixels of {} differ from what your program renders "
                                "at {} x {}; render it anew with ./rays submission",
                                like.differing, like.pixels, plain(result_.picture.file), result_.picture.raster.width,
                                result_.picture.raster.height));
    }

    bool agree() {
        solution_ = shoot(bench_.sandbox, bench_.solution, files_, result_.picture.raster, bench_.limits);
        if (solution_.against)
            return stop(Verdict::fail, "the solution cannot render this scene, so nothing can be shown by it: " +
                                           solution_.against->message);
        result_.check.image->reference = result_.check.image->solution =
            kept(bench_, result_.check.id + ".solution", solution_.exr);
        const Distance d = distance(student_.picture, solution_.picture);
        fill(*result_.check.image, d, student_.picture, solution_.picture);
        result_.counts = d.agrees(solution_.picture.pixels.size());
        if (result_.counts) return true;
        explain();
        std::string waits;
        for (const UnfinishedPlace& place : student_.unfinished)
            waits += (waits.empty() ? "; it waits for task " : ", ") + place.task;
        return stop(student_.unfinished.empty() ? Verdict::fail : Verdict::not_started,
                    fmt::format("reproduced, but {} of {} pixels differ from the solution's picture{}", d.beyond,
                                solution_.picture.pixels.size(), waits));
    }

    void explain() {
        const ImageResult& image = *result_.check.image;
        Reference truth{solution_.picture, solution_.picture, solution_.picture};
        if (const auto text = explain_picture(student_.picture, truth, kFreshTolerance))
            result_.check.diagnosis.push_back({"picture", *text, {}});
        const auto tree = [&](const fs::path& program) {
            return ray_tree(bench_.sandbox, program, files_, result_.picture.raster, image.worst_x, image.worst_y, true,
                            bench_.limits);
        };
        const std::string first = first_difference(tree(bench_.student), tree(bench_.solution));
        if (!first.empty())
            result_.check.diagnosis.push_back(
                {"tree", fmt::format("pixel ({}, {}), {}", image.worst_x, image.worst_y, first), {}});
    }

    void prove() {
        FeatureProver prover(bench_.sandbox, bench_.solution, files_, result_.picture.raster, bench_.limits,
                             solution_.picture);
        for (const std::string& feature : result_.picture.shows) result_.proofs.push_back(prover.prove(feature));
    }

    void conclude() {
        Check& check = result_.check;
        std::string shown, not_shown;
        for (const Proof& p : result_.proofs) {
            (p.shown ? shown : not_shown) += (p.shown ? shown : not_shown).empty() ? p.feature : ", " + p.feature;
            check.questions.push_back({"shows " + p.feature, p.how, "", p.expected, p.found, p.shown});
        }
        if (!result_.counts) return;
        check.verdict = not_shown.empty() && !shown.empty() ? Verdict::pass : Verdict::partial;
        check.message = "reproduced, and as the solution's; ";
        check.message += shown.empty() && not_shown.empty() ? "but submission.json claims nothing for it"
                         : not_shown.empty()                ? "shows " + shown
                                                            : fmt::format("{}does not show {}",
                                                           shown.empty() ? "" : "shows " + shown + ", but ", not_shown);
    }

    const HandInBench& bench_;
    Demonstration& result_;
    std::string bytes_;
    SceneFiles files_;
    Shot student_, solution_;
};

}  // namespace

SceneFiles submitted_scene(const HandInBench& bench, const std::string& scene) {
    if (const std::string why = path_problem(scene); !why.empty())
        throw InputError(fmt::format("the scene \"{}\" {}", scene, why));
    const fs::path course = bench.project.root / scene;
    if (scene.starts_with(kCourseScenes) && fs::is_regular_file(course)) return scene_files(course);
    const OutputFile file = read_inside(bench.folder, scene, kLargestScene);
    if (!file.taken)
        throw InputError(fmt::format("the scene {} {}: name one of the course (scenes/...) or hand yours in, too",
                                     scene, file.problem));
    return scene_files(bench.folder / scene);
}

Demonstration demonstrate(const HandInBench& bench, const SubmittedPicture& picture, std::size_t number) {
    Demonstration result;
    result.picture = picture;
    result.check.id = fmt::format("handed_in.{}.{}", number, file_stem(picture.file));
    result.check.kind = "demonstration";
    result.check.mode = "all mine";
    result.check.title = plain(picture.file);
    result.check.reproduce =
        fmt::format("./rays render {} -o {} --from student --width {} --height {}", plain(picture.scene),
                    plain(picture.file), picture.raster.width, picture.raster.height);
    ImageResult& image = result.check.image.emplace();
    image.scene = plain(picture.scene);
    image.width = picture.raster.width;
    image.height = picture.raster.height;
    Demonstrator(bench, result).run();
    return result;
}

}  // namespace rays::grader
