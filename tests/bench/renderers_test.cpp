// What charts of pictures are worth: how errors are judged, and that both renderers are asked for the same picture.
#include "renderers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "references/averaged.h"
#include "references/picture_error.h"
#include "support/files.h"

namespace rays::bench {
namespace {

RgbImage picture(int width, int height, float value) {
    return {{width, height}, std::vector<Rgb>(static_cast<std::size_t>(width * height), Rgb{value, value, value})};
}

TEST(PictureError, IsRelativeAndInRootMeanSquare) {
    const RgbImage truth = picture(4, 2, 0.5f);
    RgbImage other = truth;
    EXPECT_EQ(picture_error(other, truth), 0);
    for (Rgb& pixel : other.pixels) pixel[0] = 0.75f;
    EXPECT_DOUBLE_EQ(picture_error(other, truth), 0.5 / std::sqrt(3.0)) << "one lane of three is off by half";
    other = truth;
    other.at(3, 1) = {1, 1, 1};
    EXPECT_DOUBLE_EQ(picture_error(other, truth), 1 / std::sqrt(8.0)) << "one pixel of eight is off by all";
}

// POV-Ray writes half floats: what it cannot write is no error of ours.
TEST(PictureError, DoesNotSeeTheRoundingOfHalfFloats) {
    const float rounded = 1365.0f / 4096;  // a third in 11 bits, rounded to nearest
    EXPECT_EQ(picture_error(picture(2, 2, 1.0f / 3), picture(2, 2, rounded)), 0);
    EXPECT_GT(picture_error(picture(2, 2, 1.0f / 3 + 0.001f), picture(2, 2, rounded)), 0);
}

TEST(PictureError, OfAMeanIsWithoutTheReferencesOwn) {
    const AveragedReference truth{picture(4, 2, 0.5f), picture(4, 2, 0.03f)};
    EXPECT_NEAR(picture_error(picture(4, 2, 0.55f), truth), 0.08, 1e-6)
        << "0.05, of which 0.03 are the reference's, of 0.5";
    EXPECT_NEAR(picture_error(truth.mean, truth), 0.015, 1e-7) << "a quarter of 0.03, of 0.5";
    EXPECT_THROW(picture_error(picture(2, 4, 0.5f), truth), std::invalid_argument);
    EXPECT_EQ(picture_error(picture(4, 2, std::numeric_limits<float>::quiet_NaN()), truth),
              std::numeric_limits<double>::infinity());
}

TEST(PictureError, WhatIsNoNumberIsInfinitelyWrong) {
    const RgbImage truth = picture(2, 2, 0.5f);
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        RgbImage other = truth;
        other.at(1, 1)[2] = bad;
        EXPECT_EQ(picture_error(other, truth), std::numeric_limits<double>::infinity());
        EXPECT_EQ(picture_error(truth, other), std::numeric_limits<double>::infinity());
    }
    EXPECT_THROW(picture_error(picture(4, 1, 1), truth), std::invalid_argument) << "as many pixels, another shape";
}

TEST(Averaged, TakesTheMeanOfBlocks) {
    RgbImage fine = picture(4, 2, 0);
    fine.at(0, 0) = {1, 0, 0};
    fine.at(1, 1) = {3, 0, 0};
    fine.at(3, 1) = {0, 0, 8};
    const RgbImage mean = averaged(fine, 2);
    EXPECT_EQ(mean.raster.width, 2);
    EXPECT_EQ(mean.raster.height, 1);
    EXPECT_EQ(mean.at(0, 0), (Rgb{1, 0, 0}));
    EXPECT_EQ(mean.at(1, 0), (Rgb{0, 0, 2}));
    EXPECT_THROW(averaged(fine, 3), std::invalid_argument);
}

TEST(Statistics, OfPovrayNameTheRays) {
    EXPECT_EQ(povray_rays("Pixels:  19200   Samples: 0\nRays:            127563   Saved:   0\nShadow Ray Tests: 5\n"),
              127563);
    EXPECT_THROW(povray_rays("Shadow Rays:  12\n"), std::runtime_error);
}

TEST(Settings, StandAtTheEndOfTheScene) {
    const TemporaryFolder folder;
    write_atomically(folder.path() / "a.pov", std::string_view("sphere { 0, 1 }"));
    const auto file = with_settings(folder.path() / "a.pov", "max_trace_level 3", folder.path(), "b");
    EXPECT_EQ(read_file(file), "sphere { 0, 1 }\nglobal_settings { max_trace_level 3 }\n");
}

TEST(Commands, AskBothForTheSamePictureInOneThread) {
    const Picture asked{"/scenes/a.pov", {40, 30}};
    const auto has = [](const Command& command, const std::string& word) {
        return std::find(command.argv.begin(), command.argv.end(), word) != command.argv.end();
    };
    const Command ours = raysteps_command("render-solution", asked, "/there", "o.exr", {"--samples", "4"});
    const Command theirs = povray_command(asked, "/there", "p.exr", {"+AM1"});
    for (const std::string word : {"/scenes/a.pov", "40", "30", "1", "o.exr", "4"})
        EXPECT_TRUE(has(ours, word)) << word;
    for (const std::string word : {"+I/scenes/a.pov", "+W40", "+H30", "+WT1", "+Op.exr"})
        EXPECT_TRUE(has(theirs, word)) << word;
    EXPECT_EQ(theirs.argv.back(), "+AM1") << "the last word counts";
    EXPECT_EQ(ours.folder, theirs.folder);
}

}  // namespace
}  // namespace rays::bench
