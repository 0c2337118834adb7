// Filtered shadows: which rays something opaque blocks for sure, and which somebody has to look at.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "../step_4/hard_scenes.h"
#include "2_phong/phong.h"
#include "4_partitioning/structures.h"
#include "hard_packets.h"

namespace rays::packets::tests {
namespace {

using rays::tests::staged;

/// Opaque and clear things, some without a shadow, and a mesh whose faces have their own texture.
const std::string kClear =
    "#declare Glass = texture { pigment { rgbf <1, 0.8, 0.6, 0.7> } }\n"
    "#for (I, 1, 150) sphere { <rand(R), rand(R), rand(R)> * 10, 0.1 + 0.4 * rand(R) #if (mod(I, 2)) texture { Glass } "
    "#end\n"
    "#if (mod(I, 7) = 0) no_shadow #end } #end\n"
    "#for (I, 1, 20) torus { 0.6, 0.2 rotate 40 * x * I translate <rand(R), rand(R), rand(R)> * 10 #if (mod(I, 2)) "
    "texture { Glass } #end } #end\n"
    "mesh { #for (I, 1, 80) #local P = <rand(R), rand(R), rand(R)> * 10; triangle { P, P + <rand(R), 1, rand(R)>, P + "
    "<1, rand(R), -rand(R)>\n"
    "#if (mod(I, 2)) texture { Glass } #end } #end pigment { rgb 1 } }\n";

/// What a shadow ray meets, found by asking every primitive for all of its roots.
struct Met {
    std::vector<Real> opaque, clear;

