#include "renderer/render.h"

#include <algorithm>
#include <cmath>
#include <thread>
#include <vector>

#include "1_ray_casting/ray_casting.h"
#include "core/unfinished.h"
#include "renderer/brute_force.h"
#include "renderer/radiance.h"

namespace rays {
namespace {

// Magenta stripes over half of what is there: the finished parts stay visible. What was computed from an unfinished
// function's empty answer may be NaN, a picture may not.
Radiance striped(const Radiance& value, int x, int y) {
    const bool stripe = (x + y) / 4 % 2 == 0;
    return (value.is_finite() ? 0.5f * value : Radiance()) + (stripe ? Radiance(0.5f, 0.0f, 0.4f) : Radiance(0.05f));
}

Radiance render_pixel(const Scene& scene, const Intersector& intersector, const RenderOptions& options, int x, int y) {
    const int side = static_cast<int>(std::lround(std::sqrt(options.samples)));
    Radiance sum;
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            const Vec2 offset((i + Real(0.5)) / side - Real(0.5), (j + Real(0.5)) / side - Real(0.5));
            sum += radiance(scene, intersector, camera_ray(scene.camera, options.raster, x, y, offset));
        }
    }
    sum *= 1.0f / static_cast<float>(side * side);
    return take_unfinished_task() ? striped(sum, x, y) : sum;
}

}  // namespace

void prepare(Scene& scene) {
    for (Polygon& polygon : scene.polygons) prepare(polygon);
    for (Mesh& mesh : scene.meshes) prepare(mesh);
    for (BicubicPatch& patch : scene.patches) prepare(patch);
    take_unfinished_task();
}

Film render(const Scene& scene, const RenderOptions& options) {
    Film film(options.raster);
    const BruteForce intersector(scene);
    std::atomic<int> next_row{0};
    const auto work = [&](bool reports) {
        for (int y = next_row++; y < options.raster.height; y = next_row++) {
            for (int x = 0; x < options.raster.width; ++x)
                film.at(x, y) = render_pixel(scene, intersector, options, x, y);
            if (reports && options.progress) options.progress(double(y + 1) / options.raster.height);
        }
    };
    const int wanted = options.threads > 0 ? options.threads : static_cast<int>(std::thread::hardware_concurrency());
    std::vector<std::jthread> helpers;
    for (int i = 1; i < std::min(wanted, options.raster.height); ++i) helpers.emplace_back(work, false);
    work(true);
    helpers.clear();
    return film;
}

QueryLog explain(const Scene& scene, const Raster& raster, int column, int row) {
    QueryLog log;
    const BruteForce intersector(scene);
    query_log = &log;
    radiance(scene, intersector, camera_ray(scene.camera, raster, column, row));
    query_log = nullptr;
    return log;
}

}  // namespace rays
