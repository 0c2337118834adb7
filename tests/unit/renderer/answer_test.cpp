#include "renderer/answer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <utility>
#include <vector>

namespace rays {
namespace {

std::vector<std::string> ask(const std::string& questions) {
    std::istringstream in(questions);
    std::ostringstream out;
    answer_questions(in, out);
    std::vector<std::string> lines;
    std::istringstream answers(out.str());
    for (std::string line; std::getline(answers, line);) lines.push_back(line);
    return lines;
}

std::string scene(const std::string& sdl) { return "scene " + std::to_string(sdl.size()) + "\n" + sdl + "\n"; }

TEST(Answer, NearestAndMiss) {
    const auto lines = ask(scene("sphere { 0, 1 }") + "nearest 0 0 -5 0 0 1 0 inf\nroot 0 0 2 -5 0 0 1 0 100\n");
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_EQ(lines[0], "hit 4 0 0 -1 0 0 -1 0");
    EXPECT_EQ(lines[1], "miss");
}

TEST(Answer, EveryQueryGetsOneLineWhateverHappens) {
    const auto lines =
        ask("nearest 0 0 0 0 0 1 0 1\n" + scene("sphere { 0, 1") + "nearest 0 0 -5 0 0 1 0 9\n" +
            scene("sphere { 0, 1 }") + "nearest 0 0\nroot 7 0 0 0 0 0 1 0 1\nfly 1 2 3\nnearest a b c d e f g h\n" +
            "nearest nan inf 1e-320 0 0 0 0 inf\n");
    ASSERT_EQ(lines.size(), 7u);
    EXPECT_EQ(lines[0], "error no scene");
    for (int i = 1; i < 6; ++i) EXPECT_TRUE(lines[std::size_t(i)].starts_with("error ")) << lines[std::size_t(i)];
    EXPECT_EQ(lines[6], "miss");  // a ray of NaNs meets nothing
}

/// Counts the lines that have left, which a crash cannot take back.
class Counting : public std::stringbuf {
public:
    int left = 0;

protected:
    int sync() override {
        const std::string text = str();
        left = static_cast<int>(std::count(text.begin(), text.end(), '\n'));
        return 0;
    }
};

/// Before each line that is read, all earlier queries must have been answered for good.
class Watching : public std::streambuf {
public:
    Watching(std::vector<std::string> lines, const Counting& out) : lines_(std::move(lines)), out_(out) {}

protected:
    int_type underflow() override {
        if (at_ == lines_.size()) return traits_type::eof();
        EXPECT_EQ(out_.left, static_cast<int>(at_));
        std::string& line = lines_[at_++];
        setg(line.data(), line.data(), line.data() + line.size());
        return traits_type::to_int_type(line[0]);
    }

private:
    std::vector<std::string> lines_;
    const Counting& out_;
    std::size_t at_ = 0;
};

TEST(Answer, EachAnswerLeavesBeforeTheNextQueryIsRead) {
    Counting counting;
    Watching watching({"inside 0 0 0 0\n", "fly\n", "inside 0 0 0 0\n"}, counting);
    std::istream in(&watching);
    std::ostream out(&counting);
    answer_questions(in, out);
    EXPECT_EQ(counting.left, 3);
}

TEST(Answer, ASceneMayHoldAnyBytes) {
    const auto lines = ask(scene(std::string("sphere { 0, 1 } // \0 \n nearest", 31)) + "inside 0 0 0 0\n");
    ASSERT_EQ(lines.size(), 1u);
}

TEST(Answer, PointsGoAlongWhatIsAsked) {
    const auto lines = ask(scene("sphere { 0, 1 }") + "points random 1 2 3 0 8 sample 4 pixel 2\n" +
                           "points random 1 3 3 2 8 nothing 1 nothing 1\n");
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_EQ(std::count(lines[0].begin(), lines[0].end(), ' '), 15) << "4 samples of 2 pixels";
    EXPECT_NE(lines[0].find(lines[1]), std::string::npos) << "sample 2 of the second pixel is among them";
}

TEST(Answer, AGridIsTheCentresOfItsCells) {
    const auto lines = ask(scene("sphere { 0, 1 }") + "filter box grid 2 1 0\nfilter box 0.25 0.5 0\n");
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_EQ(lines[0], "-0.25 0 1 0.25 0 1");
    EXPECT_EQ(lines[1], "-0.25 0 1");
}

TEST(Answer, TooMuchOrTooOddIsAnError) {
    for (const char* query : {"points sobol 1 2 3 0 8192 sample 8192 nothing 1",
                              "points sobol 1 2 3 0 4096 sample 4096 pixel 2",
                              "points sobol -1 0 0 0 1 nothing 1 nothing 1",
                              "points sobol 1e30 0 0 0 1 nothing 1 nothing 1",
                              "points sobol nan 0 0 0 1 nothing 1 nothing 1",
                              "points sobol 1 0 0 5 5 nothing 1 nothing 1",
                              "points halton 1 0 0 0 1 nothing 1 nothing 1",
                              "points sobol 1 0 0 0 1 backwards 1 nothing 1",
                              "points sobol 1 0 0 0 8 sample 9 nothing 1",
                              "disc grid 0 4 0",
                              "disc grid 100 100 0",
                              "disc 0.5",
                              "polygon 2 0.5 0.5 0",
                              "filter gauss 0 0 0",
                              "lens_ray 0 10 0 0 0 0 0.5 0.5 0",
                              "light_at 0 0.5 0.5 0",
                              "value_at 0 1 0 1 0.5",
                              "tilt 0 0 0 -1 0 0 -1 0 0 -1 0.5 0.5 0",
                              "is_enough 0 1 9 0 0 0 0 0 0 0 0 0",
                              "dimensions 2000 1",
                              "standard_error -4 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0"}) {
        const auto lines = ask(scene("sphere { 0, 1 }") + query + "\n");
        ASSERT_EQ(lines.size(), 1u) << query;
        EXPECT_TRUE(lines[0].starts_with("error ")) << query << ": " << lines[0];
    }
}

}  // namespace
}  // namespace rays
