#include "grader/explain_picture.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tools.h"

namespace rays::grader {
namespace {

class ExplainTest : public testing::Test {
protected:
    RgbImage picture = test_picture();
    Reference truth = test_reference(picture, 21);
    RgbImage wrong = picture;
    std::string text() const { return explain_picture(wrong, truth, kReferenceTolerance).value_or("nothing"); }
    template <class F>
    void change(F f) {
        for (int y = 0; y < 48; ++y)
            for (int x = 0; x < 64; ++x) wrong.at(x, y) = f(x, y);
    }
};

TEST_F(ExplainTest, SaysNothingOfARightPicture) { EXPECT_EQ(text(), "nothing"); }

TEST_F(ExplainTest, NamesMirrors) {
    change([&](int x, int y) { return picture.at(63 - x, y); });
    EXPECT_EQ(text(), "the picture is mirrored left to right");
    change([&](int x, int y) { return picture.at(x, 47 - y); });
    EXPECT_EQ(text(), "the picture is upside down");
    change([&](int x, int y) { return picture.at(63 - x, 47 - y); });
    EXPECT_EQ(text(), "the picture is turned by half a turn");
}

TEST_F(ExplainTest, NamesShifts) {
    change([&](int x, int y) { return picture.at(std::max(x - 1, 0), y); });
    EXPECT_EQ(text(), "the picture is shifted 1 pixel to the right");
    change([&](int x, int y) { return picture.at(std::min(x + 2, 63), std::max(y - 1, 0)); });
    EXPECT_EQ(text(), "the picture is shifted 2 pixels to the left and 1 pixel down");
}

TEST_F(ExplainTest, NamesCurvesScalesAndChannels) {
    change([&](int x, int y) {
        Rgb c = picture.at(x, y);
        for (float& v : c) v = std::pow(v, 1 / 2.2f);
        return c;
    });
    EXPECT_EQ(text(), "the values are gamma encoded (1/2.2): colours must stay linear");
    change([&](int x, int y) {
        Rgb c = picture.at(x, y);
        for (float& v : c) v *= 2;
        return c;
    });
    EXPECT_EQ(text(), "every value is 2 times too bright");
    change([&](int x, int y) {
        const Rgb& c = picture.at(x, y);
        return Rgb{c[2], c[1], c[0]};
    });
    EXPECT_EQ(text(), "red and blue are swapped");
}

TEST_F(ExplainTest, NamesEmptyPictures) {
    change([](int, int) { return Rgb{0, 0, 0}; });
    EXPECT_EQ(text(), "the whole picture is black");
    change([](int, int) { return Rgb{0, 0.5f, 0}; });
    EXPECT_EQ(text(), "the whole picture has one colour (0, 0.5, 0)");
}

TEST_F(ExplainTest, DoesNotGuess) {
    change([&](int x, int y) { return (x + y) % 3 ? picture.at(x, y) : Rgb{1, 0, 1}; });
    EXPECT_EQ(text(), "nothing");
    change([](int, int) { return Rgb{NAN, NAN, NAN}; });
    EXPECT_EQ(text(), "nothing");
}

}  // namespace
}  // namespace rays::grader
