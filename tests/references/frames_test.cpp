// Averaged references with POV-Ray itself, and closed forms for what frame.inc does.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "command_fixture.h"
#include "core/error.h"

namespace rays {
namespace {

constexpr const char* kScene = R"(
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 0, -3> right x*4/3 up y direction z }
#macro Wall(At, Paint) box { <-99, -99, At>, <99, 99, 99> pigment { Paint } finish { emission 1 ambient 0 diffuse 0 } } #end
#ifdef (Frame) Wall(9, rgb <Frame_u0, Frame_u1, 0.25>) #else Wall(9, rgb 0.5) #end
)";

class Frames : public ReferencesCommand {
protected:
    Frames() : ReferencesCommand({4, 3}) {}

    std::filesystem::path reference() const { return folders().references() / "5_test/scene.exr"; }
};

TEST_F(Frames, AreAveragedAndChecked) {
    put("5_test/scene.pov", kScene);
    ASSERT_EQ(run({"--frames", "32"}), kSuccess) << err_;
    const ManifestEntry entry = load_manifest(folders().manifest()).entries.at(0);
    EXPECT_TRUE(entry.averaged());
    EXPECT_EQ(entry.method, "mean of 32 frames");
    EXPECT_EQ(entry.frames, 32);
    EXPECT_NE(entry.command.find("Declare=Frame=0 Declare=Frame_u0=0."), std::string::npos) << entry.command;
    EXPECT_NE(entry.command.find("vary"), std::string::npos) << entry.command;

    AveragedReference reference = load_averaged_reference(this->reference());
    EXPECT_DOUBLE_EQ(entry.standard_error, rms_error(reference));
    const Rgb mean = reference.mean.at(1, 1), error = reference.error.at(1, 1);
    // Each replicate has one number in each quarter: its mean is off by 0.036 at one standard deviation.
    EXPECT_NEAR(mean[0], 0.5f, 5 * 0.036f / std::sqrt(8.0f));
    EXPECT_NEAR(mean[1], 0.5f, 5 * 0.036f / std::sqrt(8.0f));
    EXPECT_EQ(mean[2], 0.25f);
    EXPECT_GT(error[0], 0.002f);
    EXPECT_LT(error[0], 0.03f);
    EXPECT_EQ(error[2], 0);

    const std::string bytes = read_file(this->reference());
    ASSERT_EQ(run({"--force", "--jobs", "1"}), kSuccess) << err_;
    EXPECT_EQ(read_file(this->reference()), bytes) << "not the same again";
    EXPECT_EQ(run({"--hashes"}), kSuccess) << err_;
    EXPECT_EQ(run({"--check"}), kSuccess) << err_;
    EXPECT_EQ(run({"--check", "--seed", "6"}), kSuccess) << err_;
    EXPECT_EQ(run({"--frames", "20"}), kBadInput) << "no multiple of 8";

    // One channel of one pixel that never varied, by its last digit but one.
    reference.mean.at(3, 2)[2] += 0x1p-20f;
    save_averaged_reference(reference, this->reference());
    EXPECT_EQ(run({"--check"}), kCheckFailed);
    EXPECT_TRUE(err_says("1 of 36 numbers")) << err_;
    EXPECT_TRUE(err_says("channel B of pixel 3,2")) << err_;
}

TEST_F(Frames, CheckFindsAnotherScene) {
    put("5_test/scene.pov", kScene);
    ASSERT_EQ(run({"--frames", "16"}), kSuccess) << err_;
    put("5_test/scene.pov", std::string(kScene) + "Wall(8, rgb <Frame_u0, Frame_u1, 0.2>)\n");
    EXPECT_EQ(run({"--check"}), kCheckFailed);
    EXPECT_TRUE(err_says("the scene has changed")) << err_;
    EXPECT_TRUE(err_says("12 of 36 numbers")) << err_;
}

TEST_F(Frames, AFailureSaysWhichFrame) {
    put("5_test/scene.pov", std::string(kScene) + "#ifdef (Frame) #if (Frame >= 13) #error \"unlucky\" #end #end\n");
    EXPECT_EQ(run({"--frames", "16"}), kCheckFailed);
    EXPECT_TRUE(err_says("frame 13 of 16")) << err_;
    EXPECT_TRUE(err_says("unlucky")) << err_;
    EXPECT_FALSE(std::filesystem::exists(reference()));
    put("5_test/scene.pov", std::string(kScene) + "#ifdef (Frame) #if (Frame = 7) #warning \"beware\" #end #end\n");
    EXPECT_EQ(run({"--frames", "16"}), kCheckFailed);
    EXPECT_TRUE(err_says("frame 7 of 16")) << err_;
    EXPECT_TRUE(err_says("beware")) << err_;
}

// ---- frame.inc ------------------------------------------------------------------------------------------------------

std::string frame_inc() { return read_file(std::filesystem::path(SCENES_FOLDER) / "5_distributed" / "frame.inc"); }

