// Unions, names, clips, flags.
#include "read.h"

namespace rays {
namespace {

Real red(const Scene& scene, std::size_t object) {
    return scene.materials[scene.objects[object].material].pigment.color.rgb[0];
}

TEST(ObjectReader, UnionsAreTakenApart) {
    const Scene scene =
        scene_of("union { sphere { 0, 1 translate x } union { sphere { 0, 1 } box { 0, 1 } translate y } scale 2 }");
    ASSERT_EQ(scene.objects.size(), 3u);
    EXPECT_TRUE(near(scene.spheres[0].center, {2, 0, 0}));
    EXPECT_TRUE(near(scene.spheres[1].center, {0, 2, 0}));
    EXPECT_TRUE(near(scene.boxes[0].max, {2, 4, 2}));
}

TEST(ObjectReader, ChildrenWithoutATextureWearTheUnions) {
    const Scene scene = scene_of(
        "#default { pigment { rgb 0.125 } }\n"
        "union { sphere { 0, 1 } sphere { 0, 1 pigment { rgb 0.5 } } union { sphere { 0, 1 } } pigment { rgb 0.25 } }\n"
        "union { sphere { 0, 1 } }");
    EXPECT_EQ(red(scene, 0), Real(0.25));
    EXPECT_EQ(red(scene, 1), Real(0.5));
    EXPECT_EQ(red(scene, 2), Real(0.25));
    EXPECT_EQ(red(scene, 3), Real(0.125));
}

TEST(ObjectReader, DefaultsHoldFromWhereTheyStand) {
    const Scene scene = scene_of("sphere { 0, 1 } #default { pigment { rgb 1 } finish { ambient 0 } } sphere { 0, 1 }");
    EXPECT_EQ(red(scene, 0), 0);
    EXPECT_EQ(scene.materials[scene.objects[0].material].finish.ambient[0], 0.1f);
    EXPECT_EQ(red(scene, 1), 1);
    EXPECT_EQ(scene.materials[scene.objects[1].material].finish.ambient[0], 0.0f);
}

TEST(ObjectReader, NamesCopy) {
    const Scene scene = scene_of(
        "#declare Ball = sphere { 0, 1 pigment { rgb 0.5 } }\n"
        "object { Ball translate x } object { Ball pigment { rgb 1 } } sphere { Ball translate y } Ball");
    ASSERT_EQ(scene.spheres.size(), 4u);
    EXPECT_TRUE(near(scene.spheres[0].center, {1, 0, 0}));
    EXPECT_TRUE(near(scene.spheres[2].center, {0, 1, 0}));
    EXPECT_TRUE(near(scene.spheres[3].center, {0, 0, 0}));
    EXPECT_EQ(red(scene, 0), Real(0.5));
    EXPECT_EQ(red(scene, 1), 1);
}

TEST(ObjectReader, Flags) {
    const Scene scene = scene_of(
        "sphere { 0, 1 inverse no_shadow hollow } sphere { 0, 1 inverse inverse hollow off }\n"
        "union { sphere { 0, 1 } sphere { 0, 1 hollow off } no_shadow hollow on }");
    EXPECT_TRUE(scene.objects[0].inverse && scene.objects[0].no_shadow && scene.objects[0].hollow);
    EXPECT_FALSE(scene.objects[1].inverse || scene.objects[1].no_shadow || scene.objects[1].hollow);
    EXPECT_TRUE(scene.objects[2].no_shadow && scene.objects[2].hollow);
    EXPECT_TRUE(scene.objects[3].no_shadow);
    EXPECT_FALSE(scene.objects[3].hollow);
}

TEST(ObjectReader, ClipsMoveWithTheirObject) {
    const Scene scene = scene_of("sphere { 0, 1 clipped_by { plane { y, 0 inverse } box { -1, 1 } } translate y }");
    ASSERT_NE(scene.objects[0].clip, kNone);
    const ClipList& clips = scene.clips[scene.objects[0].clip];
    ASSERT_EQ(clips.size(), 2u);
    EXPECT_EQ(clips[0].kind, ShapeKind::plane);
    EXPECT_TRUE(clips[0].inverse);
    EXPECT_NEAR(scene.planes[clips[0].shape].offset, 1, kClose);
    EXPECT_TRUE(near(scene.boxes[clips[1].shape].min, {-1, 0, -1}));
}

TEST(ObjectReader, ClipsOfAUnionCutItsChildren) {
    const Scene scene = scene_of(
        "union { sphere { 0, 1 clipped_by { box { -1, 1 } } } sphere { 0, 1 } clipped_by { plane { y, 0 } } }");
    EXPECT_EQ(scene.clips[scene.objects[0].clip].size(), 2u);
    EXPECT_EQ(scene.clips[scene.objects[1].clip].size(), 1u);
}

TEST(ObjectReader, ClipsAndBoundsCanBeLinked) {
    const Scene scene = scene_of("sphere { 0, 1 bounded_by { box { -1, 1 } } clipped_by { bounded_by } }");
    EXPECT_EQ(scene.clips[scene.objects[0].clip].size(), 1u);
    EXPECT_EQ(scene.notes.size(), 1u);
}

TEST(ObjectReader, WhatCannotClipIsAnError) {
    EXPECT_TRUE(contains(error_of("sphere { 0, 1 clipped_by { triangle { 0, x, y } } }"), "needs an inside"));
    EXPECT_TRUE(contains(error_of("sphere { 0, 1 clipped_by { union { sphere { 0, 1 } } } }"), "a union cannot clip"));
    EXPECT_TRUE(contains(error_of("union { sphere { 0, 1 } inverse }"), "cannot be inverted"));
}

TEST(ObjectReader, InteriorsAndPhotons) {
    const Scene scene = scene_of(
        "sphere { 0, 1 interior { ior 1.5 fade_distance 2 fade_power 1001 fade_color rgb <1,0.5,0.25> dispersion 1.02 "
        "caustics 0.5 }\n"
        "  photons { target 0.5 reflection on refraction on collect off } }\n"
        "union { sphere { 0, 1 } sphere { 0, 1 } interior { ior 2 } }");
    const Interior& interior = scene.interiors[scene.objects[0].interior];
    EXPECT_EQ(interior.ior, 1.5f);
    EXPECT_EQ(interior.fade_distance, 2);
    EXPECT_EQ(interior.fade_power, 1001);
    EXPECT_EQ(interior.fade_color[1], 0.5f);
    EXPECT_EQ(interior.dispersion, 1.02f);
    EXPECT_EQ(interior.caustics, 0.5f);
    const ObjectPhotons& photons = scene.photons[scene.objects[0].photons];
    EXPECT_TRUE(photons.target && photons.reflection && photons.refraction);
    EXPECT_FALSE(photons.collect);
    EXPECT_EQ(photons.spacing, Real(0.5));
    EXPECT_EQ(scene.objects[1].interior, scene.objects[2].interior);
    EXPECT_EQ(scene.interiors[scene.objects[1].interior].ior, 2);
}

TEST(ObjectReader, ObjectsKeepTheirOrder) {
    const Scene scene =
        scene_of("box { 0, 1 } sphere { 0, 1 } union { plane { y, 0 } torus { 1, 0.1 } } sphere { 0, 1 }");
    const ShapeKind expected[] = {ShapeKind::box, ShapeKind::sphere, ShapeKind::plane, ShapeKind::torus,
                                  ShapeKind::sphere};
    ASSERT_EQ(scene.objects.size(), 5u);
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(scene.objects[i].kind, expected[i]);
}

}  // namespace
}  // namespace rays
