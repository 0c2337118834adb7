#include "renderer/render.h"

#include <gtest/gtest.h>

#include "core/unfinished.h"
#include "renderer/brute_force.h"
#include "scenes.h"

namespace rays {
namespace {

using tests::same_bytes;
using tests::staged;

TEST(Render, SameBytesForOneTwoAndSevenThreads) {
    const Scene scene = staged(tests::kBallOnFloor);
    RenderOptions options{.raster = {97, 61}, .samples = 4, .threads = 1};
    const Film one = render(scene, options);
    for (const int threads : {2, 7}) {
        options.threads = threads;
        EXPECT_TRUE(same_bytes(one, render(scene, options))) << threads << " threads";
    }
}

TEST(Render, AnEmptySceneIsItsBackground) {
    const Film film = render(staged(tests::kHead), {.raster = {3, 2}});
    for (int x = 0; x < 3; ++x) EXPECT_FLOAT_EQ(film.at(x, 1)[2], 0.3f);
}

TEST(Render, OnePixelIsAPicture) {
    EXPECT_TRUE(render(staged(tests::kBallOnFloor), {.raster = {1, 1}}).at(0, 0).is_finite());
}

TEST(Render, MoreSamplesAreTheMeanOfThePixel) {
    // A plane of brightness 1 covers the lower half of a 1 x 1 picture exactly.
    const std::string half =
        "camera { orthographic location <0,0,-5> direction z right x up y }\n"
        "box { <-9,-9,0>, <9,0,1> pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 1 } }\n";
    const auto pixel = [&half](const std::string& head) {
        return render(staged(head + half), {.raster = {1, 1}, .samples = 16}).at(0, 0)[0];
    };
    EXPECT_FLOAT_EQ(pixel("#version 3.7;"), 0.5f);
    // The mean is one of the scene's numbers; the picture holds the light that it stands for.
    EXPECT_FLOAT_EQ(pixel("#version 3.7; global_settings { assumed_gamma 2 }"), 0.25f);
    EXPECT_FLOAT_EQ(pixel("#version 3.5;"), 0.21404114f);
}

// A face that wears clear glass, of a mesh that is opaque itself: the light above it goes through to the floor.
TEST(Render, ClearFacesOfOpaqueMeshesTintTheirShadows) {
    const Scene scene = staged(
        "#version 3.7; global_settings { assumed_gamma 1.0 }\n"
        "camera { orthographic location <0, 0.5, 0> direction -y right x up z }\n"
        "light_source { <0, 1000, 0>, rgb 1 parallel point_at 0 }\n"
        "#declare Glass = texture { pigment { rgbf <1, 0.25, 0.5, 0.5> } }\n"
        "plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }\n"
        "mesh { triangle { <-9, 1, -9>, <9, 1, -9>, <0, 1, 9> texture { Glass } }\n"
        "       triangle { <90, 1, 90>, <91, 1, 90>, <90, 1, 91> } texture { pigment { rgb 1 } } }\n");
    for (const bool packets : {true, false}) {
        const Film film = render(scene, {.raster = {1, 1}, .threads = 1, .packets = packets});
        const Radiance through = film.at(0, 0);
        EXPECT_FLOAT_EQ(through[0], 0.5f);
        EXPECT_FLOAT_EQ(through[1], 0.125f);
        EXPECT_FLOAT_EQ(through[2], 0.25f);
    }
}

TEST(Render, ToriInOneAnotherLookTheSameInPackets) {
    std::string tori = tests::kHead + "light_source { <3,5,-4> rgb 1 }\n";
    for (int i = 0; i < 40; ++i) {
        const std::string n = std::to_string(i);
        tori += "torus { 0.5+0.05*" + n + ", 0.04 rotate <7*" + n + ", 0, 3*" + n + "> translate y }\n" +
                "torus { 0.1, 0.3 scale <1, 0.2, 2> translate <0.2*" + n + "-4, 2, 0> }\n";
    }
    const Scene scene = staged(tori + "plane { y, -1 }");
    const Film together = render(scene, {.raster = {64, 48}, .threads = 1});
    const Film alone = render(scene, {.raster = {64, 48}, .threads = 1, .packets = false});
    EXPECT_TRUE(tests::same_bytes(together, alone));
}

TEST(Render, WhoWaitsForAStructureDoesNotAskThousandsOfObjects) {
    std::string row = tests::kHead;
    for (int i = 0; i < 1001; ++i) row += "sphere { <" + std::to_string(i) + ",0,0>, 0.4 }\n";
    const Scene few = staged(tests::kBallOnFloor), many = staged(row);
    const Ray at_ball{{0, 1, -5}, {0, 0, 1}}, at_row{{7, 0, -5}, {0, 0, 1}};
    EXPECT_TRUE(BruteForce(few, "4.6").nearest(at_ball, {0, 100})) << "what is finished is seen through the stripes";
    EXPECT_TRUE(BruteForce(many).occluded(at_row, {0, 100})) << "nobody waits";
    EXPECT_FALSE(BruteForce(many, "4.6").nearest(at_row, {0, 100}));
    EXPECT_FALSE(BruteForce(many, "4.6").occluded(at_row, {0, 100}));
    EXPECT_STREQ(take_unfinished_task(), "4.6");
}

TEST(Render, ProgressEndsAtOne) {
    double last = 0;
    RenderOptions options{.raster = {4, 9}, .threads = 1, .progress = [&](double done) { last = done; }};
    render(staged(tests::kHead), options);
    EXPECT_EQ(last, 1);
}

const std::string kMirrorRoom = tests::kBallOnFloor +
                                "plane { -z, -4 pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection { 0.9 } } }\n"
                                "plane { z, -6 pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection { 0.9 } } }\n";

TEST(Residual, IsTheWeightOfWhatWasNotTraced) {
    Scene scene = staged(kMirrorRoom);
    scene.settings.max_trace_level = 1;  // no mirror ray is traced: each weighs 0.9
    Residual residual;
    render(scene, {.raster = {40, 30}}, &residual);
    EXPECT_FLOAT_EQ(static_cast<float>(residual.max), 0.9f);
    EXPECT_GT(residual.mean, 0.01);
    EXPECT_LT(residual.mean, 0.5);
    EXPECT_FLOAT_EQ(static_cast<float>(explain(scene, {.raster = {40, 30}}, residual.x, residual.y).residual()), 0.9f);
}

TEST(Residual, BoundsWhatIsMissing) {
    Scene scene = staged(kMirrorRoom);
    scene.settings.adc_bailout = 0;
    scene.settings.max_trace_level = 40;
    const Film all = render(scene, {.raster = {40, 30}});
    float brightest = 0;
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 40; ++x) brightest = std::max(brightest, all.at(x, y).largest());
    scene.settings.max_trace_level = 3;
    Residual residual;
    const Film cut = render(scene, {.raster = {40, 30}}, &residual);
    float missing = 0;
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 40; ++x) missing = std::max(missing, all.at(x, y)[0] - cut.at(x, y)[0]);
    EXPECT_GT(missing, 0.01f);
    EXPECT_LE(missing, residual.max * brightest);
}

