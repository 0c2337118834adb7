// Noisy pictures of a known mean, invented: what a distributed ray tracer's noise is like, and what is worse.
#pragma once

#include <cstdint>
#include <string>

#include "grader/statistics.h"

namespace rays::grader {

/// Of single samples, relative to the pixel's mean.
struct Noise {
    std::string name;
    double deviation = 0.5;          ///< of a sample, Gaussian
    double edge_deviation = 0.5;     ///< in one of ten pixels, on lines across the picture
    double firefly_rate = 0;         ///< share of the samples ...
    double firefly = 60;             ///< ... that are so many times as bright
    double reference_error = 0.002;  ///< one number for all pixels of the reference, as its frames share theirs
};

/// What is wrong with a student's picture.
struct Bias {
    std::string name;
    double everywhere = 0;         ///< +0.02: 2 % too bright
    bool one_channel = false;      ///< only in green
    double blob = 0;               ///< -0.1: 10 % too dark in a square of 16 x 16 pixels ...
    int blob_x = 40, blob_y = 32;  ///< ... from here on
    double noise = 1;              ///< the standard deviation is so many times as large
};

class Generator {
public:
    explicit Generator(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15u + 0x1234567u) {}
    double uniform();  ///< in (0, 1)
    double normal();   ///< in steps finer than a picture's, and no farther out than 4.2
    int poisson(double mean);

private:
    std::uint64_t bits();
    std::uint64_t state_;
};

inline constexpr Raster kInventedRaster{96, 72};

RgbImage invented_mean(const Noise& noise);
AveragedReference invented_reference(const RgbImage& mean, const Noise& noise, Generator& random);
Pictures invented_pictures(const RgbImage& mean, const Noise& noise, const Bias& bias, int seeds, int samples,
                           Generator& random);

}  // namespace rays::grader
