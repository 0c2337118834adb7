// The seam between "what does this ray meet?" and everybody who asks.
#pragma once

#include <optional>

#include "core/hit.h"
#include "core/query_log.h"
#include "core/ray.h"

namespace rays {

/// Answers the two questions of a ray tracer about one scene. Virtual once a ray, never once a primitive.
/// Both functions may be called from several threads at once.
class Intersector {
public:
    virtual ~Intersector() = default;

    /// The hit with the smallest t in the range, if any.
    std::optional<Hit> nearest(const Ray& ray, Interval range) const {
        auto hit = find_nearest(ray, range);
        if (query_log) [[unlikely]]
            query_log->nearest(ray, range, hit);
        return hit;
    }

    /// True when anything that casts a shadow is hit in the range. May stop at the first.
    bool occluded(const Ray& ray, Interval range) const {
        const bool blocked = find_occluder(ray, range);
        if (query_log) [[unlikely]]
            query_log->occluded(ray, range, blocked);
        return blocked;
    }

private:
    virtual std::optional<Hit> find_nearest(const Ray& ray, Interval range) const = 0;
    virtual bool find_occluder(const Ray& ray, Interval range) const = 0;
};

}  // namespace rays
