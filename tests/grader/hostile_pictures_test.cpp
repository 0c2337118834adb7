// Pictures that are broken or hostile: what is wrong is said, and what is no number is like nothing.
#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>

#include "grader/submission/looks.h"
#include "grader/submission/png.h"
#include "tools.h"

namespace rays::grader {
namespace {

std::string big_endian(std::uint32_t v) {
    return {static_cast<char>(v >> 24), static_cast<char>(v >> 16), static_cast<char>(v >> 8), static_cast<char>(v)};
}

std::string chunk(const std::string& type, const std::string& data) {
    const std::string body = type + data;
    const auto sum = ::crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
    return big_endian(static_cast<std::uint32_t>(data.size())) + body + big_endian(static_cast<std::uint32_t>(sum));
}

std::string deflated(const std::string& bytes) {
    uLongf size = ::compressBound(bytes.size());
    std::string packed(size, '\0');
    ::compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
               bytes.size());
    packed.resize(size);
    return packed;
}

std::string png(std::uint32_t width, std::uint32_t height, const std::string& rows, char bits = 8, char color = 2) {
    const std::string header = big_endian(width) + big_endian(height) + bits + color + std::string(3, '\0');
    return std::string("\x89PNG\r\n\x1a\n", 8) + chunk("IHDR", header) + chunk("IDAT", deflated(rows)) +
           chunk("IEND", "");
}

TEST(PngTest, EveryFilterIsUndone) {
    // Two pixels a row; rows: as they are, from the left, from above, from the mean of both, by Paeth.
    const std::string rows{
        "\0\x0a\x14\x1e\x28\x32\x3c"
        "\1\x0a\x14\x1e\x01\x01\x01"
        "\2\x01\x01\x01\x01\x01\x01"
        "\3\x01\x01\x01\x01\x01\x01"
        "\4\x01\x01\x01\x01\x01\x01",
        35};
    const PngPicture p = decode_png(png(2, 5, rows), {2, 5});
    ASSERT_EQ(p.problem, "");
    const std::array<std::uint8_t, 3> expected[] = {{10, 20, 30}, {40, 50, 60}, {10, 20, 30}, {11, 21, 31},
                                                    {11, 21, 31}, {12, 22, 32}, {6, 11, 16},  {10, 17, 25},
                                                    {7, 12, 17},  {11, 18, 26}};
    for (std::size_t i = 0; i < 10; ++i) EXPECT_EQ(p.pixels[i], expected[i]) << i;
}

TEST(PngTest, WhatIsWrongIsSaid) {
    const std::string row("\0\1\2\3", 4);
    EXPECT_TRUE(has(decode_png("GIF89a", {1, 1}).problem, "no PNG"));
    EXPECT_TRUE(has(decode_png(png(4000000000u, 4000000000u, row), {1, 1}).problem, "4000000000 x 4000000000"));
    EXPECT_TRUE(has(decode_png(png(1, 1, row, 16), {1, 1}).problem, "another kind"));
    EXPECT_TRUE(has(decode_png(png(1, 1, row, 8, 3), {1, 1}).problem, "another kind"));
    EXPECT_TRUE(has(decode_png(png(1, 1, std::string("\7\1\2\3", 4)), {1, 1}).problem, "cannot be read"));
    EXPECT_TRUE(has(decode_png(png(1, 1, "\1"), {1, 1}).problem, "cannot be read"));
    EXPECT_TRUE(has(decode_png(png(1, 1, std::string(10'000'000, '\0')), {1, 1}).problem, "cannot be read"))
        << "more pixels than promised";
    const std::string good = png(1, 1, row);
    for (std::size_t cut = 0; cut < good.size(); ++cut)
        EXPECT_NE(decode_png(good.substr(0, cut), {1, 1}).problem, "") << cut;
    for (std::size_t at = 8; at < good.size(); ++at) {
        std::string flipped = good;
        flipped[at] = static_cast<char>(flipped[at] ^ 0x40);
        EXPECT_NE(decode_png(flipped, {1, 1}).problem, "") << at;
    }
}

TEST(LooksTest, APictureIsItself) {
    const RgbImage picture = test_picture();
    EXPECT_TRUE(likeness("a.exr", exr_bytes(picture), picture).same());
    RgbImage other = picture;
    for (int x = 0; x < 4; ++x) other.at(x, 0)[1] += 0.1f;
    const Likeness four = likeness("a.exr", exr_bytes(other), picture);
    EXPECT_EQ(four.differing, 4);
    EXPECT_FALSE(four.same()) << "three pixels of 3072 are forgiven, not four";
}

TEST(LooksTest, NumbersThatAreNoneAreNoPicture) {
    RgbImage picture = test_picture(), broken = picture;
    for (Rgb& pixel : broken.pixels) pixel[2] = std::nanf("");
    EXPECT_FALSE(likeness("a.exr", exr_bytes(broken), picture).same());
    EXPECT_FALSE(likeness("a.exr", exr_bytes(broken), broken).same()) << "not even as itself";
    EXPECT_EQ(display_level(std::nanf("")), -1);
    EXPECT_EQ(visible_share(picture, broken), 1);
}

TEST(LooksTest, AWrongSizeOrKindIsSaid) {
    const RgbImage picture = test_picture();
    EXPECT_NE(likeness("a.exr", exr_bytes(test_picture(32, 24)), picture).problem, "");
    EXPECT_NE(likeness("a.exr", "v/1\x01 no picture", picture).problem, "");
    EXPECT_TRUE(has(likeness("a.png", exr_bytes(picture), picture).problem, "no PNG"));
}

TEST(LooksTest, VisibleIsEightLevelsAndMore) {
    EXPECT_EQ(display_level(0), 0);
    EXPECT_EQ(display_level(1), 255);
    EXPECT_EQ(display_level(0.2158605f), 128);  // ((128 / 255 + 0.055) / 1.055)^2.4
    RgbImage a{{10, 1}, std::vector<Rgb>(10, Rgb{0.2158605f, 0, 0})}, b = a;
    b.pixels[3][0] = 0.2307f;  // 132: four levels more
    EXPECT_EQ(visible_share(a, b), 0);
    b.pixels[3][0] = 0.25f;  // 137
    EXPECT_DOUBLE_EQ(visible_share(a, b), 0.1);
}

}  // namespace
}  // namespace rays::grader
