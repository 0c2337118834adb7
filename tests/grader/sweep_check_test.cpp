// What a sweep charts, with shell scripts for programs.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "grader/checks.h"
#include "tools.h"

namespace rays::grader {
namespace {

/// Four questions at x = 1 and four at x = 10; an answer is its own error.
Sweep sweep_of(bool log_y) {
    Sweep sweep;
    sweep.id = "9.1.test";
    sweep.task = "9.1";
    sweep.log_y = log_y;
    sweep.pass_from = 1;
    sweep.pass_to = 10;
    const auto judge = [](const Answer& a) {
        const double error = a.kind == Answer::Kind::value ? a.numbers[0] : INFINITY;
        return Judgement{error == 0, error, "0"};
    };
    for (const double x : {1.0, 10.0}) {
        sweep.points.push_back({x, {}});
        for (int i = 0; i < 4; ++i)
            sweep.points.back().questions.push_back({"9.1", "s", fmt::format("q{}of{}", i, x), "", judge});
    }
    return sweep;
}

class SweepCheckTest : public testing::Test {
protected:
    /// At x = 1 all is right; at x = 10 these four answers come.
    Check check(bool log_y, const std::array<const char*, 4>& answers) const {
        std::string cases;
        for (int i = 0; i < 4; ++i)
            cases += fmt::format("q{}of10) echo {};; ", i, answers[static_cast<std::size_t>(i)]);
        const auto program =
            script(folder, "while read -r line; do case $line in *of1) echo 0;; " + cases + " esac; done");
        const Bench bench{project, *sandbox, step, program, program, {}, 1, {}, false};
        return sweep_check(bench, sweep_of(log_y), {}, 1);
    }

    TemporaryFolder folder;
    Project project;
    Step step;
    std::unique_ptr<Sandbox> sandbox = make_sandbox();
};

using Points = std::vector<std::pair<double, std::optional<double>>>;

TEST_F(SweepCheckTest, ALinearChartShowsTheShareOfWrongAnswers) {
    const Check c = check(false, {"0", "1", "0", "0"});
    EXPECT_EQ(c.chart->series.at(0).points, (Points{{1, 0}, {10, 0.25}}));
    EXPECT_EQ(c.verdict, Verdict::fail) << "one wrong answer makes a point wrong";
}

TEST_F(SweepCheckTest, ALogarithmicChartShowsTheWorst) {
    const Check c = check(true, {"0", "0.5", "0.25", "0"});
    EXPECT_EQ(c.chart->series.at(0).points.at(1).second, 0.5);
    EXPECT_GT(c.chart->series.at(0).points.at(0).second, 0) << "no error at all still needs a number";
}

// The identity needs no transform: an unwritten task is right at x = 1.
TEST_F(SweepCheckTest, WhatIsNotWrittenIsNotStartedThoughSomeOfItIsRight) {
    const char* waits = "unfinished 9.1";
    const Check c = check(true, {waits, waits, waits, waits});
    EXPECT_EQ(c.verdict, Verdict::not_started);
    EXPECT_EQ(c.points, 0);
    EXPECT_NE(c.message.find("right at 1 of 2 points from 1 to 10; 4 answers wait for task 9.1"), std::string::npos)
        << c.message;
    const Check wrong = check(true, {waits, "0.5", waits, waits});
    EXPECT_EQ(wrong.verdict, Verdict::fail);
    EXPECT_NE(wrong.message.find("got 0.5"), std::string::npos) << wrong.message;
}

TEST_F(SweepCheckTest, ALostAnswerSaysThatTheProgramCrashed) {
    const Check c = check(true, {"0", "0", "$(kill -SEGV $$)", "0"});
    EXPECT_EQ(c.verdict, Verdict::crash);
    EXPECT_NE(c.message.find("got no answer (the program had crashed)"), std::string::npos) << c.message;
}

TEST_F(SweepCheckTest, WhatIsNoNumberFailed) {
    EXPECT_EQ(check(false, {"0", "miss", "0", "0"}).chart->series.at(0).points.at(1).second, std::nullopt);
    EXPECT_EQ(check(true, {"0", "nan", "0", "0"}).chart->series.at(0).points.at(1).second, std::nullopt);
}

}  // namespace
}  // namespace rays::grader
