// Pictures that are estimates, against numbers that are known: the same truth is estimated many times over, and their
// scatter says how far their mean may be from it.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "renderer/render.h"
#include "scene_reader/scene_reader.h"

namespace rays::tests {

inline constexpr double kPiD = 3.14159265358979323846;

inline Scene staged(const std::string& text) {
    Scene scene = read_scene_text("#version 3.7; global_settings { assumed_gamma 1.0 }\n" + text, "test");
    prepare(scene);
    return scene;
}

/// Estimates that do not know of each other: pixels, seeds.
struct Replicas {
    std::vector<double> values;

    double mean() const {
        double sum = 0;
        for (const double v : values) sum += v;
        return sum / double(values.size());
    }
    double standard_error() const {
        double squares = 0;
        for (const double v : values) squares += (v - mean()) * (v - mean());
        return std::sqrt(squares / double(values.size() - 1) / double(values.size()));
    }
};

/// The mean is the truth, within nine times its standard error: with 64 replicas Student's t (63 degrees of freedom)
/// goes beyond by chance once in 10^12, so a thousand of these fail once in 10^9. What happens seldom has no scatter
/// when it does not happen: `samples` in all that each find 0 to 1 add 27 / samples, since e^-27 is 2e-12. `known` is
/// how far the truth itself may be off (a lamp that is not quite at infinity), to which the rounding of pixels to
/// floats is added.
inline void expect_mean(const Replicas& found, double truth, double samples, double known = 0,
                        const std::string& of = "") {
    ASSERT_GE(found.values.size(), 64u);
    const double margin = 9 * found.standard_error() + 27 / samples + known + 1e-6 * std::max(1.0, std::abs(truth));
    EXPECT_TRUE(std::abs(found.mean() - truth) <= margin)
        << of << ": " << found.mean() << " is not " << truth << " within " << margin;
}
inline constexpr double kAlways = 1e30;  ///< samples that never find nothing by chance

/// All pixels of a column, where every row has the same truth.
inline Replicas column_of(const Film& film, int x) {
    Replicas all;
    for (int y = 0; y < film.raster().height; ++y) all.values.push_back(film.at(x, y)[0]);
    return all;
}

/// The mean of f over an interval: what a pixel's box makes of a profile. The midpoint rule, fine enough for kinks.
inline double mean_over(const std::function<double(double)>& f, double centre, double width) {
    constexpr int kSteps = 4000;
    long double sum = 0;
    for (int i = 0; i < kSteps; ++i) sum += f(centre + width * ((i + 0.5) / kSteps - 0.5));
    return double(sum / kSteps);
}

/// The part of a disc of radius 1 on the lower side of a line at distance x from its centre.
inline double part_of_disc(double x) {
    if (x <= -1) return 0;
    if (x >= 1) return 1;
    return 0.5 + (x * std::sqrt(1 - x * x) + std::asin(x)) / kPiD;
}

}  // namespace rays::tests
