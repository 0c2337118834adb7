// What every way of making a picture shares: marks for unfinished tasks, residuals row by row.
#pragma once

#include <vector>

#include "core/camera.h"
#include "core/radiance.h"
#include "renderer/render.h"

namespace rays {

/// Magenta stripes over half of what is there: the finished parts stay visible. What was computed from an unfinished
/// function's empty answer may be NaN, a picture may not.
inline Radiance striped(const Radiance& value, int x, int y) {
    const bool stripe = (x + y) / 4 % 2 == 0;
    return (value.is_finite() ? 0.5f * value : Radiance()) + (stripe ? Radiance(0.5f, 0.0f, 0.4f) : Radiance(0.05f));
}

/// The residuals of a picture, row by row: their sum is the same for any number of threads.
class Residuals {
public:
    explicit Residuals(int rows) : rows_(static_cast<std::size_t>(rows)) {}

    void add(int x, int y, double pruned) {
        Row& row = rows_[static_cast<std::size_t>(y)];
        row.sum += pruned;
        if (pruned > row.max) row.max = pruned, row.x = x;
    }
    Residual over(Raster raster) const {
        Residual all;
        for (std::size_t y = 0; y < rows_.size(); ++y) {
            all.mean += rows_[y].sum;
            if (rows_[y].max > all.max) all.max = rows_[y].max, all.x = rows_[y].x, all.y = static_cast<int>(y);
        }
        all.mean /= double(raster.width) * raster.height;
        return all;
    }

private:
    struct Row {
        double sum = 0, max = 0;
        int x = 0;
    };
    std::vector<Row> rows_;
};

}  // namespace rays
