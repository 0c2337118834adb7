// The structures of step 4, asked through the seam that the renderer uses.
#include <malloc.h>

#include <cmath>
#include <stdexcept>

#include "4_partitioning/structures.h"
#include "contender.h"

namespace rays::bench {
namespace {

std::size_t allocated() {
    const struct mallinfo2 info = mallinfo2();
    return info.uordblks + info.hblkhd;
}

class Ours final : public Structure {
public:
    Ours(const Bodies& bodies, std::unique_ptr<Intersector> (*make)(const Scene&)) {
        const std::size_t before = allocated();
        intersector_ = make(bodies.scene);
        const std::size_t after = allocated();
        bytes_ = after > before ? after - before : 0;
    }

    Real nearest(const Batch& batch) const override {
        Real sum = 0;
        for (const Ray& ray : batch.rays)
            if (const auto hit = intersector_->nearest(ray, {kNearest, kInfinity})) sum += hit->t;
        return sum;
    }
    std::size_t occluded(const Batch& batch) const override {
        std::size_t hits = 0;
        for (const Ray& ray : batch.rays) hits += intersector_->occluded(ray, {kNearest, kInfinity});
        return hits;
    }
    std::vector<Real> distances(const Batch& batch) const override {
        std::vector<Real> result;
        for (const Ray& ray : batch.rays) {
            const auto hit = intersector_->nearest(ray, {kNearest, kInfinity});
            result.push_back(hit ? hit->t : kInfinity);
        }
        return result;
    }
    std::size_t bytes() const override { return bytes_; }

private:
    std::unique_ptr<Intersector> intersector_;
    std::size_t bytes_ = 0;
};

template <std::unique_ptr<Intersector> (*kMake)(const Scene&)>
std::unique_ptr<Structure> build(const Bodies& bodies) {
    return std::make_unique<Ours>(bodies, kMake);
}

}  // namespace

std::vector<Contender> our_contenders() {
    return {{"none", "every primitive asked", 1000, build<make_exhaustive>},
            {"grid", "uniform grid, 3D-DDA", 0, build<make_grid>},
            {"octree", "octree, top-down", 0, build<make_octree>},
            {"bvh", "eight children a node", 0, build<make_bvh>}};
}

Disagreement disagreement(const Batch& truth, const std::vector<Real>& distances) {
    if (distances.size() != truth.distances.size()) throw std::invalid_argument("an answer is needed for each ray");
    Disagreement result;
    for (std::size_t i = 0; i < distances.size(); ++i) {
        const bool should = std::isfinite(truth.distances[i]), does = std::isfinite(distances[i]);
        if (should && !does)
            ++result.lost;
        else if (does && !should)
            ++result.found;
        else if (does && !(std::abs(distances[i] - truth.distances[i]) <= kSameDistance * truth.distances[i]))
            ++result.elsewhere;
    }
    return result;
}

}  // namespace rays::bench
