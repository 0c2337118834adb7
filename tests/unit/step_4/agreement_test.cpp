// The invariant of the step: every structure answers with the bytes of asking every primitive.
#include <gtest/gtest.h>

#include <unistd.h>

#include <cstdlib>
#include <thread>

#include "4_partitioning/effort.h"
#include "4_partitioning/parallel.h"
#include "4_partitioning/structures.h"
#include "hard_scenes.h"
#include "renderer/agreement.h"

/// What std::thread::hardware_concurrency says while it is not 0.
static int pretended_cores = 0;
// The C library's, which the C++ library asks: what is defined in the program comes first.
extern "C" int get_nprocs() noexcept { return pretended_cores ? pretended_cores : int(sysconf(_SC_NPROCESSORS_CONF)); }

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

INSTANTIATE_TEST_SUITE_P(
    Structures, Agrees,
    testing::Combine(testing::Values(Case{Partition::grid, "grid"}, Case{Partition::octree, "octree"},
                                     Case{Partition::bvh, "bvh"}),
                     testing::Range<std::size_t>(0, hard_scenes().size())),
    [](const auto& of) { return std::get<0>(of.param).name + "_" + hard_scenes()[std::get<1>(of.param)].name; });

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

/// All that a ray can tell of a structure: whom it asks, and in which cells.
std::vector<double> seen_by(const Scene& scene, Partition partition) {
    const auto structure = make_structure(scene, partition);
    std::vector<double> seen;
    HardRays rays(scene, 5);
    for (int i = 0; i < 300; ++i) {
        std::vector<Bounds> cells;
        EffortCount count;
        count.so_far().visited = &cells;
        structure->nearest(rays.through_the_box(), {0, kInfinity});
        seen.insert(seen.end(), {double(count.so_far().tests), double(count.so_far().nodes)});
        for (const Bounds& cell : cells)
            for (int a = 0; a < 3; ++a) seen.insert(seen.end(), {double(cell.min[a]), double(cell.max[a])});
    }
    return seen;
}

TEST(ParallelBuilds, AreTheSameForAnyNumberOfThreads) {
    // Most of them in one corner: nodes of the octree are split by all threads to some depth there.
    const Scene scene = staged(
        "#declare R = seed(1); #declare I = 0; #while (I < " + std::to_string(3 * kParallelFrom) +
        ") sphere { <pow(rand(R), 8), rand(R), pow(rand(R), 8)> * 10, 0.2 * rand(R) } #declare I = I + 1; #end\n");
    for (const Partition partition : {Partition::grid, Partition::octree, Partition::bvh}) {
        pretended_cores = 1;
        const std::vector<double> alone = seen_by(scene, partition);
        for (const int cores : {2, 3, 7}) {
            pretended_cores = cores;
            ASSERT_EQ(std::thread::hardware_concurrency(), unsigned(cores)) << "the test does not reach the builds";
            EXPECT_TRUE(seen_by(scene, partition) == alone) << cores << " threads, structure " << int(partition);
        }
        pretended_cores = 0;
        EXPECT_GT(alone.at(1), 0) << "nodes of the first ray";
    }
}

TEST(VisitedLeaves, LieOnTheRayAndHoldItsHit) {
    const Scene scene = staged(hard_scenes()[3].text);  // spheres
    const auto bvh = make_structure(scene, Partition::bvh);
    HardRays rays(scene, 7);
    int hits = 0, boxes = 0;
    for (int i = 0; i < 500; ++i) {
        std::vector<Bounds> leaves;
        EffortCount count;
        count.so_far().visited = &leaves;
        const Ray ray = rays.through_the_box();
        const auto hit = bvh->nearest(ray, {0, kInfinity});
        bool holds = !hit || scene.objects[hit->object].kind == ShapeKind::plane;
        for (const Bounds& leaf : leaves) {
            const Bounds wider{leaf.min - Real(1e-4), leaf.max + Real(1e-4)};
            const bool is_met = clip(ray, {0, kInfinity}, wider).has_value();
            EXPECT_TRUE(is_met) << "ray " << i;
            holds |= hit && wider.overlaps({hit->point, hit->point});
            ++boxes;
        }
        EXPECT_TRUE(holds) << "ray " << i << ": its hit is in none of the leaves";
        hits += hit.has_value();
    }
    EXPECT_GT(hits, 100);
    EXPECT_GT(boxes, 500);
}

TEST(NoRays, AreMissesAtOnce) {
    const Scene scene = staged(hard_scenes()[3].text);
    const Real nan = std::nan(""), inf = kInfinity, huge = Real(1e300), tiny = Real(1e-300);
    const std::vector<Ray> none{{Vec3(nan), {0, 0, 1}},    {{0, 0, -9}, Vec3(nan)},  {{0, 0, -9}, {nan, 0, 1}},
                                {{0, nan, -9}, {0, 0, 1}}, {{0, 0, -9}, Vec3(0)},    {{0, 0, -9}, {0, 0, inf}},
                                {{0, -inf, 0}, {0, 1, 0}}, {{0, 0, -9}, Vec3(-0.0)}, {{0, 0, -9}, Vec3(huge)},
                                {{0, 0, -9}, Vec3(tiny)},  {Vec3(huge), Vec3(1)}};
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
