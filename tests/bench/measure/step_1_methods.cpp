// The methods of step 1 that have a knob: the form of the roots, how a torus and a patch are searched.
#include <fmt/format.h>

#include <cmath>

#include "naive.h"
#include "subject.h"
#include "truth.h"

namespace rays::bench {
namespace {

constexpr std::size_t kRays = 512;

std::shared_ptr<const Target> target_of(const ExactRoot& truth, double sizes_away,
                                        std::function<Exact(const ExactVec&, const Root&)> off_surface = {}) {
    return std::make_shared<const Target>(
        Target{1, rays_around(1, sizes_away, kRays, truth), std::move(off_surface), truth});
}

void add_sphere(const std::string& place, double sizes_away) {
    const Sphere sphere{Vec3(Real(0.05), Real(-0.03), Real(0.02)), Real(1)};
    const auto target = target_of(truth_of(sphere), sizes_away, [sphere](const ExactVec& p, const Root&) {
        return std::abs(glm::length(p - ExactVec(sphere.center)) - Exact(sphere.radius));
    });
    add_subject("sphere/" + place + "/robust",
                fmt::format("r^2 - |l|^2 and Vieta's roots, from {} radii away", sizes_away), target,
                [sphere](const Ray& ray) { return intersect(sphere, ray, {}); });
    add_subject("sphere/" + place + "/textbook", fmt::format("b^2 - c, from {} radii away", sizes_away), target,
                [sphere](const Ray& ray) { return textbook_sphere(sphere, ray, {}); });
}

void add_quadric(const std::string& place, double sizes_away) {
    Quadric quadric;  // x^2 + 2 y^2 + 3 z^2 + x y / 2 = 0.9
    quadric.q[0][0] = 1, quadric.q[1][1] = 2, quadric.q[2][2] = 3, quadric.q[3][3] = Real(-0.9);
    quadric.q[0][1] = quadric.q[1][0] = Real(0.25);
    const auto target = target_of(truth_of(quadric), sizes_away, [quadric](const ExactVec& p, const Root&) {
        const glm::vec<4, Exact> point(p, 1), qp = glm::mat<4, 4, Exact>(quadric.q) * point;
        return std::abs(glm::dot(point, qp)) / (2 * glm::length(ExactVec(qp)));
    });
    add_subject("quadric/" + place + "/robust",
                fmt::format("from the nearest point, fused discriminant, Vieta's roots; {} sizes away", sizes_away),
                target, [quadric](const Ray& ray) { return intersect(quadric, ray, {}); });
    add_subject("quadric/" + place + "/textbook", fmt::format("(-b -+ sqrt(b^2 - a c)) / a; {} sizes away", sizes_away),
                target, [quadric](const Ray& ray) { return textbook_quadric(quadric, ray, {}); });
}

void add_torus() {
    const Torus torus{Real(0.75), Real(0.25)};
    const auto target = target_of(truth_of(torus), 10, [torus](const ExactVec& p, const Root&) {
        return std::abs(std::hypot(std::hypot(p.x, p.z) - torus.major, p.y) - torus.minor);
    });
    add_subject("torus/isolated", "roots isolated by derivatives", target,
                [torus](const Ray& ray) { return intersect(torus, ray, {}); });
    for (const int steps : {4, 8, 16, 32, 64, 128, 256})
        add_subject(fmt::format("torus/steps/{}", steps), fmt::format("{} equal steps, then bisection", steps), target,
                    [torus, steps](const Ray& ray) { return stepped_torus(torus, ray, {}, steps); });
}

}  // namespace

void add_root_methods() {
    add_sphere("near", 10);
    add_sphere("far", 10'000);
    add_quadric("near", 10);
    add_quadric("far", 10'000);
    add_torus();
}

void add_patch_methods() {
    const BicubicPatch patch = wavy_patch();
    const auto target = target_of(truth_of(patch), 10);
    add_subject("patch/certified", "subdivision until Newton's method cannot miss", target,
                [patch](const Ray& ray) { return intersect(patch, ray, {}); });
    for (const int starts : {1, 2, 3, 4, 6})
        add_subject(fmt::format("patch/newton/{}", starts),
                    fmt::format("Newton's method from {0} x {0} starts", starts), target,
                    [patch, starts](const Ray& ray) { return newton_patch(patch, ray, {}, starts); });
    for (const unsigned steps : {2u, 4u, 8u, 16u})
        add_subject(fmt::format("patch/triangles/{}", steps),
                    fmt::format("{} triangles in a bounding sphere, asked one by one", 2 * steps * steps), target,
                    [mesh = tessellated(patch, steps)](const Ray& ray) { return intersect(mesh, ray, {}); });
}

}  // namespace rays::bench
