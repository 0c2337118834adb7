// The exact Fresnel formula and Schlick's, by themselves and in pictures.
#include <fmt/format.h>

#include "charts.h"
#include "methods.h"
#include "support/files.h"

namespace rays::bench {
namespace {

constexpr Raster kRaster{160, 120};
constexpr const char* kScenes[] = {"glass_spheres", "under_water", "reflectors"};

Series formulas(const std::string& name, const std::string& role, const MeasuredByName& measured,
                const std::string& real, const std::string& formula) {
    Series series{.name = name, .role = role};
    for (const std::string place : {"outside", "inside"}) {
        Point point = mean_error_point(measured.at("fresnel/" + place + "/" + formula), real);
        point.label = place;
        series.points.push_back(point);
    }
    return series;
}

}  // namespace

Chart fresnel_formulas(Laboratory& laboratory) {
    const BothReals& both = laboratory.methods(3);
    return {.id = "3.fresnel",
            .step = 3,
            .title = "Fresnel's formula, exact and by Schlick",
            .text =
                "Glass of index 1.5, seen from outside and from inside, with cosines as a diffuse surface has them. "
                "Errors are of the reflected share, against the amplitudes of both polarisations in long double.",
            .x = {"CPU time of a call", "ns", true},
            .y = {"mean error", "of the reflected share", true},
            .series = {formulas("exact, double", "solution", both.in_double, "double", "exact"),
                       formulas("exact, float", "float", both.in_float, "float", "exact"),
                       formulas("Schlick, double", "naive", both.in_double, "double", "schlick"),
                       formulas("Schlick, float", "naive", both.in_float, "float", "schlick")}};
}

Chart schlick_in_pictures(Laboratory& laboratory) {
    Chart chart{
        .id = "3.schlick",
        .step = 3,
        .title = "Schlick's formula in pictures",
        .text =
            "The same scenes with `reflection { fresnel }` by either formula, and POV-Ray. Errors are differences "
            "to POV-Ray's picture, rounded as it is: 0 means the same at every pixel.",
        .x = {"processor time of the whole process", "s", true},
        .y = {"error of the picture", "of its RMS", true},
        .rounds = laboratory.long_rounds()};
    const auto varied = read_knobs(laboratory.settings().bin, 3);
    if (varied.empty()) return chart;
    const TemporaryFolder temporary;
    const auto& folder = temporary.path();
    Series exact{.name = "Raysteps, exact", .role = "solution"};
    Series schlick{.name = "Raysteps, Schlick", .role = "naive"};
    Series povray{.name = "POV-Ray, exact", .role = "povray"};
    for (const std::string name : kScenes) {
        const Picture picture{laboratory.scene("3_recursion/" + name + ".pov"), kRaster};
        const auto tried = laboratory.try_all(
            {{raysteps_command(laboratory.program("render-solution"), picture, folder, "exact.exr"),
              folder / "exact.exr"},
             {raysteps_command(varied.at(0).program, picture, folder, "schlick.exr"), folder / "schlick.exr"},
             {povray_command(picture, folder, "povray.exr"), folder / "povray.exr"}},
            laboratory.long_rounds());
        Series* const all[] = {&exact, &schlick, &povray};
        for (std::size_t i = 0; i < tried.size(); ++i)
            all[i]->points.push_back({.x = tried[i].cpu_s,
                                      .y = picture_error(tried[i].image, tried[2].image),
                                      .label = name,
                                      .settings = fmt::format("{}, {} x {}", name, kRaster.width, kRaster.height)});
    }
    chart.series = {exact, schlick, povray};
    return chart;
}

}  // namespace rays::bench
