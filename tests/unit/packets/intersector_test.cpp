// The invariant of packets: whatever eight rays ask together, each gets the bits that it gets alone.
#include <fmt/format.h>

#include <cstdlib>
#include <optional>

#include "../step_4/hard_scenes.h"
#include "2_phong/phong.h"
#include "4_partitioning/structures.h"
#include "hard_packets.h"

namespace rays::packets::tests {
namespace {

using rays::tests::hard_scenes;
using rays::tests::HardScene;
using rays::tests::staged;

constexpr ObjectNumbers kOneObject = {};

std::optional<Hit> hit_of(const Hits& hits, int lane) {
    if (!(hits.are >> lane & 1)) return std::nullopt;
    Hit hit{hits.t[lane], hits.point[lane]};
    hit.shading_normal = hits.normal[lane];
    hit.object = hits.object[lane];
    hit.material = hits.material[lane];
    return hit;
}

/// Thousands of primitives, so that boxes, blocks and the order of the walk matter.
const std::vector<HardScene>& large_scenes() {
    static const std::vector<HardScene> scenes{
        {"thousands_of_spheres",
         "#for (I, 1, 3000) sphere { <rand(R), rand(R), rand(R)> * 20, 0.02 + 0.4 * rand(R) } #end\n"},
        {"thousands_of_cones",
         "#for (I, 1, 3000) #local P = <rand(R), rand(R), rand(R)> * 20; cone { P, 0.3 * rand(R), P + <rand(R), "
         "rand(R), rand(R)> * 2 - 1, 0.2 * rand(R)\n"
         "#if (mod(I, 3) = 0) open #end } #end\n"},
        {"thousands_of_triangles",
         "mesh { #for (I, 1, 4000) #local P = <rand(R), rand(R), rand(R)> * 20; triangle { P, P + <rand(R), rand(R), "
         "rand(R)>, P + <rand(R), rand(R), -rand(R)> } #end }\n"
         "#for (I, 1, 500) #local P = <rand(R), rand(R), rand(R)> * 20; smooth_triangle { P, x, P + <rand(R), 0, "
         "rand(R)>, y, P + <rand(R), rand(R), -rand(R)>, z } #end\n"},
        {"thousands_of_all_kinds",
         "#for (I, 1, 400) #local P = <rand(R), rand(R), rand(R)> * 30;\n"
         "union { sphere { 0, 0.4 } cylinder { 0, <1, 1, 0>, 0.2 } box { 0, <1, 0.5, 0.3> rotate 30 * I } box { 1, 1.5 "
         "} disc { <0, 2, 0>, <1, 1, 0.2>, 0.7, 0.2 }\n"
         "sphere { 0, 1 clipped_by { box { -0.4, 2 } } } triangle { x, 2 * y, z } polygon { 4, <0, 0, 0>, <1, 0, 0>, "
         "<1, 1, 0>, <0, 0, 0> rotate 70 * y }\n"
         "#if (mod(I, 10) = 0) torus { 0.6, 0.2 rotate 40 * x * I } #end rotate 17 * I translate P } #end plane { y, "
         "-1 } plane { <1, 2, 0.5>, -40 }\n"},
    };
    return scenes;
}

std::vector<HardScene> all_scenes() {
    std::vector<HardScene> all = hard_scenes();
    all.insert(all.end(), large_scenes().begin(), large_scenes().end());
    return all;
}

class PacketsAgree : public testing::TestWithParam<HardScene> {
protected:
    /// Small scenes are held against asking everything, large ones against the hierarchy that was held against it.
    void SetUp() override {
        if (scene_.objects.size() < 2000 && primitives_of(scene_).size() < 2000) exhaustive_ = make_exhaustive(scene_);
    }
    const Intersector& truth() const { return exhaustive_ ? *exhaustive_ : together_.single(); }
    /// RAYSTEPS_HARD_RAYS=1000000 asks more than the tests have time for.
    static int packets() {
        const char* wanted = std::getenv("RAYSTEPS_HARD_RAYS");
        return wanted ? std::atoi(wanted) / kLanes : 700;
    }

