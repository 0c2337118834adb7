#include "renderer/cost_map.h"

#include <fmt/format.h>

#include <atomic>
#include <thread>

#include "1_ray_casting/ray_casting.h"
#include "4_partitioning/structures.h"
#include "core/exr_file.h"
#include "renderer/radiance.h"

namespace rays {
namespace {

std::unique_ptr<Intersector> counted_structure(const Scene& scene, Partition partition) {
    if (partition == Partition::automatic) partition = choose_partition(scene);
    auto structure = partition == Partition::none ? nullptr : make_structure(scene, partition);
    return structure ? std::move(structure) : make_exhaustive(scene);
}

Inside media_at(const World& world, const Vec3& point) {
    return world.filtered_shadows ? media_around(world.scene, point) : Inside();
}

}  // namespace

Film cost_map(const Scene& scene, const RenderOptions& options) {
    Film map(options.raster);
    const auto structure = counted_structure(scene, options.partition);
    const World prototype = make_world(scene, *structure);
    std::atomic<int> next_row{0};
    const auto work = [&] {
        World world = prototype;
        for (int y = next_row++; y < options.raster.height; y = next_row++) {
            for (int x = 0; x < options.raster.width; ++x) {
                const Ray ray = camera_ray(scene.camera, options.raster, x, y);
                const Inside media = media_at(world, ray.origin);
                EffortCount count;
                radiance(world, ray, media);
                const Effort& spent = count.so_far();
                map.at(x, y) = Radiance(static_cast<float>(spent.tests), static_cast<float>(spent.nodes), 0.0f);
            }
        }
    };
    const int wanted = options.threads > 0 ? options.threads : static_cast<int>(std::thread::hardware_concurrency());
    std::vector<std::jthread> helpers;
    for (int i = 1; i < std::min(wanted, options.raster.height); ++i) helpers.emplace_back(work);
    work();
    helpers.clear();
    return map;
}

void write_cost_map(const Film& map, const std::string& path) { write_exr(map, path, {"tests", "nodes"}); }

Visit visit_of(const Scene& scene, const RenderOptions& options, int column, int row) {
    const auto structure = counted_structure(scene, options.partition);
    Visit visit;
    EffortCount count;
    count.so_far().visited = &visit.boxes;
    structure->nearest(camera_ray(scene.camera, options.raster, column, row), {0, kInfinity});
    visit.effort = count.so_far();
    visit.effort.visited = nullptr;
    return visit;
}

std::string visit_to_json(const Visit& visit) {
    std::string boxes;
    for (const Bounds& b : visit.boxes)
        boxes += fmt::format("{}[{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}]", boxes.empty() ? "" : ",", b.min.x,
                             b.min.y, b.min.z, b.max.x, b.max.y, b.max.z);
    return fmt::format(R"({{"tests":{},"nodes":{},"visited":[{}]}})", visit.effort.tests, visit.effort.nodes, boxes);
}

}  // namespace rays
