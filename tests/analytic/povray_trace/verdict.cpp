#include "verdict.h"

#include <fmt/format.h>

#include <algorithm>

namespace rays::povray_trace {
namespace {

using MaybeMet = std::optional<Met>;

/// How far a point may lie off a torus by rounding alone, as a share of its size; and how far POV-Ray's was seen to
/// lie.
constexpr double kExact = 1e-12;
constexpr double kImprecise = 1e-5;

constexpr std::array kShifts{0.01 * kTie, 0.1 * kTie, kTie};
constexpr std::size_t kAround = 8;
constexpr std::size_t kNeighbours = kShifts.size() * kAround;

Difference difference(const Primitive& primitive, const TestRay& ray, const Met& theirs, const Met& ours) {
    const double cosine = std::abs(glm::dot(ours.normal, ray.direction));
    const glm::dvec3 normal = glm::normalize(theirs.normal);
    double turned = glm::length(ours.normal - normal);
    if (!primitive.closed) turned = std::min(turned, glm::length(ours.normal + normal));
    return {glm::length(theirs.point - ours.point) * cosine / primitive.size, turned * cosine};
}

bool agree(const Primitive& primitive, const TestRay& ray, const MaybeMet& theirs, const MaybeMet& ours) {
    if (!theirs || !ours) return !theirs && !ours;
    const Difference d = difference(primitive, ray, *theirs, *ours);
    return d.off_surface <= primitive.tolerance && d.turned <= primitive.tolerance;
}

/// The ray shifted sideways by less than kTie, and last the ray from just behind our own hit on.
std::vector<TestRay> second_thoughts(const Primitive& primitive, const TestRay& ray, const MaybeMet& ours) {
    Random random(1);
    const glm::dvec3 u = random.across(ray.direction);
    const glm::dvec3 v = glm::cross(ray.direction, u);
    std::vector<TestRay> result;
    for (const double shift : kShifts) {
        for (std::size_t i = 0; i < kAround; ++i) {
            const double angle = static_cast<double>(i) * 2 * std::numbers::pi / kAround;
            TestRay moved = ray;
            moved.origin += shift * primitive.size * (std::cos(angle) * u + std::sin(angle) * v);
            result.push_back(moved);
        }
    }
    TestRay behind = ray;
    if (ours) behind.nearest = glm::dot(ours->point - ray.origin, ray.direction) + kTie * primitive.size;
    result.push_back(behind);
    return result;
}

/// Both hit at about the same place, ours is on the surface by its closed form, and theirs is not.
bool theirs_is_off(const Primitive& primitive, const MaybeMet& theirs, const MaybeMet& ours) {
    if (!primitive.distance || !theirs || !ours) return false;
    const double size = primitive.size;
    return glm::length(theirs->point - ours->point) <= kImprecise * size &&
           primitive.distance(ours->point) <= kExact * size && primitive.distance(theirs->point) >= 100 * kExact * size;
}

/// A grazing hit moves by the root of the shift, and one in the plane of a face by any length.
bool is_tie(const Primitive& primitive, const TestRay& ray, const MaybeMet& theirs, const MaybeMet* neighbours) {
    if (theirs && std::abs(glm::dot(theirs->normal, ray.direction)) <= kTie) return true;
    return std::any_of(neighbours, neighbours + kNeighbours, [&](const MaybeMet& ours) {
        if (ours.has_value() != theirs.has_value()) return false;
        return !ours || glm::length(ours->point - theirs->point) <= 4 * std::sqrt(kTie) * primitive.size;
    });
}

/// Do the neighbours see surfaces of different directions, or some of them none?
bool at_seam(const MaybeMet* neighbours) {
    return std::any_of(neighbours + 1, neighbours + kNeighbours, [&](const MaybeMet& other) {
        if (other.has_value() != neighbours->has_value()) return true;
        return other && glm::length(other->normal - (*neighbours)->normal) > 0.01;
    });
}

std::string describe(const TestRay& ray, const MaybeMet& theirs, const MaybeMet& ours) {
    const auto text = [](const glm::dvec3& v) { return fmt::format("<{:.17g}, {:.17g}, {:.17g}>", v.x, v.y, v.z); };
    const auto met = [&](const MaybeMet& m) {
        return m ? fmt::format("at {} normal {}", text(m->point), text(m->normal)) : std::string("miss");
    };
    return fmt::format("{} ray from {} along {}:\n    POV-Ray {}\n    ours    {}",
                       kKindNames[static_cast<std::size_t>(ray.kind)], text(ray.origin), text(ray.direction),
                       met(theirs), met(ours));
}

}  // namespace

Verdict compare(const Primitive& primitive, const std::vector<TestRay>& rays, const Meetings& povray,
                const Solution& solution) {
    const Meetings ours = solution(rays);
    Verdict verdict;
    std::vector<std::size_t> doubtful;
    std::vector<TestRay> again;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (!agree(primitive, rays[i], povray[i], ours[i])) {
            doubtful.push_back(i);
            const std::vector<TestRay> more = second_thoughts(primitive, rays[i], ours[i]);
            again.insert(again.end(), more.begin(), more.end());
        } else if (ours[i]) {
            const Difference d = difference(primitive, rays[i], *povray[i], *ours[i]);
            ++verdict.hits;
            verdict.worst.off_surface = std::max(verdict.worst.off_surface, d.off_surface);
            verdict.worst.turned = std::max(verdict.worst.turned, d.turned);
        }
    }
    const Meetings answers = solution(again);
    for (std::size_t k = 0; k < doubtful.size(); ++k) {
        const std::size_t i = doubtful[k];
        const MaybeMet* neighbours = &answers[k * (kNeighbours + 1)];
        const MaybeMet& behind = neighbours[kNeighbours];
        const auto kind = static_cast<std::size_t>(rays[i].kind);
        if (theirs_is_off(primitive, povray[i], ours[i])) {
            ++verdict.imprecise[kind];
        } else if (is_tie(primitive, rays[i], povray[i], neighbours)) {
            ++verdict.ties[kind];
        } else if (ours[i] && at_seam(neighbours) && agree(primitive, rays[i], povray[i], behind)) {
            ++verdict.leaks[kind];
        } else {
            verdict.wrong.push_back(describe(rays[i], povray[i], ours[i]));
        }
    }
    return verdict;
}

}  // namespace rays::povray_trace
