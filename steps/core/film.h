// The picture: linear radiance, one value a pixel, rows from top to bottom.
#pragma once

#include <string>
#include <vector>

#include "core/camera.h"
#include "core/large_pages.h"
#include "core/radiance.h"

namespace rays {

class Film {
public:
    explicit Film(Raster raster)
        : raster_(raster), pixels_(static_cast<std::size_t>(raster.width) * static_cast<std::size_t>(raster.height)) {}

    const Raster& raster() const { return raster_; }
    Radiance& at(int x, int y) { return pixels_[index(x, y)]; }
    const Radiance& at(int x, int y) const { return pixels_[index(x, y)]; }

private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(raster_.width) + static_cast<std::size_t>(x);
    }
    Raster raster_;
    LargeVector<Radiance> pixels_;
};

/// Writes the lanes that have a name, R, G and B as a rule, as 32-bit floats. The file appears whole or not at all.
/// Throws InputError when it cannot be written.
void write_exr(const Film& film, const std::string& path, const std::vector<std::string>& lanes = {"R", "G", "B"});

}  // namespace rays