TEST(Residual, IsTheSameForAnyNumberOfThreadsAndZeroWhenNothingIsPruned) {
    const Scene scene = staged(kMirrorRoom);
    Residual one, three, none;
    render(scene, {.raster = {41, 33}, .threads = 1}, &one);
    render(scene, {.raster = {41, 33}, .threads = 3}, &three);
    EXPECT_GT(one.mean, 0);
    EXPECT_EQ(one.mean, three.mean);
    EXPECT_EQ(one.max, three.max);
    EXPECT_EQ(one.x, three.x);
    EXPECT_EQ(one.y, three.y);
    render(staged(tests::kBallOnFloor), {.raster = {20, 15}}, &none);
    EXPECT_EQ(none.max, 0);
}

TEST(Explain, TheTreeBeginsWithTheCameraRayAndHoldsTheShadowRay) {
    const Scene scene = staged(tests::kBallOnFloor);
    const QueryLog log = explain(scene, {.raster = {40, 30}}, 20, 18);
    ASSERT_GE(log.queries.size(), 2u);
    EXPECT_EQ(log.queries[0].kind, "camera");
    EXPECT_TRUE(log.queries[0].hit.has_value());
    EXPECT_EQ(log.queries[1].kind, "shadow");
    EXPECT_EQ(query_log, nullptr);
}

TEST(Explain, TheRadianceIsThePixels) {
    const Scene scene = staged(tests::kBallOnFloor);
    const Film film = render(scene, {.raster = {40, 30}});
    const QueryLog log = explain(scene, {.raster = {40, 30}}, 17, 11);
    for (int c = 0; c < 3; ++c) EXPECT_EQ(log.queries.front().radiance[c], film.at(17, 11)[c]);
}

}  // namespace
}  // namespace rays
