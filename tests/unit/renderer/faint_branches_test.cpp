// Branches that nobody could see: from which weight on, and that indeed nobody sees them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <random>

#include <fmt/format.h>

#include "../packets/scene_writer.h"
#include "renderer/needs.h"
#include "scenes.h"

namespace rays {
namespace {

constexpr double kFinestStep = 0x1p-24;  // of a half float

const std::string kDeep = "#version 3.7; global_settings { assumed_gamma 1.0 max_trace_level 4 adc_bailout 0 }\n";
const std::string kLossless =
    "pigment { rgbt 1 } finish { ambient 0 diffuse 0 reflection { 0, 1 fresnel on } conserve_energy } interior { ior "
    "1.5 }";

double weight(const std::string& rest) {
    return faintest_weight(read_scene_text(kDeep + "background { rgb 1 }\n" + rest, "faint"));
}

TEST(FaintBranches, AFurnaceBringsItsBackgroundAtMost) {
    EXPECT_DOUBLE_EQ(weight("sphere { 0, 1 " + kLossless + " }"), kFinestStep);
    EXPECT_DOUBLE_EQ(weight("background { rgb <0, 8, 1> } sphere { 0, 1 " + kLossless + " }"), kFinestStep / 8);
}

TEST(FaintBranches, LightsAndWhatTheyLightCount) {
    const std::string glass = "sphere { 0, 1 " + kLossless + " }\n";
    const auto floor = [&](const std::string& finish) {
        return glass + "plane { y, -2 pigment { rgb <0.5, 1, 0> } finish { " + finish + " } }\n";
    };
    const std::string light =
        "light_source { 9, rgb 3 } light_source { -9, rgb <0, 1, 2> fade_distance 1 fade_power 2 }\n";
    EXPECT_DOUBLE_EQ(weight(floor("ambient 2 diffuse 0")), kFinestStep / 2);
    EXPECT_DOUBLE_EQ(weight(floor("ambient 0 diffuse 0 emission 5")), kFinestStep / 5);
    EXPECT_DOUBLE_EQ(weight(light + floor("ambient 1 diffuse 0.5")), kFinestStep / (1 + 0.5 * (3 + 2 * 2)));
    EXPECT_DOUBLE_EQ(weight(light + floor("ambient 0 diffuse 0 phong 1 specular 1")), kFinestStep / (2 * 7));
}

TEST(FaintBranches, WhatGivesMoreThanItGetsCountsOnEachLevel) {
    // 1/4 + 1/2 of ... of 1: with a background of 1 no more than 1; with a mirror of 1, 1/4 more a level.
    const auto mirror = [](double share) {
        return fmt::format("sphere {{ 0, 1 pigment {{ rgb 1 }} finish {{ ambient 0.25 diffuse 0 reflection {} }} }}",
                           share);
    };
    EXPECT_DOUBLE_EQ(weight(mirror(0.5)), kFinestStep);
    EXPECT_DOUBLE_EQ(weight(mirror(1)), kFinestStep / 2);
    // Without conserve_energy glass passes what it mirrors as well: twice as much a level.
    EXPECT_DOUBLE_EQ(weight("sphere { 0, 1 pigment { rgbt 1 } finish { ambient 0 diffuse 0 reflection { 0, 1 fresnel "
                            "on } } interior { ior 1.5 } }"),
                     kFinestStep / 16);
}

TEST(FaintBranches, TotalReflectionOutweighsATint) {
    // Its weight has the tint, a half on each level, its light has not.
    const std::string half = "sphere { 0, 1 pigment { rgbt 0.5 } finish { ambient 0 diffuse 0 } interior { ior ";
    EXPECT_DOUBLE_EQ(weight(half + "1.5 } }"), kFinestStep / 16);
    EXPECT_DOUBLE_EQ(weight(half + "1 } }"), kFinestStep);
    // And it passes all: a highlight of 1 may be added on each level.
    EXPECT_DOUBLE_EQ(
        weight("light_source { 9, rgb 1 } sphere { 0, 1 pigment { rgbt 0.5 } finish { ambient 0 diffuse 0 phong "
               "1 } interior { ior 1.5 } }"),
        kFinestStep / (16 * (1 + 4)));
}

TEST(FaintBranches, ABrightMetalOutweighsItsWeight) {
    EXPECT_DOUBLE_EQ(
        weight("sphere { 0, 1 pigment { rgb 2 } finish { ambient 0 diffuse 0 reflection { 0.5 metallic } } }"),
        kFinestStep / 16);
}

TEST(FaintBranches, TheGreyOfATintMayBeMuchLessThanItsLargestLane) {
    const auto clear = [](const char* color) {
        return fmt::format("sphere {{ 0, 1 pigment {{ {} }} finish {{ ambient 0 diffuse 0 }} }}", color);
    };
    EXPECT_DOUBLE_EQ(weight(clear("rgbf <0.5, 0.5, 1, 1>")), 0.114 * kFinestStep);
    EXPECT_DOUBLE_EQ(weight(clear("rgbf <0.5, 0.5, 0.5, 1>")), kFinestStep);
}

TEST(FaintBranches, NobodyKnowsWhatAContrastMakesOfLittle) {
    EXPECT_EQ(weight("sphere { 0, 1 finish { reflection 0.5 reflection_exponent 2 } }"), 0);
}

TEST(FaintBranches, NobodyKnowsHowLargeANegativePowerIs) {
    const std::string glass = "sphere { 0, 1 " + kLossless + " }\n";
    const std::string light = "light_source { 9, rgb 1 }\n";
    EXPECT_GT(weight(glass + light + "plane { y, 0 finish { phong 1 } }"), 0);
    EXPECT_EQ(weight(glass + light + "plane { y, 0 finish { phong 1 phong_size -1 } }"), 0);
    EXPECT_EQ(weight(glass + light + "plane { y, 0 finish { reflection { 0, 0.5 falloff -1 } } }"), 0);
    EXPECT_EQ(weight(glass + "light_source { 9, rgb 1 spotlight tightness -1 } plane { y, 0 }"), 0);
}

TEST(FaintBranches, NobodyKnowsHowMuchLightGlassMakes) {
    const auto fades_to = [](const char* color) {
        return std::string(
                   "sphere { 0, 1 pigment { rgbt 1 } interior { fade_distance 1 fade_power 1001 fade_color rgb ") +
               color + " } }";
    };
    EXPECT_GT(weight(fades_to("<0, 1, 1>")), 0);
    EXPECT_EQ(weight(fades_to("<0, 1.1, 1>")), 0);
    EXPECT_EQ(weight(fades_to("<0, -0.1, 1>")), 0);
    EXPECT_GT(weight("sphere { 0, 1 pigment { rgbft <1, 0.5, 1, 0.9, 0.1> } }"), 0);
    EXPECT_EQ(weight("sphere { 0, 1 pigment { rgbft <1, 0.5, 1, 0.9, 0.2> } }"), 0);
}

TEST(FaintBranches, ScenesWithoutBranchesLeaveNothingOut) {
    EXPECT_EQ(weight("sphere { 0, 1 pigment { rgb 1 } }"), 0);
    EXPECT_EQ(weight(""), 0);
}

TEST(FaintBranches, TheScenesOwnBailoutStaysWhenItIsLarger) {
    Scene scene = read_scene_text(
        "global_settings { adc_bailout 0.01 } background { rgb 1 } sphere { 0, 1 " + kLossless + " }", "own");
    drop_faint_branches(scene);
    EXPECT_EQ(scene.settings.adc_bailout, 0.01f);
    scene.settings.adc_bailout = 0;
    drop_faint_branches(scene);
    EXPECT_EQ(scene.settings.adc_bailout, static_cast<float>(kFinestStep));
}

TEST(FaintBranches, ScenesThatMoveKeepTheirs) {
    Scene scene = read_scene_text(kDeep + "background { rgb Time } sphere { 0, 1 " + kLossless + " }", "moves");
    drop_faint_branches(scene);
    EXPECT_EQ(scene.settings.adc_bailout, 0);
}

// ---- Pictures -------------------------------------------------------------------------------------------------------

/// The largest difference that leaving faint branches out makes, in units of what a float holds of the pixel plus 1.
double largest_difference(Scene scene, Raster raster) {
    prepare(scene);
    const Film all = render(scene, {.raster = raster});
    drop_faint_branches(scene);
    const Film seen = render(scene, {.raster = raster});
    double largest = 0;
    for (int y = 0; y < raster.height; ++y)
        for (int x = 0; x < raster.width; ++x)
            for (int c = 0; c < 3; ++c) {
                const double a = all.at(x, y)[c], b = seen.at(x, y)[c];
                largest = std::max(largest, std::abs(a - b) / (1 + std::abs(a)));
            }
    return largest;
}

/// A pixel loses a few hundred branches at most, each less than the finest step.
constexpr double kUnseen = 256 * kFinestStep;

TEST(FaintBranches, NobodySeesThemInTheScenesOfStep3) {
    int differ = 0;
    for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(SCENES_DIR) / "3_recursion")) {
        if (entry.path().extension() != ".pov") continue;
        ReadOptions options;
        options.raster = {96, 72};
        const double difference = largest_difference(read_scene(entry.path(), options), options.raster);
        EXPECT_LE(difference, kUnseen) << entry.path();
        differ += difference > 0;
    }
    EXPECT_GE(differ, 2) << "nothing was left out";
}

