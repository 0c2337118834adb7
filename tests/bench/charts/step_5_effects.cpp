// Pictures that are means: error against time and against samples, for every pattern and for POV-Ray's own methods.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <regex>

#include "charts.h"
#include "references/averaged.h"
#include "references/frame_numbers.h"
#include "references/picture_error.h"
#include "support/files.h"

namespace rays::bench {
namespace {

/// An effect of step 5 and what POV-Ray has for it.
struct Effect {
    std::string id, scene, title;
    std::vector<std::pair<std::string, std::string>> povray_variants =
        {};                        ///< of the scene: settings, and what stands in place of...
    std::string replaced = "";     ///< ...this text, a regular expression
    std::vector<int> grids = {1};  ///< samples along each axis of a pixel, for each variant
    /// Slopes of the error of a picture with the number of samples, as theory has them (NOTES.md of step 5).
    std::string theory = "";
};

const std::vector<Effect>& effects() {
    static const std::vector<Effect> all{
        {"edges",
         "edges",
         "Anti-aliasing",
         {},
         "",
         {1, 2, 3, 4, 6, 8},
         "random -0.5, jittered and Sobol -0.75 along edges"},
        {"area_light",
         "soft_shadow",
         "Soft shadows",
         {{"3 x 3", "3, 3 "},
          {"5 x 5", "5, 5 "},
          {"9 x 9", "9, 9 "},
          {"5 x 5 jitter", "5, 5 jitter "},
          {"9 x 9 adaptive 1", "9, 9 adaptive 1 "},
          {"9 x 9 adaptive 1 jitter", "9, 9 adaptive 1 jitter "},
          {"17 x 17 adaptive 2", "17, 17 adaptive 2 "}},
         "17, 17 ",
         {1, 2, 3},
         "random -0.5, others between -0.625 and -0.75: pixel and light are four dimensions"},
        {"lens",
         "focus_middle",
         "Depth of field",
         {{"blur_samples 8", "blur_samples 8 confidence 0.9 variance 0.01"},
          {"blur_samples 20", "blur_samples 20 confidence 0.9 variance 0.001"},
          {"blur_samples 50", "blur_samples 50 confidence 0.95 variance 0.0005"},
          {"blur_samples 100", "blur_samples 100 confidence 0.99 variance 0.0001"},
          {"blur_samples 200", "blur_samples 200 confidence 0.999 variance 0"},
          {"blur_samples 500", "blur_samples 500 confidence 0.999 variance 0"}},
         "blur_samples 200 confidence 0.999 variance 0",
         {1},
         "random -0.5, others between -0.625 and -0.75: pixel and lens are four dimensions"},
        {"motion",
         "moving_sphere",
         "Motion blur",
         {},
         "",
         {},
         "random -0.5, others between -0.67 and -0.75: pixel and time are three dimensions"},
        {"glossy", "glossy_floor", "Rough mirrors", {}, "", {}, "random -0.5"},
    };
    return all;
}

constexpr int kMostFrames = 64;

struct Pattern {
    const char *option, *name, *role;
    std::vector<int> samples;
};
const Pattern kPatterns[] = {{"sobol", "Sobol", "solution", {1, 2, 4, 8, 16, 32, 64, 128, 256, 1024}},
                             {"multi_jittered", "multi-jittered", "octree", {4, 16, 64, 256}},
                             {"jittered", "jittered", "grid", {4, 16, 64, 256}},
                             {"regular", "regular", "embree", {4, 16, 64, 256}},
                             {"random", "random", "naive", {4, 16, 64, 256}}};

RgbImage mean_of(const std::vector<RgbImage>& pictures, std::size_t count) {
    RgbImage mean = pictures.front();
    for (std::size_t i = 0; i < mean.pixels.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            double sum = 0;
            for (std::size_t k = 0; k < count; ++k) sum += pictures[k].pixels[i][c];
            mean.pixels[i][c] = static_cast<float>(sum / double(count));
        }
    return mean;
}

constexpr int kSlopeFrom = 16;

/// The slope of log error over log samples of joined points, by least squares over those from kSlopeFrom samples on.
double slope_of(const std::vector<Point>& points, const std::vector<int>& samples) {
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (samples[i] < kSlopeFrom) continue;
        const double x = std::log(samples[i]), y = std::log(points[i].y);
        n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

/// All pictures of an effect, each made once.
struct Made {
    std::vector<Series> by_time, by_samples;
    std::vector<Point> at_errors;  ///< POV-Ray's time over ours at the same error
};

class Effects {
public:
    explicit Effects(Laboratory& laboratory) : laboratory_(laboratory) {}

    const Made& of(const Effect& effect) {
        auto& made = made_[effect.id];
        if (made.by_time.empty()) make(effect, made);
        return made;
    }

private:
    void make(const Effect& effect, Made& made) {
        const TemporaryFolder temporary;
        const auto& folder = temporary.path();
        const auto scene = laboratory_.scene("5_distributed/" + effect.scene + ".pov");
        const auto truth =
            load_averaged_reference(laboratory_.scene("references/5_distributed/" + effect.scene + ".exr"));
        const Picture picture{scene, truth.raster()};
        std::vector<Try> tries;
        std::vector<std::string> labels;
        const auto add_ours = [&](const std::string& name, std::vector<std::string> options) {
            tries.push_back(
                {raysteps_command(laboratory_.program("render-solution"), picture, folder, name + ".exr", options),
                 folder / (name + ".exr")});
            labels.push_back(fmt::format("{}", fmt::join(options, " ")));
        };
        for (const Pattern& pattern : kPatterns)
            for (const int n : pattern.samples)
                add_ours(fmt::format("{}-{}", pattern.option, n),
                         {"--pattern", pattern.option, "--samples", std::to_string(n)});
        const std::vector<double> errors{0.04, 0.02, 0.01, 0.005, 0.0025};
        for (const double e : errors)
            add_ours(fmt::format("adaptive-{}", e),
                     {"--pattern", "sobol", "--samples", "4096", "--error", fmt::format("{}", e)});
        const std::size_t first_povray = tries.size();
        add_povray(effect, picture, folder, tries, labels);
        const std::size_t first_frame = tries.size();
        const auto tried = laboratory_.try_all(tries, laboratory_.long_rounds());
        const auto point = [&](std::size_t i) {
            return Point{
                .x = tried[i].cpu_s, .y = picture_error(tried[i].image, truth), .label = "", .settings = labels[i]};
        };
        std::size_t next = 0;
        for (const Pattern& pattern : kPatterns) {
            Series series{.name = pattern.name, .role = pattern.role, .joined = true};
            for (std::size_t k = 0; k < pattern.samples.size(); ++k) series.points.push_back(point(next++));
            Series samples = series;
            if (made.by_time.empty())  // the solution's way, beside whose points the student's stand
                for (std::size_t k = 0; k < pattern.samples.size(); ++k)
                    if (const int n = pattern.samples[k]; n == 4 || n == 16 || n == 64)
                        series.points[k].label = fmt::format("{} samples", n);
            for (std::size_t k = 0; k < pattern.samples.size(); ++k) samples.points[k].x = exactly(pattern.samples[k]);
            const double slope = slope_of(samples.points, pattern.samples);
            samples.name = fmt::format("{} (slope {:.2f})", pattern.name, slope);
            made.by_time.push_back(series);
            made.by_samples.push_back(samples);
        }
        Series adaptive{.name = "Sobol, adaptive", .role = "float", .joined = true};
        for (std::size_t k = 0; k < errors.size(); ++k) adaptive.points.push_back(point(next++));
        made.by_time.push_back(adaptive);
        Series povray{.name = "POV-Ray's own", .role = "povray"};
        for (std::size_t i = first_povray; i < first_frame; ++i) povray.points.push_back(point(i));
        if (!povray.points.empty()) made.by_time.push_back(povray);
        if (effect.id != "edges") made.by_time.push_back(frames_of_povray(picture, folder, truth));
        compare(effect, made);
    }

    void add_povray(const Effect& effect, const Picture& picture, const std::filesystem::path& folder,
                    std::vector<Try>& tries, std::vector<std::string>& labels) const {
        auto variants = effect.povray_variants;
        if (variants.empty()) variants.push_back({"", ""});
        int number = 0;
        for (const auto& [name, text] : variants)
            for (const int grid : effect.grids) {
                Picture variant = picture;
                if (!name.empty()) {
                    variant.scene = folder / fmt::format("variant-{}.pov", number);
                    // Settings of the lens may stand in an include, which the variant then takes in.
                    std::string sdl = read_file(picture.scene);
                    const std::string include = "#include \"focus.inc\"";
                    if (const auto at = sdl.find(include); at != std::string::npos)
                        sdl.replace(at, include.size(), read_file(picture.scene.parent_path() / "focus.inc"));
                    write_atomically(variant.scene, std::regex_replace(sdl, std::regex(effect.replaced), text));
                }
                std::vector<std::string> options{"+L" + picture.scene.parent_path().string()};
                if (grid > 1) options.insert(options.end(), {"+AM1", "+A0.0", fmt::format("+R{}", grid), "-J"});
                const std::string output = fmt::format("povray-{}.exr", number++);
                tries.push_back({povray_command(variant, folder, output, options), folder / output});
                labels.push_back(
                    fmt::format("POV-Ray {}{}", name, grid > 1 ? fmt::format(" +AM1 +A0.0 +R{}", grid) : " -A"));
            }
    }

    /// The mean of the first frames of an averaged reference of that many: each is a whole process, as it is for
    /// whoever does that.
    Series frames_of_povray(const Picture& picture, const std::filesystem::path& folder,
                            const AveragedReference& truth) const {
        Series series{.name = "mean of POV-Ray's frames", .role = "povray", .joined = true};
        for (const int count : {8, 16, 32, kMostFrames}) {
            std::vector<RgbImage> frames;
            double seconds = 0;
            for (int k = 0; k < count; ++k) {
                const std::string output = fmt::format("frame-{}.exr", k);
                seconds += run_or_throw(povray_command(picture, folder, output, frame_declarations(k, count))).cpu_s;
                frames.push_back(load_rgb_exr(folder / output));
            }
            series.points.push_back({.x = exactly(seconds),
                                     .y = picture_error(mean_of(frames, frames.size()), truth),
                                     .label = "",
                                     .settings = fmt::format("{} frames", count)});
        }
        return series;
    }

    /// At some errors: the quickest of POV-Ray's points that reach it, and our quickest way to what that point reached.
    static void compare(const Effect& effect, Made& made) {
        for (const double error : {0.03, 0.02, 0.01}) {
            const Point* best = nullptr;
            for (const Series& series : made.by_time) {
                if (series.role != "povray") continue;
                for (const Point& p : series.points)
                    if (p.y <= error && (!best || p.x.median < best->x.median)) best = &p;
            }
            if (!best) continue;
            double mine = -1;
            std::string how;
            for (const Series& series : made.by_time) {
                const double seconds = series.role == "povray" ? -1 : time_at(series, best->y);
                if (!(seconds > 0) || (mine > 0 && seconds >= mine)) continue;
                mine = seconds;
                how = series.name;
            }
            if (!(mine > 0)) continue;
            made.at_errors.push_back(
                {.x = {best->x.median / mine, best->x.low / mine, best->x.high / mine},
                 .label = fmt::format("{}, error {}", effect.title, error),
                 .settings =
                     fmt::format("POV-Ray reaches {:.2g} in {:.3g} s ({}), Raysteps in {:.3g} s of processor time ({})",
                                 best->y, best->x.median, best->settings, mine, how)});
        }
    }
    /// Negative where the series does not reach.
    static double time_at(const Series& series, double error) {
        for (std::size_t i = 1; i < series.points.size(); ++i) {
            const Point &a = series.points[i - 1], &b = series.points[i];
            if (!(a.y >= error && error >= b.y)) continue;
            const double part = a.y > b.y ? std::log(a.y / error) / std::log(a.y / b.y) : 0;
            return a.x.median * std::pow(b.x.median / a.x.median, part);
        }
        return series.points.front().y <= error ? series.points.front().x.median : -1;
    }

    Laboratory& laboratory_;
    std::map<std::string, Made> made_;
};

Effects& effects_of(Laboratory& laboratory) {
    static Effects effects(laboratory);
    return effects;
}

const Effect& effect_named(const std::string& id) {
    return *std::find_if(effects().begin(), effects().end(), [&](const Effect& e) { return e.id == id; });
}

Chart by_time(Laboratory& laboratory, const std::string& id) {
    const Effect& effect = effect_named(id);
    return {.id = "5." + id + ".time",
            .step = 5,
            .title = effect.title + ": error against time",
            .text = fmt::format(
                "{}, 96 x 72 pixels, whole processes, one thread. Errors are differences to the mean of many "
                "deterministic frames "
                "by POV-Ray, the standard error of which has been taken away. Adaptive: --error 0.04 to 0.0025.",
                effect.scene),
            .x = {"processor time of the whole process", "s", true},
            .y = {"error of the picture", "of its RMS", true},
            .front = true,
            .series = effects_of(laboratory).of(effect).by_time,
            .rounds = laboratory.long_rounds()};
}

Chart by_samples(Laboratory& laboratory, const std::string& id) {
    const Effect& effect = effect_named(id);
    return {
        .id = "5." + id + ".samples",
        .step = 5,
        .title = effect.title + ": error against samples",
        .text = fmt::format(
            "{}, 96 x 72 pixels. Slopes are fitted from 16 samples on; theory: {}. A picture has flat parts, edges and "
            "penumbrae: its slope lies between theirs.",
            effect.scene, effect.theory),
        .x = {"samples a pixel", "", true},
        .y = {"error of the picture", "of its RMS", true},
        .series = effects_of(laboratory).of(effect).by_samples,
        .rounds = laboratory.long_rounds()};
}

}  // namespace

Chart edges_by_time(Laboratory& laboratory) { return by_time(laboratory, "edges"); }
Chart edges_by_samples(Laboratory& laboratory) { return by_samples(laboratory, "edges"); }
Chart area_light_by_time(Laboratory& laboratory) { return by_time(laboratory, "area_light"); }
Chart area_light_by_samples(Laboratory& laboratory) { return by_samples(laboratory, "area_light"); }
Chart lens_by_time(Laboratory& laboratory) { return by_time(laboratory, "lens"); }
Chart lens_by_samples(Laboratory& laboratory) { return by_samples(laboratory, "lens"); }
Chart motion_by_time(Laboratory& laboratory) { return by_time(laboratory, "motion"); }
Chart motion_by_samples(Laboratory& laboratory) { return by_samples(laboratory, "motion"); }
Chart glossy_by_time(Laboratory& laboratory) { return by_time(laboratory, "glossy"); }
Chart glossy_by_samples(Laboratory& laboratory) { return by_samples(laboratory, "glossy"); }

Chart to_reach_an_error(Laboratory& laboratory) {
    Series ratios{.name = "Raysteps", .role = "solution"};
    for (const Effect& effect : effects()) {
        const Made& made = effects_of(laboratory).of(effect);
        ratios.points.insert(ratios.points.end(), made.at_errors.begin(), made.at_errors.end());
    }
    return {.id = "5.povray",
            .step = 5,
            .kind = ChartKind::ratios,
            .title = "To reach the same error",
            .text =
                "POV-Ray's processor time over ours for errors of 0.03, 0.02 and 0.01 of the picture's RMS: the "
                "quickest of its methods and "
                "settings on the charts above that reaches them, and our quickest for the error that it reached, "
                "between the points of a "
                "curve. Whole processes of 96 x 72 pixels: where both are quick, it is their starts that are compared.",
            .x = {"POV-Ray's time / ours", "", true},
            .series = {ratios},
            .rounds = laboratory.long_rounds()};
}

}  // namespace rays::bench
