#include <gtest/gtest.h>

#include <random>

#include "grader/picture.h"
#include "tools.h"

namespace rays::grader {
namespace {

const std::string& good() {
    static const std::string bytes = exr_bytes(test_picture());
    return bytes;
}

std::string problem(const std::string& bytes) { return decode_exr(bytes, 64, 48).problem; }

TEST(ExrHeader, TakesTheRenderProgramsFiles) { EXPECT_EQ(exr_header_problem(good(), 64, 48), ""); }

TEST(ExrHeader, RefusesEmptyAndForeignBytes) {
    EXPECT_EQ(problem(""), "is not an OpenEXR file");
    EXPECT_EQ(problem("\x89PNG\r\n"), "is not an OpenEXR file");
    EXPECT_EQ(problem(std::string(4096, '\0')), "is not an OpenEXR file");
}

TEST(ExrHeader, NamesTheWrongSize) { EXPECT_EQ(exr_header_problem(good(), 48, 64), "is 64 x 48 pixels, not 48 x 64"); }

TEST(ExrHeader, RefusesAbsurdSizesWithoutReservingMemory) {
    std::string bytes = good();
    const auto name = bytes.find("dataWindow");
    ASSERT_NE(name, std::string::npos);
    // name, type "box2i", size 4 bytes, then xMin yMin xMax yMax: 2^31 - 1 columns
    const auto x_max = name + std::string("dataWindow").size() + 1 + std::string("box2i").size() + 1 + 4 + 8;
    bytes.replace(x_max, 4, "\xfe\xff\xff\x7f");
    EXPECT_EQ(problem(bytes), "is 2147483647 x 48 pixels, not 64 x 48");
}

TEST(ExrHeader, RefusesTiledMultiPartAndDeepFiles) {
    for (const char flag : {'\x02', '\x08', '\x10'}) {
        std::string bytes = good();
        bytes[5] = flag;
        EXPECT_EQ(problem(bytes), "is not a plain OpenEXR file (one part of scan lines)");
    }
}

TEST(ExrHeader, SurvivesEveryTruncation) {
    for (std::size_t length = 0; length < good().size(); length += length < 600 ? 1 : 997)
        EXPECT_NE(problem(good().substr(0, length)), "") << "cut to " << length << " bytes";
}

TEST(ExrHeader, SurvivesRandomDamage) {
    std::mt19937 random(7);
    for (int i = 0; i < 300; ++i) {
        std::string bytes = good();
        for (int k = 0; k < 4; ++k) bytes[random() % (i % 2 ? 500 : bytes.size())] = static_cast<char>(random());
        const DecodedPicture decoded = decode_exr(bytes, 64, 48);
        if (decoded.problem.empty()) {
            EXPECT_EQ(decoded.picture.pixels.size(), 64u * 48u);
        } else {
            EXPECT_TRUE(decoded.picture.pixels.empty());
        }
    }
}

}  // namespace
}  // namespace rays::grader
