// Step 4, spatial partitioning: what is partitioned, the one test of a primitive, and the choice.
#include "4_partitioning/partitioning.h"

#include <cmath>

#include "4_partitioning/effort.h"
#include "4_partitioning/structures.h"
#include "core/unfinished.h"

namespace rays {

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

PrimitiveTester::PrimitiveTester(const Scene& scene) : scene_(&scene), primitives_(primitives_of(scene)) {
    dispatch_.reserve(primitives_.size());
    for (const Primitive& p : primitives_) {
        const Object& object = scene.objects[p.object];
        const bool plain = object.transform == kNone && object.clip == kNone;
        dispatch_.push_back({object.shape, object.kind, plain, !object.no_shadow});
    }
}

// Most primitives of large scenes are plain spheres, faces, triangles and cones, and most scenes have a floor: these are
// asked without detours.
std::optional<Root> PrimitiveTester::intersect_one(std::uint32_t primitive, const Ray& ray, Interval range) const {
    if (effort) [[unlikely]]
        ++effort->tests;
    const Dispatch& d = dispatch_[primitive];
    const Primitive p = primitives_[primitive];
    if (d.plain) {
        if (d.kind == ShapeKind::sphere) return intersect(scene_->spheres[d.shape], ray, range);
        if (d.kind == ShapeKind::mesh) return intersect(scene_->meshes[d.shape], p.part, ray, range);
        if (d.kind == ShapeKind::triangle) return intersect(scene_->triangles[d.shape], ray, range);
        if (d.kind == ShapeKind::cone) return intersect(scene_->cones[d.shape], ray, range);
        if (d.kind == ShapeKind::plane) return intersect(scene_->planes[d.shape], ray, range);
    }
    return intersect_part(*scene_, scene_->objects[p.object], p.part, ray, range);
}

namespace {

bool is_iterated(ShapeKind kind) { return kind == ShapeKind::torus || kind == ShapeKind::bicubic_patch; }

/// The smallest number above t.
Real just_above(Real t) {
    return t > 0 ? t * (1 + std::numeric_limits<Real>::epsilon()) : std::nextafter(t, kInfinity);
}

}  // namespace

void PrimitiveTester::keep_nearer(std::uint32_t primitive, const Ray& ray, Interval range, Candidate& best) const {
    // A little beyond the best root, so that one at equal t is seen too; the rule for ties then decides. Iterations that
    // start from the ends of the range would make the last bits depend on the order of the questions.
    if (best.primitive != kNone && !is_iterated(dispatch_[primitive].kind)) range.max = just_above(best.root.t);
    const auto root = intersect_one(primitive, ray, range);
    if (!root) return;
    if (best.primitive == kNone || root->t < best.root.t || (root->t == best.root.t && primitive < best.primitive))
        best = {*root, primitive};
}

bool PrimitiveTester::blocks(std::uint32_t primitive, const Ray& ray, Interval range) const {
    return dispatch_[primitive].casts && intersect_one(primitive, ray, range).has_value();
}

std::optional<Hit> PrimitiveTester::complete(const Ray& ray, const Candidate& best) const {
    if (best.primitive == kNone) return std::nullopt;
    return complete_hit(*scene_, primitives_[best.primitive].object, ray, best.root);
}

std::optional<Partition> partition_named(std::string_view name) {
    if (name == "auto") return Partition::automatic;
    if (name == "none") return Partition::none;
    if (name == "grid") return Partition::grid;
    if (name == "octree") return Partition::octree;
    if (name == "bvh") return Partition::bvh;
    return std::nullopt;
}

Partition choose_partition(const Scene& scene) {
    // Task 4.9: none for a few primitives, where asking all is fastest; else the fastest structure. Measure where they cross.
    unfinished("4.9");
    return {};
}

namespace {

class Exhaustive final : public Intersector {
public:
    explicit Exhaustive(const Scene& scene) : tester_(scene) {}

private:
    std::optional<Hit> find_nearest(const Ray& ray, Interval range) const override {
        Candidate best;
        if (!is_ray(ray)) return std::nullopt;
        for (std::uint32_t i = 0; i < tester_.primitives().size(); ++i) tester_.keep_nearer(i, ray, range, best);
        return tester_.complete(ray, best);
    }
    bool find_occluder(const Ray& ray, Interval range) const override {
        for (std::uint32_t i = 0; is_ray(ray) && i < tester_.primitives().size(); ++i)
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

}  // namespace rays
