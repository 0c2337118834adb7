// Each shape's numbers, and what transforms do to them.
#include "read.h"

namespace rays {
namespace {

TEST(ShapeReader, SphereUnderSimilarityIsASphere) {
    const Scene scene = scene_of("sphere { <1,2,3>, 0.5 scale 2 rotate 90*z translate x }");
    ASSERT_EQ(scene.spheres.size(), 1u);
    EXPECT_TRUE(near(scene.spheres[0].center, {-3, 2, 6}));
    EXPECT_NEAR(scene.spheres[0].radius, 1, kClose);
    EXPECT_EQ(scene.objects[0].transform, kNone);
}

TEST(ShapeReader, StretchedSphereKeepsItsTransform) {
    const Scene scene = scene_of("sphere { 0, 1 scale <1,2,1> translate x }");
    ASSERT_NE(scene.objects[0].transform, kNone);
    const Transform& map = scene.transforms[scene.objects[0].transform];
    EXPECT_TRUE(near(map.point_to_world({1, 1, 1}), {2, 2, 1}));
    EXPECT_TRUE(near(map.point_to_local({2, 2, 1}), {1, 1, 1}));
    EXPECT_TRUE(near(scene.spheres[0].center, {0, 0, 0}));
}

TEST(ShapeReader, PlaneKeepsItsInside) {
    const Scene scene = scene_of("plane { 2*y, 3 scale <1,2,1> rotate 90*z }");
    EXPECT_TRUE(near(scene.planes[0].normal, {-1, 0, 0}));
    EXPECT_NEAR(scene.planes[0].offset, 6, 10 * kClose);
}

TEST(ShapeReader, BoxIsSortedAndFoldsOnlyAlongItsAxes) {
    const Scene scene = scene_of(
        "box { <1,-1,2>, <0,1,-2> scale <2,1,1> translate y } box { -1, 1 rotate 45*y } box { -1, 1 scale -1 }");
    EXPECT_TRUE(near(scene.boxes[0].min, {0, 0, -2}));
    EXPECT_TRUE(near(scene.boxes[0].max, {2, 2, 2}));
    EXPECT_EQ(scene.objects[0].transform, kNone);
    EXPECT_NE(scene.objects[1].transform, kNone);
    EXPECT_NE(scene.objects[2].transform, kNone);
}

TEST(ShapeReader, DiscConeCylinder) {
    const Scene scene = scene_of(
        "disc { <0,1,0>, 2*y, 2, 0.5 scale 2 } cone { 0, 1, y, 0 open translate x } cylinder { 0, 2*y, 0.5 scale "
        "<1,1,3> }");
    EXPECT_TRUE(near(scene.discs[0].center, {0, 2, 0}));
    EXPECT_TRUE(near(scene.discs[0].normal, {0, 1, 0}));
    EXPECT_NEAR(scene.discs[0].radius, 4, kClose);
    EXPECT_NEAR(scene.discs[0].hole_radius, 1, kClose);
    EXPECT_TRUE(scene.cones[0].open);
    EXPECT_TRUE(near(scene.cones[0].base, {1, 0, 0}));
    EXPECT_EQ(scene.cones[0].base_radius, 1);
    EXPECT_EQ(scene.cones[0].cap_radius, 0);
    EXPECT_FALSE(scene.cones[1].open);
    EXPECT_NE(scene.objects[2].transform, kNone);
}

/// The form's value at a point.
Real form(const Quadric& quadric, const Vec3& p) {
    const Vec4 h(p, 1);
    return glm::dot(h, quadric.q * h);
}

TEST(ShapeReader, QuadricIsTheFormPovRayMeans) {
    // A x^2 + B y^2 + C z^2 + D xy + E xz + F yz + G x + H y + I z + J
    const Scene scene = scene_of("quadric { <1,2,3>, <4,5,6>, <7,8,9>, 10 }");
    const Vec3 p(Real(0.5), -2, Real(1.5));
    const Real expected = p.x * p.x + 2 * p.y * p.y + 3 * p.z * p.z + 4 * p.x * p.y + 5 * p.x * p.z + 6 * p.y * p.z +
                          7 * p.x + 8 * p.y + 9 * p.z + 10;
    EXPECT_NEAR(form(scene.quadrics[0], p), expected, 100 * kClose);
}

TEST(ShapeReader, QuadricFollowsItsTransform) {
    const std::string quadric = "quadric { <1,2,-3>, <0.4,0.5,0.6>, <7,8,9>, -10 ";
    const Scene plain = scene_of(quadric + "}");
    const Scene moved = scene_of(quadric + "scale <1,2,3> rotate <10,20,30> translate <1,2,3> }");
    const Scene point =
        scene_of("light_source { <0.3,0.6,-0.9>, 1 scale <1,2,3> rotate <10,20,30> translate <1,2,3> }");
    EXPECT_EQ(moved.objects[0].transform, kNone);
    EXPECT_NEAR(form(moved.quadrics[0], point.lights[0].location),
                form(plain.quadrics[0], {Real(0.3), Real(0.6), Real(-0.9)}), 1000 * kClose);
    EXPECT_EQ(moved.quadrics[0].q, glm::transpose(moved.quadrics[0].q));
}

TEST(ShapeReader, PolygonContoursCloseWhereTheirFirstPointComesAgain) {
    const Scene scene =
        scene_of("polygon { 10, <0,0>, <4,0>, <4,4>, <0,4>, <0,0>, <1,1>, <2,1>, <2,2>, <1,2>, <1,1> translate z }");
    ASSERT_EQ(scene.polygons.size(), 1u);
    EXPECT_EQ(scene.polygons[0].contour_ends, (std::vector<std::uint32_t>{4, 8}));
    EXPECT_TRUE(near(scene.polygons[0].points[5], {2, 1, 1}));
}

TEST(ShapeReader, AnOpenPolygonIsClosedWithANote) {
    const Scene scene = scene_of("polygon { 3, <0,0>, <4,0>, <4,4> }");
    EXPECT_EQ(scene.polygons[0].contour_ends, (std::vector<std::uint32_t>{3}));
    ASSERT_EQ(scene.notes.size(), 1u);
    EXPECT_TRUE(contains(scene.notes[0], "not closed"));
}

TEST(ShapeReader, WhatPovRayDropsIsDroppedWithANote) {
    for (const char* text :
         {"triangle { 0, x, 2*x }", "polygon { 4, 0, x, 2*x, <0,0,0> }", "polygon { 5, 0, x, x+y, y+z, <0,0,0> }",
          "smooth_triangle { 0, z, x, z, y, 0 }", "box { x, x+y }", "box { 1, 1 }"}) {
        const Scene scene = scene_of(text);
        EXPECT_TRUE(scene.objects.empty()) << text;
        EXPECT_EQ(scene.notes.size(), 1u) << text;
    }
}

TEST(ShapeReader, SmoothTriangleNormalsAreUnitAndFollowAsNormals) {
    const Scene scene = scene_of("smooth_triangle { 0, <0,0,3>, x, <1,0,1>, y, <0,1,1> scale <2,1,1> }");
    const SmoothTriangle& t = scene.smooth_triangles[0];
    EXPECT_TRUE(near(t.normal_a, {0, 0, 1}));
    EXPECT_TRUE(near(t.normal_b, glm::normalize(Vec3(Real(0.5), 0, 1))));
    EXPECT_TRUE(near(t.triangle.b, {2, 0, 0}));
}

TEST(ShapeReader, MeshJoinsEqualCorners) {
    const Scene scene = scene_of(
        "mesh { triangle { 0, x, y } triangle { x, y, x+y } triangle { 0, 0, y } smooth_triangle { 0, z, x, z+x, z, z "
        "} translate x }");
    ASSERT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.meshes[0].faces.size(), 3u);  // the degenerate one is gone
    EXPECT_EQ(scene.meshes[0].positions.size(), 5u);
    EXPECT_TRUE(scene.meshes[0].faces[2].smooth);
    EXPECT_EQ(scene.objects[0].transform, kNone);  // used once: moved
    EXPECT_TRUE(near(scene.meshes[0].positions[0], {1, 0, 0}));
}

TEST(ShapeReader, SmallMeshesUsedTwiceStandWhereTheyAre) {
    const Scene scene = scene_of(
        "#declare M = mesh { triangle { 0, x, y } }\n"
        "object { M scale 2 translate z } object { M } object { M translate 5 * x }");
    ASSERT_EQ(scene.objects.size(), 3u);
    const Vec3 second_corner[] = {{2, 0, 1}, {1, 0, 0}, {6, 0, 0}};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(scene.objects[i].transform, kNone);
        EXPECT_TRUE(near(scene.meshes[scene.objects[i].shape].positions[1], second_corner[i])) << i;
    }
}

