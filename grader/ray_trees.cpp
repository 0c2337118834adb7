#include "grader/ray_trees.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "core/vec.h"
#include "grader/text.h"

namespace rays::grader {
namespace {

using nlohmann::json;
using V = glm::dvec3;

// Differences below these are rounding of single precision geometry, not mistakes.
constexpr double kAngle_deg = 0.005;
constexpr double kRelative = 1e-4;

struct Query {
    std::string kind;
    int depth = 0;
    V origin{0}, direction{0};
    bool hit = false, blocked = false, pruned = false;
    double weight = 1;
    double t = 0;
    int object = 0;
    V normal{0};
    V radiance{0};
};

V vector_of(const json& j) {
    const auto number = [&](std::size_t i) { return j.at(i).is_number() ? j.at(i).get<double>() : NAN; };
    return {number(0), number(1), number(2)};
}

std::optional<std::vector<Query>> parse(const std::string& text) {
    std::vector<Query> queries;
    try {
        const json tree = json::parse(text);
        for (const json& q : tree.at("queries")) {
            Query query;
            query.kind = plain(q.at("kind").get<std::string>(), 20);
            query.depth = q.at("depth");
            query.origin = vector_of(q.at("origin"));
            query.direction = vector_of(q.at("direction"));
            query.blocked = q.at("blocked");
            query.pruned = q.value("pruned", false);
            query.weight = q.value("weight", 1.0);
            query.radiance = vector_of(q.at("radiance"));
            const json& hit = q.at("hit");
            query.hit = !hit.is_null();
            if (query.hit) {
                query.t = hit.at("t").is_number() ? hit.at("t").get<double>() : NAN;
                query.object = hit.at("object");
                query.normal = vector_of(hit.at("shading_normal"));
            }
            queries.push_back(query);
        }
    } catch (const json::exception&) {
        return {};
    }
    return queries;
}

double angle_deg(const V& a, const V& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 57.29577951308232;
}

// Written so that NaN differs.
bool near(double a, double b, double scale) { return std::abs(a - b) <= kRelative * std::max(scale, std::abs(b)); }
bool near(const V& a, const V& b) {
    const double scale = std::max(1.0, glm::length(b));
    return near(a.x, b.x, scale) && near(a.y, b.y, scale) && near(a.z, b.z, scale);
}

std::string text(const V& v) { return fmt::format("({:.5g}, {:.5g}, {:.5g})", v.x, v.y, v.z); }

std::string ray_difference(const Query& a, const Query& b) {
    if (!near(a.origin, b.origin))
        return fmt::format("starts at {}, the solution's at {}", text(a.origin), text(b.origin));
    const double angle = angle_deg(a.direction, b.direction);
    if (!(angle <= kAngle_deg))
        return fmt::format("has a direction that differs by {:.3g} degrees: {}, the solution's {}", angle,
                           text(a.direction), text(b.direction));
    return {};
}

std::string hit_difference(const Query& a, const Query& b) {
    if (b.kind == "shadow")
        return a.blocked == b.blocked ? ""
               : a.blocked            ? "is blocked; the solution's reaches the light"
                                      : "reaches the light; the solution's is blocked";
    if (a.pruned != b.pruned)
        return a.pruned ? fmt::format("is not traced (weight {:.4g}); the solution's is", a.weight)
                        : fmt::format("is traced (weight {:.4g}); the solution's is not (weight {:.4g})", a.weight,
                                      b.weight);
    if (!near(a.weight, b.weight, 0))
        return fmt::format("has the weight {:.6g}; the solution's has {:.6g}", a.weight, b.weight);
    if (a.hit != b.hit)
        return a.hit ? fmt::format("hits object {} at t = {:.6g}; the solution's misses everything", a.object, a.t)
                     : fmt::format("misses everything; the solution's hits object {} at t = {:.6g}", b.object, b.t);
    if (!b.hit) return {};
    if (a.object != b.object)
        return fmt::format("hits object {} at t = {:.6g}; the solution's object {} at t = {:.6g}", a.object, a.t,
                           b.object, b.t);
    // t counts in lengths of the direction, which is free.
    const double reach_a = a.t * glm::length(a.direction), reach_b = b.t * glm::length(b.direction);
    if (!near(reach_a, reach_b, 0))
        return fmt::format("hits object {} at distance {:.6g}; the solution's at {:.6g}", b.object, reach_a, reach_b);
    const double angle = angle_deg(a.normal, b.normal);
    if (!(angle <= kAngle_deg))
        return fmt::format("finds a normal that differs by {:.3g} degrees: {}, the solution's {}", angle,
                           text(a.normal), text(b.normal));
    return {};
}

std::string name(const Query& q) { return fmt::format("depth {}: the {} ray", q.depth, q.kind); }

}  // namespace

std::string first_difference(const std::string& student_json, const std::string& solution_json) {
    const auto student = parse(student_json), solution = parse(solution_json);
    if (!student) return "the student's program prints no ray tree";
    if (!solution) return {};
    const std::size_t common = std::min(student->size(), solution->size());
    for (std::size_t i = 0; i < common; ++i) {
        const Query &a = (*student)[i], &b = (*solution)[i];
        if (a.kind != b.kind || a.depth != b.depth)
            return fmt::format("{} was asked where the solution asks the {} ray of depth {}", name(a), b.kind, b.depth);
        if (const auto text = ray_difference(a, b); !text.empty()) return name(b) + " " + text;
        if (const auto text = hit_difference(a, b); !text.empty()) return name(b) + " " + text;
    }
    if (student->size() > common) return name((*student)[common]) + " is asked, which the solution does not ask";
    if (solution->size() > common) return name((*solution)[common]) + " is missing";
    for (std::size_t i = 0; i < common; ++i) {
        const Query &a = (*student)[i], &b = (*solution)[i];
        if (b.kind != "shadow" && !near(a.radiance, b.radiance))
            return fmt::format("{} agrees in all geometry, but brings home {}; the solution's {}", name(b),
                               text(a.radiance), text(b.radiance));
    }
    return {};
}

}  // namespace rays::grader
