// Light sources, background, global settings.
#include "read.h"

namespace rays {
namespace {

TEST(LightReader, Point) {
    const Scene scene =
        scene_of("light_source { <1,2,3> color rgb <1,0.5,0.25> fade_distance 4 fade_power 2 shadowless translate x }");
    const Light& light = scene.lights[0];
    EXPECT_EQ(light.kind, Light::Kind::point);
    EXPECT_TRUE(near(light.location, {2, 2, 3}));
    EXPECT_EQ(light.color[1], 0.5f);
    EXPECT_EQ(light.fade_distance, 4);
    EXPECT_EQ(light.fade_power, 2);
    EXPECT_TRUE(light.shadowless);
    EXPECT_TRUE(scene.objects.empty());
}

TEST(LightReader, SpotAnglesAreRadians) {
    const Scene scene = scene_of(
        "light_source { 0, 1 spotlight point_at 5*z radius 20 falloff 40 tightness 10 rotate 90*y } light_source { 0, "
        "1 spotlight }");
    const Light& light = scene.lights[0];
    EXPECT_EQ(light.kind, Light::Kind::spot);
    EXPECT_NEAR(light.radius_rad, 20 * kPi / 180, kClose);
    EXPECT_NEAR(light.falloff_rad, 40 * kPi / 180, kClose);
    EXPECT_EQ(light.tightness, 10);
    EXPECT_TRUE(near(light.point_at, {5, 0, 0}));
    EXPECT_NEAR(scene.lights[1].radius_rad, 30 * kPi / 180, kClose);
    EXPECT_NEAR(scene.lights[1].falloff_rad, 45 * kPi / 180, kClose);
    EXPECT_TRUE(near(scene.lights[1].point_at, {0, 0, 1}));
}

TEST(LightReader, CylinderAndParallel) {
    const Scene scene = scene_of(
        "light_source { 0, 1 cylinder radius 2 falloff 3 point_at y } light_source { y, 1 parallel point_at 0 }");
    EXPECT_EQ(scene.lights[0].kind, Light::Kind::cylinder);
    EXPECT_TRUE(scene.lights[0].parallel);
    EXPECT_EQ(scene.lights[0].radius_rad, 2);
    EXPECT_EQ(scene.lights[0].falloff_rad, 3);
    EXPECT_TRUE(scene.lights[1].parallel);
    EXPECT_EQ(scene.lights[1].kind, Light::Kind::point);
}

/// As POV-Ray 3.7.0.10 renders them: each pair gives the same picture to the last bit.
TEST(LightReader, TheLastOfShadowlessSpotlightAndCylinderCounts) {
    const std::string spot = "spotlight point_at 0 radius 5 falloff 8 tightness 3 ";
    const std::pair<std::string, std::string> alike[] = {
        {spot + "shadowless", "shadowless"},
        {"shadowless " + spot, spot},
        {"shadowless cylinder point_at 0", "cylinder point_at 0"},
        {spot + "cylinder", "cylinder point_at 0"},
        {"cylinder " + spot, "parallel " + spot},
        {"cylinder point_at 0 radius 1 falloff 2 shadowless", "parallel point_at 0 shadowless"},
    };
    for (const auto& [words, same_words] : alike) {
        const auto light_of = [](const std::string& text) {
            return scene_of("light_source { <3,6,-4>, 1 " + text + " }").lights.at(0);
        };
        const Light light = light_of(words), same = light_of(same_words);
        EXPECT_EQ(light.kind, same.kind) << words;
        EXPECT_EQ(light.shadowless, same.shadowless) << words;
        EXPECT_EQ(light.parallel, same.parallel) << words;
        EXPECT_EQ(light.radius_rad, same.radius_rad) << words;
        EXPECT_EQ(light.falloff_rad, same.falloff_rad) << words;
        EXPECT_EQ(light.tightness, same.tightness) << words;
        // Where a point light points does not matter.
        if (light.parallel || light.kind != Light::Kind::point) {
            EXPECT_TRUE(near(light.point_at, same.point_at)) << words;
        }
    }
    // These are errors in POV-Ray, too: a shadowless light has no cone and no direction of its own.
    EXPECT_TRUE(contains(error_of("light_source { y, 1 spotlight shadowless radius 3 }"), "'radius' needs spotlight"));
    EXPECT_TRUE(contains(error_of("light_source { y, 1 shadowless point_at 0 }"), "'point_at' needs spotlight"));
}

TEST(LightReader, Area) {
    const Scene scene = scene_of(
        "light_source { 0, 1 area_light <2,0,0>, <0,0,3>, 4, 5 adaptive 1 jitter circular orient rotate 90*y }");
    const Light& light = scene.lights[0];
    EXPECT_TRUE(light.area && light.jitter && light.circular && light.orient);
    EXPECT_TRUE(near(light.axis_u, {0, 0, -2}));
    EXPECT_TRUE(near(light.axis_v, {3, 0, 0}));
    EXPECT_EQ(light.size_u, 4);
    EXPECT_EQ(light.size_v, 5);
    EXPECT_EQ(light.adaptive, 1);
}

TEST(LightReader, LightsInUnionsMoveWithThem) {
    const Scene scene = scene_of(
        "union { light_source { 0, 1 } sphere { 0, 1 } translate x } #declare L = light_source { y, 1 } light_source { "
        "L translate x }");
    EXPECT_TRUE(near(scene.lights[0].location, {1, 0, 0}));
    EXPECT_TRUE(near(scene.lights[1].location, {1, 1, 0}));
}

TEST(LightReader, Nonsense) {
    EXPECT_TRUE(contains(error_of("light_source { 0, 1 radius 5 }"), "'radius' needs spotlight"));
    EXPECT_TRUE(contains(error_of("light_source { z, 1 spotlight point_at z }"), "its own location"));
    EXPECT_TRUE(contains(error_of("light_source { 0, 1 area_light x, y, 0, 1 }"), "between 1 and"));
}

TEST(SettingsReader, BackgroundAndGlobalSettings) {
    const Scene scene = scene_of(
        "global_settings { assumed_gamma 1.0 max_trace_level 7 adc_bailout 0 ambient_light rgb <1,2,3> photons { "
        "spacing 0.1 } }\n"
        "background { rgb <0.1,0.2,0.3> }");
    EXPECT_EQ(scene.settings.max_trace_level, 7);
    EXPECT_EQ(scene.settings.adc_bailout, 0);
    EXPECT_EQ(scene.settings.ambient_light[2], 3);
    EXPECT_TRUE(scene.settings.photons);
    EXPECT_EQ(scene.settings.photon_spacing, Real(0.1));
    EXPECT_EQ(scene.background[1], 0.2f);
}

// POV-Ray 3.7.0.10: tokenize.cpp, EffectiveLanguageVersion() in scene.h.
TEST(SettingsReader, GammaAsPovRayTakesIt) {
    const auto gamma_of = [](const std::string& text) { return scene_of(text).settings.gamma; };
    EXPECT_TRUE(gamma_of("#version 3.7;").is_linear());
    EXPECT_TRUE(gamma_of("#version 3.5; global_settings { assumed_gamma 1 }").is_linear());
    EXPECT_TRUE(gamma_of("global_settings { assumed_gamma 1.005 }").is_linear());
    EXPECT_EQ(gamma_of("global_settings { assumed_gamma 2.2 }").power, 2.2f);
    EXPECT_TRUE(gamma_of("#version 3.7; global_settings { assumed_gamma srgb }").srgb);
    EXPECT_TRUE(gamma_of("").srgb);
    EXPECT_TRUE(gamma_of("#version 3.5;").srgb);
    EXPECT_TRUE(gamma_of("#version 3.5; #version 3.7;").is_linear());
    EXPECT_EQ(gamma_of("global_settings { assumed_gamma 1.5 } global_settings { assumed_gamma 1 }").power, 1.5f);
    EXPECT_TRUE(contains(error_of("global_settings { assumed_gamma 0 }"), "greater than 0"));
    const Scene old = scene_of("camera { }");
    ASSERT_EQ(old.notes.size(), 1u);
    EXPECT_TRUE(contains(old.notes[0], "neither #version 3.7 nor assumed_gamma"));
}

TEST(SettingsReader, ColoursOfSrgbMeetTheGamma) {
    const auto green_of = [](const std::string& settings) {
        return scene_of("#version 3.7; global_settings { " + settings + " } background { srgb <0, 0.5, 1> }")
            .background[1];
    };
    EXPECT_NEAR(green_of("assumed_gamma 1"), 0.21404114f, 1e-7f);
    EXPECT_NEAR(green_of("assumed_gamma 2"), 0.46264580f, 1e-6f);
    EXPECT_EQ(green_of("assumed_gamma srgb"), 0.5f);
}

TEST(SettingsReader, OldVersionsFilterByColour) {
    EXPECT_FALSE(scene_of("#version 3.7;").settings.filter_by_color);
    EXPECT_TRUE(scene_of("#version 3.6;").settings.filter_by_color);
    EXPECT_TRUE(scene_of("").settings.filter_by_color);
    EXPECT_EQ(scene_of("#version 3.7; background { rgbt 0.8 }").background[0], 0.8f * (1 - 0.8f));
    EXPECT_EQ(scene_of("#version 3.6; background { rgbt 0.8 }").background[0], 0.8f);
}

TEST(LightReader, ALocationCanHaveAName) {
    const Scene scene = scene_of("#declare From = <1,2,3>; light_source { From, rgb 0.5 } light_source { From rgb 1 }");
    ASSERT_EQ(scene.lights.size(), 2u);
    EXPECT_TRUE(near(scene.lights[0].location, {1, 2, 3}));
    EXPECT_EQ(scene.lights[0].color[0], 0.5f);
}

}  // namespace
}  // namespace rays
