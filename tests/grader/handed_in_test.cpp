// The checks of pictures and reports, with the solution's program in the student's place.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "core/error.h"
#include "grader/submission/hand_in.h"
#include "grader/submission/handed_in.h"
#include "grader/submission/report_check.h"
#include "tools.h"

namespace rays::grader {
namespace {

namespace fs = std::filesystem;

const char* const kBall = R"(#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 6 adc_bailout 0 }
camera { location <0, 0, -3> right x*image_width/image_height up y angle 60 look_at <0, 0, 0> }
light_source { <2, 4, -3>, rgb 1 }
sphere { <0, 0, 0>, 1 pigment { rgb 0.7 } finish { ambient 0.1 diffuse 0.6 phong PHONG } }
)";

class HandedInTest : public testing::Test {
protected:
    Project project = find_project();
    TemporaryFolder folder;
    std::unique_ptr<Sandbox> sandbox = make_sandbox();
    HandInBench bench{
        project,  *sandbox, project.program("render-solution"), project.program("render-solution"), folder.path(), {},
        limits(), 1};

    /// As the grader's: AddressSanitizer maps terabytes of address space.
    Limits limits() const {
        Limits all;
        if (project.sanitized()) all.memory_mb = 0;
        return all;
    }

    void put(const std::string& name, const std::string& text) const { write_atomically(folder.path() / name, text); }

    void put_ball(double phong) const {
        std::string text = kBall;
        text.replace(text.find("PHONG"), 5, std::to_string(phong));
        put("ball.pov", text);
    }

    /// The scene's picture, as the program writes it.
    std::string picture(const std::string& scene, const std::string& name, Raster raster = {80, 60}) const {
        Job job;
        job.program = bench.student;
        job.files = submitted_scene(bench, scene);
        job.arguments = {job.files.front().name,       "-o", name, "--width", std::to_string(raster.width), "--height",
                         std::to_string(raster.height)};
        job.outputs = {name};
        job.limits = limits();
        return sandbox->run(job).files[name].bytes;
    }

