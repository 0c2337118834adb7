// Beyond the step: a bounding volume hierarchy with eight children a node. Boxes, triangles, spheres and cones are
// tested eight at once in float; they only decide whom to ask, and the shared test of a primitive, in `Real`, gives the
// answer.
#include <algorithm>
#include <atomic>

#include "4_partitioning/primitive_tester.h"
#include "4_partitioning/structures.h"
#include "core/unfinished.h"
//> hidden
#include "4_partitioning/beyond/hierarchy.h"
#include "4_partitioning/beyond/single_walk.h"
//< hidden

namespace rays {

//> hidden
namespace {

using namespace wide;

constexpr std::uint32_t kMostInLeaf = 8;  ///< triangles or spheres; measured (NOTES.md)

class Bvh final : public SingleRays {
public:
    explicit Bvh(std::shared_ptr<const Hierarchy> hierarchy)
        : hierarchy_(std::move(hierarchy)),
          tester_(hierarchy_->tester),
          unbounded_(hierarchy_->unbounded),
          tree_(hierarchy_->tree) {}

    bool blocked(const Ray& ray, Interval range, std::uint32_t& last) const override {
        if (!is_ray(ray) || !(range.min < range.max)) return false;
        if (last != kNone && tester_.blocks(last, ray, range)) return true;
        const auto blocks = [&](std::uint32_t primitive, const PrimitiveTester::Dispatch& d) {
            if (!tester_.blocks(d, ray, range)) return false;
            last = primitive;
            return true;
        };
        if (looks_back(range)) return any_of_all([&](std::uint32_t p) { return blocks(p, tester_.dispatch(p)); });
        return (!tree_.empty() && SingleWalk(tree_, ray, range).any_below(tree_.root(), blocks)) ||
               std::any_of(unbounded_.begin(), unbounded_.end(),
                           [&](std::uint32_t p) { return blocks(p, tester_.dispatch(p)); });
    }

private:
    struct LastOccluder {
        std::uint64_t of = 0;  ///< whose: an address could be a later structure's
        std::uint32_t primitive = kNone;
    };

    static std::uint64_t next_number() {
        static std::atomic<std::uint64_t> last{0};
        return ++last;
    }

    std::optional<Hit> find_nearest(const Ray& ray, Interval range) const override {
        if (!is_ray(ray)) return std::nullopt;
        Candidate best;
        const auto keep_nearer = [&](std::uint32_t primitive) { tester_.keep_nearer(primitive, ray, range, best); };
        if (looks_back(range)) {
            any_of_all([&](std::uint32_t primitive) { return keep_nearer(primitive), false; });
            return tester_.complete(ray, best);
        }
        for (const std::uint32_t primitive : unbounded_) keep_nearer(primitive);
        if (!tree_.empty()) {
            SingleWalk walk(tree_, ray, range);
            if (best.primitive != kNone) walk.shorten(best.root.t);
            walk.nearest_below(tree_.root(), [&](std::uint32_t primitive, const PrimitiveTester::Dispatch& d) {
                const std::uint32_t before = best.primitive;
                tester_.keep_nearer(primitive, d, ray, range, best);
                if (best.primitive != before) walk.shorten(best.root.t);
            });
        }
        return tester_.complete(ray, best);
    }

    bool find_occluder(const Ray& ray, Interval range) const override {
        // Neighbouring points tend to lie in the same shadow: who blocked last is asked first.
        thread_local LastOccluder last;
        if (last.of != number_) last = {number_, kNone};
        return blocked(ray, range, last.primitive);
    }

    /// Boxes are for rays that go forward. Whoever looks back is rare enough to ask everybody.
    static bool looks_back(Interval range) { return range.min < 0; }
    template <class Ask>
    bool any_of_all(const Ask& ask) const {
        for (std::uint32_t primitive = 0; primitive < tester_.size(); ++primitive)
            if (ask(primitive)) return true;
        return false;
    }

    const std::shared_ptr<const Hierarchy> hierarchy_;
    const PrimitiveTester& tester_;
    const std::vector<std::uint32_t>& unbounded_;
    const Tree& tree_;
    const std::uint64_t number_ = next_number();
};

}  // namespace

std::shared_ptr<const Hierarchy> wide::make_hierarchy(const Scene& scene) {
    return std::make_shared<const Hierarchy>(scene, kMostInLeaf);
}

std::unique_ptr<SingleRays> wide::make_bvh(std::shared_ptr<const Hierarchy> hierarchy) {
    return std::make_unique<Bvh>(std::move(hierarchy));
}
//< hidden

std::unique_ptr<Intersector> make_bvh(const Scene& scene) {
    //> 4.10 Beyond the step: any structure of your own, the faster the better. Until then, the octree stands in.
    return wide::make_bvh(wide::make_hierarchy(scene));
    //< 4.10
}

}  // namespace rays
