// The ray tree of one pixel: every ray asked and every hit found, in order.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/hit.h"
#include "core/radiance.h"
#include "core/ray.h"

namespace rays {

struct QueryLog {
    struct Query {
        std::string kind;   ///< "camera", "shadow"; later "reflected", "refracted"
        int parent = -1;    ///< the query whose hit this ray starts from; -1 for the root
        int depth = 0;
        Ray ray;
        Interval range;
        std::optional<Hit> hit;  ///< nearest queries
        bool blocked = false;    ///< shadow queries
        Radiance radiance;       ///< what the ray brought home
    };
    std::vector<Query> queries;
    std::string next_kind = "camera";
    int current = -1;  ///< the query whose hit is being shaded

    void nearest(const Ray& ray, Interval range, const std::optional<Hit>& hit);
    void occluded(const Ray& ray, Interval range, bool blocked);

    /// One line a ray, indented by depth.
    std::string to_text() const;
    /// {"queries": [...]}, numbers with 17 digits.
    std::string to_json() const;
};

/// Null but while a pixel is being explained, on the thread that explains it.
extern constinit thread_local QueryLog* query_log;

}  // namespace rays
