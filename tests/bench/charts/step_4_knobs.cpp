// The constants of grid, octree and bvh: what other numbers would cost, in time and in memory.
#include <fmt/format.h>

#include "charts.h"

namespace rays::bench {
namespace {

struct ShownKnob {
    const char *knob, *series, *label, *role;  ///< points with the same label would be linked
};
constexpr ShownKnob kKnobs[] = {{"grid-density", "grid: cells a body", "{} cells", "grid"},
                                {"octree-leaf", "octree: most bodies in a leaf", "leaf {}", "octree"},
                                {"octree-depth", "octree: most levels", "depth {}", "naive"},
                                {"bvh-leaf", "bvh: most bodies in a leaf", "bvh {}", "solution"}};

constexpr double kBodies = 100'000;

Point memory_and_time(const Timed& rays, const Timed& build, const std::string& label, const std::string& settings) {
    const Spread us = spread(build.ns);
    return point_of(exactly(build.counter("bytes") / kBodies), spread(rays.ns), label,
                    fmt::format("{}; built in {:.2g} us a body", settings, us.median / 1e3 / kBodies));
}

Chart knobs_with(Laboratory& laboratory, const std::string& bodies) {
    const std::string set = fmt::format("{}/{}/", bodies, static_cast<int>(kBodies));
    Chart chart{
        .id = "4.knobs." + bodies,
        .step = 4,
        .title = fmt::format("Knobs of the structures, among 100 000 random {}", bodies),
        .text =
            "The same rays (one diffuse bounce, nearest hit) through each structure with one of its constants changed. "
            "Below and left is better: less memory, less time.",
        .x = {"memory of the structure, a body", "bytes", true},
        .y = {"CPU time of a ray", "ns", true},
        .front = true,
        .rounds = laboratory.long_rounds()};
    for (const ShownKnob& shown : kKnobs) {
        Series series{.name = shown.series, .role = shown.role, .joined = true};
        const std::string structure = std::string(shown.knob).substr(0, std::string(shown.knob).find('-'));
        for (const KnobRun& run : laboratory.knobs()) {
            if (run.knob.name != shown.knob) continue;
            series.points.push_back(memory_and_time(run.timed.at("nearest/bounced/" + set + structure),
                                                    run.timed.at("build/" + set + structure),
                                                    fmt::format(fmt::runtime(shown.label), run.knob.value),
                                                    fmt::format("{}: {}", shown.series, run.knob.value)));
        }
        if (!series.points.empty()) chart.series.push_back(std::move(series));
    }
    return chart;
}

}  // namespace

Chart knobs_with_spheres(Laboratory& laboratory) { return knobs_with(laboratory, "spheres"); }
Chart knobs_with_triangles(Laboratory& laboratory) { return knobs_with(laboratory, "triangles"); }

}  // namespace rays::bench
