#include "batch.h"

#include <cmath>
#include <random>

namespace rays::bench {
namespace {

constexpr int kSide = 512, kTile = 32, kEvery = 8;

void add_ray(Batch& batch, const Vec3& origin, const Vec3& direction, const Intersector& truth) {
    const Ray ray{in_float(origin), in_float(glm::normalize(direction))};
    const auto hit = truth.nearest(ray, {kNearest, kInfinity});
    batch.rays.push_back(ray);
    batch.distances.push_back(hit ? hit->t : kInfinity);
}

Vec3 cosine_weighted(const Vec3& normal, std::mt19937_64& random) {
    const auto unit = [&] { return Real(static_cast<double>(random() >> 11) * 0x1p-53); };
    // A point of the unit sphere on top of the normal (Shirley, "Ray Tracing in One Weekend", 2016).
    const Real z = 2 * unit() - 1, angle = 2 * kPi * unit(), r = std::sqrt(1 - z * z);
    const Vec3 direction = normal + Vec3(r * std::cos(angle), r * std::sin(angle), z);
    return glm::length(direction) > Real(1e-3) ? direction : normal;
}

}  // namespace

Batch primary_rays(const Bodies& bodies, const Intersector& truth) {
    const Vec3 forward = glm::normalize(bodies.look_at - bodies.eye);
    const Vec3 right = glm::normalize(glm::cross(Vec3(0, 1, 0), forward)), up = glm::cross(forward, right);
    const Real width = 2 * std::tan(glm::radians(bodies.angle_deg) / 2);
    Batch batch;
    for (int tile = 0; tile < kSide / kTile * (kSide / kTile); ++tile) {
        const int column = tile % (kSide / kTile), row = tile / (kSide / kTile);
        if ((column + row) % kEvery != 0) continue;
        for (int i = 0; i < kTile * kTile; ++i) {
            const Real x = (Real(column * kTile + i % kTile) + Real(0.5)) / kSide - Real(0.5);
            const Real y = Real(0.5) - (Real(row * kTile + i / kTile) + Real(0.5)) / kSide;
            add_ray(batch, bodies.eye, forward + width * (x * right + y * up), truth);
        }
    }
    return batch;
}

Batch bounced_rays(const Batch& primary, const Intersector& truth) {
    std::mt19937_64 random(20260131);
    Batch batch;
    for (const Ray& ray : primary.rays) {
        const auto hit = truth.nearest(ray, {kNearest, kInfinity});
        if (!hit) continue;
        const Vec3 normal = glm::dot(hit->normal, ray.direction) > 0 ? -hit->normal : hit->normal;
        add_ray(batch, hit->point + kNearest * normal, cosine_weighted(normal, random), truth);
    }
    return batch;
}

}  // namespace rays::bench
