#include "core/query_log.h"

#include <fmt/format.h>

namespace rays {
namespace {

std::string numbers(const Vec3& v) { return fmt::format("[{:.17g},{:.17g},{:.17g}]", v.x, v.y, v.z); }

// JSON has no infinity: a range without end is null.
std::string number(Real v) { return std::isfinite(v) ? fmt::format("{:.17g}", v) : "null"; }

std::string outcome(const QueryLog::Query& q) {
    if (q.pruned) return "not traced";
    if (q.kind == "shadow" && !q.hit) return q.blocked ? "blocked" : "free";
    if (!q.hit) return "miss";
    return fmt::format("object {} at t={:.9g}, point ({:.6g}, {:.6g}, {:.6g}), normal ({:.6g}, {:.6g}, {:.6g})",
                       q.hit->object, q.hit->t, q.hit->point.x, q.hit->point.y, q.hit->point.z, q.hit->shading_normal.x,
                       q.hit->shading_normal.y, q.hit->shading_normal.z);
}

std::string hit_json(const std::optional<Hit>& hit) {
    if (!hit) return "null";
    return fmt::format(R"({{"t":{},"object":{},"point":{},"normal":{},"shading_normal":{}}})", number(hit->t),
                       hit->object, numbers(hit->point), numbers(hit->normal), numbers(hit->shading_normal));
}

}  // namespace

constinit thread_local QueryLog* query_log = nullptr;

void QueryLog::nearest(const Ray& ray, Interval range, const std::optional<Hit>& hit) {
    const int depth = current < 0 ? 0 : queries[static_cast<std::size_t>(current)].depth + 1;
    queries.push_back({next_kind, current, depth, ray, range, hit, false, {}, next_weight});
    if (next_kind != "shadow") current = static_cast<int>(queries.size()) - 1;
    next_kind = "shadow";  // a ray that nobody announces is one of the shading's own
}

void QueryLog::occluded(const Ray& ray, Interval range, bool blocked) {
    const int depth = current < 0 ? 0 : queries[static_cast<std::size_t>(current)].depth + 1;
    queries.push_back({"shadow", current, depth, ray, range, std::nullopt, blocked, {}});
}

void QueryLog::pruned(const char* kind, const Ray& ray, float weight) {
    const int depth = current < 0 ? 0 : queries[static_cast<std::size_t>(current)].depth + 1;
    queries.push_back({kind, current, depth, ray, {}, std::nullopt, false, {}, weight, true});
}

double QueryLog::residual() const {
    double sum = 0;
    for (const Query& q : queries)
        if (q.pruned) sum += q.weight;
    return sum;
}

std::string QueryLog::to_text() const {
    std::string text;
    for (const Query& q : queries) {
        text += fmt::format("{:{}}{} ray from ({:.6g}, {:.6g}, {:.6g}) along ({:.6g}, {:.6g}, {:.6g}): {}", "",
                            2 * q.depth, q.kind, q.ray.origin.x, q.ray.origin.y, q.ray.origin.z, q.ray.direction.x,
                            q.ray.direction.y, q.ray.direction.z, outcome(q));
        if (q.kind != "shadow")
            text += fmt::format(" -> radiance ({:.6g}, {:.6g}, {:.6g}), weight {:.4g}", q.radiance[0], q.radiance[1],
                                q.radiance[2], q.weight);
        text += '\n';
    }
    if (const double missing = residual(); missing > 0)
        text += fmt::format(
            "residual: rays that were not traced weigh {:.4g}; the pixel lacks at most that, times the "
            "brightest radiance of the scene\n",
            missing);
    return text;
}

std::string QueryLog::to_json() const {
    std::string json = "{\"queries\":[";
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const Query& q = queries[i];
        json += fmt::format(
            R"({}{{"kind":"{}","parent":{},"depth":{},"origin":{},"direction":{},"range":[{},{}],"hit":{},"blocked":{},)"
            R"("radiance":[{:.9g},{:.9g},{:.9g}],"weight":{:.9g},"pruned":{}}})",
            i ? ",\n" : "\n", q.kind, q.parent, q.depth, numbers(q.ray.origin), numbers(q.ray.direction),
            number(q.range.min), number(q.range.max), hit_json(q.hit), q.blocked, q.radiance[0], q.radiance[1],
            q.radiance[2], q.weight, q.pruned);
    }
    return json + fmt::format("\n],\"residual\":{:.9g}}}\n", residual());
}

}  // namespace rays
