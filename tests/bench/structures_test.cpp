// What measure-4 measures: bodies, rays, and that everybody answers the same.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "4_partitioning/structures.h"
#include "measure/contender.h"
#include "scene_reader/scene_reader.h"

namespace rays::bench {
namespace {

bool is_float(Real value) {
    const volatile float rounded = static_cast<float>(value);
    return Real(rounded) == value;
}
bool is_float(const Vec3& v) { return is_float(v.x) && is_float(v.y) && is_float(v.z); }

/// The share of 10 000 parallel rays along an axis, through all of the cube, that hit anything.
double covered(const Bodies& bodies, int axis) {
    const auto structure = make_bvh(bodies.scene);
    int hits = 0;
    for (int i = 0; i < 10'000; ++i) {
        Ray ray{Vec3(0), Vec3(0)};
        ray.direction[axis] = 1;
        ray.origin[axis] = -2;
        // Not to its edge, where bodies stand out of the cube.
        ray.origin[(axis + 1) % 3] = Real(0.9) * (Real(i % 100) / 99 - Real(0.5));
        ray.origin[(axis + 2) % 3] = Real(0.9) * (Real(i / 100) / 99 - Real(0.5));
        hits += structure->occluded(ray, {0, kInfinity});
    }
    return hits / 10'000.0;
}

TEST(Bodies, CoverTheirViewOnce) {
    // Poisson: with one hit expected 1 - 1/e are covered. Several rays see the same body, so the spread is that of the
    // 4000 bodies rather than of the rays: 0.48 / sqrt(4000 * 0.63) or so; four times that.
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(covered(random_spheres(4000), axis), 1 - std::exp(-1), 0.04) << "axis " << axis;
        EXPECT_NEAR(covered(random_triangles(4000), axis), 1 - std::exp(-1), 0.04) << "axis " << axis;
    }
}

TEST(Bodies, AreFloatsNumbersAndAlwaysTheSame) {
    const Bodies spheres = random_spheres(100), triangles = random_triangles(100);
    EXPECT_EQ(spheres.scene.spheres.size(), 100u);
    for (const Sphere& s : spheres.scene.spheres) EXPECT_TRUE(is_float(s.center) && is_float(s.radius));
    ASSERT_EQ(triangles.scene.meshes.at(0).faces.size(), 100u);
    for (const Vec3& p : triangles.scene.meshes[0].positions) EXPECT_TRUE(is_float(p));
    EXPECT_EQ(random_spheres(100).scene.spheres[99].center, spheres.scene.spheres[99].center);
}

Real farthest(const Mesh& mesh) {
    Real result = 0;
    for (const Vec3& p : mesh.positions) result = std::max(result, glm::length(p));
    return result;
}

// The scene turns its flake, which keeps distances from the middle.
TEST(Bodies, FlakeIsThatOfTheScene) {
    const auto file = std::filesystem::path(BENCH_SCENES) / "million_triangles.pov";
    const Scene scene =
        read_scene(file.string(), {});  // a million triangles made by loops are within the reader's limits
    const Bodies flake = tessellated_flake();
    EXPECT_EQ(flake.count, 826'560u);
    EXPECT_EQ(flake.count, scene.meshes.at(0).faces.size());
    EXPECT_NEAR(farthest(flake.scene.meshes.at(0)), farthest(scene.meshes[0]), 1e-6);  // rounded to float
}

TEST(Batch, RaysHitWhatTheySay) {
    const Bodies bodies = random_spheres(1000);
    const auto truth = make_exhaustive(bodies.scene);
    const Batch primary = primary_rays(bodies, *truth), bounced = bounced_rays(primary, *truth);
    EXPECT_EQ(primary.rays.size(), 512u * 512u / 8);
    std::size_t hits = 0;
    for (std::size_t i = 0; i < primary.rays.size(); ++i) {
        ASSERT_TRUE(is_float(primary.rays[i].origin) && is_float(primary.rays[i].direction)) << "ray " << i;
        ASSERT_NEAR(glm::length(primary.rays[i].direction), 1, 1e-6);
        hits += std::isfinite(primary.distances[i]);
    }
    EXPECT_EQ(bounced.rays.size(), hits) << "one from every hit";
    EXPECT_GT(hits, primary.rays.size() / 10);
    // From the surface outwards: into no sphere at once.
    for (std::size_t i = 0; i < bounced.rays.size(); i += 97) {
        Real clearance = kInfinity;
        for (const Sphere& s : bodies.scene.spheres)
            clearance = std::min(clearance, std::abs(glm::length(bounced.rays[i].origin - s.center) - s.radius));
        ASSERT_LT(clearance, 1e-4) << "starts on a sphere";
    }
}

TEST(Contenders, AnswerAlike) {
    for (const Bodies& bodies : {random_spheres(1000), random_triangles(1000)}) {
        const auto truth = make_exhaustive(bodies.scene);
        const Batch primary = primary_rays(bodies, *truth), bounced = bounced_rays(primary, *truth);
        std::size_t blocked = 0;
        for (const Real t : bounced.distances) blocked += std::isfinite(t);
        for (const Contender& contender : our_contenders()) {
            const auto structure = contender.build(bodies);
            EXPECT_EQ(structure->distances(bounced), bounced.distances) << contender.name;
            EXPECT_EQ(structure->occluded(bounced), blocked) << contender.name;
#ifndef __SANITIZE_ADDRESS__  // whose memory does not count as the allocator's
            EXPECT_GT(structure->bytes(), bodies.count) << contender.name;
#endif
        }
        for (const Contender& contender : other_contenders()) {
            const auto structure = contender.build(bodies);
            // In float: a few rays of ten thousand that graze.
            EXPECT_LE(disagreement(bounced, structure->distances(bounced)).all(), bounced.rays.size() / 1000)
                << contender.name;
            EXPECT_NEAR(double(structure->occluded(bounced)), double(blocked), double(blocked) / 1000)
                << contender.name;
            EXPECT_GT(structure->bytes(), bodies.count) << contender.name;
        }
    }
}

TEST(Disagreement, TellsLostFromFound) {
    Batch truth;
    truth.distances = {1, 1, 1, kInfinity, kInfinity, 2};
    const Disagreement d = disagreement(truth, {1 + kSameDistance / 2, kInfinity, 1 + 2 * kSameDistance, 5, kInfinity,
                                                std::numeric_limits<Real>::quiet_NaN()});
    EXPECT_EQ(d.lost, 2u) << "a NaN is no hit";
    EXPECT_EQ(d.found, 1u);
    EXPECT_EQ(d.elsewhere, 1u);
    EXPECT_EQ(d.all(), 4u);
    EXPECT_THROW(disagreement(truth, {1}), std::invalid_argument);
}

}  // namespace
}  // namespace rays::bench
