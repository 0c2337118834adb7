// The simplest intersector: ask every object.
#pragma once

#include "1_ray_casting/ray_casting.h"
#include "2_phong/phong.h"
#include "core/intersector.h"
#include "core/unfinished.h"

namespace rays {

class BruteForce final : public Intersector {
public:
    /// The scene must outlive the intersector. `waits_for` is the unfinished task of the structure that it stands in for:
    /// every pixel that asks then waits for that task.
    explicit BruteForce(const Scene& scene, const char* waits_for = nullptr) : scene_(scene), waits_for_(waits_for) {}

private:
    std::optional<Hit> find_nearest(const Ray& ray, Interval range) const override {
        if (waits_for_) unfinished(waits_for_);
        return nearest_hit(scene_, ray, range);
    }
    bool find_occluder(const Ray& ray, Interval range) const override { return any_occluder(scene_, ray, range); }

    const Scene& scene_;
    const char* waits_for_;
};

}  // namespace rays
