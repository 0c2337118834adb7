#include "renderer/needs.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "renderer/brute_force.h"
#include "renderer/radiance.h"
#include "scenes.h"

namespace rays {
namespace {

using tests::same_bytes;

Film picture(Scene scene) {
    prepare(scene);
    return render(scene, {.raster = {60, 45}});
}

/// Shows every effect of the steps built so far, each on some pixel.
const std::string kEverything =
    tests::kHead +
    "light_source { <3,5,-4> rgb 0.5 fade_distance 6 fade_power 2 }\n"
    "light_source { <-4,6,-3> rgb 0.5 spotlight point_at <-1,0,0> radius 10 falloff 20 tightness 2 }\n"
    "light_source { <0,9,-9> rgb 0.3 parallel point_at <0,0,0> }\n"
    "sphere { <0,1,0>, 1 pigment { rgb <1,0.5,0.2> } clipped_by { box { <-2,-2,-2>, <2,1.5,2> } }\n"
    "  finish { ambient 0.1 diffuse 0.6 phong 0.5 specular 0.2 metallic 1 emission 0.05 } }\n"
    "smooth_triangle { <-2,0.1,0>, <-1,1,-1>, <-1.2,0.1,0>, <0,1,0>, <-1.5,1.8,0.2>, <1,0,-1> pigment { rgb 1 } }\n"
    "plane { y, 0 pigment { checker rgb 1 rgb 0.2 } finish { ambient 0.1 diffuse 0.7 } }\n"
    "sphere { <1.6,0.7,-0.8>, 0.7 pigment { rgbf <0.8,0.9,0.7,0.9> } finish { ambient 0 diffuse 0.1\n"
    "  reflection { 0, 1 fresnel on } conserve_energy }\n"
    "  interior { ior 1.5 fade_distance 1 fade_power 1001 fade_color rgb <0.3,0.6,0.9> } }\n"
    "sphere { <-1.5,2.2,1>, 0.6 pigment { rgb <1,0.7,0.3> }\n"
    "  finish { ambient 0 diffuse 0.1 reflection { 0.7 metallic } reflection_exponent 1.5 } }\n";

/// And every effect of step 5.
const std::string kDistributed =
    tests::kHead +
    "camera { location <0,2,-6> direction z*1.5 right x*4/3 up y aperture 0.5 focal_point <0,2,0> }\n"
    "light_source { <3,5,-4> rgb 1 area_light <2,0,0>, <0,0,2>, 4, 4 }\n"
    "sphere { <-1 + 2 * Time,1,0>, 1 pigment { rgb <1,0.5,0.2> } finish { ambient 0.1 diffuse 0.6 phong 0.5 } }\n"
    "plane { y, 0 pigment { checker rgb 1 rgb 0.2 } finish { ambient 0.1 diffuse 0.5 reflection 0.3 glossy 0.02 } }\n";

void expect_each_effect_of(int step, const std::string& text) {
    const Scene scene = read_scene_text(text, "everything");
    const Film full = picture(scene);
    for (const Effect& effect : effects()) {
        if (effect.step > kLastBuiltStep || (effect.step == 5) != (step == 5)) continue;
        ASSERT_TRUE(effect.needed(scene)) << effect.name;
        Scene without = scene;
        remove_effect(without, effect.name);
        EXPECT_FALSE(effect.needed(without)) << effect.name;
        EXPECT_FALSE(same_bytes(full, picture(without))) << effect.name << " makes no difference";
    }
}

TEST(Needs, LeavingOutANeededEffectChangesThePicture) {
    expect_each_effect_of(1, kEverything);
    expect_each_effect_of(5, kDistributed);
}

TEST(Needs, WithoutStep5AllOfItIsGone) {
    Scene scene = read_scene_text(kDistributed, "distributed");
    EXPECT_TRUE(is_distributed(scene, {}));
    for (const char* effect : {"area_lights", "depth_of_field", "motion", "glossy"}) remove_effect(scene, effect);
    EXPECT_FALSE(is_distributed(scene, {}));
    EXPECT_TRUE(is_distributed(scene, {.samples = 7}));
    EXPECT_FALSE(is_distributed(scene, {.samples = 9}));
}

/// Nothing of it can be seen: the bytes are those of a pinhole, a point light and a still scene.
TEST(Needs, EffectsOfNoSizeAreNotModelled) {
    const std::string rest =
        "sphere { <0,1,0>, 1 pigment { rgb <1,0.5,0.2> } finish { ambient 0.1 diffuse 0.6 phong 0.5 } }\n"
        "sphere { <2,1,1>, 1 pigment { rgb <1,0.5,0.9> } finish { ambient 0.1 diffuse 0.6 phong 0.5 } }\n";
    const std::string camera = "camera { location <0,2,-6> direction z*1.5 right x*4/3 up y focal_point <0,2,0> ";
    const auto staged = [&](const std::string& text) {
        Scene scene = read_scene_text(tests::kHead + text + rest, "small");
        drop_what_is_not_needed(scene);
        drop_small_blur(scene, {60, 45});
        return scene;
    };
    const Scene plain = staged(camera + "}\nlight_source { <30,50,-40> rgb 1 }\n");
    const Scene small =
        staged(camera + "aperture 0.001 }\nlight_source { <30,50,-40> rgb 1 area_light x*0.001, y*0.001, 4, 4 }\n");
    const Scene none = staged(camera + "aperture 0 }\nlight_source { <30,50,-40> rgb 1 area_light 0, 0, 4, 4 }\n");
    const Scene large =
        staged(camera + "aperture 0.5 }\nlight_source { <30,50,-40> rgb 1 area_light x*9, y*9, 4, 4 }\n");
    EXPECT_FALSE(is_distributed(small, {}));
    EXPECT_FALSE(is_distributed(none, {}));
    EXPECT_TRUE(same_bytes(picture(plain), picture(small)));
    EXPECT_TRUE(same_bytes(picture(plain), picture(none)));
    EXPECT_GT(large.camera.aperture, 0);
    EXPECT_TRUE(large.lights.front().area);
}

TEST(Needs, WhatIsNotNeededMakesNoDifference) {
    const std::string text = tests::kBallOnFloor + "light_source { <1,1,-9> rgb 0 fade_distance 0 fade_power 2 }\n";
    const Scene scene = read_scene_text(text, "plain");
    const Film full = picture(scene);
    for (const Effect& effect : effects()) {
        if (effect.needed(scene)) continue;
        Scene without = scene;
        remove_effect(without, effect.name);
        EXPECT_TRUE(same_bytes(full, picture(without))) << effect.name;
    }
    Scene lean = scene;
    drop_what_is_not_needed(lean);
    EXPECT_LT(lean.lights.size(), scene.lights.size());
    EXPECT_TRUE(same_bytes(full, picture(lean)));
}

TEST(Needs, DroppingWhatIsNotNeededKeepsThePictureOfEverything) {
    Scene lean = read_scene_text(kEverything, "everything");
    const Film full = picture(lean);
    drop_what_is_not_needed(lean);
    EXPECT_TRUE(same_bytes(full, picture(lean)));
}

bool needs(const Scene& scene, const char* name) {
    for (const Effect& effect : effects())
        if (effect.name == name) return effect.needed(scene);
    ADD_FAILURE() << "no effect " << name;
    return false;
}

TEST(Needs, WhatOnlyLooksLikeGlassNeedsNoneOfIt) {
    // An opaque ball with an index and a fade, a mirror of strength nothing, a clear ball that casts no shadow.
    const Scene scene = read_scene_text(tests::kBallOnFloor +
                                            "sphere { <2,1,0>, 1 pigment { rgb 1 } interior { ior 1.5 fade_distance 1 "
                                            "fade_power 2 fade_color rgb 0.5 } }\n"
                                            "sphere { <-2,1,0>, 1 pigment { rgb 1 } finish { reflection { 0 fresnel on "
                                            "metallic } conserve_energy } }\n",
                                        "looks");
    for (const char* name : {"reflection", "transparency", "refraction", "absorption", "fresnel", "conserve_energy",
                             "metallic_reflection", "reflection_exponent", "filtered_shadows"})
        EXPECT_FALSE(needs(scene, name)) << name;
}

TEST(Needs, TheDefaultFadeColourTakesNothing) {
    const std::string glass =
        tests::kBallOnFloor + "sphere { <2,1,0>, 1 pigment { rgbt 1 } interior { fade_distance 1 ";
    EXPECT_TRUE(needs(read_scene_text(glass + "fade_power 2 fade_color rgb 0.5 } }", "fade"), "absorption"));
    EXPECT_FALSE(needs(read_scene_text(glass + "fade_power 2 fade_color rgb 1 } }", "fade"), "absorption"));
}

TEST(Needs, ClearThingsWithoutAShadowFilterNone) {
    Scene scene =
        read_scene_text(tests::kBallOnFloor + "sphere { <1,2,-1>, 0.5 pigment { rgbt 0.7 } no_shadow }", "clear");
    EXPECT_TRUE(needs(scene, "transparency"));
    EXPECT_FALSE(needs(scene, "filtered_shadows"));
    prepare(scene);
    const BruteForce all(scene);
    EXPECT_TRUE(make_world(scene, all).sees_through);
    EXPECT_FALSE(make_world(scene, all).filtered_shadows);
}

TEST(Needs, DroppingKeepsThePictureOfGlassThatHasWordsWithoutEffect) {
    Scene lean = read_scene_text(tests::kBallOnFloor +
                                     "sphere { <0.7,1,-2>, 0.6 pigment { rgbf <0.5,0.7,0.9,0.8> } finish { reflection "
                                     "{ 0 fresnel on } conserve_energy }\n"
                                     "  interior { ior 1.3 fade_distance 1 fade_power 2 fade_color rgb 1 } }\n",
                                 "words");
    const Film full = picture(lean);
    drop_what_is_not_needed(lean);
    EXPECT_EQ(lean.interiors[0].fade_distance, 0);
    EXPECT_TRUE(same_bytes(full, picture(lean)));
}

TEST(Needs, ALaterStepIsRefusedByName) {
    const std::string foggy = "media { scattering { 1, 0.1 } }";
    const Scene later = read_scene_text(tests::kHead + foggy, "foggy.pov");
    try {
        require_built(later);
        FAIL() << "fog was accepted";
    } catch (const InputError& e) {
        EXPECT_NE(std::string(e.what()).find("foggy.pov: needs media"), std::string::npos) << e.what();
        EXPECT_NE(std::string(e.what()).find("step 7"), std::string::npos) << e.what();
    }
    Scene plain = later;
    remove_effect(plain, "media");
    EXPECT_NO_THROW(require_built(plain));
}

TEST(Needs, MirrorsAndGlassAreBuilt) { EXPECT_NO_THROW(require_built(read_scene_text(kEverything, "everything"))); }

TEST(Needs, AnUnknownEffectIsRefusedWithTheListOfKnownOnes) {
    Scene scene;
    try {
        remove_effect(scene, "shadow");
        FAIL();
    } catch (const InputError& e) {
        EXPECT_NE(std::string(e.what()).find("shadows"), std::string::npos) << e.what();
    }
}

}  // namespace
}  // namespace rays
