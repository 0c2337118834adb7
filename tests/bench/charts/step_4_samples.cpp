// More samples a pixel: the same regular grids in both renderers.
#include <fmt/format.h>

#include "charts.h"
#include "support/files.h"

namespace rays::bench {
namespace {

constexpr Raster kRaster{96, 72};
constexpr int kReference = 32;  ///< samples a pixel along each axis, of the reference

/// The mean of a frame with 32 x 32 as many pixels: no sampler is trusted, not even POV-Ray's.
RgbImage reference(const std::filesystem::path& scene, const std::filesystem::path& folder) {
    const Picture fine{scene, {kRaster.width * kReference, kRaster.height * kReference}};
    run_or_throw(povray_command(fine, folder, "fine.exr"));
    return averaged(load_rgb_exr(folder / "fine.exr"), kReference);
}

Chart samples(Laboratory& laboratory, const std::string& scene_name, const std::string& id, const std::string& title) {
    const TemporaryFolder temporary;
    const auto& folder = temporary.path();
    const Picture picture{laboratory.scene(scene_name), kRaster};
    const RgbImage truth = reference(picture.scene, folder);
    const std::vector<int> sides{1, 2, 3, 4, 5, 6, 8, 9};
    std::vector<Try> tries;
    for (const int n : sides) {
        const std::string ours = fmt::format("{}-rays.exr", n), theirs = fmt::format("{}-pov.exr", n);
        tries.push_back({raysteps_command(laboratory.program("render-solution"), picture, folder, ours,
                                          {"--samples", std::to_string(n * n)}),
                         folder / ours});
        std::vector<std::string> grid{"+AM1", "+A0.0", fmt::format("+R{}", n)};
        if (n == 1) grid.clear();  // +R1 would trace every pixel twice
        tries.push_back({povray_command(picture, folder, theirs, grid), folder / theirs});
    }
    const auto tried = laboratory.try_all(tries, laboratory.long_rounds());
    Series ours{.name = "Raysteps", .role = "solution", .joined = true};
    Series theirs{.name = "POV-Ray", .role = "povray", .joined = true};
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const std::string grid = fmt::format("{0} x {0}", sides[i]);
        ours.points.push_back({.x = tried[2 * i].cpu_s,
                               .y = picture_error(tried[2 * i].image, truth),
                               .label = grid,
                               .settings = fmt::format("--samples {}", sides[i] * sides[i])});
        theirs.points.push_back({.x = tried[2 * i + 1].cpu_s,
                                 .y = picture_error(tried[2 * i + 1].image, truth),
                                 .label = grid,
                                 .settings = sides[i] == 1 ? "-A" : fmt::format("+AM1 +A0.0 +R{} -J", sides[i])});
    }
    return {.id = id,
            .step = 4,
            .title = title,
            .text = fmt::format("Regular grids of samples in every pixel, {} x {} pixels, whole processes, one thread. "
                                "Errors are differences to the "
                                "mean of {} x {} samples, by POV-Ray, one a pixel of a larger frame.",
                                kRaster.width, kRaster.height, kReference, kReference),
            .x = {"processor time of the whole process", "s", true},
            .y = {"error of the picture", "of its RMS", true},
            .front = true,
            .series = {ours, theirs},
            .rounds = laboratory.long_rounds()};
}

}  // namespace

Chart samples_of_stadium(Laboratory& laboratory) {
    return samples(laboratory, "4_partitioning/teapot_in_a_stadium.pov", "4.samples.stadium",
                   "Samples a pixel: the teapot in the stadium");
}

Chart samples_of_checkers(Laboratory& laboratory) {
    return samples(laboratory, "2_phong/checkers.pov", "4.samples.checkers", "Samples a pixel: checkers");
}

}  // namespace rays::bench
