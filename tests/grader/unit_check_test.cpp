// What a task's questions come to, with shell scripts for programs.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "grader/checks.h"
#include "tools.h"

namespace rays::grader {
namespace {

class UnitCheckTest : public testing::Test {
protected:
    /// Question i is answered by the i-th of these; right is "1".
    Check check(const std::vector<std::string>& answers) const {
        std::vector<Question> questions;
        std::string cases;
        for (std::size_t i = 0; i < answers.size(); ++i) {
            const auto judge = [](const Answer& a) {
                return Judgement{a.kind == Answer::Kind::value && a.numbers[0] == 1, 0, "1"};
            };
            questions.push_back({"9.1", "s\n", fmt::format("q{}", i), fmt::format("claim {}", i), judge});
            cases += fmt::format("q{}) {};; ", i, answers[i] == "crash" ? "kill -SEGV $$" : "echo " + answers[i]);
        }
        const auto program =
            script(folder, "while read -r line; do case $line in scene*|s) ;; " + cases + " esac; done");
        const Bench bench{project, *sandbox, step, program, program, {}, 1, {}, false};
        return unit_check(bench, {"9.1", "Nine", 4, {}, {}, {}}, questions, 4);
    }

    TemporaryFolder folder;
    Project project;
    Step step;
    std::unique_ptr<Sandbox> sandbox = make_sandbox();
};

TEST_F(UnitCheckTest, RightAnswersAndWaitingOnesAreNoFailure) {
    const Check c = check({"1", "unfinished 9.7", "unfinished 9.7", "unfinished 9.7"});
    EXPECT_EQ(c.verdict, Verdict::partial);
    EXPECT_TRUE(c.waits);
    EXPECT_EQ(c.message, "1 of 1 answered questions right; 3 wait for task 9.7");
    EXPECT_EQ(c.points, 0) << "a quarter of the answers earns nothing";
    EXPECT_EQ(c.questions.front().answer, "unfinished 9.7");
}

TEST_F(UnitCheckTest, AWrongAnswerIsToldBeforeAnUnfinishedOne) {
    const Check c = check({"unfinished 9.7", "1", "miss", "unfinished 9.7"});
    EXPECT_EQ(c.verdict, Verdict::fail);
    EXPECT_FALSE(c.waits);
    EXPECT_EQ(c.message, "1 of 2 answered questions right; 2 wait for task 9.7; claim 2: expected 1, got miss");
    EXPECT_EQ(c.questions.front().answer, "miss");
}

TEST_F(UnitCheckTest, NothingAnsweredIsNotStarted) {
    const Check c = check({"unfinished 9.1", "unfinished 9.1"});
    EXPECT_EQ(c.verdict, Verdict::not_started);
    EXPECT_EQ(c.message, "all 2 questions wait for task 9.1");
}

TEST_F(UnitCheckTest, AnUnwrittenTaskDoesNotCrash) {
    const Check c = check({"unfinished 9.1", "crash", "unfinished 9.1"});
    EXPECT_EQ(c.verdict, Verdict::not_started);
    EXPECT_TRUE(c.message.starts_with("0 of 0 answered questions right; 2 wait for task 9.1; the program crashed"))
        << c.message;
}

TEST_F(UnitCheckTest, ACrashIsSaidWhereAnAnswerIsMissing) {
    const Check c = check({"1", "crash", "1"});
    EXPECT_EQ(c.verdict, Verdict::crash);
    EXPECT_NE(c.message.find("claim 1: expected 1, got no answer (the program had crashed)"), std::string::npos)
        << c.message;
}

}  // namespace
}  // namespace rays::grader
