// count-rays SCENE WIDTH HEIGHT: prints how many rays the tree of a picture has, shadow rays left out, and how many of
// them were cut off and not traced; POV-Ray's "Rays" are all of them. One sample a pixel.
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "core/query_log.h"
#include "renderer/radiance.h"
#include "renderer/render.h"
#include "scene_reader/scene_reader.h"

namespace {

using namespace rays;

struct Count {
    unsigned long long all = 0, cut_off = 0;
};

Count count(const char* file, Raster raster) {
    ReadOptions options;
    options.raster = raster;
    Scene scene = read_scene(file, options);
    prepare(scene);
    const auto intersector = make_intersector(scene, Partition::automatic);
    World world = make_world(scene, *intersector);
    const Inside inside = world.sees_through ? media_around(scene, scene.camera.location) : Inside();
    Count result;
    for (int y = 0; y < raster.height; ++y) {
        for (int x = 0; x < raster.width; ++x) {
            QueryLog log;
            query_log = &log;
            radiance(world, camera_ray(scene.camera, raster, x, y), inside);
            query_log = nullptr;
            for (const auto& query : log.queries) {
                result.all += query.kind != "shadow";
                result.cut_off += query.pruned;
            }
        }
    }
    return result;
}

}  // namespace

int main(int argc, char** argv) {
    const Raster raster{argc == 4 ? std::atoi(argv[2]) : 0, argc == 4 ? std::atoi(argv[3]) : 0};
    if (raster.width < 1 || raster.height < 1) {
        std::fputs("count-rays SCENE WIDTH HEIGHT\n", stderr);
        return 2;
    }
    try {
        const Count rays = count(argv[1], raster);
        std::printf("%llu %llu\n", rays.all, rays.cut_off);
        return 0;
    } catch (const std::exception& e) {
        std::fprintf(stderr, "count-rays: %s\n", e.what());
        return 2;
    }
}
