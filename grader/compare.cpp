#include "grader/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rays::grader {
namespace {

bool finite(const Rgb& c) { return std::isfinite(c[0]) && std::isfinite(c[1]) && std::isfinite(c[2]); }

double allowance(const Tolerance& t, float reference) { return t.absolute + t.relative * std::abs(double(reference)); }

// Largest difference of the channels in units of the tolerance; infinite when not finite.
double excess(const Rgb& value, const Rgb& reference, const Tolerance& t) {
    if (!finite(value)) return std::numeric_limits<double>::infinity();
    double worst = 0;
    for (std::size_t c = 0; c < 3; ++c)
        worst = std::max(worst, std::abs(double(value[c]) - double(reference[c])) / allowance(t, reference[c]));
    return worst;
}

// Does something within half a pixel look like this? Channels are bounded one by one, and with the tolerance: colours
// between two surfaces' (of an anti-aliased edge) count as well.
bool explained_by_surroundings(const Rgb& value, const Rgb& low, const Rgb& high, const Tolerance& t) {
    for (std::size_t c = 0; c < 3; ++c)
        if (!(value[c] >= low[c] - allowance(t, low[c]) && value[c] <= high[c] + allowance(t, high[c]))) return false;
    return true;
}

std::string percent(int count, int pixels) {
    return fmt::format("{} of {} pixels ({:.3g} %)", count, pixels, 100.0 * count / pixels);
}

std::string problem_of(const Comparison& c, int allowed) {
    if (c.not_finite > 0) return fmt::format("{} are NaN or infinite", percent(c.not_finite, c.pixels));
    const int unexplained = c.beyond - c.on_silhouettes;
    if (unexplained > 0)
        return fmt::format("{} differ from the reference by more than its rounding, by up to {:.3g}",
                           percent(unexplained, c.pixels), c.max_error);
    if (c.beyond > allowed)
        return fmt::format("{} on silhouettes differ from the reference; {} may", percent(c.beyond, c.pixels), allowed);
    return {};
}

}  // namespace

bool within(const Rgb& value, const Rgb& reference, const Tolerance& tolerance) {
    return excess(value, reference, tolerance) <= 1;
}

Comparison compare(const RgbImage& picture, const Reference& truth, const Tolerance& tolerance, int least_allowed) {
    Comparison result;
    const RgbImage& frame = truth.frame;
    const auto [width, height] = frame.raster;
    result.pixels = width * height;
    if (picture.raster.width != width || picture.raster.height != height) {
        result.beyond = result.pixels;
        result.problem = fmt::format("the picture is {} x {} pixels, not {} x {}", picture.raster.width,
                                     picture.raster.height, width, height);
        return result;
    }
    double worst = -1, squares = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const Rgb &value = picture.at(x, y), &reference = frame.at(x, y);
            const bool is_finite = finite(value);
            double error = 0;
            for (std::size_t c = 0; c < 3; ++c) {
                const double difference = std::abs(double(value[c]) - double(reference[c]));
                error = std::max(error, difference);
                if (is_finite) squares += difference * difference / 3;
            }
            double out = excess(value, reference, tolerance);
            const bool is_beyond = !(out <= 1);
            const bool silhouette =
                is_beyond && explained_by_surroundings(value, truth.min.at(x, y), truth.max.at(x, y), tolerance);
            result.beyond += is_beyond;
            result.on_silhouettes += silhouette;
            result.not_finite += !is_finite;
            if (is_finite && !silhouette) result.max_error = std::max(result.max_error, error);
            if (silhouette) out = std::min(out, 1.0);  // the worst pixel is one that nothing explains, if there is any
            if (out > worst) {
                worst = out;
                result.worst_x = x;
                result.worst_y = y;
            }
        }
    }
    const int counted = result.pixels - result.not_finite;
    result.rmse = counted > 0 ? std::sqrt(squares / counted) : 0;
    const int allowed = std::max(least_allowed, static_cast<int>(kSilhouetteShare * result.pixels));
    result.problem = problem_of(result, allowed);
    result.passed = result.problem.empty();
    return result;
}

}  // namespace rays::grader
