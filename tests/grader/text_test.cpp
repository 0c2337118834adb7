#include "grader/text.h"

#include <gtest/gtest.h>

namespace rays::grader {
namespace {

TEST(Plain, TakesAwayWhatATerminalObeys) {
    EXPECT_EQ(plain("\x1b[31mred\x07\x9b\r"), "?[31mred???");
    EXPECT_EQ(plain("a\nb\tc"), "a b c");
    EXPECT_EQ(plain(std::string("a\0b", 3)), "a?b");
    EXPECT_EQ(plain("\xe2\x80\xae"), "???") << "no right-to-left override either";
    EXPECT_EQ(plain_lines("a\nb\x1b"), "a\nb?");
}

TEST(Plain, Cuts) {
    EXPECT_EQ(plain(std::string(1000, 'x'), 10), "xxxxxxxxxx...");
    EXPECT_EQ(plain("short", 10), "short");
}

}  // namespace
}  // namespace rays::grader