    /// Is nothing left of the light, for sure? Behind something clear the next kShadowTolerance are passed over.
    bool is_blocked() const {
        return std::any_of(opaque.begin(), opaque.end(), [&](Real t) {
            return std::none_of(clear.begin(), clear.end(),
                                [&](Real c) { return c <= t && t <= c + kShadowTolerance * Real(1.001); });
        });
    }
};
Met met_by(const Scene& scene, const PrimitiveTester& tester, const Ray& ray, Interval range) {
    Met met;
    for (std::uint32_t i = 0; i < tester.size(); ++i) {
        if (!tester.dispatch(i).casts) continue;
        const Primitive p = tester.primitive(i);
        const Object& object = scene.objects[p.object];
        std::uint32_t material = object.material;
        if (object.kind == ShapeKind::mesh &&
            scene.meshes[object.shape].faces[p.part].material != Mesh::kObjectMaterial)
            material = scene.meshes[object.shape].faces[p.part].material;
        auto& roots = lets_light_through(scene.materials[material].pigment) ? met.clear : met.opaque;
        for (Interval rest = range;; rest.min = roots.back()) {
            Candidate best;
            tester.keep_nearer(i, ray, rest, best);
            if (best.primitive == kNone) break;
            roots.push_back(best.root.t);
        }
    }
    return met;
}

TEST(PacketObstacles, SayWhichRaysAreBlockedAndWhichMeetSomethingClear) {
    const Scene scene = staged(kClear);
    const PacketIntersector together_intersector(scene);
    const PrimitiveTester tester(scene);
    HardPackets source(scene, 4);
    int blocked = 0, blocked_beside_clear = 0, clear = 0, none = 0, asked_alone = 0;
    for (int n = 0; n < 6000; ++n) {
        const Packet p = source.next();
        const Obstacles got = together_intersector.obstacles(together(p.rays), Mask::of(p.active), p.span());
        ASSERT_EQ((got.opaque | got.clear).bits() & ~p.active, 0u);
        ASSERT_EQ((got.opaque & got.clear).bits(), 0u) << "either blocked, or to be looked at";
        for (std::size_t i = 0; i < kLanes; ++i) {
            if (!(p.active >> i & 1)) continue;
            const Interval range = p.ranges[i];
            const Met truth = met_by(scene, tester, p.rays[i], range);
            const bool is_blocked = got.opaque.bits() >> i & 1, is_clear = got.clear.bits() >> i & 1;
            const std::string where = fmt::format("packet {}, lane {}, {}", n, i, text(p.rays[i], range));
            // To be looked at is always right, for rays that go their own way even where there is nothing clear.
            if (is_clear) {
                ++(truth.clear.empty() ? asked_alone : clear);
            } else if (is_blocked) {
                ASSERT_TRUE(truth.is_blocked()) << where;
                ++(truth.clear.empty() ? blocked : blocked_beside_clear);
            } else {
                ASSERT_TRUE(truth.opaque.empty() && truth.clear.empty()) << where;
                ++none;
            }
        }
    }
    EXPECT_GT(blocked, 100);
    EXPECT_GT(blocked_beside_clear, 20);
    EXPECT_GT(clear, 100);
    EXPECT_GT(none, 100);
    EXPECT_GT(asked_alone, 0);
}

TEST(PacketObstacles, RaysTogetherArePassedOnOnlyForSomethingClear) {
    // All eight the same way, over opaque and clear spheres in rows: no lane is alone.
    const Scene scene = staged(
        "#for (I, 0, 7) sphere { <I, 0, 0>, 0.3 #if (mod(I, 2)) pigment { rgbt 0.5 } #end } #if (I > 3) sphere { <I, "
        "0, 4>, 0.3 } #end #end\n");
    const PacketIntersector intersector(scene);
    Lanes<Ray> rays;
    for (std::size_t i = 0; i < kLanes; ++i)
        rays[i] = {{Real(i) + Real(0.01), Real(0.02), -5}, glm::normalize(Vec3(Real(0.001), Real(0.001), 1))};
    const Obstacles all = intersector.obstacles(together(rays), Mask::of(kAllLanes), {Reals(0.0), Reals(100.0)});
    // 5 and 7 meet both: they are blocked when what is opaque is asked first.
    EXPECT_EQ(all.opaque.bits() | 0b10100000u, 0b11110101u);
    EXPECT_EQ(all.clear.bits() & ~0b10100000u, 0b00001010u);
    EXPECT_EQ(all.opaque.bits() ^ all.clear.bits(), kAllLanes);
    const Obstacles near = intersector.obstacles(together(rays), Mask::of(kAllLanes), {Reals(0.0), Reals(2.0)});
    EXPECT_FALSE(near.opaque.any() || near.clear.any());
    const Obstacles behind = intersector.obstacles(together(rays), Mask::of(kAllLanes), {Reals(7.0), Reals(100.0)});
    EXPECT_EQ(behind.opaque.bits(), 0b11110000u);
    EXPECT_FALSE(behind.clear.any());
}

TEST(PacketObstacles, WhatIsOpaqueBlocksUnlessSomethingClearIsJustBefore) {
    // A wall. Before its right half are clear discs that almost touch it: behind them a shadow ray passes over the
    // wall. What else there is makes many leaves, so that the wall is asked before or after the discs.
    int asked_first = 0;
    for (int seed = 0; seed < 30; ++seed) {
        const Scene scene = staged(
            fmt::format("#declare S = seed({});\n box {{ <-20, -20, 5>, <20, 20, 6> }}\n"
                        "#for (I, 4, 7) disc {{ <I, 0, 4.9995>, z, 0.3 pigment {{ rgbt 0.5 }} }} #end\n"
                        "#for (I, 0, 7) disc {{ <I, 0, 3>, z, 0.3 pigment {{ rgbt 0.5 }} }} #end\n"
                        "#for (I, 1, 100) sphere {{ <rand(S) * 30 - 15, rand(S) * 20 + 2, rand(S) * 20>, 0.3 }} #end\n",
                        seed));
        const PacketIntersector intersector(scene);
        Lanes<Ray> rays;
        for (std::size_t i = 0; i < kLanes; ++i) rays[i] = {{Real(i), Real(0), 0}, {0, 0, 1}};
        const Obstacles met = intersector.obstacles(together(rays), Mask::of(kAllLanes), {Reals(1e-3), Reals(100.0)});
        EXPECT_EQ(met.clear.bits() & 0b11110000u, 0b11110000u) << seed;
        EXPECT_EQ((met.opaque | met.clear).bits(), kAllLanes) << seed;
        asked_first += (met.opaque.bits() & 0b1111u) != 0;
    }
    EXPECT_GT(asked_first, 5) << "the wall, before the discs";
}

}  // namespace
}  // namespace rays::packets::tests
