#include "target.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

namespace rays::bench {
namespace {

/// Another root of the same surface is at least so far away, in sizes; the error of a coarse method may be larger, and
/// then it is as bad as a wrong answer.
constexpr Exact kOtherRoot = 0.05L;

glm::dvec3 random_unit(std::mt19937_64& random) {
    const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    const double z = 2 * uniform() - 1, angle = 2 * std::numbers::pi * uniform(), r = std::sqrt(1 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
}

bool same_answer(std::optional<Exact> a, std::optional<Exact> b, Exact tolerance) {
    if (!a || !b) return !a && !b;
    return std::abs(*a - *b) < tolerance;
}

/// Do rays a thousandth of the size beside this one see the same?
bool is_clear(const Ray& ray, double size, const ExactRoot& truth) {
    const ExactRay exact(ray);
    const ExactVec axis = std::abs(exact.direction.x) < 0.7L ? ExactVec(1, 0, 0) : ExactVec(0, 1, 0);
    const ExactVec across = glm::normalize(glm::cross(exact.direction, axis));
    const ExactVec other = glm::normalize(glm::cross(exact.direction, across));
    const auto here = truth(exact);
    for (const ExactVec& step : {across, -across, other, -other}) {
        ExactRay beside = exact;
        beside.origin += Exact(0.001L * size) * step;
        if (!same_answer(here, truth(beside), Exact(size) * kOtherRoot)) return false;
    }
    return true;
}

Exact error_of_hit(const Target& target, const ExactRay& ray, const Root& root, std::optional<Exact> truth) {
    if (target.off_surface) return target.off_surface(ray.at(root.t), root) / target.size;
    return std::abs(Exact(root.t) - *truth) / target.size;
}

}  // namespace

Accuracy judge(const Target& target, const Answers& answers) {
    std::vector<double> errors;
    Accuracy result;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        const ExactRay ray(target.rays[i]);
        const auto& answer = answers[i];
        const auto truth = target.nearest ? target.nearest(ray) : std::nullopt;
        if (!answer && !truth) continue;
        bool right = !target.nearest;
        if (answer && truth) right = same_answer(Exact(answer->t), truth, target.size * kOtherRoot);
        const double error = right ? static_cast<double>(error_of_hit(target, ray, *answer, truth)) : 1;
        errors.push_back(error < 1 ? error : 1);  // a NaN is as wrong as anything
        result.wrong += right ? 0 : 1;
    }
    if (errors.empty()) return {1, 1, 1, 1};
    std::sort(errors.begin(), errors.end());
    result.mean = std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size());
    result.median = errors[errors.size() / 2];
    result.largest = errors.back();
    result.wrong /= static_cast<double>(answers.size());
    return result;
}

std::vector<Ray> rays_around(double size, double sizes_away, std::size_t count, const ExactRoot& truth) {
    std::mt19937_64 random(20260131);
    std::vector<Ray> rays;
    while (rays.size() < count) {
        const double radius = 1.1 * size * std::cbrt(static_cast<double>(random() >> 11) * 0x1p-53);
        const glm::dvec3 aim = radius * random_unit(random);
        const glm::dvec3 from = sizes_away * size * random_unit(random);
        const Ray ray{Vec3(from), Vec3(glm::normalize(aim - from))};
        if (!truth || is_clear(ray, size, truth)) rays.push_back(ray);
    }
    return rays;
}

}  // namespace rays::bench
