// Only the work that a scene needs: how many shadow rays are asked, and over which range.
#include <gtest/gtest.h>

#include "stage.h"

namespace rays::tests {
namespace {

const Vec3 kUp{0, 1, 0};

int shadow_rays(const std::string& scene_text, const Vec3& normal = kUp) {
    const Scene scene = staged(scene_text);
    const OpenSky sky;
    direct_light(scene, scene.lights, OpaqueShadows(sky), surface_of(scene, normal, normal, normal));
    return sky.asked;
}

const std::string kAbove = "light_source { <0, 9, 0>, rgb 1 }\n";

TEST(Effort, OneShadowRayForALightInFront) { EXPECT_EQ(shadow_rays(ball("diffuse 0.5") + kAbove), 1); }
TEST(Effort, HighlightsNeedTheSameOne) { EXPECT_EQ(shadow_rays(ball("diffuse 0.5 phong 1 specular 1") + kAbove), 1); }
TEST(Effort, AHighlightAloneNeedsOne) { EXPECT_EQ(shadow_rays(ball("diffuse 0 specular 1") + kAbove), 1); }
TEST(Effort, NoneForALightBehindTheSurface) { EXPECT_EQ(shadow_rays(ball("diffuse 0.5") + kAbove, -kUp), 0); }
TEST(Effort, NoneForASurfaceThatReflectsNothing) { EXPECT_EQ(shadow_rays(ball("ambient 1 diffuse 0") + kAbove), 0); }
TEST(Effort, NoneForAShadowlessLight) {
    EXPECT_EQ(shadow_rays(ball("diffuse 0.5") + "light_source { <0, 9, 0>, rgb 1 shadowless }\n"), 0);
}
TEST(Effort, NoneForABlackLight) {
    EXPECT_EQ(shadow_rays(ball("diffuse 0.5") + "light_source { <0, 9, 0>, rgb 0 }\n"), 0);
}
TEST(Effort, NoneOutsideOfASpotlightsCone) {
    EXPECT_EQ(shadow_rays(ball("diffuse 0.5") +
                          "light_source { <5, 9, 0>, rgb 1 spotlight radius 5 falloff 10 point_at <5, 0, 0> }\n"),
              0);
}

TEST(Effort, TheRangeLeavesOutBothEnds) {
    const Scene scene = staged(ball("diffuse 1") + "light_source { <3, 5, 0>, rgb 1 }\n");
    const OpenSky sky;
    direct_light(scene, scene.lights, OpaqueShadows(sky), surface_of(scene, kUp, kUp, kUp));
    ASSERT_EQ(sky.asked, 1);
    EXPECT_EQ(sky.last_ray.origin, kUp);
    EXPECT_NEAR(glm::length(sky.last_ray.direction), 1, 1e-6);
    EXPECT_NEAR(sky.last_range.min, kShadowTolerance, 1e-9);
    EXPECT_NEAR(sky.last_range.max, 5 - kShadowTolerance, 1e-6);  // 3-4-5: the light is 5 away
}

}  // namespace
}  // namespace rays::tests
