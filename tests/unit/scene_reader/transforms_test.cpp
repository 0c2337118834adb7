// Where transforms take the point <1,2,3>. The numbers are POV-Ray 3.7.0.10's, printed by vtransform() of
// transforms.inc.
#include "read.h"

namespace rays {
namespace {

struct Case {
    const char* transform;
    Vec3 expected;
};

TEST(Transforms, TakeAPointWherePovRayDoes) {
    const Case cases[] = {
        {"translate <1,2,3>", {2, 4, 6}},
        {"rotate <20,30,40>", {1.456679428056510, 2.336235600049708, 2.533789309500169}},
        {"rotate 90*z", {-2, 1, 3}},
        {"scale <2,3,-4>", {2, 6, -12}},
        {"scale 2 translate x rotate 30*y", {5.598076211353315, 4, 3.696152422706632}},
        {"matrix <1,0.5,0, -0.3,1,0.2, 0,0.1,2, 4,5,6>", {4.4, 7.8, 12.4}},
        {"transform { rotate <10,20,30> translate <1,0,2> inverse }",
         {0.597672477460239, 1.928304149685306, 0.961473200870918}},
        {"transform { transform { scale 2 } translate x inverse rotate 30*z }",
         {0.433012701892219, 0.616025403784439, 1.5}},
        {"Axis_Rotate_Trans(<1,1,0>, 33)", {2.236018580901358, 0.763981419098642, 2.901129658794295}},
        {"Shear_Trans(x+y, y, z-x*0.5)", {-0.5, 3, 3}},
        {"Rotate_Around_Trans(<10,20,30>, <1,1,1>)", {1.316075002209703, 1.918620741731980, 3.014009067963182}},
        {"Reorient_Trans(x, <1,2,3>)", {-3.207134902949093, 1.069044967649698, 1.603567451474546}},
    };
    if (povray_include_folder().empty()) GTEST_SKIP() << "POV-Ray's include files are not installed";
    for (const Case& c : cases) {
        const std::string head = "#include \"transforms.inc\"\n";
        const Scene light = scene_of(head + "light_source { <1,2,3>, rgb 1 " + c.transform + " }");
        EXPECT_TRUE(near(light.lights[0].location, c.expected)) << c.transform;
        const Scene declared = scene_of(head + "#declare T = transform { " + c.transform +
                                        " } light_source { <1,2,3>, rgb 1 transform { T } }");
        EXPECT_TRUE(near(declared.lights[0].location, c.expected)) << c.transform << ", declared";
        // A triangle takes the same way through another door.
        const Scene triangle = scene_of(head + "triangle { <1,2,3>, <2,2,3>, <1,3,3> " + c.transform + " }");
        EXPECT_TRUE(near(triangle.triangles[0].a, c.expected)) << c.transform << ", of a triangle";
    }
}

TEST(Transforms, ScaleByZeroIsOneWithANote) {
    const Scene scene = scene_of("sphere { x, 1 scale <0,1,1> }");
    EXPECT_TRUE(near(scene.spheres[0].center, {1, 0, 0}));
    ASSERT_EQ(scene.notes.size(), 1u);
    EXPECT_TRUE(contains(scene.notes[0], "test.pov:1:15: a scale by 0"));
}

TEST(Transforms, SingularMatrixIsAnError) {
    EXPECT_TRUE(contains(error_of("sphere { 0, 1 matrix <1,1,0, 1,1,0, 0,0,1, 0,0,0> }"),
                         "test.pov:1:15: this matrix is singular"));
}

}  // namespace
}  // namespace rays
