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
    const auto lines = ask("nearest 0 0 0 0 0 1 0 1\n" + scene("sphere { 0, 1") + "nearest 0 0 -5 0 0 1 0 9\n" +
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

}  // namespace
}  // namespace rays
