// From a scene to a picture.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "4_partitioning/partitioning.h"
#include "5_distributed/distributed.h"
#include "core/film.h"
#include "core/query_log.h"
#include "core/scene.h"

namespace rays {

struct RenderOptions {
    Raster raster;
    int samples = 1;  ///< a pixel
    /// Nothing: a regular grid in the pixel (1: its centre) where that shows the scene and the number is a square; else
    /// Sobol points.
    std::optional<Pattern> pattern;
    Filter filter = Filter::box;
    float error =
        0;  ///< > 0: pixels stop when their standard error is no larger; `samples` is the most, needs sobol or random
    std::uint64_t seed = 0;
    int threads = 0;  ///< 0: one a core
    Partition partition = Partition::automatic;
    bool packets = true;  ///< neighbouring rays together, where the program can and the partition is automatic
    std::function<void(double done)> progress;  ///< called now and then from one thread, 0 <= done <= 1
};

/// Computes once what shapes use for every ray. Before anything else is asked about a scene.
void prepare(Scene& scene);

/// What finds hits in a prepared scene. The scene must outlive it.
std::unique_ptr<Intersector> make_intersector(const Scene& scene, Partition partition);

/// What pruning leaves open: a pixel may lack at most its residual times the brightest radiance of the scene.
struct Residual {
    double mean = 0, max = 0;
    int x = 0, y = 0;    ///< the pixel of the largest
    double samples = 1;  ///< a pixel, in the mean
};

/// Does the picture take random samples, for the scene's sake or by wish?
bool is_distributed(const Scene& scene, const RenderOptions& options);

/// The same bytes for any number of threads. Pixels that needed an unfinished task are striped.
void render(const Scene& scene, const RenderOptions& options, FilmLines& picture, Residual* residual = nullptr);
Film render(const Scene& scene, const RenderOptions& options, Residual* residual = nullptr);

/// Every ray asked for one pixel: of one sample at its centre, or of the first sample where the scene is distributed
/// over.
QueryLog explain(const Scene& scene, const RenderOptions& options, int column, int row);

}  // namespace rays
