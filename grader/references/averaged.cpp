#include "references/averaged.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/error.h"
#include "references/exr_layers.h"

namespace rays {
namespace {

// Mean and error were rounded to floats.
constexpr double kRounding = std::numeric_limits<float>::epsilon();

std::size_t numbers_of(Raster raster) {
    return 3 * static_cast<std::size_t>(raster.width) * static_cast<std::size_t>(raster.height);
}

}  // namespace

double rms_error(const AveragedReference& reference) {
    double sum = 0;
    for (const Rgb& pixel : reference.error.pixels) {
        for (const double error : pixel) sum += error * error;
    }
    return std::sqrt(sum / static_cast<double>(numbers_of(reference.raster())));
}

void save_averaged_reference(const AveragedReference& reference, const std::filesystem::path& file) {
    save_layers(file, {{"", &reference.mean}, {"error.", &reference.error}}, Digits::single);
}

AveragedReference load_averaged_reference(const std::filesystem::path& file) {
    AveragedReference result;
    load_layers(file, {{"", &result.mean}, {"error.", &result.error}});
    for (std::size_t i = 0; i < result.mean.pixels.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            const float mean = result.mean.pixels[i][c], error = result.error.pixels[i][c];
            if (std::isfinite(mean) && std::isfinite(error) && error >= 0) continue;
            throw InputError(fmt::format("{}: number {} of pixel {} is {} with a standard error of {}", file.string(),
                                         c, i, mean, error));
        }
    }
    return result;
}

FrameSums::FrameSums(Raster raster) : raster_(raster) {
    for (std::vector<double>& sum : sums_) sum.assign(numbers_of(raster), 0.0);
}

void FrameSums::add(int replicate, const RgbImage& frame) {
    if (frame.raster.width != raster_.width || frame.raster.height != raster_.height)
        throw std::invalid_argument("a frame of another size");
    for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
        for (const float number : frame.pixels[i]) {
            if (!std::isfinite(number)) throw std::invalid_argument(fmt::format("pixel {} is {}", i, number));
        }
    }
    std::vector<double>& sum = sums_.at(static_cast<std::size_t>(replicate));
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += frame.pixels[i / 3][i % 3];
    ++counts_[static_cast<std::size_t>(replicate)];
}

std::vector<double> FrameSums::replicate_mean(int replicate) const {
    std::vector<double> result = sums_.at(static_cast<std::size_t>(replicate));
    for (double& number : result) number /= counts_[static_cast<std::size_t>(replicate)];
    return result;
}

AveragedReference FrameSums::result() const {
    std::array<std::vector<double>, kReplicates> means;
    for (int r = 0; r < kReplicates; ++r) means[static_cast<std::size_t>(r)] = replicate_mean(r);
    AveragedReference result;
    result.mean = {raster_, std::vector<Rgb>(means[0].size() / 3)};
    result.error = result.mean;
    for (std::size_t i = 0; i < means[0].size(); ++i) {
        double sum = 0, squares = 0;
        for (const std::vector<double>& mean : means) sum += mean[i];
        const double mean = sum / kReplicates;
        for (const std::vector<double>& replicate : means) squares += (replicate[i] - mean) * (replicate[i] - mean);
        result.mean.pixels[i / 3][i % 3] = static_cast<float>(mean);
        result.error.pixels[i / 3][i % 3] = static_cast<float>(std::sqrt(squares / (kReplicates * (kReplicates - 1))));
    }
    return result;
}

std::string difference_of_replicate(const AveragedReference& reference, const std::vector<double>& replicate) {
    if (replicate.size() != numbers_of(reference.raster()))
        return fmt::format("the size is {} x {}, no longer", reference.raster().width, reference.raster().height);
    int count = 0;
    std::string first;
    for (std::size_t i = 0; i < replicate.size(); ++i) {
        const double mean = reference.mean.pixels[i / 3][i % 3], error = reference.error.pixels[i / 3][i % 3];
        const double most = (1 + kRounding) * kFurthestReplicate * error + kRounding * std::abs(mean);
        if (std::abs(replicate[i] - mean) <= most) continue;
        if (count++ > 0) continue;
        const std::size_t pixel = i / 3, width = static_cast<std::size_t>(reference.raster().width);
        first = fmt::format("channel {} of pixel {},{} was {:.6g} +- {:.2g}, is {:.6g}", "RGB"[i % 3], pixel % width,
                            pixel / width, mean, error, replicate[i]);
    }
    if (count == 0) return "";
    return fmt::format("{} of {} numbers are further from the mean than any replicate was; {}", count, replicate.size(),
                       first);
}

}  // namespace rays
