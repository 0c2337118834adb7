// Step 4, spatial partitioning: what is partitioned, the one test of a primitive, and the choice.
#include "4_partitioning/partitioning.h"

#include "4_partitioning/primitive_tester.h"
#include "4_partitioning/structures.h"
#include "core/unfinished.h"

namespace rays {

//> given
constinit thread_local Effort* effort = nullptr;

std::vector<Primitive> primitives_of(const Scene& scene) {
    std::vector<Primitive> primitives;
    for (std::uint32_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        const std::size_t parts = object.kind == ShapeKind::mesh ? scene.meshes[object.shape].faces.size() : 1;
        for (std::uint32_t part = 0; part < parts; ++part) primitives.push_back({i, part});
    }
    return primitives;
}

PrimitiveTester::PrimitiveTester(const Scene& scene) : scene_(&scene) {
    const auto way_of = [](const Object& object) {
        if (object.transform != kNone || object.clip != kNone) return Way::other;
        switch (object.kind) {
            case ShapeKind::sphere: return Way::sphere;
            case ShapeKind::mesh: return Way::face;
            case ShapeKind::triangle: return Way::triangle;
            case ShapeKind::cone: return Way::cone;
            case ShapeKind::plane: return Way::plane;
            default: return Way::other;
        }
    };
    const std::vector<Primitive> primitives = primitives_of(scene);
    dispatch_.reserve(primitives.size());
    for (const Primitive& p : primitives) {
        const Object& object = scene.objects[p.object];
        const bool iterated = object.kind == ShapeKind::torus || object.kind == ShapeKind::bicubic_patch;
        dispatch_.push_back({p, object.shape, way_of(object), iterated, !object.no_shadow});
    }
}

std::optional<Partition> partition_named(std::string_view name) {
    if (name == "auto") return Partition::automatic;
    if (name == "none") return Partition::none;
    if (name == "grid") return Partition::grid;
    if (name == "octree") return Partition::octree;
    if (name == "bvh") return Partition::bvh;
    return std::nullopt;
}

//< given

Partition choose_partition(const Scene& scene) {
    //> 4.9 none for a few primitives, where asking all is fastest; else the fastest structure. Measure where they cross.
    std::size_t primitives = 0;
    for (const Object& object : scene.objects)
        primitives += object.kind == ShapeKind::mesh ? scene.meshes[object.shape].faces.size() : 1;
    return primitives <= kCrossover ? Partition::none : Partition::bvh;
    //< 4.9
}

//> given
namespace {

class Exhaustive final : public Intersector {
public:
    explicit Exhaustive(const Scene& scene) : tester_(scene) {}

private:
    std::optional<Hit> find_nearest(const Ray& ray, Interval range) const override {
        Candidate best;
        if (!is_ray(ray)) return std::nullopt;
        for (std::uint32_t i = 0; i < tester_.size(); ++i) tester_.keep_nearer(i, ray, range, best);
        return tester_.complete(ray, best);
    }
    bool find_occluder(const Ray& ray, Interval range) const override {
        for (std::uint32_t i = 0; is_ray(ray) && i < tester_.size(); ++i)
            if (tester_.blocks(i, ray, range)) return true;
        return false;
    }

    PrimitiveTester tester_;
};

}  // namespace

std::unique_ptr<Intersector> make_exhaustive(const Scene& scene) { return std::make_unique<Exhaustive>(scene); }

std::unique_ptr<Intersector> make_structure(const Scene& scene, Partition partition) {
    switch (partition) {
        case Partition::grid: return make_grid(scene);
        case Partition::octree: return make_octree(scene);
        case Partition::bvh: return make_bvh(scene);
        case Partition::automatic:
        case Partition::none: break;
    }
    return nullptr;
}
//< given

}  // namespace rays
