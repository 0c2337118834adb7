// What is outside of the subset is said clearly; what is accepted without effect is noted.
#include "read.h"

namespace rays {
namespace {

TEST(Subset, UnknownWordsAreNamedWithTheirPlaceAndWhatIsSupported) {
    const std::string error = error_of("sphere { 0, 1 }\n  blob { threshold 1 }");
    EXPECT_TRUE(contains(error, "test.pov:2:3: 'blob' is not in the subset")) << error;
    EXPECT_TRUE(contains(error, "bicubic_patch")) << error;
}

TEST(Subset, EveryOtherWordOfPovRayIsRefusedNotIgnored) {
    for (const char* text : {"sky_sphere { pigment { rgb 1 } }",
                             "fog { distance 1 }",
                             "intersection { sphere { 0, 1 } }",
                             "merge { sphere { 0, 1 } }",
                             "difference { sphere { 0, 1 } }",
                             "isosurface { }",
                             "height_field { }",
                             "sphere { 0, 1 normal { bumps 1 } }",
                             "sphere { 0, 1 pigment { granite } }",
                             "sphere { 0, 1 finish { irid { 1 } } }",
                             "sphere { 0, 1 finish { brilliance -1 } }",
                             "sphere { 0, 1 no_image }",
                             "camera { fisheye }",
                             "light_source { 0, 1 looks_like { sphere { 0, 1 } } }",
                             "global_settings { radiosity { } }",
                             "#fopen F \"x\" read",
                             "sphere { 0, 1 interior_texture { pigment { rgb 1 } } }",
                             "#declare S = spline { linear_spline 0, 0 1, 1 }",
                             "sphere { 0, 1 texture { pigment { checker turbulence 1 } } }",
                             "#declare N = now;"}) {
        EXPECT_TRUE(contains(error_of(text), "test.pov:1:")) << text;
    }
}

TEST(Subset, AcceptedWithANote) {
    for (const char* text :
         {"sphere { 0, 1 bounded_by { box { -1, 1 } } }", "sphere { 0, 1 pigment { rgb 1 quick_color rgb 0 } }",
          "global_settings { max_intersections 64 }", "torus { 1, 0.5 sturm }",
          "#version 3.7; camera { confidence 0.9 }", "#undef Nothing", "global_settings { charset utf8 }",
          "#warning \"careful\"", "light_source { 0, 1 area_illumination off }"}) {
        const Scene scene = scene_of(text);
        ASSERT_EQ(scene.notes.size(), 1u) << text;
        EXPECT_TRUE(contains(scene.notes[0], "test.pov:1:")) << scene.notes[0];
    }
}

TEST(Subset, PovRaysIncludeFilesThatParse) {
    if (povray_include_folder().empty()) GTEST_SKIP() << "POV-Ray's include files are not installed";
    for (const char* name :
         {"colors", "consts", "math", "transforms", "rand", "finish", "functions", "shapes", "strings"}) {
        EXPECT_EQ(error_of("#include \"" + std::string(name) + ".inc\""), "") << name;
    }
    const Scene scene = scene_of("#include \"colors.inc\"\nsphere { 0, 1 pigment { color SteelBlue } }");
    EXPECT_EQ(scene.materials[scene.objects[0].material].pigment.color.rgb[2], 0.556863f);
    // Its macros as well: the numbers are POV-Ray's.
    std::string printed;
    ReadOptions options;
    options.debug = [&printed](const std::string& text) { printed += text; };
    scene_of("#include \"colors.inc\"\n#declare C = CHSL2RGB(<120, 0.5, 0.25>); #debug vstr(3, C, \" \", 0, 6)",
             options);
    EXPECT_EQ(printed, "0.125000 0.375000 0.125000");
}

// Who includes textures.inc for its glass need not be told of its clouds; who uses the clouds is told.
TEST(Subset, WhatPovRaysFilesDeclareBeyondTheSubsetIsAnErrorForItsUsers) {
    if (povray_include_folder().empty()) GTEST_SKIP() << "POV-Ray's include files are not installed";
    for (const char* name : {"textures", "stones", "woods", "glass", "metals", "golds", "skies", "stars", "chars",
                             "shapes2", "shapesq", "logo"}) {
        EXPECT_EQ(error_of("#include \"" + std::string(name) + ".inc\""), "") << name;
    }
    const Scene scene = scene_of("#include \"textures.inc\"\nsphere { 0, 1 texture { Green_Glass } }");
    EXPECT_EQ(scene.materials[scene.objects[0].material].pigment.color.filter, 0.9f);
    const std::string error = error_of("#include \"textures.inc\"\nsphere { 0, 1 texture { Jade } }");
    EXPECT_TRUE(contains(error, "test.pov:2:25: 'Jade' holds what is not in the subset")) << error;
    EXPECT_TRUE(contains(error, "(textures.inc:63:5: 'marble' is not in the subset")) << error;
    // A copy, an array's element and an expression are no way around.
    for (const char* text :
         {"#declare Copy = Jade; #declare Copies = array[1] { Copy } sphere { 0, 1 texture { Copies[0] } }",
          "#declare I = 1 + Jade;", "sphere { 0, Jade }"}) {
        EXPECT_TRUE(contains(error_of("#include \"textures.inc\"\n" + std::string(text)), "not in the subset")) << text;
    }
    // In the scene itself it is an error at once.
    EXPECT_TRUE(contains(error_of("#declare P = pigment { granite }"), "'granite' is not in the subset"));
}

TEST(Subset, DeclaredLayersAreOneTextureWhenTheUppermostIsOpaque) {
    const std::string below = "#declare T = texture { pigment { rgb 1 } } texture { pigment { ";
    const Scene scene = scene_of(below + "rgb 0.5 } }\nsphere { 0, 1 texture { T } }");
    EXPECT_EQ(scene.materials[scene.objects[0].material].pigment.color.rgb[0], 0.5f);
    EXPECT_TRUE(contains(error_of(below + "rgbt 0.5 } }"), "layered textures are not in the subset"));
}

TEST(Subset, MessagesHoldNoControlCharacters) {
    const std::string error = error_of("#include \"a\\0b\x1b[2J\"");
    EXPECT_FALSE(error.empty());
    EXPECT_EQ(error.find('\x1b'), std::string::npos);
    EXPECT_EQ(error.find('\0'), std::string::npos);
}

}  // namespace
}  // namespace rays
