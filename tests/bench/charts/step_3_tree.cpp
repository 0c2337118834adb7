// How deep the tree of rays goes, and what is too little to follow: the two knobs of recursion, in both renderers.
#include <fmt/format.h>

#include <array>
#include <cstdlib>

#include "charts.h"
#include "support/files.h"

namespace rays::bench {
namespace {

constexpr Raster kRaster{160, 120};
constexpr int kDeepest = 20;

/// One setting of both knobs.
struct Knobs {
    int max_trace_level;
    double adc_bailout;
    bool by_depth;  ///< depth is what is varied

    std::string text() const { return fmt::format("max_trace_level {} adc_bailout {}", max_trace_level, adc_bailout); }
    std::string label() const {
        return by_depth ? fmt::format("depth {}", max_trace_level) : fmt::format("{:.2g}", adc_bailout);
    }
};

const std::vector<Knobs>& all_knobs() {
    static const std::vector<Knobs> knobs{{1, 0, true},
                                          {2, 0, true},
                                          {3, 0, true},
                                          {4, 0, true},
                                          {5, 0, true},
                                          {7, 0, true},
                                          {10, 0, true},
                                          {kDeepest, 0.3, false},
                                          {kDeepest, 0.1, false},
                                          {kDeepest, 0.03, false},
                                          {kDeepest, 0.01, false},
                                          {kDeepest, 1.0 / 256, false},
                                          {kDeepest, 0.001, false},
                                          {kDeepest, 0.0001, false}};
    return knobs;
}

struct Measured {
    Knobs knobs;
    Spread cpu_s;
    double rays_of_pixel, error;
};
struct Both {
    std::vector<Measured> raysteps, povray;
};

double per_pixel(double rays) { return rays / (kRaster.width * kRaster.height); }

double our_rays(const Laboratory& laboratory, const Picture& picture) {
    const Command command = trusted({laboratory.program("count-rays").string(), picture.scene.string(),
                                     std::to_string(kRaster.width), std::to_string(kRaster.height)},
                                    {});
    const std::string counts = run_or_throw(command).out;
    char* rest = nullptr;
    const double all = std::strtod(counts.c_str(), &rest);
    return all - std::strtod(rest, nullptr);
}

double their_rays(const Picture& picture, const std::filesystem::path& folder) {
    const Ended ended = run_or_throw(povray_command(picture, folder, "counted.exr", {"+GS"}));
    return povray_rays(ended.out + ended.err);
}

Both measure(const Laboratory& laboratory) {
    const TemporaryFolder temporary;
    const auto& folder = temporary.path();
    const auto scene = laboratory.scene("3_recursion/glass_spheres.pov");
    const auto picture = [&](const std::string& settings, const std::string& name) {
        return Picture{with_settings(scene, settings, folder, name), kRaster};
    };
    run_or_throw(povray_command(picture(fmt::format("max_trace_level {} adc_bailout 0", kDeepest), "whole"), folder,
                                "whole.exr"));
    const RgbImage truth = load_rgb_exr(folder / "whole.exr");

    std::vector<Try> tries;
    std::vector<Picture> pictures;
    for (const Knobs& knobs : all_knobs()) {
        const std::string name = fmt::format("try-{}", pictures.size());
        pictures.push_back(picture(knobs.text(), name));
        tries.push_back(
            {raysteps_command(laboratory.program("render-solution"), pictures.back(), folder, name + "-rays.exr"),
             folder / (name + "-rays.exr")});
        tries.push_back({povray_command(pictures.back(), folder, name + "-pov.exr"), folder / (name + "-pov.exr")});
    }
    const auto tried = laboratory.try_all(tries, laboratory.long_rounds());
    Both both;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const Tried &ours = tried[2 * i], &theirs = tried[2 * i + 1];
        both.raysteps.push_back({all_knobs()[i], ours.cpu_s, per_pixel(our_rays(laboratory, pictures[i])),
                                 picture_error(ours.image, truth)});
        both.povray.push_back({all_knobs()[i], theirs.cpu_s, per_pixel(their_rays(pictures[i], folder)),
                               picture_error(theirs.image, truth)});
    }
    return both;
}

/// Both charts show the same measurements.
const Both& measured(const Laboratory& laboratory) {
    static const Both both = measure(laboratory);
    return both;
}

Series series_of(const std::string& name, const std::string& role, const std::vector<Measured>& all, bool by_depth,
                 bool over_rays) {
    Series series{.name = name, .role = role, .joined = true};
    for (const Measured& m : all) {
        if (m.knobs.by_depth != by_depth) continue;
        series.points.push_back({.x = over_rays ? exactly(m.rays_of_pixel) : m.cpu_s,
                                 .y = m.error,
                                 .label = role == "solution" ? m.knobs.label() : "",
                                 .settings = fmt::format("{}; {:.3g} rays a pixel, {:.3g} s of processor time",
                                                         m.knobs.text(), m.rays_of_pixel, m.cpu_s.median)});
    }
    return series;
}

Chart chart_of(const Laboratory& laboratory, bool over_rays) {
    const Both& both = measured(laboratory);
    Chart chart{.id = "3.tree", .step = 3, .y = {"error of the picture", "of its RMS", true}, .front = true};
    for (const bool by_depth : {true, false}) {
        const std::string knob = by_depth ? "depth" : "threshold";
        chart.series.push_back(series_of("Raysteps, " + knob, "solution", both.raysteps, by_depth, over_rays));
        chart.series.push_back(series_of("POV-Ray, " + knob, "povray", both.povray, by_depth, over_rays));
    }
    chart.rounds = laboratory.long_rounds();
    return chart;
}

}  // namespace

Chart tree_by_time(Laboratory& laboratory) {
    Chart chart = chart_of(laboratory, false);
    chart.id = "3.tree.time";
    chart.title = "Glass spheres: where the tree of rays is cut, against time";
    chart.text = fmt::format(
        "max_trace_level with adc_bailout 0 (Raysteps leaves out what could not bring 2^-24), and adc_bailout at level "
        "{0}, "
        "160 x 120 pixels, whole processes. "
        "Errors are differences to POV-Ray's picture at level {0} with nothing pruned. Depth alone costs "
        "exponentially; "
        "the threshold leaves out only branches that carry nothing.",
        kDeepest);
    chart.x = {"processor time of the whole process", "s", true};
    return chart;
}

Chart tree_by_rays(Laboratory& laboratory) {
    Chart chart = chart_of(laboratory, true);
    chart.id = "3.tree.rays";
    chart.title = "Glass spheres: where the tree of rays is cut, against rays";
    chart.text =
        "The same pictures over the number of rays, shadow rays left out. POV-Ray's statistics also count the rays "
        "that "
        "it then does not trace.";
    chart.x = {"rays a pixel", "", true};
    return chart;
}

}  // namespace rays::bench
