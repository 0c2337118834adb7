#include "renderer/adaptive_picture.h"

#include <algorithm>

#include "core/unfinished.h"

namespace rays {
namespace {

/// Which of the four groups a sample of the round belongs to that makes `before` samples `after`: each group gets a run
/// of neighbours, which are stratified among themselves.
std::uint32_t group_of(std::uint32_t sample, std::uint32_t before, std::uint32_t after) {
    return (sample - before) * Estimate::kGroups / (after - before);
}

}  // namespace

AdaptivePicture::AdaptivePicture(const Distribution& distribution, Residuals& residuals)
    : distribution_(distribution),
      raster_(distribution.options().raster),
      residuals_(residuals),
      pixels_(std::size_t(raster_.width) * std::size_t(raster_.height)),
      active_(pixels_.size(), 1),
      unfinished_(pixels_.size(), 0),
      pruned_(pixels_.size(), 0) {}

void AdaptivePicture::sample_row(SampleTracer& tracer, int y, std::uint32_t before, std::uint32_t after) {
    const auto add = [&](std::uint32_t number, const Radiance& brought, double pruned) {
        const auto x = static_cast<int>(number / Estimate::kGroups);
        pixels_[index(x, y)].sum[number % Estimate::kGroups] += brought;
        pruned_[index(x, y)] += pruned;
    };
    for (int x = 0; x < raster_.width; ++x) {
        if (!active_[index(x, y)]) continue;
        const auto number = [&](std::uint32_t sample) {
            return static_cast<std::uint32_t>(x) * Estimate::kGroups + group_of(sample, before, after);
        };
        tracer.add(x, y, distribution_.draw(x, y, before, after), after, number, add);
        pixels_[index(x, y)].samples = after;
        if (take_unfinished_task()) unfinished_[index(x, y)] = 1;
    }
    tracer.flush(add);
}

std::size_t AdaptivePicture::choose(float wanted) {
    std::vector<float> errors(pixels_.size());
    for (std::size_t i = 0; i < errors.size(); ++i) errors[i] = standard_error(pixels_[i]);
    std::size_t left = 0;
    for (int y = 0; y < raster_.height; ++y)
        for (int x = 0; x < raster_.width; ++x) {
            float around[8];
            std::size_t count = 0;
            for (int v = std::max(0, y - 1); v <= std::min(raster_.height - 1, y + 1); ++v)
                for (int u = std::max(0, x - 1); u <= std::min(raster_.width - 1, x + 1); ++u)
                    if (u != x || v != y) around[count++] = errors[index(u, v)];
            auto& active = active_[index(x, y)];
            active = active && !is_enough(errors[index(x, y)], {around, count}, wanted);
            left += active;
        }
    take_unfinished_task();
    return left;
}

void AdaptivePicture::finish(Film& film) {
    for (int y = 0; y < raster_.height; ++y)
        for (int x = 0; x < raster_.width; ++x) {
            const Radiance mean = pixels_[index(x, y)].mean();
            film.at(x, y) = unfinished_[index(x, y)] ? striped(mean, x, y) : mean;
            residuals_.add(x, y, pruned_[index(x, y)] / pixels_[index(x, y)].samples);
        }
}

double AdaptivePicture::mean_samples() const {
    double all = 0;
    for (const Estimate& pixel : pixels_) all += pixel.samples;
    return all / double(pixels_.size());
}

}  // namespace rays
