// Grid and octree in whole pictures, beside the bvh.
#include <fmt/format.h>

#include "charts.h"
#include "support/files.h"

namespace rays::bench {

Chart structures_in_scenes(Laboratory& laboratory) {
    constexpr int kSide = 128;  // the grid takes long in the stadium
    const TemporaryFolder temporary;
    const auto& folder = temporary.path();
    Series grid{.name = "grid", .role = "grid"}, octree{.name = "octree", .role = "octree"};
    for (const std::string& name : scenes_of(laboratory.scene("4_partitioning"))) {
        const Picture picture{laboratory.scene("4_partitioning/" + name + ".pov"), {kSide, kSide}};
        std::vector<Command> commands;
        for (const char* structure : {"bvh", "grid", "octree"})
            commands.push_back(raysteps_command(laboratory.program("render-solution"), picture, folder, "x.exr",
                                                {"--partition", structure}));
        const auto times = time_in_turns(commands, laboratory.long_rounds());
        const auto point = [&](std::size_t i) {
            const PairedTimes pair = paired(times[i], times[0]);
            return Point{.x = pair.ratio,
                         .label = name,
                         .settings = fmt::format("{:.3g} s, bvh {:.3g} s", pair.first_s.median, pair.second_s.median)};
        };
        grid.points.push_back(point(1));
        octree.points.push_back(point(2));
    }
    return {.id = "4.scenes",
            .step = 4,
            .kind = ChartKind::ratios,
            .title = "Grid and octree in the scenes of step 4",
            .text = fmt::format("Processor time of the whole process at {0} x {0} pixels over that with the bvh: above "
                                "1 the bvh is faster. "
                                "The teapot in the stadium is all in one cell of the grid.",
                                kSide),
            .x = {"time / time with the bvh", "", true},
            .series = {grid, octree},
            .rounds = laboratory.long_rounds()};
}

}  // namespace rays::bench
