#include "grader/compare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "grader/picture.h"
#include "tools.h"

namespace rays::grader {
namespace {

constexpr int kEdge = 64 / 3;

class CompareTest : public testing::Test {
protected:
    RgbImage picture = test_picture();
    Reference truth = test_reference(picture, kEdge);
    Comparison result(const RgbImage& p) const { return compare(p, truth, kReferenceTolerance); }
};

TEST_F(CompareTest, IdentityPasses) {
    const Comparison c = result(picture);
    EXPECT_TRUE(c.passed) << c.problem;
    EXPECT_EQ(c.beyond, 0);
    EXPECT_EQ(c.max_error, 0);
    EXPECT_EQ(c.pixels, 64 * 48);
}

TEST_F(CompareTest, HalfRoundingPassesAndTwiceThatFails) {
    RgbImage rounded = picture, off = picture;
    for (Rgb& p : rounded.pixels)
        for (float& v : p) v *= 1 + 1.0f / 2048;
    for (Rgb& p : off.pixels)
        for (float& v : p) v *= 1 + 2.0f / 2048;
    EXPECT_TRUE(result(rounded).passed) << result(rounded).problem;
    EXPECT_FALSE(result(off).passed);
}

TEST_F(CompareTest, OnePixelThatNothingExplainsFails) {
    picture.at(5, 7)[1] += 0.01f;
    const Comparison c = result(picture);
    EXPECT_FALSE(c.passed);
    EXPECT_EQ(c.beyond, 1);
    EXPECT_EQ(c.on_silhouettes, 0);
    EXPECT_EQ(c.worst_x, 5);
    EXPECT_EQ(c.worst_y, 7);
    EXPECT_NEAR(c.max_error, 0.01, 1e-6);
}

TEST_F(CompareTest, OnePixelOfTheOtherSideOfASilhouettePasses) {
    picture.at(kEdge, 9) = picture.at(kEdge - 1, 9);
    const Comparison c = result(picture);
    EXPECT_TRUE(c.passed) << c.problem;
    EXPECT_EQ(c.on_silhouettes, 1);
    EXPECT_EQ(c.max_error, 0) << "silhouettes are left out";
}

TEST_F(CompareTest, AMovedSilhouetteIsTooManyPixels) {
    for (int y = 0; y < 48; ++y) picture.at(kEdge, y) = picture.at(kEdge - 1, y);
    const Comparison c = result(picture);
    EXPECT_EQ(c.on_silhouettes, 48);
    EXPECT_FALSE(c.passed) << "48 of 3072 pixels are 1.6 %, allowed are 0.05 %";
}

TEST_F(CompareTest, ASilhouettePixelWithAForeignColourFails) {
    picture.at(kEdge, 9) = {0.9f, 0.0f, 0.9f};
    EXPECT_FALSE(result(picture).passed);
}

TEST_F(CompareTest, NanAndInfinityFailEvenOnSilhouettesAndAreCounted) {
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity()}) {
        RgbImage p = picture;
        p.at(kEdge, 3)[2] = bad;
        const Comparison c = result(p);
        EXPECT_FALSE(c.passed);
        EXPECT_EQ(c.not_finite, 1);
        EXPECT_EQ(c.worst_x, kEdge);
        EXPECT_EQ(c.worst_y, 3);
        EXPECT_TRUE(std::isfinite(c.rmse));
        EXPECT_TRUE(std::isfinite(c.max_error));
    }
}

TEST_F(CompareTest, AllNanFails) {
    for (Rgb& p : picture.pixels) p.fill(std::numeric_limits<float>::quiet_NaN());
    EXPECT_FALSE(result(picture).passed);
    EXPECT_EQ(result(picture).not_finite, 64 * 48);
}

TEST_F(CompareTest, AnotherSizeFails) {
    const Comparison c = result(test_picture(48, 64));
    EXPECT_FALSE(c.passed);
    EXPECT_NE(c.problem.find("48 x 64"), std::string::npos);
    EXPECT_FALSE(result(RgbImage{}).passed);
}

TEST_F(CompareTest, BlackFails) {
    for (Rgb& p : picture.pixels) p.fill(0);
    EXPECT_FALSE(result(picture).passed);
    EXPECT_EQ(result(picture).beyond, 64 * 48);
}

TEST_F(CompareTest, ShiftByOnePixelFails) {
    RgbImage shifted = picture;
    for (int y = 0; y < 48; ++y)
        for (int x = 1; x < 64; ++x) shifted.at(x, y) = picture.at(x - 1, y);
    EXPECT_FALSE(result(shifted).passed);
}

TEST(Within, IsFalseForNan) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_TRUE(within({1, 1, 1}, {1, 1, 1}, kReferenceTolerance));
    EXPECT_FALSE(within({1, nan, 1}, {1, 1, 1}, kReferenceTolerance));
}

TEST(DecodeExr, ReadsWhatTheRenderProgramsWrite) {
    const RgbImage picture = test_picture();
    const DecodedPicture decoded = decode_exr(exr_bytes(picture), 64, 48);
    ASSERT_EQ(decoded.problem, "");
    EXPECT_EQ(decoded.picture.pixels, picture.pixels);
}

TEST(DecodeExr, KeepsNanForTheVerdict) {
    RgbImage picture = test_picture();
    picture.at(1, 2)[0] = std::numeric_limits<float>::quiet_NaN();
    const DecodedPicture decoded = decode_exr(exr_bytes(picture), 64, 48);
    ASSERT_EQ(decoded.problem, "");
    EXPECT_TRUE(std::isnan(decoded.picture.at(1, 2)[0]));
}

}  // namespace
}  // namespace rays::grader
