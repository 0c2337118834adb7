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
        std::string kind;  ///< "camera", "reflected", "refracted", "transmitted", "shadow"
        int parent = -1;   ///< the query whose hit this ray starts from; -1 for the root
        int depth = 0;
        Ray ray;
        Interval range;
        std::optional<Hit> hit;  ///< nearest queries
        bool blocked = false;    ///< shadow queries
        Radiance radiance;       ///< what the ray brought home
        float weight = 1;        ///< the largest share of that which can reach the pixel
        bool pruned = false;     ///< never traced: too deep, or too small a share
    };
    std::vector<Query> queries;
    std::string next_kind = "camera";
    float next_weight = 1;
    int current = -1;  ///< the query whose hit is being shaded

    void nearest(const Ray& ray, Interval range, const std::optional<Hit>& hit);
    void occluded(const Ray& ray, Interval range, bool blocked);
    /// A ray of this kind that is not traced.
    void pruned(const char* kind, const Ray& ray, float weight);

    /// The weights of all rays that were not traced: what the pixel may lack, in units of the brightest radiance.
    double residual() const;
    /// One line a ray, indented by depth; at the end the residual, if there is one.
    std::string to_text() const;
    /// {"queries": [...], "residual": ..}, numbers with 17 digits.
    std::string to_json() const;
};

/// Logs one ray of the tree: between construction and destruction, the nearest query is this ray's, and all queries
/// after it start from its hit. Costs one branch when nothing is logged.
class LoggedRay {
public:
    LoggedRay(const char* kind, float weight);
    ~LoggedRay();
    LoggedRay(const LoggedRay&) = delete;
    LoggedRay& operator=(const LoggedRay&) = delete;

    /// Passes on what the ray brings home.
    const Radiance& brings(const Radiance& radiance) const;

private:
    int parent_ = -1, own_ = -1;
};

/// Null but while a pixel is being explained, on the thread that explains it.
extern constinit thread_local QueryLog* query_log;

inline LoggedRay::LoggedRay(const char* kind, float weight) {
    if (!query_log) [[likely]]
        return;
    parent_ = query_log->current;
    own_ = static_cast<int>(query_log->queries.size());
    query_log->next_kind = kind;
    query_log->next_weight = weight;
}

inline LoggedRay::~LoggedRay() {
    if (query_log) [[unlikely]]
        query_log->current = parent_;
}

inline const Radiance& LoggedRay::brings(const Radiance& radiance) const {
    if (query_log) [[unlikely]]
        query_log->queries[static_cast<std::size_t>(own_)].radiance = radiance;
    return radiance;
}

}  // namespace rays
