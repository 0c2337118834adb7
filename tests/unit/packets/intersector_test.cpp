// The invariant of packets: whatever eight rays ask together, each gets the bits that it gets alone.
#include <fmt/format.h>

#include <cstdlib>
#include <optional>

#include "../step_4/hard_scenes.h"
#include "2_phong/phong.h"
#include "4_partitioning/structures.h"
#include "eight.h"
#include "packets/intersector.h"
#include "renderer/agreement.h"

namespace rays::packets::tests {
namespace {

using rays::tests::hard_scenes;
using rays::tests::HardScene;
using rays::tests::staged;

constexpr ObjectNumbers kOneObject = {};

/// Eight rays of one of several habits, and which of them ask.
struct Packet {
    Lanes<Ray> rays;
    unsigned active = kAllLanes;
    Lanes<Interval> ranges;

    Span span() const {
        Lanes<Real> near, far;
        for (std::size_t i = 0; i < kLanes; ++i) {
            near[i] = ranges[i].min;
            far[i] = ranges[i].max;
        }
        return {together(near), together(far)};
    }
};

class HardPackets {
public:
    HardPackets(const Scene& scene, std::uint64_t seed) : rays_(scene, seed), bits_(seed) {}

    /// Directions of unit length, as packets want them.
    Packet next() {
        Packet packet;
        const HardRays::Query first = forwards();
        const Real length = glm::length(first.ray.direction);
        const Real spread = std::pow(Real(10), -4 * unit());
        const std::uint64_t habit = below(6);
        for (std::size_t i = 0; i < kLanes; ++i) {
            const Ray other = rays_.next().ray;
            Ray& ray = packet.rays[i] = first.ray;
            if (habit == 0) ray = other;                                                      // all over the place
            if (habit == 1) ray.direction += spread * glm::length(ray.direction) * jitter();  // a pencil
            if (habit == 2) ray.origin += spread * glm::length(ray.direction) * jitter();     // side by side
            if (habit == 3) ray = rays_.through_the_box();
            if (habit == 4 && i % 2) ray = {ray.origin, -ray.direction};  // two ways
            if (habit == 5)
                ray.direction =
                    i < 5 ? ray.direction + spread * glm::length(ray.direction) * jitter() : other.direction;
            if (!is_ray(ray)) ray = first.ray;
            ray.direction = glm::normalize(ray.direction);
            Interval& range = packet.ranges[i] = {first.range.min * length, first.range.max * length};
            if (below(3) == 0) range.max = range.min + unit() * Real(20);
            if (below(8) == 0) range.min = unit() * Real(10);
        }
        if (below(2)) packet.active = unsigned(bits_()) & kAllLanes;
        return packet;
    }

private:
    HardRays::Query forwards() {
        for (;;) {
            const HardRays::Query q = rays_.next();
            if (q.range.min >= 0) return q;
        }
    }
    Real unit() { return Real(double(bits_() >> 11) * 0x1p-53); }
    std::uint64_t below(std::uint64_t n) { return bits_() % n; }
    Vec3 jitter() {
        const Real x = unit(), y = unit();
        return Vec3(x, y, unit()) - Real(0.5);
    }

    HardRays rays_;
    std::mt19937_64 bits_;
};

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

// ---- Filtered shadows -----------------------------------------------------------------------------------------------

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
    for (int n = 0; n < 1500; ++n) {
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
    // A wall. Before its right half are clear discs that almost touch it: behind them a shadow ray passes over the wall.
    // What else there is makes many leaves, so that the wall is asked before or after the discs.
    int asked_first = 0;
    for (int seed = 0; seed < 30; ++seed) {
        const Scene scene = staged(fmt::format(
            "#declare S = seed({});\n box {{ <-20, -20, 5>, <20, 20, 6> }}\n"
            "#for (I, 4, 7) disc {{ <I, 0, 4.9995>, z, 0.3 pigment {{ rgbt 0.5 }} }} #end\n"
            "#for (I, 0, 7) disc {{ <I, 0, 3>, z, 0.3 pigment {{ rgbt 0.5 }} }} #end\n"
            "#for (I, 1, 100) sphere {{ <rand(S) * 30 - 15, rand(S) * 20 + 2, rand(S) * 20>, 0.3 }} #end\n", seed));
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

// ---- Rays and none --------------------------------------------------------------------------------------------------

TEST(PacketDirections, GroupRaysOfOneWay) {
    const Lanes<Ray> rays{Ray{Vec3(0), {1, 2, 3}},    Ray{Vec3(0), {-1, 2, 3}}, Ray{Vec3(0), {1, 2, 3}},
                          Ray{Vec3(0), {0, 2, 3}},    Ray{Vec3(0), {3, 2, 1}},  Ray{Vec3(0), {1, 3, 2}},
                          Ray{Vec3(0), {-0.0, 1, 2}}, Ray{Vec3(0), {2, 2, 2}}};
    const Directions directions(together(rays).direction);
    EXPECT_EQ(directions.like_the_first(0b11111111), 0b00000101u);
    EXPECT_EQ(directions.like_the_first(0b11111010), 0b00000010u);
    EXPECT_EQ(directions.like_the_first(0b11111000), 0b01001000u) << "0 and -0 both stand still";
    EXPECT_EQ(directions.like_the_first(0b11110000), 0b10010000u) << "of equal components the first is the longest";
    EXPECT_EQ(directions.way(0).longest_axis, 2);
    EXPECT_EQ(directions.way(4).longest_axis, 0);
    EXPECT_EQ(directions.way(5).longest_axis, 1);
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
            intersector.occluded(together(rays), Mask::of(kAllLanes), {Reals(1e-3), Reals(1e7)}, kOneObject, suspects).bits();
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
    EXPECT_FALSE(intersector.occluded(together(rays), Mask::of(0), {Reals(0.0), Reals(100.0)}, kOneObject, suspects).any());
    EXPECT_FALSE(intersector.occluded(together(rays), Mask::of(kAllLanes), {Reals(0.0), Reals(-1.0)}, kOneObject, suspects).any())
        << "an empty range";
    EXPECT_FALSE(
        intersector.occluded(together(rays), Mask::of(kAllLanes), {Reals(0.0), Reals(std::nan(""))}, kOneObject, suspects).any());
    EXPECT_EQ(intersector.nearest(together(rays), Mask::of(0b1), {Reals(0.0), Reals(100.0)}).are, 1u) << "one ray";
}

}  // namespace
}  // namespace rays::packets::tests