int scenes_by_chance() {
    const char* wanted = std::getenv("RAYSTEPS_CHANCE_SCENES");
    return wanted ? std::atoi(wanted) : 100;
}

TEST(FaintBranches, NobodySeesThemInScenesByChance) {
    for (int seed = 0; seed < scenes_by_chance(); ++seed) {  // most of these give more than they get somewhere
        Scene scene = read_scene_text(packets::tests::SceneWriter(std::uint64_t(seed)).scene(), "chance");
        scene.settings.max_trace_level = 8;
        scene.settings.adc_bailout = 0;
        EXPECT_LE(largest_difference(scene, {31, 22}), kUnseen) << "seed " << seed;
    }
}

/// Balls that give no more than they get, near each other: deep trees of ever fainter branches.
std::string modest_balls(std::uint64_t seed) {
    std::mt19937_64 bits(seed);
    const auto number = [&](double from, double to) { return from + (to - from) * double(bits() >> 11) * 0x1p-53; };
    const auto one_of = [&](std::initializer_list<const char*> words) { return words.begin()[bits() % words.size()]; };
    std::string text =
        "#version 3.7; global_settings { assumed_gamma 1.0 max_trace_level 12 adc_bailout 0 }\n"
        "camera { location <0, 1, -6> right x*4/3 look_at 0 angle 50 } background { rgb <0.4, 0.7, 1> }\n"
        "light_source { <3, 9, -5>, rgb 1 }\n";
    for (int n = 0; n < 8; ++n)
        text += fmt::format(
            "sphere {{ <{}, {}, {}>, {} pigment {{ {} }} finish {{ ambient 0 diffuse 0.2 {} conserve_energy }} "
            "interior {{ "
            "ior {} }} }}\n",
            number(-1.5, 1.5), number(-1, 1), number(-1.5, 1.5), number(0.3, 0.9),
            one_of({"rgbt 1", "rgbf <1, 1, 1, 1>", "rgbf <0.9, 1, 0.8, 0.9>", "rgb <0.3, 0.6, 0.2>"}),
            one_of({"reflection { 0, 1 fresnel on }", "reflection 0.1", "reflection { rgb <0.2, 0.1, 0.3> metallic }",
                    ""}),
            one_of({"1.1", "1.5", "2"}));
    return text;
}

TEST(FaintBranches, NobodySeesThemAmongBallsByChance) {
    int differ = 0;
    for (int seed = 0; seed < scenes_by_chance(); ++seed) {
        const double difference =
            largest_difference(read_scene_text(modest_balls(std::uint64_t(seed)), "balls"), {31, 22});
        EXPECT_LE(difference, kUnseen) << "seed " << seed;
        differ += difference > 0;
    }
    EXPECT_GE(20 * differ, scenes_by_chance()) << "nothing was left out";
}

}  // namespace
}  // namespace rays
