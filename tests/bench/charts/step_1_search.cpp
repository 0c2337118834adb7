// Searches with a knob: the torus by steps, the patch by Newton's method and by triangles.
#include <initializer_list>

#include "charts.h"
#include "methods.h"

namespace rays::bench {
namespace {

std::vector<std::string> numbered(const std::string& prefix, std::initializer_list<int> numbers) {
    std::vector<std::string> names;
    for (const int n : numbers) names.push_back(prefix + std::to_string(n));
    return names;
}

}  // namespace

Chart torus_methods(Laboratory& laboratory) {
    const BothReals& both = laboratory.methods(1);
    const auto steps = numbered("torus/steps/", {4, 8, 16, 32, 64, 128, 256});
    return {.id = "1.torus",
            .step = 1,
            .title = "A torus: isolated roots, or steps along the ray",
            .text =
                "Equal steps miss a pair of roots that lies between two of them; the rays of this chart keep a "
                "thousandth of the size away from silhouettes, so steps look better than they are.",
            .x = kTimeOfRay,
            .y = kMeanError,
            .front = true,
            .series = {mean_error_series("isolated, double", "solution", both.in_double, "double", {"torus/isolated"}),
                       mean_error_series("isolated, float", "float", both.in_float, "float", {"torus/isolated"}),
                       mean_error_series("steps, double", "naive", both.in_double, "double", steps),
                       mean_error_series("steps, float", "naive", both.in_float, "float", steps)}};
}

Chart patch_methods(Laboratory& laboratory) {
    const BothReals& both = laboratory.methods(1);
    const auto newton = numbered("patch/newton/", {1, 2, 3, 4, 6});
    const auto triangles = numbered("patch/triangles/", {2, 4, 8, 16});
    return {
        .id = "1.patch",
        .step = 1,
        .title = "A bicubic patch: certified subdivision, Newton's method, triangles",
        .text =
            "Newton's method from few starts finds another root or none; triangles, which POV-Ray's patches are, "
            "are coarse. Certified subdivision asks Newton's method only where it cannot fail.",
        .x = kTimeOfRay,
        .y = kMeanError,
        .front = true,
        .series = {mean_error_series("certified, double", "solution", both.in_double, "double", {"patch/certified"}),
                   mean_error_series("certified, float", "float", both.in_float, "float", {"patch/certified"}),
                   mean_error_series("Newton, double", "naive", both.in_double, "double", newton),
                   mean_error_series("triangles, double", "naive", both.in_double, "double", triangles)}};
}

}  // namespace rays::bench
