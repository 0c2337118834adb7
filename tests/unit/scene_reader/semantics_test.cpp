// The language itself against POV-Ray. Each semantics/*.pov prints values with #debug; the .expected beside it is what
// POV-Ray 3.7.0.10 printed (povray +Ix.pov +W1 +H1 -D -F +GDx.expected, without its empty lines).
#include <filesystem>
#include <fstream>
#include <sstream>

#include "read.h"

namespace rays {
namespace {

std::string file_text(const std::filesystem::path& path) {
    std::ifstream in(path);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

class Semantics : public ::testing::TestWithParam<const char*> {};

TEST_P(Semantics, PrintsWhatPovRayPrints) {
    const std::filesystem::path folder = RAYSTEPS_SEMANTICS;
    std::string printed;
    ReadOptions options;
    options.debug = [&printed](const std::string& text) { printed += text; };
    read_scene(folder / (std::string(GetParam()) + ".pov"), options);
    const std::string expected = file_text(folder / (std::string(GetParam()) + ".expected"));
    ASSERT_FALSE(expected.empty());
    std::istringstream found_lines(printed), expected_lines(expected);
    std::string found, wanted;
    while (std::getline(expected_lines, wanted)) {
        ASSERT_TRUE(std::getline(found_lines, found)) << "missing: " << wanted;
        EXPECT_EQ(found, wanted);
    }
    EXPECT_FALSE(std::getline(found_lines, found)) << "too much: " << found;
}

INSTANTIATE_TEST_SUITE_P(Files, Semantics, ::testing::Values("expressions", "functions", "directives"));

}  // namespace
}  // namespace rays