    const Scene scene_ = staged(GetParam().text);
    const PacketIntersector together_{scene_};
    std::unique_ptr<Intersector> exhaustive_;
};

TEST_P(PacketsAgree, OnTheNearest) {
    HardPackets source(scene_, 1);
    int hits = 0;
    for (int n = 0; n < packets(); ++n) {
        const Packet p = source.next();
        const Hits got = together_.nearest(together(p.rays), Mask::of(p.active), p.span());
        ASSERT_EQ(got.are & ~p.active, 0u) << "who did not ask has a hit";
        for (int i = 0; i < kLanes; ++i) {
            if (!(p.active >> i & 1)) continue;
            const Ray& ray = p.rays[std::size_t(i)];
            const Interval range = p.ranges[std::size_t(i)];
            const auto expected = truth().nearest(ray, range);
            hits += expected.has_value();
            ASSERT_TRUE(same(hit_of(got, i), expected))
                << "packet " << n << ", lane " << i << ", " << text(ray, range) << ": " << text(hit_of(got, i))
                << " instead of " << text(expected);
        }
    }
    if (!scene_.objects.empty()) {
        EXPECT_GT(hits, packets() * kLanes / 50) << "the rays look past the scene";
    }
}

TEST_P(PacketsAgree, OnWhatIsOccluded) {
    HardPackets source(scene_, 2);
    Suspects suspects(4);  // kept from packet to packet, as a light keeps them
    for (int n = 0; n < packets(); ++n) {
        const Packet p = source.next();
        if (n % 20 == 0) suspects = Suspects(4);
        ObjectNumbers lit;
        for (int i = 0; i < kLanes; ++i) lit[i] = static_cast<std::uint32_t>(n + i % 3);
        const unsigned got = together_.occluded(together(p.rays), Mask::of(p.active), p.span(), lit, suspects).bits();
        ASSERT_EQ(got & ~p.active, 0u) << "who did not ask is blocked";
        for (std::size_t i = 0; i < kLanes; ++i) {
            if (!(p.active >> i & 1)) continue;
            const Interval range = p.ranges[i];
            ASSERT_EQ(got >> i & 1, unsigned{truth().occluded(p.rays[i], range)})
                << "packet " << n << ", lane " << i << ", " << text(p.rays[i], range);
        }
    }
}

TEST_P(PacketsAgree, OnTheirOwnSingleRays) {
    // Programs with packets give single rays to this intersector.
    const Agreement agreement = compare(scene_, together_.single(), truth(), 300, 3);
    EXPECT_EQ(agreement.differences, 0u) << agreement.first;
}

INSTANTIATE_TEST_SUITE_P(Scenes, PacketsAgree, testing::ValuesIn(all_scenes()),
                         [](const auto& of) { return of.param.name; });

// ---- Rays and none --------------------------------------------------------------------------------------------------

TEST(PacketDirections, GroupRaysOfOneWay) {
    const Lanes<Ray> rays{Ray{Vec3(0), {1, 2, 3}},    Ray{Vec3(0), {-1, 2, 3}}, Ray{Vec3(0), {1, 2, 3}},
                          Ray{Vec3(0), {0, 2, 3}},    Ray{Vec3(0), {3, 2, 1}},  Ray{Vec3(0), {1, 3, 2}},
                          Ray{Vec3(0), {-0.0, 1, 2}}, Ray{Vec3(0), {2, 2, 2}}};
    const Directions directions(together(rays).direction);
    EXPECT_EQ(directions.like_the_first(0b11111111), 0b10110101u);
    EXPECT_EQ(directions.like_the_first(0b11111010), 0b00000010u);
    EXPECT_EQ(directions.like_the_first(0b11111000), 0b01001000u) << "0 and -0 both stand still";
    EXPECT_FALSE(directions.way(1).forwards[0]);
    EXPECT_TRUE(directions.way(6).forwards[0]);
}

TEST(PacketIntersectors, MissWhatIsNoRay) {
    // Whose answers are NaN must not be found, nor make the others miss.
    const Scene scene = staged(
        hard_scenes()[3].text +
        "box { 1, 2 rotate 10 } torus { 1, 0.2 } disc { 0, y, 1 } quadric { <1, 1, 1>, <0, 0, 0>, <0, 0, 0>, -1 }\n");
    const PacketIntersector intersector(scene);
    const Real nan = std::nan("");
    const Vec3 origin(5, 5, -9), direction = glm::normalize(Vec3(Real(0.01), Real(0.02), 1));
    for (const Ray& none : {Ray{origin, Vec3(nan)}, Ray{Vec3(nan), direction}, Ray{origin, {nan, 0, 1}},
                            Ray{{0, nan, -9}, direction}, Ray{origin, Vec3(0)}, Ray{origin, Vec3(-0.0)},
                            Ray{origin, {0, 0, kInfinity}}, Ray{{0, -kInfinity, 0}, direction}}) {
        Lanes<Ray> rays;
        for (std::size_t i = 0; i < kLanes; ++i)
            rays[i] = i % 3 == 1 ? none : Ray{origin + Vec3(Real(i) * Real(0.1)), direction};
        const Hits hits = intersector.nearest(together(rays), Mask::of(kAllLanes), {Reals(1e-4), Reals(1e7)});
        Suspects suspects(1);
        const unsigned blocked =
            intersector.occluded(together(rays), Mask::of(kAllLanes), {Reals(1e-3), Reals(1e7)}, kOneObject, suspects)
                .bits();
        for (std::size_t i = 0; i < kLanes; ++i) {
            EXPECT_TRUE(same(hit_of(hits, int(i)), intersector.single().nearest(rays[i], {Real(1e-4), Real(1e7)})))
                << text(rays[i], {});
            EXPECT_EQ(blocked >> i & 1, unsigned{intersector.single().occluded(rays[i], {Real(1e-3), Real(1e7)})})
                << text(rays[i], {});
        }
    }
}

TEST(PacketIntersectors, NobodyAsksNobodyIsAnswered) {
    const Scene scene = staged("plane { y, 0 } sphere { 0, 1 }\n");
    const PacketIntersector intersector(scene);
    Lanes<Ray> rays;
    rays.fill({{0, 3, -5}, glm::normalize(Vec3(0, Real(-0.6), 1))});
    Suspects suspects(1);
    EXPECT_EQ(intersector.nearest(together(rays), Mask::of(0), {Reals(0.0), Reals(100.0)}).are, 0u);
    EXPECT_FALSE(
        intersector.occluded(together(rays), Mask::of(0), {Reals(0.0), Reals(100.0)}, kOneObject, suspects).any());
    EXPECT_FALSE(
        intersector.occluded(together(rays), Mask::of(kAllLanes), {Reals(0.0), Reals(-1.0)}, kOneObject, suspects)
            .any())
        << "an empty range";
    EXPECT_FALSE(
        intersector
            .occluded(together(rays), Mask::of(kAllLanes), {Reals(0.0), Reals(std::nan(""))}, kOneObject, suspects)
            .any());
    EXPECT_EQ(intersector.nearest(together(rays), Mask::of(0b1), {Reals(0.0), Reals(100.0)}).are, 1u) << "one ray";
}

}  // namespace
}  // namespace rays::packets::tests
