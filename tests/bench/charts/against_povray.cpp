// Whole pictures: POV-Ray's processor time over ours.
#include <fmt/format.h>

#include <cmath>

#include "charts.h"

namespace rays::bench {
namespace {

constexpr int kSide = 512;

/// POV-Ray's times over ours: a row for each scene, and the geometric mean of each round.
Series ratios(const std::vector<WholeProgram>& programs, std::vector<double> WholeProgram::*ours, Series series) {
    std::vector<double> means(programs.at(0).povray_s.size(), 0.0);
    for (const WholeProgram& program : programs) {
        const PairedTimes times = paired(program.povray_s, program.*ours);
        series.points.push_back({.x = times.ratio,
                                 .label = program.scene.substr(program.scene.find('/') + 1),
                                 .settings = fmt::format("POV-Ray {:.3g} s, Raysteps {:.3g} s of processor time",
                                                         times.first_s.median, times.second_s.median)});
        for (std::size_t round = 0; round < means.size(); ++round)
            means[round] += std::log(program.povray_s[round] / (program.*ours)[round]);
    }
    for (double& mean : means) mean = std::exp(mean / static_cast<double>(programs.size()));
    series.points.push_back(
        {.x = spread(means), .label = "geometric mean", .settings = fmt::format("of {} scenes", programs.size())});
    return series;
}

Chart against_povray(Laboratory& laboratory, int step, const std::string& folder, const std::string& title) {
    const auto programs = laboratory.whole_programs(folder, kSide);
    return {.id = folder == "bench" ? "4.povray.bench" : fmt::format("{}.povray", step),
            .step = step,
            .kind = ChartKind::ratios,
            .title = title,
            .text = fmt::format(
                "Processor time (user and system) of the whole process from start to exit, {0} x {0} pixels, "
                "no anti-aliasing, one thread, EXR written. In turns, all scenes in each round; median and interval. "
                "Ray by ray (--no-packets) the picture is the same.",
                kSide),
            .x = {"POV-Ray's time / ours", "", true},
            .series = {ratios(programs, &WholeProgram::raysteps_s, {.name = "Raysteps", .role = "solution"}),
                       ratios(programs, &WholeProgram::single_s, {.name = "ray by ray", .role = "naive"})},
            .rounds = laboratory.long_rounds()};
}

}  // namespace

Chart step_1_against_povray(Laboratory& laboratory) {
    return against_povray(laboratory, 1, "1_ray_casting", "Whole program beside POV-Ray: scenes of step 1");
}

Chart step_2_against_povray(Laboratory& laboratory) {
    return against_povray(laboratory, 2, "2_phong", "Whole program beside POV-Ray: scenes of step 2");
}

Chart step_3_against_povray(Laboratory& laboratory) {
    return against_povray(laboratory, 3, "3_recursion", "Whole program beside POV-Ray: scenes of step 3");
}

Chart step_4_against_povray(Laboratory& laboratory) {
    return against_povray(laboratory, 4, "4_partitioning", "Whole program beside POV-Ray: scenes of step 4");
}

Chart bench_against_povray(Laboratory& laboratory) {
    if (!laboratory.settings().large) return {};
    return against_povray(laboratory, 4, "bench", "Whole program beside POV-Ray: large scenes");
}

}  // namespace rays::bench