TEST(ShapeReader, LargeMeshesUsedTwiceAreShared) {
    const std::string faces = "#for (I, 1, 66000) triangle { 0, <I, 0, 0>, y } #end";
    const Scene scene =
        scene_of("#declare M = mesh { " + faces +
                 " } object { M scale 2 } object { M scale 3 } object { M scale 4 }\n"
                 "#declare Small = mesh { triangle { 0, x, y } } object { Small } object { Small scale 5 }");
    ASSERT_EQ(scene.objects.size(), 5u);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(scene.objects[i].shape, 0u);
        EXPECT_NE(scene.objects[i].transform, kNone);
    }
    EXPECT_TRUE(near(scene.meshes[0].positions[1], {1, 0, 0}));
    EXPECT_EQ(scene.objects[4].transform, kNone) << "what is small has its copy all the same";
}

TEST(ShapeReader, CopiesOfAllMeshesTogetherHaveALimit) {
    std::string text;
    for (const std::string m : {"A", "B", "C"})
        text += "#declare " + m + " = mesh { #for (I, 1, 50000) triangle { 0, <I, 0, 0>, y } #end } object { " + m +
                " } object { " + m + " scale 2 }\n";
    const Scene scene = scene_of(text);
    ASSERT_EQ(scene.objects.size(), 6u);
    EXPECT_EQ(scene.objects[1].transform, kNone);
    EXPECT_EQ(scene.objects[3].transform, kNone);
    EXPECT_NE(scene.objects[5].transform, kNone) << "150 000 faces would be copied";
}