/// The mean of `vector` (SDL, of S, T, W) and of the squares of its components, over a grid of midpoints.
std::array<double, 6> moments(const std::string& vector) {
    const std::string sdl = frame_inc() + R"(
#declare Sum = <0, 0, 0>; #declare Squares = <0, 0, 0>; #declare N = 20;
#for (I, 0, N - 1) #for (J, 0, N - 1) #for (K, 0, N - 1)
    #declare S = (I + 0.5)/N; #declare T = (J + 0.5)/N; #declare W = (K + 0.5)/N;
    #declare P = )" + vector +
                            R"(;
    #declare Sum = Sum + P/(N*N*N); #declare Squares = Squares + P*P/(N*N*N);
#end #end #end
#fopen Out "answers" write
#write (Out, str(Sum.x, 0, 9), " ", str(Sum.y, 0, 9), " ", str(Sum.z, 0, 9), " ")
#write (Out, str(Squares.x, 0, 9), " ", str(Squares.y, 0, 9), " ", str(Squares.z, 0, 9), "\n")
#fclose Out
)";
    std::istringstream in(Povray().answers("#version 3.7;\nglobal_settings { assumed_gamma 1.0 }\n" + sdl, 60));
    std::array<double, 6> result{};
    for (double& number : result) in >> number;
    EXPECT_TRUE(in);
    return result;
}

void expect_moments(const std::string& vector, const std::array<double, 6>& expected) {
    const std::array<double, 6> found = moments(vector);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(found[i], expected[i], 0.006) << vector << ", moment " << i;
}

TEST(FrameInc, PointsAreUniform) {
    expect_moments("Frame_disc(S, T)", {0, 0, 0, 0.25, 0.25, 0});
    // A regular polygon in the unit circle: (2 + cos(2 pi / n)) / 12 for each axis.
    expect_moments("Frame_polygon(S, T, 6)", {0, 0, 0, 2.5 / 12, 2.5 / 12, 0});
    expect_moments("Frame_polygon(S, T, 3)", {0, 0, 0, 1.5 / 12, 1.5 / 12, 0});
    expect_moments("Frame_square(S, T, 2*x, 3*z)", {0, 0, 0, 4 / 12.0, 0, 9 / 12.0});
    expect_moments("Frame_ellipse(S, T, 2*x, 4*z)", {0, 0, 0, 0.25, 0, 1});
    expect_moments("Frame_ball(S, T, W, 2)", {0, 0, 0, 1, 1, 1});
    // cos has the density (m + 2) c^(m+1): its mean is (m + 2)/(m + 3), that of its square (m + 2)/(m + 4); m = 10.
    expect_moments("Frame_tilt(S, T, 0.1, y)", {0, 12 / 13.0, 0, 1 / 14.0, 12 / 14.0, 1 / 14.0});
}

TEST(FrameInc, ALensBlursAPointToItsDisc) {
    const TemporaryFolder folder;
    write_atomically(folder.path() / "frame.inc", frame_inc());
    // At 2 and a half times the distance of focus the lens of radius A/4 = 0.3 is seen as a disc of radius 0.45 around
    // a ball of radius 0.2, by 0.5 beside the axis; a pixel is 0.1 wide there.
    write_atomically(folder.path() / "scene.pov", R"(
#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "frame.inc"
#declare Eye = <1, 2, -4>; #declare Ahead = 2*z; #declare Across = 0.8*2*x; #declare Above = 0.8*2*y;
camera { Frame_lens(1.2, Eye + 2*z) }
sphere { <1.5, 2, 1>, 0.2 pigment { rgb 1 } finish { emission 1 ambient 0 diffuse 0 } }
)");
    const Povray povray;
    const AveragedReference reference = average_of_frames(
        {.povray = &povray, .raster = {40, 40}, .frames = 256, .jobs = 24}, folder.path() / "scene.pov");
    double light = 0, x = 0, y = 0, xx = 0, yy = 0;
    for (int row = 0; row < 40; ++row) {
        for (int column = 0; column < 40; ++column) {
            const double value = reference.mean.at(column, row)[0];
            const double right = 0.1 * (column + 0.5 - 20), up = 0.1 * (20 - row - 0.5);
            light += value;
            x += value * right;
            y += value * up;
            xx += value * right * right;
            yy += value * up * up;
        }
    }
    x /= light;
    y /= light;
    EXPECT_NEAR(x, 0.5, 0.01);
    EXPECT_NEAR(y, 0, 0.01);
    EXPECT_NEAR(light * 0.01, 3.14159 * 0.04, 0.002);
    const double variance = (0.45 * 0.45 + 0.2 * 0.2) / 4 + 0.1 * 0.1 / 12;  // of a disc, a ball and a square pixel
    EXPECT_NEAR(xx / light - x * x, variance, 0.03 * variance);
    EXPECT_NEAR(yy / light - y * y, variance, 0.03 * variance);
}

}  // namespace
}  // namespace rays
