// The simplest intersector: ask every object.
#pragma once

#include "1_ray_casting/ray_casting.h"
#include "2_phong/phong.h"
#include "core/intersector.h"

namespace rays {

class BruteForce final : public Intersector {
public:
    /// The scene must outlive the intersector.
    explicit BruteForce(const Scene& scene) : scene_(scene) {}

private:
    std::optional<Hit> find_nearest(const Ray& ray, Interval range) const override {
        return nearest_hit(scene_, ray, range);
    }
    bool find_occluder(const Ray& ray, Interval range) const override { return any_occluder(scene_, ray, range); }

    const Scene& scene_;
};

}  // namespace rays
