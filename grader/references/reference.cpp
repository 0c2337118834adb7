#include "references/reference.h"

#include <algorithm>
#include <stdexcept>

namespace rays {
namespace {

constexpr int kFine = 4;            // fine pixels per pixel, in each direction
constexpr int kMargin = kFine / 2;  // fine pixels in half a pixel

}  // namespace

bool Reference::silhouette(int x, int y) const {
    for (std::size_t c = 0; c < 3; ++c) {
        const float low = min.at(x, y)[c];
        const float high = max.at(x, y)[c];
        if (!(high - low <= half_rounding(low) + half_rounding(high))) return true;
    }
    return false;
}

bool Reference::within_envelope(int x, int y, const Rgb& color) const {
    for (std::size_t c = 0; c < 3; ++c) {
        const float low = min.at(x, y)[c];
        const float high = max.at(x, y)[c];
        if (!(color[c] >= low - half_rounding(low) && color[c] <= high + half_rounding(high))) return false;
    }
    return true;
}

Reference make_reference(RgbImage frame, const RgbImage& fine) {
    const Raster& raster = frame.raster;
    if (fine.raster.width != kFine * raster.width || fine.raster.height != kFine * raster.height) {
        throw std::invalid_argument("the fine frame must have 4 x 4 as many pixels");
    }
    Reference result{frame, frame, std::move(frame)};
    for (int y = 0; y < result.raster().height; ++y) {
        for (int x = 0; x < result.raster().width; ++x) {
            Rgb& low = result.min.at(x, y);
            Rgb& high = result.max.at(x, y);
            const int y_end = std::min(kFine * (y + 1) + kMargin, fine.raster.height);
            const int x_end = std::min(kFine * (x + 1) + kMargin, fine.raster.width);
            for (int fy = std::max(kFine * y - kMargin, 0); fy < y_end; ++fy) {
                for (int fx = std::max(kFine * x - kMargin, 0); fx < x_end; ++fx) {
                    for (std::size_t c = 0; c < 3; ++c) {
                        low[c] = std::min(low[c], fine.at(fx, fy)[c]);
                        high[c] = std::max(high[c], fine.at(fx, fy)[c]);
                    }
                }
            }
        }
    }
    return result;
}

}  // namespace rays
