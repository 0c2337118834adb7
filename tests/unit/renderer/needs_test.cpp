#include "renderer/needs.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "scenes.h"

namespace rays {
namespace {

using tests::same_bytes;

Film picture(Scene scene) {
    prepare(scene);
    return render(scene, {.raster = {60, 45}});
}

/// Shows every effect of the steps built so far, each on some pixel.
const std::string kEverything = tests::kHead +
    "light_source { <3,5,-4> rgb 0.5 fade_distance 6 fade_power 2 }\n"
    "light_source { <-4,6,-3> rgb 0.5 spotlight point_at <-1,0,0> radius 10 falloff 20 tightness 2 }\n"
    "light_source { <0,9,-9> rgb 0.3 parallel point_at <0,0,0> }\n"
    "sphere { <0,1,0>, 1 pigment { rgb <1,0.5,0.2> } clipped_by { box { <-2,-2,-2>, <2,1.5,2> } }\n"
    "  finish { ambient 0.1 diffuse 0.6 phong 0.5 specular 0.2 metallic 1 emission 0.05 } }\n"
    "smooth_triangle { <-2,0.1,0>, <-1,1,-1>, <-1.2,0.1,0>, <0,1,0>, <-1.5,1.8,0.2>, <1,0,-1> pigment { rgb 1 } }\n"
    "plane { y, 0 pigment { checker rgb 1 rgb 0.2 } finish { ambient 0.1 diffuse 0.7 } }\n";

TEST(Needs, LeavingOutANeededEffectChangesThePicture) {
    const Scene scene = read_scene_text(kEverything, "everything");
    const Film full = picture(scene);
    for (const Effect& effect : effects()) {
        if (effect.step > kLastBuiltStep) continue;
        ASSERT_TRUE(effect.needed(scene)) << effect.name;
        Scene without = scene;
        remove_effect(without, effect.name);
        EXPECT_FALSE(effect.needed(without)) << effect.name;
        EXPECT_FALSE(same_bytes(full, picture(without))) << effect.name << " makes no difference";
    }
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

TEST(Needs, ALaterStepIsRefusedByName) {
    const Scene mirror = read_scene_text(tests::kHead + "sphere { 0, 1 finish { reflection 0.5 } }", "mirror.pov");
    try {
        require_built(mirror);
        FAIL() << "a mirror was accepted";
    } catch (const InputError& e) {
        EXPECT_NE(std::string(e.what()).find("mirror.pov: needs reflection"), std::string::npos) << e.what();
        EXPECT_NE(std::string(e.what()).find("step 3"), std::string::npos) << e.what();
    }
    Scene plain = mirror;
    remove_effect(plain, "reflection");
    EXPECT_NO_THROW(require_built(plain));
}

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
