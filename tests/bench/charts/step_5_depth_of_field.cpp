// How deep is the field that counts as sharp: the lecture's formula and the exact one.
#include "charts.h"

namespace rays::bench {
namespace {

constexpr double kFocal_mm = 50, kNumber = 2, kCircle_mm = 0.03;

/// Between the near and the far limit, from the hyperfocal distance H = f^2 / (N c) + f.
double exact_mm(double distance) {
    const double h = kFocal_mm * kFocal_mm / (kNumber * kCircle_mm) + kFocal_mm;
    const double near = distance * (h - kFocal_mm) / (h + distance - 2 * kFocal_mm);
    const double far = distance * (h - kFocal_mm) / (h - distance);
    return far - near;
}

}  // namespace

Chart depth_of_field_formulas(Laboratory&) {
    Series exact{.name = "exact", .role = "solution", .joined = true},
        lecture{.name = "2 N c U^2 / f^2", .role = "naive", .joined = true};
    for (const double u : {150.0, 200.0, 300.0, 500.0, 1000.0, 2000.0, 5000.0, 10000.0, 20000.0, 30000.0, 38000.0}) {
        exact.points.push_back({.x = exactly(u), .y = exact_mm(u), .label = "", .settings = "far limit - near limit"});
        lecture.points.push_back({.x = exactly(u),
                                  .y = 2 * kNumber * kCircle_mm * u * u / (kFocal_mm * kFocal_mm),
                                  .label = "",
                                  .settings = ""});
    }
    return {.id = "5.depth_of_field",
            .step = 5,
            .title = "Depth of field: a formula and the truth",
            .text =
                "A lens of 50 mm at f/2, circles of confusion up to 0.03 mm. Near the lens the short formula is too "
                "large (it forgets the focal "
                "length), towards the hyperfocal distance of 41.7 m it is far too small: there the field reaches to "
                "infinity.",
            .x = {"distance in focus", "mm", true},
            .y = {"depth of field", "mm", true},
            .series = {exact, lecture}};
}

}  // namespace rays::bench
