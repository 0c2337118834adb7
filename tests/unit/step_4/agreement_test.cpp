// The invariant of the step: every structure answers with the bytes of asking every primitive.
#include <gtest/gtest.h>

#include <cstdlib>

#include "4_partitioning/parallel.h"
#include "4_partitioning/structures.h"
#include "hard_scenes.h"
#include "renderer/agreement.h"

namespace rays::tests {
namespace {

/// RAYSTEPS_HARD_RAYS=1000000 asks more than the tests have time for.
std::size_t rays_a_scene() {
    const char* wanted = std::getenv("RAYSTEPS_HARD_RAYS");
    return wanted ? std::strtoul(wanted, nullptr, 10) : 4000;
}

struct Case {
    Partition partition;
    std::string name;
};

class Agrees : public testing::TestWithParam<std::tuple<Case, std::size_t>> {};

TEST_P(Agrees, WithAskingEveryPrimitive) {
    const auto& [structure, index] = GetParam();
    const HardScene& hard = hard_scenes()[index];
    const Scene scene = staged(hard.text);
    const auto fast = make_structure(scene, structure.partition), slow = make_exhaustive(scene);
    const Agreement agreement = compare(scene, *fast, *slow, rays_a_scene(), 1);
    EXPECT_EQ(agreement.differences, 0u) << hard.name << ", " << agreement.rays << " rays: " << agreement.first;
    if (!scene.objects.empty()) {
        EXPECT_GT(agreement.hits, agreement.rays / 50) << "the rays look past the scene";
    }
}

INSTANTIATE_TEST_SUITE_P(Structures, Agrees,
                         testing::Combine(testing::Values(Case{Partition::grid, "grid"}, Case{Partition::octree, "octree"},
                                                          Case{Partition::bvh, "bvh"}),
                                          testing::Range<std::size_t>(0, hard_scenes().size())),
                         [](const auto& of) {
                             return std::get<0>(of.param).name + "_" + hard_scenes()[std::get<1>(of.param)].name;
                         });

TEST(ParallelBuilds, AgreeWithAskingEveryPrimitive) {
    // Twice as many as are built by one thread. Under ThreadSanitizer this is the test of the builds.
    const std::string text = "#declare R = seed(1); #declare I = 0; #while (I < " + std::to_string(2 * kParallelFrom) +
                             ") sphere { <rand(R), rand(R), rand(R)> * 10, 0.1 } #declare I = I + 1; #end\n";
    const Scene scene = staged(text);
    ASSERT_GE(scene.objects.size(), kParallelFrom);
    const auto slow = make_exhaustive(scene);
    for (const Partition partition : {Partition::grid, Partition::octree, Partition::bvh}) {
        const Agreement agreement = compare(scene, *make_structure(scene, partition), *slow, 200, 1);
        EXPECT_EQ(agreement.differences, 0u) << agreement.first;
        EXPECT_GT(agreement.hits, agreement.rays / 50);
    }
}

TEST(NoRays, AreMissesAtOnce) {
    const Scene scene = staged(hard_scenes()[3].text);
    const Real nan = std::nan(""), inf = kInfinity, huge = Real(1e300), tiny = Real(1e-300);
    const std::vector<Ray> none{{Vec3(nan), {0, 0, 1}}, {{0, 0, -9}, Vec3(nan)},  {{0, 0, -9}, {nan, 0, 1}}, {{0, nan, -9}, {0, 0, 1}},
                                {{0, 0, -9}, Vec3(0)},  {{0, 0, -9}, {0, 0, inf}}, {{0, -inf, 0}, {0, 1, 0}}, {{0, 0, -9}, Vec3(-0.0)},
                                {{0, 0, -9}, Vec3(huge)}, {{0, 0, -9}, Vec3(tiny)}, {Vec3(huge), Vec3(1)}};
    for (const Partition partition : {Partition::grid, Partition::octree, Partition::bvh}) {
        const auto structure = make_structure(scene, partition);
        for (const Ray& ray : none)
            for (const Interval range : {Interval{0, inf}, Interval{-inf, inf}, Interval{nan, 1}, Interval{0, nan}}) {
                EXPECT_FALSE(structure->nearest(ray, range));
                EXPECT_FALSE(structure->occluded(ray, range));
            }
        const Ray good{{0.4f, 0.4f, -9}, {0, 0, 1}};
        EXPECT_FALSE(structure->nearest(good, {nan, 1}));
        EXPECT_FALSE(structure->nearest(good, {0, nan}));
        EXPECT_FALSE(structure->occluded(good, {1, -1}));
    }
}

}  // namespace
}  // namespace rays::tests
