// Whole pictures: POV-Ray's processor time over ours.
#include <fmt/format.h>

#include <initializer_list>

#include "charts.h"

namespace rays::bench {
namespace {

constexpr int kSide = 512;

Chart against_povray(Laboratory& laboratory, int step, const std::string& folder,
                     std::initializer_list<const char*> scenes) {
    Series series{.name = "Raysteps", .role = "solution", .points = {}};
    for (const std::string scene : scenes) {
        const PairedTimes times = laboratory.against_povray(folder + "/" + scene + ".pov", kSide, kSide);
        series.points.push_back({.x = times.ratio,
                                 .label = scene,
                                 .settings = fmt::format("POV-Ray {:.3g} s, Raysteps {:.3g} s of processor time",
                                                         times.first_s.median, times.second_s.median)});
    }
    return {.id = fmt::format("{}.povray", step),
            .step = step,
            .kind = ChartKind::ratios,
            .title = "Whole pictures beside POV-Ray",
            .text = fmt::format(
                "Processor time (user and system) of the whole process from start to exit, {0} x {0} pixels, "
                "no anti-aliasing, one thread, EXR written. Pairs in turns; median and 95 % interval.",
                kSide),
            .x = {"POV-Ray's time / ours", "", true},
            .y = {},
            .series = {series}};
}

}  // namespace

Chart step_1_against_povray(Laboratory& laboratory) {
    return against_povray(laboratory, 1, "1_ray_casting",
                          {"one_sphere", "still_life", "polygons", "quadrics", "torus", "patches", "meshes"});
}

Chart step_2_against_povray(Laboratory& laboratory) {
    return against_povray(laboratory, 2, "2_phong",
                          {"highlights", "checkers", "shadow_study", "spotlights", "chess_night"});
}

}  // namespace rays::bench
