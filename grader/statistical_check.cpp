#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "grader/checks.h"
#include "grader/fresh_pictures.h"
#include "grader/picture_parts.h"
#include "grader/statistical_words.h"
#include "references/averaged.h"

namespace rays::grader {
namespace {

namespace fs = std::filesystem;

constexpr double kBiasShare = 0.7;  ///< of the points; the others are for the noise
constexpr int kFewestOfSolution = 4;

/// Whose pictures, and which of their batches: no seed is used twice.
enum class Series { student, student_again, student_for_noise, solution, solution_again };

// SplitMix64 of all that a seed depends on; 31 bits, for programs that read an int.
std::uint64_t seed_of(std::uint64_t of_run, const std::string& scene, Series series, int number) {
    std::uint64_t z = of_run;
    const auto mix = [&](std::uint64_t v) {
        z += v + 0x9e3779b97f4a7c15u;
        z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
        z = (z ^ z >> 27) * 0x94d049bb133111ebu;
        z ^= z >> 31;
    };
    for (const char c : scene) mix(static_cast<unsigned char>(c));
    mix(static_cast<std::uint64_t>(series));
    // An odd step visits all 31-bit numbers: seeds of a series never repeat.
    return (z + 2654435761u * static_cast<std::uint64_t>(number)) & 0x7fffffffu;
}

/// Takes the pictures of one check and remembers what went wrong.
class Photographer {
public:
    Photographer(const Bench& bench, const SceneTask& scene, const SceneFiles& files, Raster raster)
        : bench_(bench), scene_(scene), files_(files), raster_(raster) {}

    /// Nothing when a run failed, or when the student has not finished: see against() and unfinished().
    Pictures take(const fs::path& program, Series series, int seeds) {
        Pictures pictures;
        for (int i = 0; i < seeds; ++i) {
            const std::uint64_t seed = seed_of(bench_.seed, scene_.scene, series, i);
            std::vector<std::string> options = options_of(scene_.partition);
            for (const std::string& o : {std::string("--pattern"), std::string("sobol"), std::string("--samples"),
                                         std::to_string(scene_.samples), std::string("--seed"), std::to_string(seed)})
                options.push_back(o);
            Shot shot = shoot(bench_.sandbox, program, files_, raster_, bench_.limits, options);
            seconds_ += shot.seconds;
            unfinished_ = shot.unfinished;
            if (shot.against) {
                against_ =
                    Finding{shot.against->verdict, fmt::format("with --seed {}: {}", seed, shot.against->message)};
                return {};
            }
            if (!unfinished_.empty()) return {};
            pictures.push_back(std::move(shot.picture));
        }
        return pictures;
    }

