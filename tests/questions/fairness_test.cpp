// Are the questions fair? The solution answers all of them, for any seed, and every sweep within its stated range; no
// task has too few; another seed asks others; nonsense is never right.
#include <gtest/gtest.h>

#include <map>

#include "asked.h"
#include "grader/course.h"
#include "questions/exchange.h"

namespace rays::tests {
namespace {

using grader::Question;

void expect_all_right(const std::vector<Question>& questions, const std::string& where) {
    const auto answers = asked(questions);
    for (std::size_t i = 0; i < questions.size(); ++i) {
        const auto judgement = questions[i].judge(answers[i]);
        EXPECT_TRUE(judgement.ok) << where << ", task " << questions[i].task << ": " << questions[i].about << '\n'
                                  << questions[i].scene << questions[i].query << "\nexpected " << judgement.expected
                                  << ", got " << answers[i].text;
    }
}

class OfStep : public testing::TestWithParam<int> {
protected:
    const int step = GetParam();
};

TEST_P(OfStep, TheSolutionAnswersEveryQuestion) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed)
        expect_all_right(grader::questions_of(step, seed), "seed " + std::to_string(seed));
}

TEST_P(OfStep, EveryTaskIsAskedOften) {
    constexpr std::size_t kTasks[] = {15, 10, 11, 9};  // of steps 1 to 4, as in step.json
    std::map<std::string, int> count;
    for (const Question& q : grader::questions_of(step, 7)) ++count[q.task];
    EXPECT_EQ(count.size(), kTasks[step - 1]);
    for (const auto& [task, n] : count) EXPECT_GE(n, 24) << task;
}

TEST_P(OfStep, AnotherSeedAsksOtherQuestions) {
    const auto one = grader::questions_of(step, 1), again = grader::questions_of(step, 1),
               other = grader::questions_of(step, 2);
    ASSERT_EQ(one.size(), again.size());
    std::size_t same = 0;
    for (std::size_t i = 0; i < one.size(); ++i) {
        EXPECT_TRUE(one[i].query == again[i].query && one[i].scene == again[i].scene);
        same += i < other.size() && one[i].query == other[i].query && one[i].scene == other[i].scene;
    }
    // Some cases are chosen for what they are (an exact critical angle, an empty box), not by dice.
    EXPECT_LT(same, one.size() / 5) << "of " << one.size();
}

TEST_P(OfStep, NonsenseIsNeverRight) {
    for (const char* line : {"", "nan", "nan nan nan", "nan nan nan nan", "inf inf inf", "1e400 0 0", "300 300 300",
                             "0 0 0 0 0 0 0 0 0", "hello", "-1", "hit nan 0 0 0 0 0 0 0"})
        for (const Question& q : grader::questions_of(step, 3))
            EXPECT_FALSE(q.judge(grader::parse_answer(line)).ok) << q.query << " accepted '" << line << "'";
}

TEST_P(OfStep, TheSolutionHoldsWithinEverySweepsRange) {
    for (const grader::Sweep& sweep : grader::sweeps_of(step, 5)) {
        int inside = 0;
        for (const auto& point : sweep.points) {
            if (!(point.x >= sweep.pass_from && point.x <= sweep.pass_to)) continue;
            ++inside;
            expect_all_right(point.questions, sweep.id);
        }
        EXPECT_GE(inside, 4) << sweep.id;
    }
}

INSTANTIATE_TEST_SUITE_P(Questions, OfStep, testing::Range(1, 5));

}  // namespace
}  // namespace rays::tests
