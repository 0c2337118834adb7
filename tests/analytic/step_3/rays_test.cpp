// Known answers of whole rays: slabs, ball lenses, mirror balls, images between mirrors, the furnace.
#include <gtest/gtest.h>

#include <cmath>

#include "core/query_log.h"
#include "renderer/radiance.h"
#include "stage.h"

namespace rays::tests {
namespace {

constexpr bool kDouble = sizeof(Real) == 8;
const std::string kDeep = "global_settings { max_trace_level 100 adc_bailout 0 }\n";
const std::string kInvisible = "pigment { rgbt 1 } finish { ambient 0 diffuse 0 } ";
const std::string kLossless =
    "pigment { rgbt 1 } finish { ambient 0 diffuse 0 reflection { 0, 1 fresnel on } conserve_energy } ";

struct Seen {
    Radiance radiance;
    double pruned = 0;
    std::vector<QueryLog::Query> rays;  ///< traced ones, without shadow rays
};

Seen seen(const std::string& text, const Ray& ray) {
    const Scene scene = staged(text);
    const BruteForce intersector(scene);
    World world = make_world(scene, intersector);
    QueryLog log;
    query_log = &log;
    Seen result{radiance(world, ray, media_around(scene, ray.origin)), 0, {}};
    query_log = nullptr;
    result.pruned = world.pruned;
    for (const auto& q : log.queries)
        if (q.kind != "shadow" && !q.pruned) result.rays.push_back(q);
    return result;
}

/// Glass 1 thick between z = 0 and 1; behind it green light, before it red.
std::string slab(const std::string& look, const std::string& interior) {
    return kDeep + "box { <-900, -900, 0>, <900, 900, 1> " + look + "interior { " + interior + " } }\n" +
           "plane { -z, -20 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission rgb <0, 1, 0> } }\n"
           "plane { z, -20 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission rgb <1, 0, 0> } }\n";
}

TEST(Slab, TransmitsTwelveThirteenths) {
    const Seen s = seen(slab(kLossless, "ior 1.5"), {{0, 0, -5}, {0, 0, 1}});
    EXPECT_NEAR(s.radiance[1], 12.0 / 13, 1e-6);
    EXPECT_NEAR(s.radiance[0], 1.0 / 13, 1e-6);
}

TEST(Slab, PartialSumsAreGeometric) {
    const double r = 0.04;
    for (int levels = 3; levels < 12; ++levels) {
        Scene scene = staged(slab(kLossless, "ior 1.5"));
        scene.settings.max_trace_level = levels;
        const BruteForce intersector(scene);
        World world = make_world(scene, intersector);
        const Radiance found = radiance(world, {{0, 0, -5}, {0, 0, 1}}, {});
        double through = 0;
        for (int k = 0; 3 + 2 * k <= levels; ++k) through += (1 - r) * (1 - r) * std::pow(r, 2 * k);
        EXPECT_NEAR(found[1], through, 1e-6) << levels;
        EXPECT_NEAR(found[0] + found[1] + world.pruned, 1, 1e-6) << "what is missing was pruned, at level " << levels;
    }
}

TEST(Slab, ShiftsAndStaysParallel) {
    for (const double degrees : {1.0, 20.0, 45.0, 70.0, 88.0}) {
        const double a = degrees * 3.14159265358979323846 / 180, n = 1.5;
        const Vec3 in(std::sin(a), 0, std::cos(a));
        const Seen s = seen(slab(kInvisible, "ior 1.5"), {-Real(3) * in, in});
        ASSERT_EQ(s.rays.size(), 3u) << degrees;
        const Ray& out = s.rays.back().ray;
        EXPECT_LT(glm::length(out.direction - in), kDouble ? 1e-13 : 1e-4) << degrees;
        // Across the ray, from the straight line through the origin.
        const Real shift = out.origin.z * in.x - out.origin.x * in.z;
        const double truth = std::sin(a) * (1 - std::cos(a) / std::sqrt(n * n - std::sin(a) * std::sin(a)));
        EXPECT_NEAR(shift, truth, kDouble ? 1e-12 : 1e-4) << degrees;
    }
}

TEST(Slab, LiftsWhatLiesBehindIt) {
    // Near the normal a point behind a slab looks nearer by t (1 - 1 / n).
    const Real a = Real(1e-3);
    const Vec3 in(std::sin(a), 0, std::cos(a));
    const Seen s = seen(slab(kInvisible, "ior 1.5"), {-Real(3) * in, in});
    const Ray& out = s.rays.back().ray;
    const Real moved = out.origin.z - out.origin.x * std::cos(a) / std::sin(a);
    EXPECT_NEAR(moved, 1 - 1 / 1.5, 1e-6 + (kDouble ? 0 : 1e-3));  // paraxial: off by angles squared
}

TEST(Slab, AbsorbsAsPovrayDoes) {
    // Only the part of a way that ends by leaving the glass is absorbed: reflected light within is not. So the closed
    // form T = (1 - R)^2 a / (1 - R^2 a^2) of physics has no a^2 here. (POV-Ray's slab is measured in povray_numbers.)
    const double r = 0.04, a = std::exp(-0.7);
    const Seen s =
        seen(slab(kLossless, "ior 1.5 fade_distance 1 fade_power 1001 fade_color rgb 0.3"), {{0, 0, -5}, {0, 0, 1}});
    EXPECT_NEAR(s.radiance[1], (1 - r) * (1 - r) * a / (1 - r * r), 1e-6);
}

TEST(BallLens, FocalLengthFromItsCentre) {
    for (const double n : {1.333, 1.5, 1.8}) {
        const Real h = Real(1e-3);
        const Seen s = seen(kDeep + "sphere { 0, 1 " + kInvisible + "interior { ior " + std::to_string(n) + " } }\n",
                            {{h, 0, -5}, {0, 0, 1}});
        ASSERT_EQ(s.rays.size(), 3u);
        const Ray& out = s.rays.back().ray;
        const Real focus = out.origin.z - out.origin.x / out.direction.x * out.direction.z;
        EXPECT_NEAR(focus, n / (2 * (n - 1)), kDouble ? 1e-5 : 1e-2) << n;  // spherical aberration: angles squared
    }
}

TEST(MirrorBall, FocusIsHalfItsRadiusBehindTheSurface) {
    const Real h = Real(1e-3);
    const Seen s = seen(kDeep + "sphere { 0, 2 pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection { 1 } } }\n",
                        {{h, 0, -9}, {0, 0, 1}});
    ASSERT_EQ(s.rays.size(), 2u);
    const Ray& out = s.rays.back().ray;
    const Real focus = out.origin.z - out.origin.x / out.direction.x * out.direction.z;
    EXPECT_NEAR(focus, -1, kDouble ? 1e-5 : 1e-2);
}

TEST(ParallelMirrors, TheKthImageIsTwoKTimesTheGapAway) {
    // Mirrors at z = 0 and z = 3, a ray at a slant: after k pairs of bounces it is where it would be 2 k 3 behind.
    const std::string room = kDeep +
                             "plane { z, 0 pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection { 1 } } }\n"
                             "plane { -z, -3 pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection { 1 } } }\n";
    const Seen s = seen(room, {{0, 0, 1}, {Real(0.6), 0, Real(0.8)}});
    ASSERT_EQ(s.rays.size(), 100u) << "as many rays as levels";
    for (std::size_t k = 1; 2 * k < s.rays.size(); ++k) {
        const Ray& ray = s.rays[2 * k].ray;  // from the mirror z = 0 again
        EXPECT_NEAR(ray.origin.x, (6.0 * double(k) - 1) * 0.75, (kDouble ? 1e-12 : 1e-4) * double(k)) << k;
        EXPECT_NEAR(ray.direction.z, 0.8, kDouble ? 1e-14 : 1e-6) << k;
    }
}

TEST(Chord, TheSecondHitIsAChordAway) {
    // No offset along the normal: a ray into a ball leaves it 2 r cos(inner angle) further on.
    for (const double h : {0.0, 0.3, 0.9, 0.999}) {
        const Seen s =
            seen(kDeep + "sphere { 0, 1 " + kInvisible + "interior { ior 1.5 } }\n", {{Real(h), 0, -5}, {0, 0, 1}});
        ASSERT_EQ(s.rays.size(), 3u) << h;
        EXPECT_NEAR(s.rays[1].hit->t, 2 * std::sqrt(1 - h * h / 2.25), kDouble ? 1e-12 : 1e-4) << h;
    }
}

TEST(Mirror, NegativeLightHasNoPowersInAMirror) {
    // A light that takes light away, seen in a mirror whose reflections have a fractional exponent: black, not NaN.
    const Scene scene = staged(
        "light_source { <0, 0, -5>, rgb -1 } plane { z, 0 pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection { "
        "1 "
        "exponent 3 } } } plane { z, -6 inverse pigment { rgb 1 } finish { ambient 0 diffuse 1 } }");
    const BruteForce intersector(scene);
    World world = make_world(scene, intersector);
    const Radiance seen = radiance(world, {{0.1, 0, -3}, {0, 0, 1}}, {});
    for (int c = 0; c < 3; ++c) EXPECT_EQ(seen[c], 0);
}

TEST(Furnace, LosslessGlassIsInvisible) {
    const std::string all = kDeep + "background { rgb 1 }\n";
    for (const char* thing : {"sphere { 0, 1 ", "box { -0.8, 0.8 rotate <20, 30, 10> ",
                              "torus { 0.7, 0.25 rotate 50*x ", "cone { -0.8*y, 0.9, 0.9*y, 0.2 "}) {
        Scene scene = staged(all + thing + kLossless + "interior { ior 1.7 } }\n");
        scene.settings.max_trace_level = 12;
        const BruteForce intersector(scene);
        World world = make_world(scene, intersector);
        for (int i = 0; i < 60; ++i) {
            world.pruned = 0;
            const Vec3 from(4 * std::sin(Real(i)), Real(0.1) * (i % 17) - Real(0.8), 4 * std::cos(Real(i)));
            const Vec3 at(Real(0.05) * (i % 13) - Real(0.3), Real(0.07) * (i % 7) - Real(0.2), 0);
            const Radiance found = radiance(world, {from, at - from}, media_around(scene, from));
            // Some hundred sums of floats.
            EXPECT_NEAR(found[0] + world.pruned, 1, 2e-5) << thing << i;
        }
    }
}

TEST(Furnace, WithoutConservedEnergyASlabGlows) {
    const std::string all = kDeep + "background { rgb 1 }\n";
    const Seen s = seen(all +
                            "box { <-900, -900, 0>, <900, 900, 1> pigment { rgbt 1 } finish { ambient 0 diffuse 0 "
                            "reflection { 0, 1 fresnel on } } interior { ior 1.5 } }\n",
                        {{0, 0, -5}, {0, 0, 1}});
    // 1 + R before, and inside the ray is joined by R of itself at each end: R + (1 + R / (1 - R)) = 0.04 + 1 / 0.96.
    EXPECT_NEAR(s.radiance[0], 0.04 + 1 / 0.96, 1e-5);
    EXPECT_NEAR(s.radiance[0], 1.082, 5e-4) << "as POV-Ray has it";
}

}  // namespace
}  // namespace rays::tests