    const std::optional<Finding>& against() const { return against_; }
    const std::vector<UnfinishedPlace>& unfinished() const { return unfinished_; }
    double seconds() const { return seconds_; }

private:
    const Bench& bench_;
    const SceneTask& scene_;
    const SceneFiles& files_;
    Raster raster_;
    std::optional<Finding> against_;
    std::vector<UnfinishedPlace> unfinished_;
    double seconds_ = 0;
};

struct Sitting {
    const Bench& bench;
    const SceneTask& scene;
    const fs::path& program;
    const AveragedReference& truth;
    VerdictOptions options;
    Photographer& student;
    Photographer& solution;
};

void fill(StatisticsResult& s, const Examination& e, const VerdictOptions& options) {
    s.not_finite = e.not_finite;
    s.tiles = static_cast<int>(e.tiles.size());
    s.tiles_wrong = e.tiles_wrong;
    s.alarm_rate = options.alarm_rate();
    s.tile_margin = options.tile_margin;
    s.whole_margin = options.whole_margin;
    s.noise_full = options.noise_full;
    s.noise_none = options.noise_none;
    if (e.not_finite > 0) return;
    const auto of = [](const Difference& d, std::size_t channel) {
        return ChannelDifference{channel_name(channel), d.value, d.reference, d.margin,
                                 d.standard_error,      d.z,     d.limit,     d.wrong};
    };
    for (std::size_t c = 0; c < 3; ++c) s.whole.push_back(of(e.whole[c], c));
    const Tile& worst = e.tiles[static_cast<std::size_t>(e.worst_tile)];
    s.worst =
        WorstTile{worst.x, worst.y, worst.width, worst.height, of(worst.channels[e.worst_channel], e.worst_channel)};
    s.variance = e.mean_variance;
}

// Numbers of the mean picture that every picture has; the page shows those of the statistics.
void fill(ImageResult& image, const RgbImage& mean, const AveragedReference& truth,
          const std::optional<WorstTile>& worst) {
    image.pixels = static_cast<int>(truth.mean.pixels.size());
    double squares = 0;
    int counted = 0;
    for (std::size_t i = 0; i < mean.pixels.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            const double difference = std::abs(double(mean.pixels[i][c]) - double(truth.mean.pixels[i][c]));
            if (!std::isfinite(difference)) continue;
            image.max_error = std::max(image.max_error, difference);
            squares += difference * difference;
            ++counted;
        }
    }
    image.tolerance = VerdictOptions{}.tile_margin;  // of a mean, not of a pixel: the page has a map of z
    image.rmse = counted > 0 ? std::sqrt(squares / counted) : 0;
    if (worst) image.worst_x = worst->x + worst->width / 2, image.worst_y = worst->y + worst->height / 2;
    image.worst_student = mean.at(image.worst_x, image.worst_y);
    image.worst_reference = truth.mean.at(image.worst_x, image.worst_y);
}

// The solution's noise at as many samples; too much of it must be found twice.
std::optional<NoiseVerdict> noise_of(const Sitting& s, const BiasVerdict& bias) {
    const bool equal = all_equal(bias.pictures);
    const auto compared = [&](const Examination& student, Series series, int seeds) -> std::optional<NoiseVerdict> {
        const Pictures pictures = s.solution.take(s.bench.solution, series, seeds);
        if (pictures.empty()) return {};
        return judge_noise(student, equal, examine(pictures, s.truth, {}), s.options);
    };
    const auto first = compared(bias.examination, Series::solution, std::max(kFewestOfSolution, s.scene.seeds / 2));
    if (!first || first->share == 1) return first;
    const Pictures more = s.student.take(s.program, Series::student_for_noise, 2 * s.scene.seeds);
    if (more.empty()) return {};
    const auto second = compared(examine(more, s.truth, {}), Series::solution_again, s.scene.seeds);
    return second ? std::optional(kinder(*first, *second)) : second;
}

void judge_noise_of(const Sitting& s, const BiasVerdict& bias, Check& check) {
    const auto noise = noise_of(s, bias);
    if (!noise) {
        const bool ours = s.solution.against().has_value();
        check.verdict = ours                  ? Verdict::infrastructure_error
                        : s.student.against() ? s.student.against()->verdict
                                              : Verdict::fail;
        check.message = ours ? "the solution cannot render this scene: " + s.solution.against()->message
                        : s.student.against()
                            ? s.student.against()->message
                            : "a further picture waits for " + unfinished_text(s.student.unfinished());
        check.points = 0;
        return;
    }
    check.statistics->variance = noise->student;
    check.statistics->solution_variance = noise->solution;
    check.statistics->noise_ratio = noise->ratio;
    const std::string words = noise_text(*noise, s.options);
    check.message += (noise->share == 1 ? "; " : ", but ") + words;
    if (noise->share < 1) check.diagnosis.push_back({"picture", words, {}});
    if (noise->unresolved) {
        check.verdict = Verdict::fail;
        check.points = 0;
        return;
    }
    check.verdict = noise->share == 1 ? Verdict::pass : Verdict::partial;
    check.points = check.max * (kBiasShare + (1 - kBiasShare) * noise->share);
}

void judge(const Sitting& s, Check& check) {
    Pictures first = s.student.take(s.program, Series::student, s.scene.seeds);
    const auto stopped = [&] {
        if (s.student.against())
            check.verdict = s.student.against()->verdict, check.message = s.student.against()->message;
        else
            check.verdict = Verdict::not_started,
            check.message = "the picture waits for task " + unfinished_text(s.student.unfinished());
    };
    if (first.empty()) return stopped();
    const BiasVerdict bias = judge_bias(std::move(first), s.truth, s.options, [&](int seeds) {
        return s.student.take(s.program, Series::student_again, seeds);
    });
    StatisticsResult& statistics = check.statistics.emplace();
    statistics.samples = s.scene.samples;
    statistics.seeds = bias.examination.seeds;
    statistics.batches = bias.batches;
    fill(statistics, bias.examination, s.options);
    const RgbImage mean = mean_of(bias.pictures);
    fill(*check.image, mean, s.truth, statistics.worst);
    // A fresh scene's pictures are shown where they are wrong only.
    const bool keep = check.kind == "statistical" || !bias.passed;
    if (keep) check.image->student = kept_picture(s.bench, check.id, mean);
    if (keep && bias.examination.not_finite == 0)
        statistics.z_picture = kept_picture(s.bench, check.id + ".z", z_picture(bias.examination, mean.raster));
    if (bias.cut_short) return stopped();
    check.message = bias_text(bias, mean.raster);
    if (!bias.passed) {
        check.verdict = Verdict::fail;
        if (all_equal(bias.pictures))
            check.diagnosis.push_back(
                {"picture", "pictures of different seeds are equal: --seed must decide all random numbers", {}});
        if (bias.examination.not_finite == 0 && s.bench.explain)
            if (const auto text = explain_bias(bias.pictures, s.truth, s.options))
                check.diagnosis.push_back({"picture", *text, {}});
        return;
    }
    check.verdict = Verdict::pass;
    check.points = check.max;
    if (check.mode == "isolated" && check.kind == "statistical") judge_noise_of(s, bias, check);
}

Check checked(const Bench& bench, const SceneTask& scene, const fs::path& program, const std::string& mode) {
    Check check = new_picture_check(bench, scene, "statistical", mode);
    try {
        const ReferenceFiles files = reference_files(bench, scene.scene, true);
        const AveragedReference truth = load_averaged_reference(files.reference);
        if (!bench.out.empty()) check.image->reference = fs::relative(files.reference, bench.out).string();
        check.image->width = truth.mean.raster.width;
        check.image->height = truth.mean.raster.height;
        Photographer student(bench, scene, files.scene, truth.mean.raster),
            solution(bench, scene, files.scene, truth.mean.raster);
        VerdictOptions options;
        options.noise_full = scene.noise_full;
        options.noise_none = scene.noise_none;
        judge({bench, scene, program, truth, options, student, solution}, check);
        check.seconds = student.seconds();
    } catch (const InputError& e) {
        check.verdict = Verdict::infrastructure_error;
        check.message = e.what();
    }
    return check;
}

// The mean of the solution's pictures, good to what the spread of its seeds says.
AveragedReference truth_by_solution(const Pictures& pictures) {
    AveragedReference truth{mean_of(pictures), mean_of(pictures)};
    const double n = double(pictures.size());
    for (std::size_t i = 0; i < truth.mean.pixels.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            double squares = 0;
            for (const RgbImage& picture : pictures)
                squares += std::pow(double(picture.pixels[i][c]) - double(truth.mean.pixels[i][c]), 2);
            truth.error.pixels[i][c] = static_cast<float>(std::sqrt(squares / (n * (n - 1))));
        }
    return truth;
}

}  // namespace

