#include "invented_noise.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace rays::grader {
namespace {

constexpr int kNormals = 1 << 16;

// The inverse of the normal distribution at the middles of equal shares. Not a lambda: a compiler may try to compute
// those when it compiles, which took GCC a minute.
std::vector<float> make_normals() {
    std::vector<float> table;
    for (int i = 0; i < kNormals; ++i) {
        double low = -6, high = 6;
        for (int k = 0; k < 50; ++k) {
            const double middle = 0.5 * (low + high);
            (0.5 * std::erfc(-middle / std::sqrt(2.0)) < (i + 0.5) / kNormals ? low : high) = middle;
        }
        table.push_back(static_cast<float>(low));
    }
    return table;
}

const std::vector<float>& normals() {
    static const auto table = make_normals();
    return table;
}

bool on_edge(int x, int y) { return (x + 2 * y) % 40 < 4; }

bool in_blob(const Bias& b, int x, int y) {
    return x >= b.blob_x && x < b.blob_x + 16 && y >= b.blob_y && y < b.blob_y + 16;
}

}  // namespace

std::uint64_t Generator::bits() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
}

double Generator::uniform() { return (double(bits() >> 11) + 0.5) * 0x1p-53; }

double Generator::normal() { return double(normals()[bits() >> 48]); }

int Generator::poisson(double mean) {
    // In pieces, so that exp does not underflow.
    int count = 0;
    for (; mean > 0; mean -= 30) {
        double product = uniform();
        for (const double end = std::exp(-std::min(mean, 30.0)); product > end; product *= uniform()) ++count;
    }
    return count;
}

// A bright and a dark half, a gradient, and channels of different strength.
RgbImage invented_mean(const Noise& noise) {
    RgbImage picture{kInventedRaster, {}};
    for (int y = 0; y < kInventedRaster.height; ++y) {
        for (int x = 0; x < kInventedRaster.width; ++x) {
            const double u = double(x) / kInventedRaster.width, v = double(y) / kInventedRaster.height;
            const double light =
                (u + 0.3 * v < 0.5 ? 0.9 - 0.6 * v : 0.06 + 0.2 * u) * (1 + (noise.firefly - 1) * noise.firefly_rate);
            picture.pixels.push_back({float(light), float(0.8 * light), float((0.5 + 0.3 * v) * light)});
        }
    }
    return picture;
}

AveragedReference invented_reference(const RgbImage& mean, const Noise& noise, Generator& random) {
    AveragedReference truth{mean, mean};
    const double error = noise.reference_error * random.normal();
    for (std::size_t i = 0; i < mean.pixels.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            truth.mean.pixels[i][c] = float(double(mean.pixels[i][c]) * (1 + error));
            truth.error.pixels[i][c] = float(noise.reference_error * double(mean.pixels[i][c]));
        }
    }
    return truth;
}

Pictures invented_pictures(const RgbImage& mean, const Noise& noise, const Bias& bias, int seeds, int samples,
                           Generator& random) {
    const double root = std::sqrt(double(samples)), lift = 1 + (noise.firefly - 1) * noise.firefly_rate;
    const auto pixels = double(mean.pixels.size());
    Pictures pictures;
    for (int s = 0; s < seeds; ++s) {
        RgbImage picture = mean;
        for (int y = 0; y < mean.raster.height; ++y) {
            for (int x = 0; x < mean.raster.width; ++x) {
                const double deviation = bias.noise * (on_edge(x, y) ? noise.edge_deviation : noise.deviation) / root;
                const double common = random.normal();
                // Most of the noise is brightness; a part of it is each channel's own.
                for (float& v : picture.at(x, y))
                    v = float(double(v) * (1 + deviation * (0.9 * common + 0.436 * random.normal())) / lift);
            }
        }
        for (int i = random.poisson(pixels * samples * noise.firefly_rate); i > 0; --i) {
            const auto at = std::min(static_cast<std::size_t>(random.uniform() * pixels), mean.pixels.size() - 1);
            for (std::size_t c = 0; c < 3; ++c)
                picture.pixels[at][c] += float((noise.firefly - 1) * double(mean.pixels[at][c]) / lift / samples);
        }
        for (int y = 0; y < mean.raster.height; ++y)
            for (int x = 0; x < mean.raster.width; ++x)
                for (std::size_t c = 0; c < 3; ++c)
                    picture.at(x, y)[c] *= float((bias.one_channel && c != 1 ? 1 : 1 + bias.everywhere) *
                                                 (in_blob(bias, x, y) ? 1 + bias.blob : 1));
        pictures.push_back(std::move(picture));
    }
    return pictures;
}

}  // namespace rays::grader