TEST(ShapeReader, Mesh2) {
    const Scene scene = scene_of(
        "mesh2 { vertex_vectors { 4, 0, x, y, x+y } normal_vectors { 2, z, <1,0,1> }\n"
        "texture_list { 2, texture { pigment { rgb <1,0,0> } } texture { pigment { rgb <0,1,0> } } }\n"
        "face_indices { 2, <0,1,2>, 1, <1,2,3>, 0 } normal_indices { 1, <0,0,1> } }");
    const Mesh& mesh = scene.meshes[0];
    ASSERT_EQ(mesh.faces.size(), 2u);
    EXPECT_TRUE(mesh.faces[0].smooth);
    EXPECT_FALSE(mesh.faces[1].smooth);
    EXPECT_EQ(mesh.faces[0].position, (std::array<std::uint32_t, 3>{0, 1, 2}));
    EXPECT_EQ(mesh.faces[0].normal, (std::array<std::uint32_t, 3>{0, 0, 1}));
    EXPECT_EQ(scene.materials[mesh.faces[0].material].pigment.color.rgb[1], 1);
    EXPECT_EQ(scene.materials[mesh.faces[1].material].pigment.color.rgb[0], 1);
}

TEST(ShapeReader, Mesh2NormalsWithoutIndicesAreTheVertices) {
    const Scene scene = scene_of(
        "mesh2 { vertex_vectors { 3, 0, x, y } normal_vectors { 3, z, z+x, z+y } face_indices { 1, <0,1,2> } }");
    EXPECT_TRUE(scene.meshes[0].faces[0].smooth);
    EXPECT_EQ(scene.meshes[0].faces[0].normal, (std::array<std::uint32_t, 3>{0, 1, 2}));
}

TEST(ShapeReader, MeshCornersAreRoundedToSinglePrecisionAsInPovRay) {
    const Scene scene = scene_of("mesh { triangle { <0.1,0,0>, x, y } }");
    EXPECT_EQ(scene.meshes[0].positions[0].x, Real(0.1f));
}

TEST(ShapeReader, PatchAndTorus) {
    const Scene scene = scene_of(
        "bicubic_patch { type 1 flatness 0.01 u_steps 3 v_steps 3,\n"
        "<0,0,0>,<0,0,1>,<0,0,2>,<0,0,3>, <1,0,0>,<1,0,1>,<1,0,2>,<1,0,3>,\n"
        "<2,0,0>,<2,0,1>,<2,0,2>,<2,0,3>, <3,0,0>,<3,0,1>,<3,0,2>,<3,5,3> translate y }\n"
        "torus { 2, 0.5 } torus { 2, 0.5 rotate 90*x }");
    EXPECT_TRUE(near(scene.patches[0].control[6], {1, 1, 2}));
    EXPECT_TRUE(near(scene.patches[0].control[15], {3, 6, 3}));
    EXPECT_EQ(scene.tori[0].minor, Real(0.5));
    EXPECT_EQ(scene.objects[1].transform, kNone);
    EXPECT_NE(scene.objects[2].transform, kNone);
}

// POV-Ray shows it, and many scenes carry a picture on one.
TEST(ShapeReader, AFlatBoxIsARectangle) {
    for (const char* text : {"box { <1,2,3>, <5,2,7> }", "box { <5,2,7>, <1,2,3> }"}) {
        const Scene scene = scene_of(text);
        ASSERT_EQ(scene.polygons.size(), 1u) << text;
        EXPECT_TRUE(scene.boxes.empty());
        EXPECT_EQ(scene.polygons[0].contour_ends, (std::vector<std::uint32_t>{4}));
        const Vec3 corners[] = {{1, 2, 3}, {1, 2, 7}, {5, 2, 7}, {5, 2, 3}};
        for (std::size_t i = 0; i < 4; ++i) EXPECT_TRUE(near(scene.polygons[0].points[i], corners[i])) << i;
    }
    EXPECT_TRUE(contains(error_of("sphere { 0, 1 clipped_by { box { -1, <1,1,-1> } } }"), "needs an inside"));
}

TEST(ShapeReader, NonsenseIsAnError) {
    for (const char* text :
         {"sphere { 0, 0 }", "sphere { 0, -1 }", "plane { 0, 1 }", "disc { 0, y, 1, 1 }", "disc { 0, 0, 1 }",
          "cone { 0, 1, 0, 2 }", "cone { 0, 0, y, 0 }", "cylinder { 0, y, 0 }", "quadric { 0, 0, 0, 1 }",
          "torus { 0, 1 }", "polygon { 2, <0,0>, <1,1> }", "mesh { }", "mesh2 { face_indices { 1, <0,1,2> } }",
          "mesh2 { vertex_vectors { 3, 0, x, y } face_indices { 1, <0,1,3> } }"}) {
        EXPECT_TRUE(contains(error_of(text), "test.pov:1:")) << text;
    }
}

}  // namespace
}  // namespace rays
