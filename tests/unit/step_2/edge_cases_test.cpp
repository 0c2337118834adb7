// Numbers at the edge of what a scene may say: nothing becomes NaN or infinite, and POV-Ray's word holds.
#include <gtest/gtest.h>

#include "stage.h"

namespace rays::tests {
namespace {

const Vec3 kUp{0, 1, 0};
const Vec3 kAside{1, 0, 0};

Surface up_facing(const Scene& scene, const Vec3& to_viewer = kUp) { return surface_of(scene, kUp, kUp, to_viewer); }
Illumination white_from(const Vec3& l) { return {glm::normalize(l), 1, Radiance(1.0f)}; }

TEST(EdgeCases, ExponentZeroIsAConstantHighlight) {
    const Scene scene = staged(ball("diffuse 0 phong 0.7 phong_size 0"));
    const Illumination light = white_from({1, 2, 0});
    // POV-Ray 3.7.0.10 renders 0.35 with a light of 0.5.
    expect_near(phong(up_facing(scene), light), Radiance(0.7f), 1e-6);
}

TEST(EdgeCases, HugeExponentsFallToZeroNotToNaN) {
    const Scene scene = staged(ball("diffuse 0 phong 1 phong_size 1e30 specular 1 roughness 1e-30"));
    for (const double tilt : {1e-12, 1e-3, 1.0}) {
        const Illumination light = white_from({tilt, 1, 0});
        EXPECT_TRUE(phong(up_facing(scene), light).is_finite()) << tilt;
        EXPECT_TRUE(blinn(up_facing(scene), light).is_finite()) << tilt;
    }
    expect_near(phong(up_facing(scene), white_from({1, 1, 0})), Radiance(0.0f), 0);
}

TEST(EdgeCases, LightOppositeToTheViewerHasNoHalfVector) {
    const Scene scene = staged(ball("diffuse 0 specular 1"));
    Surface surface = up_facing(scene, -glm::normalize(Vec3(1, 1, 0)));
    expect_near(blinn(surface, white_from({1, 1, 0})), Radiance(0.0f), 0);
}

// POV-Ray 3.7.0.10 (trace.cpp) keeps the old formula for scenes whose version is below 3.7.
TEST(EdgeCases, OldScenesFilterByTheirBrightestChannel) {
    const std::string glass = "sphere { 0, 1 pigment { rgbft <0.4, 0.8, 0.2, 0.5, 0.25> } }\n";
    const auto opacity = [](const std::string& text) {
        const Scene scene = staged(text);
        Hit hit;
        hit.point = hit.normal = hit.shading_normal = kUp;
        hit.material = scene.objects[0].material;
        return surface_at(scene, hit, kUp).opacity;
    };
    EXPECT_FLOAT_EQ(opacity(glass), 1 - 0.5f - 0.25f);
    EXPECT_FLOAT_EQ(opacity("#version 3.6;\n" + glass), 1 - 0.5f * 0.8f - 0.25f);
}

TEST(EdgeCases, MetalIsFiniteWhereRoundingMakesTheCosineMoreThanOne) {
    const Scene scene = staged(ball("diffuse 0 phong 1 metallic"));
    Surface surface = up_facing(scene);
    surface.normal *= Real(1) + 4 * std::numeric_limits<Real>::epsilon();
    const Radiance tint = highlight_color(surface, white_from(kUp));
    EXPECT_TRUE(tint.is_finite());
    expect_near(tint, surface.color, 1e-6);
}

TEST(EdgeCases, ALightAtTheSurfaceAddsNothing) {
    const Scene scene = staged(ball("ambient 0 diffuse 1 phong 1") + "light_source { <0, 1, 0>, rgb 1 }\n");
    const BruteForce intersector(scene);
    expect_near(direct_light(scene, scene.lights, OpaqueShadows(intersector), up_facing(scene)), Radiance(0.0f), 0);
}

TEST(EdgeCases, AParallelLightThatPointsAtItselfIsFinite) {
    Light light;
    light.parallel = true;
    light.location = light.point_at = {1, 2, 3};
    const Illumination i = illuminate(light, Vec3(0));
    EXPECT_TRUE(is_finite(i.to_light));
    EXPECT_TRUE(std::isfinite(i.distance));
    EXPECT_TRUE(i.radiance.is_finite());
}

TEST(EdgeCases, BehindAParallelLightsPlaneThereIsLightWithoutShadow) {
    // As POV-Ray has it: the rays come from nowhere, and the shadow ray has no length.
    const Scene scene = staged(
        "sphere { <0, 1.5, 0>, 0.2 pigment { rgb 1 } }\n"
        "light_source { <0, -3, 0>, rgb 1 parallel point_at <0, -5, 0> }\n");
    const BruteForce intersector(scene);
    Surface surface;
    surface.point = Vec3(0);
    const Illumination light = illuminate(scene.lights[0], surface.point);
    EXPECT_LT(light.distance, 0);
    expect_near(light.radiance, Radiance(1.0f), 0);
    EXPECT_FALSE(in_shadow(intersector, surface, light));
}

TEST(EdgeCases, FadingIsFiniteAtEveryDistance) {
    Light light;
    light.fade_distance = Real(0.5);
    for (const double power : {0.5, 1.0, 2.0, 3.0, 40.0}) {
        light.fade_power = Real(power);
        for (const double d : {0.0, 1e-30, 0.5, 1e10, 1e30}) {
            const Real f = fading(light, Real(d));
            EXPECT_TRUE(f >= 0 && f <= 2) << power << " " << d << ": " << f;
        }
    }
}

TEST(EdgeCases, RimsWithoutWidth) {
    Light spot;
    spot.kind = Light::Kind::spot;
    spot.point_at = {0, 0, 1};
    spot.radius_rad = spot.falloff_rad = Real(0.5);
    EXPECT_EQ(cone_of_light(spot, {std::tan(Real(0.49)), 0, 1}), 1);
    EXPECT_EQ(cone_of_light(spot, {std::tan(Real(0.51)), 0, 1}), 0);
    spot.radius_rad = Real(0.7);  // larger than the falloff: POV-Ray cuts at the radius
    EXPECT_EQ(cone_of_light(spot, {std::tan(Real(0.69)), 0, 1}), 1);
    EXPECT_EQ(cone_of_light(spot, {std::tan(Real(0.71)), 0, 1}), 0);
    spot.radius_rad = Real(1.7);  // beyond 90 degrees there is no rim
    EXPECT_EQ(cone_of_light(spot, {100, 0, 1}), 1);
}

TEST(EdgeCases, OpacityDimsTheSurfaceButNotItsHighlight) {
    const Scene scene = staged(ball("ambient 0.5 emission 0.25 diffuse 0.5 phong 0.5 phong_size 0"));
    Surface surface = up_facing(scene);
    const Radiance white(1.0f);
    const Radiance whole = ambient(surface, white) + diffuse(surface, white_from(kUp));
    surface.opacity = 0.25f;
    expect_near(ambient(surface, white) + diffuse(surface, white_from(kUp)), 0.25f * whole, 1e-6);
    expect_near(phong(surface, white_from(kUp)), Radiance(0.5f), 1e-6);
}

TEST(EdgeCases, CheckerFarFromTheOriginStillHasTwoColours) {
    const Scene scene = staged("sphere { 0, 1 pigment { checker rgb 0 rgb 1 } }\n");
    const Pigment& pigment = scene.materials[scene.objects[0].material].pigment;
    // 2^40: an int would have overflowed. In float, 2^22: the last decade that still tells halves apart.
    const Real far = sizeof(Real) == 8 ? Real(1099511627776.0) : Real(4194304.0);
    EXPECT_EQ(pigment_at(scene, pigment, {far, Real(0.5), Real(0.5)}).rgb[0], 0);
    EXPECT_EQ(pigment_at(scene, pigment, {far, Real(1.5), Real(0.5)}).rgb[0], 1);
    EXPECT_EQ(pigment_at(scene, pigment, {-far, Real(-0.5), Real(0.5)}).rgb[0], 1);
}

TEST(EdgeCases, FacingKeepsTheNormalSeenEdgeOn) {
    EXPECT_EQ(facing(kUp, kAside), kUp);
    EXPECT_EQ(facing(kUp, -kUp), -kUp);
    EXPECT_EQ(facing(kUp, {1, Real(-1e-9), 0}), -kUp);
}

}  // namespace
}  // namespace rays::tests
