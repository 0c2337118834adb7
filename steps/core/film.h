// The picture: linear radiance, one value a pixel, rows from top to bottom.
#pragma once

#include <algorithm>
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

/// Where a picture goes as it is finished. What lies in the cache is still at hand; a whole film has to be fetched
/// back.
class FilmLines {
public:
    virtual ~FilmLines() = default;
    /// The picture's lines from `first` on, as wide as it is: each line once, in any order, from any thread. Does not
    /// throw.
    virtual void take(const Film& lines, int first) noexcept = 0;
};

/// A picture on disk that is being written. It appears whole or not at all.
class PictureFile : public FilmLines {
public:
    /// All lines are there. Throws InputError when the file cannot be written.
    virtual void finish() = 0;
};

/// A picture in memory.
struct WholeFilm final : FilmLines {
    explicit WholeFilm(Raster raster) : film(raster) {}
    void take(const Film& lines, int first) noexcept override {
        for (int y = 0; y < lines.raster().height; ++y)
            std::copy_n(&lines.at(0, y), lines.raster().width, &film.at(0, first + y));
    }
    Film film;
};

}  // namespace rays
