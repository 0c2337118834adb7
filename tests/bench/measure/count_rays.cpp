// count-rays SCENE WIDTH HEIGHT: prints how many rays the picture takes, shadow rays left out: what POV-Ray counts as
// "Rays". One sample a pixel.
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "renderer/radiance.h"
#include "renderer/render.h"
#include "scene_reader/scene_reader.h"

namespace {

using namespace rays;

/// Passes questions on. Rays of the tree look from kNearest to kFarthest; shadow rays never do.
class Counting final : public Intersector {
public:
    explicit Counting(const Intersector& other) : other_(other) {}
    unsigned long long rays() const { return rays_; }

private:
    std::optional<Hit> find_nearest(const Ray& ray, Interval range) const override {
        rays_ += range.min == kNearest && range.max == kFarthest;
        return other_.nearest(ray, range);
    }
    bool find_occluder(const Ray& ray, Interval range) const override { return other_.occluded(ray, range); }

    const Intersector& other_;
    mutable unsigned long long rays_ = 0;  // one thread asks
};

unsigned long long count(const char* file, Raster raster) {
    ReadOptions options;
    options.raster = raster;
    Scene scene = read_scene(file, options);
    prepare(scene);
    const auto intersector = make_intersector(scene, Partition::automatic);
    const Counting counting(*intersector);
    World world = make_world(scene, counting);
    const Inside inside = world.sees_through ? media_around(scene, scene.camera.location) : Inside();
    for (int y = 0; y < raster.height; ++y)
        for (int x = 0; x < raster.width; ++x) radiance(world, camera_ray(scene.camera, raster, x, y), inside);
    return counting.rays();
}

}  // namespace

int main(int argc, char** argv) {
    const Raster raster{argc == 4 ? std::atoi(argv[2]) : 0, argc == 4 ? std::atoi(argv[3]) : 0};
    if (raster.width < 1 || raster.height < 1) {
        std::fputs("count-rays SCENE WIDTH HEIGHT\n", stderr);
        return 2;
    }
    try {
        std::printf("%llu\n", count(argv[1], raster));
        return 0;
    } catch (const std::exception& e) {
        std::fprintf(stderr, "count-rays: %s\n", e.what());
        return 2;
    }
}
