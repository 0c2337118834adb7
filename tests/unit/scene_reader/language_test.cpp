// The interpreter where POV-Ray's printed values do not reach: options, includes, places in messages.
#include <filesystem>
#include <fstream>

#include "read.h"

namespace rays {
namespace {

Real printed_number(const std::string& expression, const ReadOptions& options = {}) {
    return scene_of("light_source { <" + expression + ", 0, 0>, 1 }", options).lights[0].location.x;
}

TEST(Language, OptionsArePredeclared) {
    ReadOptions options;
    options.raster = {640, 480};
    options.clock = Real(0.25);
    options.frame_number = 7;
    options.declared = {{"Answer", 42}};
    EXPECT_EQ(printed_number("image_width", options), 640);
    EXPECT_EQ(printed_number("image_height", options), 480);
    EXPECT_EQ(printed_number("clock", options), Real(0.25));
    EXPECT_EQ(printed_number("frame_number", options), 7);
    EXPECT_EQ(printed_number("Answer", options), 42);
    EXPECT_EQ(printed_number("Raysteps"), 1);
}

TEST(Language, WhatOnlyRaystepsReads) {
    EXPECT_EQ(scene_of("#ifdef (Raysteps) sphere { 0, 1 } #else box { 0, 1 } #end").spheres.size(), 1u);
}

TEST(Language, LocalsOfAnIncludeFileEndWithIt) {
    const auto folder = std::filesystem::path(::testing::TempDir()) / "raysteps_language_test";
    std::filesystem::create_directories(folder / "sub");
    std::ofstream(folder / "part.inc") << "#local L = 3; #declare D = L; sphere { 0, D }";
    std::ofstream(folder / "sub/deep.inc") << "sphere { 0, 9 }";
    std::ofstream(folder / "open.inc") << "#if (1)";
    std::filesystem::create_symlink("/etc/hostname", folder / "link.inc");
    const auto read = [&folder](const std::string& text) {
        return read_scene_text(text, (folder / "main.pov").string());
    };
    const Scene scene = read(
        "#include \"part.inc\"\n#ifdef (L) #error \"L is still here\" #end sphere { 0, D } #include \"sub/deep.inc\"");
    EXPECT_EQ(scene.spheres.size(), 3u);
    EXPECT_EQ(scene.spheres[1].radius, 3);
    EXPECT_THROW(read("#include \"open.inc\"\n#end"), InputError);
    try {
        read("#include \"link.inc\"");
        ADD_FAILURE() << "a link out of the folder was followed";
    } catch (const InputError& error) {
        EXPECT_TRUE(contains(error.what(), "leads outside")) << error.what();
    }
    std::filesystem::remove_all(folder);
}

TEST(Language, PlacesAreLineAndColumn) {
    EXPECT_TRUE(contains(error_of("sphere { 0, 1 }\n\n   sphere { 0 1 fnord }"), "test.pov:3:17: 'fnord'"));
    EXPECT_TRUE(contains(error_of("#error \"enough\""), "test.pov:1:1: the scene stops here: enough"));
}

TEST(Language, ErrorsInMacrosSayWhoCalled) {
    const std::string error = error_of("#macro Ball(R)\n sphere { 0, R }\n#end\nBall(1)\nBall(-1)");
    EXPECT_TRUE(contains(error, "test.pov:2:14: a sphere's radius is -1")) << error;
    EXPECT_TRUE(contains(error, "in macro Ball, called at test.pov:5:1")) << error;
}

TEST(Language, LinesEndAsOnAnySystem) {
    for (const std::string end : {"\n", "\r\n", "\r"}) {
        const Scene scene = scene_of("// a comment" + end + "sphere { 0, 1 } // another" + end + "box { 0, 1 }");
        EXPECT_EQ(scene.objects.size(), 2u) << ::testing::PrintToString(end);
        EXPECT_TRUE(contains(error_of("sphere { 0, 1 }" + end + "// a comment" + end + "  nothing"), "test.pov:3:3:"))
            << ::testing::PrintToString(end);
    }
}

TEST(Language, ConditionsMayCallMacros) {
    const std::string macros = "#macro Less(A, B) (A < B) #end #macro Two() 2 #end ";
    const Scene scene =
        scene_of(macros +
                 "#declare I = 0; #while (Less(I, 3)) #declare I = I + 1; #end "
                 "#if (Less(2, I)) #for (J, Two(), Two() + 1) sphere { J, 1 } #end #else box { 0, 1 } #end "
                 "#switch (Two()) #case (Two()) plane { y, I } #break #end "
                 "#if (0) #elseif (Less(0, 1)) torus { Two(), 1 #if (Less(0, 1)) scale 2 #end } #end");
    EXPECT_EQ(scene.spheres.size(), 2u);
    EXPECT_TRUE(scene.boxes.empty());
    ASSERT_EQ(scene.planes.size(), 1u);
    EXPECT_EQ(scene.planes[0].offset, 3);
    EXPECT_EQ(scene.tori.size(), 1u);
}

TEST(Language, DeclarationsNeedTheirSemicolon) {
    EXPECT_TRUE(contains(error_of("#declare A = 1\n#declare B = 2;"), "ends with ';'"));
    EXPECT_EQ(error_of("#declare T = texture { pigment { rgb 1 } }\n#declare S = \"text\"\n#declare M = 1;"), "");
}

TEST(Language, MacrosMayMakeStatements) {
    const Scene scene = scene_of(
        "#macro Row(N) #for (I, 1, N) sphere { <I,0,0>, 0.5 Paint(I/N) } #end #end\n"
        "#macro Paint(V) pigment { rgb V } #end\nunion { Row(4) scale 2 }");
    ASSERT_EQ(scene.spheres.size(), 4u);
    EXPECT_TRUE(near(scene.spheres[3].center, {8, 0, 0}));
    EXPECT_EQ(scene.materials[scene.objects[1].material].pigment.color.rgb[0], 0.5f);
}

TEST(Language, NumbersInAllSpellings) {
    EXPECT_EQ(printed_number("1.5e2"), 150);
    EXPECT_EQ(printed_number(".5"), Real(0.5));
    EXPECT_EQ(printed_number("5."), 5);
    EXPECT_EQ(printed_number("1e-400"), 0);
    EXPECT_EQ(printed_number("0.1234567890123456789"), Real(0.1234567890123456789));
    EXPECT_EQ(printed_number("123456789012345678901234567890"), Real(123456789012345678901234567890.0));
    EXPECT_TRUE(contains(error_of("sphere { 0, 1.2.3 }"), "two points"));
}

}  // namespace
}  // namespace rays
