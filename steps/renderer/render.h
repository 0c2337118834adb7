// From a scene to a picture.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>

#include "core/film.h"
#include "core/query_log.h"
#include "core/scene.h"

namespace rays {

struct RenderOptions {
    Raster raster;
    int samples = 1;  ///< a square number: a regular grid in the pixel. 1: the pixel's centre.
    std::uint64_t seed = 0;
    int threads = 0;  ///< 0: one a core
    std::function<void(double done)> progress;  ///< called now and then from one thread, 0 <= done <= 1
};

/// Computes once what shapes use for every ray. Before anything else is asked about a scene.
void prepare(Scene& scene);

/// The same bytes for any number of threads. Pixels that needed an unfinished task are striped.
Film render(const Scene& scene, const RenderOptions& options);

/// Every ray asked for one pixel (one sample at its centre).
QueryLog explain(const Scene& scene, const Raster& raster, int column, int row);

}  // namespace rays
