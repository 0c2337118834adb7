// The simplest intersector: ask every object.
#pragma once

#include "1_ray_casting/ray_casting.h"
#include "2_phong/phong.h"
#include "core/intersector.h"
#include "core/unfinished.h"

namespace rays {

class BruteForce final : public Intersector {
public:
    /// The scene must outlive the intersector. `waits_for` is the unfinished task of the structure that it stands in
    /// for: every pixel that asks then waits for that task, and where there are many objects it does not wait for hits
    /// as well.
    explicit BruteForce(const Scene& scene, const char* waits_for = nullptr)
        : scene_(scene), waits_for_(waits_for), stands_still_(waits_for && scene.objects.size() > kMostWhileWaiting) {}

private:
    std::optional<Hit> find_nearest(const Ray& ray, Interval range) const override {
        if (waits_for_) unfinished(waits_for_);
        if (stands_still_) return std::nullopt;
        return nearest_hit(scene_, ray, range);
    }
    bool find_occluder(const Ray& ray, Interval range) const override {
        return !stands_still_ && any_occluder(scene_, ray, range);
    }

    const Scene& scene_;
    const char* waits_for_;
    bool stands_still_;
    static constexpr std::size_t kMostWhileWaiting = 1000;  ///< beyond, a striped picture would take minutes
};

}  // namespace rays
