// Pigments, finishes, textures.
#include "read.h"

namespace rays {
namespace {

const Material& worn(const Scene& scene, std::size_t object) { return scene.materials[scene.objects[object].material]; }

TEST(TextureReader, FinishDefaultsArePovRays) {
    const Scene scene = scene_of("sphere { 0, 1 }");
    const Finish& finish = worn(scene, 0).finish;
    EXPECT_EQ(finish.ambient[0], 0.1f);
    EXPECT_EQ(finish.diffuse, 0.6f);
    EXPECT_EQ(finish.phong, 0);
    EXPECT_EQ(finish.phong_size, 40);
    EXPECT_EQ(finish.specular, 0);
    EXPECT_EQ(finish.roughness, 0.05f);
}

TEST(TextureReader, EveryWordOfAFinish) {
    const Scene scene = scene_of(
        "sphere { 0, 1 finish { ambient rgb <1,2,3> diffuse 0.5 emission 0.25 phong 0.7 phong_size 80 specular 0.3 "
        "roughness 0.01\n"
        "metallic 0.5 reflection { 0.1, 0.9 fresnel on falloff 2 exponent 0.5 metallic } conserve_energy brilliance 2 "
        "} }");
    const Finish& finish = worn(scene, 0).finish;
    EXPECT_EQ(finish.ambient[2], 3);
    EXPECT_EQ(finish.diffuse, 0.5f);
    EXPECT_EQ(finish.emission[1], 0.25f);
    EXPECT_EQ(finish.phong, 0.7f);
    EXPECT_EQ(finish.phong_size, 80);
    EXPECT_EQ(finish.specular, 0.3f);
    EXPECT_EQ(finish.roughness, 0.01f);
    EXPECT_EQ(finish.metallic, 0.5f);
    EXPECT_EQ(finish.reflection.min[0], 0.1f);
    EXPECT_EQ(finish.reflection.max[0], 0.9f);
    EXPECT_TRUE(finish.reflection.fresnel);
    EXPECT_EQ(finish.reflection.falloff, 2);
    EXPECT_EQ(finish.reflection.exponent, 2);  // the power that is applied: 1 / 0.5
    EXPECT_EQ(finish.reflection.metallic, 1);
    EXPECT_TRUE(finish.conserve_energy);
    EXPECT_EQ(finish.brilliance, 2);
}

TEST(TextureReader, ReflectionInShort) {
    const Scene scene = scene_of(
        "sphere { 0, 1 finish { reflection rgb <0.1,0.2,0.3> } } sphere { 0, 1 finish { reflection { 0.5 fresnel } } "
        "}");
    EXPECT_EQ(worn(scene, 0).finish.reflection.min[1], 0.2f);
    EXPECT_EQ(worn(scene, 0).finish.reflection.max[2], 0.3f);
    EXPECT_EQ(worn(scene, 1).finish.reflection.min[0], 0);  // one colour with fresnel: from black
    EXPECT_EQ(worn(scene, 1).finish.reflection.max[0], 0.5f);
}

TEST(TextureReader, AlbedoIsWorkedIn) {
    // methods.md 2 (f): measured 5.5 for size 10 and 1.52 for roughness 1/10.
    const Scene scene =
        scene_of("sphere { 0, 1 finish { phong albedo 1 phong_size 10 specular albedo 1 roughness 0.1 } }");
    EXPECT_FLOAT_EQ(worn(scene, 0).finish.phong, 5.5f);
    const Scene metal = scene_of("sphere { 0, 1 finish { diffuse albedo 0.5 brilliance 5 } }");
    EXPECT_FLOAT_EQ(worn(metal, 0).finish.diffuse, 1.5f);
    EXPECT_NEAR(worn(scene, 0).finish.specular, 12 / (4 * (2 - std::pow(2.0, -5.0))), 1e-5);
}

TEST(TextureReader, CheckerDefaultsAndColors) {
    const Scene scene = scene_of(
        "plane { y, 0 pigment { checker rgb 1, rgb <1,0,0> scale 2 } } plane { y, 0 pigment { checker } }\n"
        "plane { y, 0 pigment { checker pigment { rgb 0.5 } pigment { rgb 0.25 } } }");
    ASSERT_TRUE(worn(scene, 0).pigment.checker_other.has_value());
    EXPECT_EQ(worn(scene, 0).pigment.checker_other->rgb[0], 1);
    EXPECT_EQ(worn(scene, 0).pigment.checker_other->rgb[1], 0);
    ASSERT_NE(worn(scene, 0).pigment.transform, kNone);
    EXPECT_TRUE(near(scene.transforms[worn(scene, 0).pigment.transform].point_to_world({1, 1, 1}), {2, 2, 2}));
    EXPECT_EQ(worn(scene, 1).pigment.color.rgb[2], 1);
    EXPECT_EQ(worn(scene, 1).pigment.checker_other->rgb[1], 1);
    EXPECT_EQ(worn(scene, 1).pigment.transform, kNone);
    EXPECT_EQ(worn(scene, 2).pigment.checker_other->rgb[0], 0.25f);
}

Vec3 pattern_origin(const Scene& scene, std::size_t object) {
    const std::uint32_t transform = worn(scene, object).pigment.transform;
    return transform == kNone ? Vec3(0) : scene.transforms[transform].point_to_world(Vec3(0));
}

TEST(TextureReader, ColorBeginsTheNextColour) {
    for (const char* text : {"checker color rgb <1,1,1>*0.5 color rgb <1,1,1>*0.25", "checker color Grey color Dark",
                             "checker color red 0.5 green 0.5 blue 0.5 color green 0.25 blue 0.25 red 0.25"}) {
        const std::string names = "#declare Grey = rgb 0.5; #declare Dark = color rgb 0.25; ";
        const Scene scene = scene_of(names + "sphere { 0, 1 pigment { " + text + " } }");
        const Pigment& pigment = worn(scene, 0).pigment;
        ASSERT_TRUE(pigment.checker_other) << text;
        for (int i = 0; i < 3; ++i) {
            EXPECT_EQ(pigment.color.rgb[i], 0.5f) << text;
            EXPECT_EQ(pigment.checker_other->rgb[i], 0.25f) << text;
        }
    }
}

// Scenes from before POV-Ray 3.1, and Eric Haines' SPD, have ior there. As POV-Ray does, it overrules the interior.
TEST(TextureReader, AFinishMayHoldTheIorOfOldScenes) {
    const Scene scene = scene_of(
        "#declare Glass = texture { pigment { rgbf 1 } finish { refraction 1.0 ior 1.5 caustics 0.25 } }\n"
        "sphere { 0, 1 texture { Glass } }\n"
        "sphere { 0, 1 texture { Glass } interior { ior 2 fade_power 3 } }\n"
        "union { sphere { 0, 1 } texture { Glass } }\n"
        "sphere { 0, 1 }");
    for (std::size_t i = 0; i < 3; ++i) {
        ASSERT_NE(scene.objects[i].interior, kNone) << i;
        EXPECT_EQ(scene.interiors[scene.objects[i].interior].ior, 1.5f) << i;
        EXPECT_EQ(scene.interiors[scene.objects[i].interior].caustics, 0.25f) << i;
    }
    EXPECT_EQ(scene.interiors[scene.objects[1].interior].fade_power, 3);
    EXPECT_EQ(scene.objects[3].interior, kNone);
    EXPECT_TRUE(contains(error_of("sphere { 0, 1 finish { refraction 0.5 } }"), "only refraction 1"));
    EXPECT_TRUE(contains(error_of("sphere { 0, 1 finish { ior 0 } }"), "greater than 0"));
}

TEST(TextureReader, TexturesMoveWithWhatIsDoneAfterThem) {
    const Scene scene = scene_of(
        "#declare T = texture { pigment { checker translate x } scale 2 }\n"
        "sphere { 0, 1 translate y texture { T } }\n"
        "sphere { 0, 1 texture { T } translate y }\n"
        "union { sphere { 0, 1 texture { T } translate y } translate z }\n"
        "union { sphere { 0, 1 translate y } texture { T } translate z }\n"
        "union { sphere { 0, 1 } translate 5*z texture { T translate x } }");
    EXPECT_TRUE(near(pattern_origin(scene, 0), {2, 0, 0}));
    EXPECT_TRUE(near(pattern_origin(scene, 1), {2, 1, 0}));
    EXPECT_TRUE(near(pattern_origin(scene, 2), {2, 1, 1}));
    EXPECT_TRUE(near(pattern_origin(scene, 3), {2, 0, 1}));
    EXPECT_TRUE(near(pattern_origin(scene, 4), {3, 0, 0}));
}

TEST(TextureReader, NamesOfEveryKind) {
    const Scene scene = scene_of(
        "#declare P = pigment { rgb 0.5 } #declare F = finish { phong 1 } #declare T = texture { pigment { P } finish "
        "{ F } }\n"
        "#declare M = material { texture { T } interior { ior 1.5 } } #declare I = interior { ior 2 }\n"
        "sphere { 0, 1 texture { T } } sphere { 0, 1 pigment { P } finish { F diffuse 0 } } sphere { 0, 1 material { M "
        "} }\n"
        "sphere { 0, 1 texture { T finish { phong 0.25 } } interior { I } }");
    EXPECT_EQ(worn(scene, 0).finish.phong, 1);
    EXPECT_EQ(worn(scene, 1).finish.diffuse, 0);
    EXPECT_EQ(worn(scene, 1).finish.phong, 1);
    EXPECT_EQ(worn(scene, 2).pigment.color.rgb[0], 0.5f);
    EXPECT_EQ(scene.interiors[scene.objects[2].interior].ior, 1.5f);
    EXPECT_EQ(worn(scene, 3).finish.phong, 0.25f);
    EXPECT_EQ(scene.interiors[scene.objects[3].interior].ior, 2);
}

TEST(TextureReader, OneMaterialForAllWhoShareIt) {
    const Scene scene =
        scene_of("#declare T = texture { pigment { rgb 1 } } #for (I, 1, 9) sphere { I, 1 texture { T } } #end");
    EXPECT_EQ(scene.materials.size(), 1u);
}

TEST(TextureReader, AnOpaqueLayerHidesWhatIsBelow) {
    const Scene scene = scene_of("sphere { 0, 1 texture { pigment { rgb 0.25 } } texture { pigment { rgb 0.5 } } }");
    EXPECT_EQ(worn(scene, 0).pigment.color.rgb[0], 0.5f);
    EXPECT_TRUE(contains(error_of("sphere { 0, 1 texture { pigment { rgb 0.25 } } texture { pigment { rgbt 0.5 } } }"),
                         "layered"));
}

TEST(TextureReader, FilterAndTransmit) {
    const Scene scene = scene_of(
        "sphere { 0, 1 pigment { color rgbft <0.1, 0.2, 0.3, 0.4, 0.5> } } sphere { 0, 1 pigment { rgb 1 transmit 0.25 "
        "} }");
    EXPECT_EQ(worn(scene, 0).pigment.color.filter, 0.4f);
    EXPECT_EQ(worn(scene, 0).pigment.color.transmit, 0.5f);
    EXPECT_EQ(worn(scene, 1).pigment.color.transmit, 0.25f);
}

TEST(Finish, GlossyIsAWordOfOurOwn) {
    const auto finish_of = [](const std::string& text) { return scene_of(text).materials.at(0).finish; };
    EXPECT_EQ(finish_of("sphere { 0, 1 finish { reflection 0.5 glossy 0.02 } }").glossy, 0.02f);
    EXPECT_EQ(finish_of("sphere { 0, 1 finish { reflection 0.5 } }").glossy, 0.0f);
    // As a name it may stand for a finish, as scenes have it.
    EXPECT_EQ(finish_of("#declare glossy = finish { phong 0.7 } sphere { 0, 1 finish { glossy } }").phong, 0.7f);
    for (const char* wrong : {"glossy -0.1", "glossy 1.5"})
        EXPECT_NE(error_of(std::string("sphere { 0, 1 finish { ") + wrong + " } }").find("glossy lies between"),
                  std::string::npos)
            << wrong;
}

}  // namespace
}  // namespace rays
