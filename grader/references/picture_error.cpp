#include "references/picture_error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace rays {
namespace {

void expect_same_size(const RgbImage& picture, const RgbImage& reference) {
    if (picture.pixels.size() != reference.pixels.size() || picture.raster.width != reference.raster.width)
        throw std::invalid_argument("pictures of different sizes cannot be compared");
}

/// To 11 significant bits.
double in_half(double value) {
    if (!std::isfinite(value)) return value;
    int exponent = 0;
    const double fraction = std::frexp(value, &exponent);
    return std::ldexp(std::nearbyint(std::ldexp(fraction, 11)), exponent - 11);
}

}  // namespace

double picture_error(const RgbImage& picture, const RgbImage& reference) {
    expect_same_size(picture, reference);
    double differences = 0, all = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        for (std::size_t lane = 0; lane < 3; ++lane) {
            const double truth = in_half(reference.pixels[i][lane]);
            const double difference = in_half(picture.pixels[i][lane]) - truth;
            differences += difference * difference;
            all += truth * truth;
        }
    }
    if (!std::isfinite(differences) || !(all > 0)) return std::numeric_limits<double>::infinity();
    return std::sqrt(differences / all);
}

double picture_error(const RgbImage& picture, const AveragedReference& reference) {
    expect_same_size(picture, reference.mean);
    double differences = 0, own = 0, all = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        for (std::size_t lane = 0; lane < 3; ++lane) {
            const double truth = reference.mean.pixels[i][lane], error = reference.error.pixels[i][lane];
            const double difference = picture.pixels[i][lane] - truth;
            differences += difference * difference;
            own += error * error;
            all += truth * truth;
        }
    }
    if (!std::isfinite(differences) || !(all > 0)) return std::numeric_limits<double>::infinity();
    return std::sqrt(std::max(differences - own, own / 16) / all);
}

}  // namespace rays
