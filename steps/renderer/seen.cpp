#include "renderer/seen.h"

#include <fmt/format.h>

#include "1_ray_casting/ray_casting.h"

namespace rays {
namespace {

// In the order of ShapeKind.
constexpr std::array<const char*, kShapeKinds> kNames{"spheres",  "planes",   "triangles", "smooth_triangles",
                                                      "polygons", "meshes",   "boxes",     "discs",
                                                      "cones",    "quadrics", "tori",      "patches"};

}  // namespace

std::array<std::int64_t, kShapeKinds> shapes_seen(const Scene& scene, const RenderOptions& options) {
    std::array<std::int64_t, kShapeKinds> seen{};
    const auto intersector = make_intersector(scene, options.partition);
    for (int y = 0; y < options.raster.height; ++y)
        for (int x = 0; x < options.raster.width; ++x) {
            const Ray ray = camera_ray(scene.camera, options.raster, x, y);
            if (const auto hit = intersector->nearest(ray, {0, kInfinity}))
                ++seen[static_cast<std::size_t>(scene.objects[hit->object].kind)];
        }
    return seen;
}

std::string seen_to_json(const std::array<std::int64_t, kShapeKinds>& seen) {
    std::string json;
    for (std::size_t kind = 0; kind < kShapeKinds; ++kind)
        json += fmt::format(R"({}"{}":{})", json.empty() ? "" : ",", kNames[kind], seen[kind]);
    return fmt::format(R"({{"seen":{{{}}}}})", json) + "\n";
}

}  // namespace rays
