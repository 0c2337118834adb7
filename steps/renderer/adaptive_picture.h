// A picture that is sampled until every pixel is good enough.
#pragma once

#include <vector>

#include "renderer/distribute.h"
#include "renderer/rows.h"

namespace rays {

class AdaptivePicture {
public:
    /// All pixels are active: nobody has a sample.
    AdaptivePicture(const Distribution& distribution, Residuals& residuals);

    /// One more round for row y: active pixels get samples up to `after` in all. Rows may be sampled by several
    /// threads.
    void sample_row(SampleTracer& tracer, int y, std::uint32_t before, std::uint32_t after);
    /// Who has to go on to reach this standard error? Returns how many.
    std::size_t choose(float wanted);
    void finish(Film& film);
    /// Of a pixel.
    double mean_samples() const;

private:
    std::size_t index(int x, int y) const { return std::size_t(y) * std::size_t(raster_.width) + std::size_t(x); }

    const Distribution& distribution_;
    Raster raster_;
    Residuals& residuals_;
    std::vector<Estimate> pixels_;
    std::vector<char> active_, unfinished_;
    std::vector<double> pruned_;
};

}  // namespace rays
