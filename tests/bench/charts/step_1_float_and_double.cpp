// What float costs and saves, for every primitive of step 1.
#include <fmt/format.h>

#include <array>

#include "charts.h"
#include "methods.h"

namespace rays::bench {
namespace {

constexpr std::array kPrimitives{"plane",    "triangle", "polygon", "disc",  "box",  "sphere",
                                 "cylinder", "cone",     "quadric", "torus", "patch"};

Series median_errors(const std::string& name, const std::string& role, const MeasuredByName& measured) {
    Series series{.name = name, .role = role};
    for (const std::string primitive : kPrimitives) {
        const Measured& m = measured.at("primitive/" + primitive);
        series.points.push_back({.x = spread(m.ns),
                                 .y = m.error_median,
                                 .label = primitive,
                                 .settings = fmt::format("{} in {}, {}; largest error {:.2g}", primitive, name,
                                                         m.settings, m.error_largest)});
    }
    return series;
}

}  // namespace

Chart float_and_double(Laboratory& laboratory) {
    const BothReals& both = laboratory.methods(1);
    return {.id = "1.reals",
            .step = 1,
            .title = "Every primitive in float and in double",
            .text =
                "The ends of a line are the same code with both number types. Errors are distances from the true "
                "surface, the rays' own numbers taken as exact; about half of the rays hit.",
            .x = kTimeOfRay,
            .y = {"median error", "sizes of the shape", true},
            .series = {median_errors("double", "solution", both.in_double),
                       median_errors("float", "float", both.in_float)}};
}

Chart float_against_double(Laboratory& laboratory) {
    const BothReals& both = laboratory.methods(1);
    Series series{.name = "float", .role = "float"};
    for (const std::string primitive : kPrimitives) {
        const Measured& f = both.in_float.at("primitive/" + primitive);
        const Measured& d = both.in_double.at("primitive/" + primitive);
        std::vector<double> ratios;
        for (std::size_t i = 0; i < f.ns.size(); ++i) ratios.push_back(f.ns[i] / d.ns.at(i));
        series.points.push_back({.x = spread(ratios),
                                 .label = primitive,
                                 .settings = fmt::format("{:.3g} ns a ray in float, {:.3g} ns in double",
                                                         spread(f.ns).median, spread(d.ns).median)});
    }
    return {.id = "1.reals.ratio",
            .step = 1,
            .kind = ChartKind::ratios,
            .title = "Time in float as a share of the time in double",
            .text =
                "Median of the rounds, each round's two builds one after the other, with its 95 % interval. Below 1 "
                "float is faster.",
            .x = {"time in float / time in double", "", true},
            .series = {series}};
}

}  // namespace rays::bench
