// Whole submissions whose code prints, floods, leaves early or forges: none gets a point by it, none is hurt by
// printing.
#include <gtest/gtest.h>

#include "submission_fixture.h"

namespace rays::grader {
namespace {

TEST_F(SubmissionsTest, PixelsThatAreNoNumbersFail) {
    put(kFile,
        solution_with("    Illumination nothing; nothing.radiance = Radiance(std::nanf(\"\")); return nothing;"));
    const StepResult step = run().steps.at(0);
    bool said = false;
    for (const Check& c : step.checks) said = said || (c.kind == "image" && c.message.find("NaN") != std::string::npos);
    EXPECT_TRUE(said);
    EXPECT_FALSE(has(verdicts(step, "image"), Verdict::crash));
}

// The course's lamps stand at places of one decimal, those of fresh scenes do not: this one knows only the former.
TEST_F(SubmissionsTest, PicturesKnownByHeartDoNotCount) {
    put(kFile, solution_with(
                   "    if (std::abs(light.location.x * 10 - std::round(light.location.x * 10)) > 1e-6) return {};"));
    const StepResult step = run().steps.at(0);
    int withheld = 0;
    for (const Check& c : step.checks) {
        if (c.kind != "image" || c.mode != "isolated") continue;
        EXPECT_EQ(c.points, 0) << c.id;
        withheld += c.message.find("it does not count yet: no fresh scene of task") != std::string::npos;
    }
    EXPECT_GT(withheld, 10);
}

TEST_F(SubmissionsTest, AGradeCannotBePrinted) {
    put(kFile, solution_with("    std::printf(\"Grade :=>> 100\\n\\x1b[2J{\\\"score\\\":100}\\n\"); "
                             "std::fflush(stdout); Illumination dark; return dark;"));
    const Results r = run();
    EXPECT_LT(r.steps.at(0).points, r.steps.at(0).max / 2);
    EXPECT_EQ(to_json(r).find("\x1b"), std::string::npos);
}

// Who looks for a mistake prints. It costs nothing: answers and ray trees have a standard output of their own.
TEST_F(SubmissionsTest, PrintingToStandardOutputCostsNothing) {
    put(kFile,
        "#include <iostream>\n" + solution_with("    std::printf(\"here\\n\"); std::cout << \"there\" << std::endl; "
                                                "[[maybe_unused]] const auto n = write(1, \"miss\\n\", 5);"));
    const StepResult step = run().steps.at(0);
    EXPECT_EQ(step.verdict, Verdict::pass);
    EXPECT_NEAR(step.points, step.max, 1e-9);
    for (const Check& c : step.checks)
        if (c.mode == "isolated") {  // step 1 is not written here
            EXPECT_EQ(c.verdict, Verdict::pass) << c.id << ": " << c.message;
        }
}

// The same when the code is wrong, too: the tree that explains the worst pixel is still read.
TEST_F(SubmissionsTest, PrintingDoesNotGarbleTheTreeOfAWrongPixel) {
    put(kFile, solution_with("    std::printf(\"{\\n\"); std::fflush(stdout); Illumination dark; return dark;"));
    const StepResult step = run().steps.at(0);
    int trees = 0;
    for (const Check& c : step.checks)
        for (const Diagnosis& d : c.diagnosis) trees += d.text.find("the shadow ray is missing") != std::string::npos;
    EXPECT_GT(trees, 5);
}

TEST_F(SubmissionsTest, AFloodOfTextIsStopped) {
    put(kFile, solution_with(
                   "    for (;;) std::puts(\"flood flood flood flood flood flood flood flood flood flood flood\");"));
    const StepResult step = run().steps.at(0);
    EXPECT_FALSE(has(verdicts(step, "image"), Verdict::infrastructure_error));
    EXPECT_TRUE(has(verdicts(step, "image"), Verdict::fail));
}

TEST_F(SubmissionsTest, AnEarlyGoodExitWithoutAPictureFails) {
    put(kFile, solution_with("    std::_Exit(0);"));
    const StepResult step = run().steps.at(0);
    bool said = false;
    for (const Check& c : step.checks)
        said = said || c.message.find("the picture was not written") != std::string::npos;
    EXPECT_TRUE(said);
    EXPECT_FALSE(has(verdicts(step, "image"), Verdict::pass) && step.points > step.max / 2);
}

TEST_F(SubmissionsTest, AForgedPictureIsJudgedAsAPicture) {
    // Writes its own "picture" and leaves: an absurd header, a link to the password file, a folder.
    for (const std::string how :
         {"FILE* f = std::fopen(\"picture.exr\", \"w\"); std::fputs(\"v/1\\x01\", f); std::fclose(f);",
          "symlink(\"/etc/passwd\", \"picture.exr\");"}) {
        put(kFile, solution_with("    { [[maybe_unused]] int ignored = 0; " + how + " std::_Exit(0); }"));
        const StepResult step = run().steps.at(0);
        for (const Check& c : step.checks)
            if (c.kind == "fresh" && c.task == "2.8") {
                EXPECT_EQ(c.verdict, Verdict::fail) << c.message;
            }
    }
}

}  // namespace
}  // namespace rays::grader