Check noisy_fresh_picture(const Bench& bench, const Task& task, const FreshPick& pick, int place) {
    constexpr int kSamples = 16, kSeeds = 8, kSamplesOfTruth = 64;
    const Raster raster{kFreshWidth, kFreshHeight};
    Check check =
        new_check(fmt::format("{}.fresh.{}", task.id, place + 1), task.id, "fresh", task.title + ": fresh scenes", 1);
    check.image.emplace().scene = pick.name;
    SceneTask scene, finer;
    scene.scene = finer.scene = pick.name;
    scene.samples = kSamples, finer.samples = kSamplesOfTruth;
    scene.seeds = finer.seeds = kSeeds;
    Photographer student(bench, scene, pick.files, raster), solution(bench, finer, pick.files, raster);
    const Pictures pictures = solution.take(bench.solution, Series::solution, kSeeds);
    if (pictures.empty()) {
        check.verdict = Verdict::infrastructure_error;
        check.message =
            "the solution cannot render a fresh scene" + (solution.against() ? ": " + solution.against()->message : "");
        return check;
    }
    check.image->width = raster.width;
    check.image->height = raster.height;
    const AveragedReference truth = truth_by_solution(pictures);
    judge({bench, scene, bench.student, truth, VerdictOptions{}, student, solution}, check);
    if (check.verdict != Verdict::pass)
        check.image->reference = check.image->solution = kept_picture(bench, check.id + ".solution", truth.mean);
    check.seconds = student.seconds();
    return check;
}

Check statistical_check(const Bench& bench, const SceneTask& scene) {
    return checked(bench, scene, bench.student, "isolated");
}

Check statistical_all_mine_check(const Bench& bench, const SceneTask& scene, const fs::path& all_mine) {
    return checked(bench, scene, all_mine, "all mine");
}

}  // namespace rays::grader