    Demonstration demonstrated(std::vector<std::string> shows, const std::string& scene = "ball.pov",
                               const std::string& file = "a.png") const {
        return demonstrate(bench, {file, scene, {80, 60}, std::move(shows)}, 1);
    }
};

TEST_F(HandedInTest, APictureThatShowsItsClaimsPasses) {
    put_ball(0.9);
    put("a.png", picture("ball.pov", "a.png"));
    const Demonstration d = demonstrated({"spheres", "phong", "light_sources"});
    EXPECT_EQ(d.check.verdict, Verdict::pass) << d.check.message;
    EXPECT_TRUE(d.counts);
    EXPECT_EQ(d.check.questions.size(), 3u);
}

TEST_F(HandedInTest, WhatCannotBeSeenIsNotShown) {
    put_ball(0.004);  // a highlight of one display level
    put("a.png", picture("ball.pov", "a.png"));
    const Demonstration d = demonstrated({"spheres", "phong", "polygons", "reflection", "recursive_reflection", "fog"});
    EXPECT_EQ(d.check.verdict, Verdict::partial);
    ASSERT_EQ(d.proofs.size(), 6u);
    EXPECT_TRUE(d.proofs[0].shown);
    for (std::size_t i = 1; i < 6; ++i) EXPECT_FALSE(d.proofs[i].shown) << d.proofs[i].feature;
    EXPECT_EQ(d.proofs[5].found, "no such feature");
}

TEST_F(HandedInTest, DepthCountsReflectionsOnly) {
    const auto depth_shown = [&](const std::string& scene) {
        put("a.png", picture(scene, "a.png"));
        const Demonstration d = demonstrated({kRecursiveReflection}, scene);
        EXPECT_TRUE(d.counts) << d.check.message;
        return d.proofs.at(0).shown;
    };
    EXPECT_FALSE(depth_shown("scenes/3_recursion/depth_1.pov"));
    EXPECT_TRUE(depth_shown("scenes/3_recursion/depth_3.pov"));
    // Rays go deep here, but through glass.
    put("panes.pov", R"(#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 8 adc_bailout 0 }
camera { location <0, 0, -3> right x*image_width/image_height up y angle 60 look_at <0, 0, 0> }
light_source { <2, 4, -3>, rgb 1 }
background { rgb <0.2, 0.5, 0.9> }
#declare I = 0;
#while (I < 3)
    box { <-2, -2, 2*I>, <2, 2, 2*I + 0.5> pigment { rgbt <1, 1, 1, 0.9> } finish { ambient 0.02 diffuse 0.1 reflection { 0.03 } } interior { ior 1.5 } }
    #declare I = I + 1;
#end
)");
    EXPECT_FALSE(depth_shown("panes.pov"));
}

TEST_F(HandedInTest, AnotherPictureIsNotReproduced) {
    put_ball(0.9);
    put("a.png", picture("ball.pov", "a.png"));
    put_ball(0.2);
    const Demonstration d = demonstrated({"spheres"});
    EXPECT_EQ(d.check.verdict, Verdict::fail);
    EXPECT_NE(d.check.message.find("not reproduced"), std::string::npos) << d.check.message;
    EXPECT_TRUE(d.proofs.empty());
}

TEST_F(HandedInTest, BrokenFilesAreNamed) {
    put_ball(0.9);
    const auto message = [&](const std::string& scene, const std::string& file) {
        const Demonstration d = demonstrated({"spheres"}, scene, file);
        EXPECT_EQ(d.check.verdict, Verdict::fail) << d.check.message;
        EXPECT_FALSE(d.counts);
        return d.check.message;
    };
    put("a.png", "no picture");
    put("empty.exr", "");
    put("bad.pov", "#include \"../../../../etc/passwd\"\nsphere {");
    put("worse.pov", "sphere { <0, 0, 0> }");
    fs::create_symlink("/etc/hostname", folder.path() / "link.png");
    EXPECT_NE(message("ball.pov", "missing.png").find("was not found"), std::string::npos);
    EXPECT_NE(message("ball.pov", "a.png").find("is no PNG"), std::string::npos);
    EXPECT_NE(message("ball.pov", "empty.exr").find("is empty"), std::string::npos);
    EXPECT_NE(message("ball.pov", "link.png").find("is a link"), std::string::npos);
    EXPECT_NE(message("missing.pov", "a.png").find("was not found"), std::string::npos);
    EXPECT_EQ(message("bad.pov", "a.png").find("root:"), std::string::npos);
    EXPECT_NE(message("worse.pov", "a.png").find("ended with status 2"), std::string::npos);
}

TEST_F(HandedInTest, AForgedHeaderIsNoPicture) {
    put_ball(0.9);
    std::string bytes = picture("ball.pov", "a.exr");
    put("whole.exr", bytes);
    EXPECT_EQ(demonstrated({"spheres"}, "ball.pov", "whole.exr").check.verdict, Verdict::pass);
    put("cut.exr", bytes.substr(0, bytes.size() / 2));
    const auto window = bytes.find("dataWindow");
    ASSERT_NE(window, std::string::npos);
    bytes.replace(window + 30, 4, "\x7f\x7f\x7f\x7f");  // two thousand million columns
    put("absurd.exr", bytes);
    for (const char* file : {"cut.exr", "absurd.exr"})
        EXPECT_EQ(demonstrated({"spheres"}, "ball.pov", file).check.verdict, Verdict::fail) << file;
}

TEST_F(HandedInTest, ABuildErrorIsNotTheSolutionsMerit) {
    put_ball(0.9);
    put("a.png", picture("ball.pov", "a.png"));
    bench.student.clear();
    EXPECT_EQ(demonstrated({"spheres"}).check.verdict, Verdict::build_error);
}

TEST_F(HandedInTest, NothingHandedInIsNotStartedAndEarnsNothing) {
    const HandedIn h = grade_handed_in(bench, read_rubric(project.root / "grader" / "rubric.json"));
    EXPECT_EQ(h.points, 0);
    EXPECT_NE(h.verdict, Verdict::pass);
    for (const Check& c : h.checks) EXPECT_EQ(c.verdict, Verdict::not_started) << c.id << ": " << c.message;
}

TEST_F(HandedInTest, AReportIsHeldToItsWords) {
    put_ball(0.9);
    put("a.png", picture("ball.pov", "a.png"));
    const std::vector<Demonstration> pictures{demonstrated({"spheres", "phong", "polygons"})};
    put("report.md",
        "The ball a.png shows spheres.\n```\n./rays render submission/ball.pov -o submission/a.png --width 80 --height "
        "60\n"
        "./rays render submission/ball.pov -o submission/a.png --width 80 --height 60 --without phong\n"
        "./rays render submission/ball.pov -o b.png --width 80 --height 60\n./rays render ball.pov; id -o "
        "a.png\n```\n");
    const std::vector<Check> checks = report_checks(bench, pictures, 10);
    ASSERT_EQ(checks.size(), 3u);
    EXPECT_NEAR(checks[0].points, 4 * 2.0 / 3, 1e-9) << "no polygon in sight";
    EXPECT_NEAR(checks[1].points, 4 * 1.0 / 4, 1e-9) << checks[1].message;
    EXPECT_NE(checks[1].message.find("another picture"), std::string::npos) << checks[1].message;
    EXPECT_NE(checks[1].message.find("does not list"), std::string::npos) << checks[1].message;
    // Too short, no template, a.png named, spheres named, Phong and polygons not.
    EXPECT_NEAR(checks[2].points, 2 * 3.0 / 6, 1e-9) << checks[2].message;
    put("report.md", std::string(3'000'000, 'x'));
    const std::vector<Check> huge = report_checks(bench, pictures, 10);
    EXPECT_EQ(huge.at(0).points, 0);
    EXPECT_NE(huge.at(0).message.find("more than"), std::string::npos);
}

TEST_F(HandedInTest, TheTemplateIsACompleteStartButForItsWords) {
    write_atomically(folder.path() / "steps" / "1_ray_casting" / "step.json",
                     read_file(project.steps() / "1_ray_casting" / "step.json"));
    put("steps/1_ray_casting/camera.cpp", "// mine\n");
    const fs::path out = folder.path() / "out";
    const HandInResult r =
        hand_in(project, {folder.path() / "steps", folder.path() / "submission", bench.student}, out);
    EXPECT_EQ(r.made.size(), 2u);
    EXPECT_FALSE(is_complete(r)) << "the words are still to be written";
    for (const Check& c : r.checked.checks) {
        if (c.id == "report.text") continue;
        EXPECT_EQ(c.verdict, Verdict::pass) << c.id << ": " << c.message;
    }
    EXPECT_EQ(read_file(out / "1_ray_casting" / "camera.cpp"), "// mine\n");
    for (const char* file : {"submission.json", "report.md", "pictures/still_life.png"})
        EXPECT_TRUE(fs::exists(out / file)) << file;
    EXPECT_THROW(
        hand_in(project, {folder.path() / "steps", folder.path() / "submission", bench.student}, folder.path()),
        InputError)
        << "a folder with other things in it is not written to";
}

}  // namespace
}  // namespace rays::grader
