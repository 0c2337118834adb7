// The questions that the grader asks a student's program, asked here in process: the solution answers all of them, for
// any seed, and every sweep within its stated range.
#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "questions/exchange.h"
#include "renderer/answer.h"

namespace rays::tests {
namespace {

using grader::Answer;
using grader::Question;

std::vector<Answer> asked(const std::vector<Question>& questions) {
    std::vector<const Question*> pointers;
    for (const Question& question : questions) pointers.push_back(&question);
    std::istringstream in(grader::question_text(pointers));
    std::stringstream out;
    answer_questions(in, out);
    std::vector<Answer> answers;
    for (std::string line; std::getline(out, line);) answers.push_back(grader::parse_answer(line));
    answers.resize(questions.size());
    return answers;
}

void expect_all_right(const std::vector<Question>& questions, const std::string& where) {
    const std::vector<Answer> answers = asked(questions);
    for (std::size_t i = 0; i < questions.size(); ++i) {
        const auto judgement = questions[i].judge(answers[i]);
        EXPECT_TRUE(judgement.ok) << where << ", task " << questions[i].task << ": " << questions[i].about << '\n'
                                  << questions[i].scene << questions[i].query << "\nexpected " << judgement.expected
                                  << ", got " << answers[i].text;
    }
}

class OfSeed : public testing::TestWithParam<int> {};

TEST_P(OfSeed, TheSolutionAnswersEveryQuestion) {
    expect_all_right(grader::questions_3_recursion(static_cast<std::uint64_t>(GetParam())), "seed");
}

INSTANTIATE_TEST_SUITE_P(Questions, OfSeed, testing::Range(1, 11));

TEST(Questions, AtLeast24ATask) {
    std::map<std::string, int> count;
    for (const Question& q : grader::questions_3_recursion(7)) ++count[q.task];
    EXPECT_EQ(count.size(), 11u);
    for (const auto& [task, n] : count) EXPECT_GE(n, 24) << task;
}

TEST(Questions, AnotherSeedAsksOtherQuestions) {
    const auto one = grader::questions_3_recursion(1), again = grader::questions_3_recursion(1),
               other = grader::questions_3_recursion(2);
    ASSERT_EQ(one.size(), again.size());
    int same = 0, repeated = 0;
    for (std::size_t i = 0; i < one.size(); ++i) {
        repeated += one[i].query == again[i].query && one[i].scene == again[i].scene;
        same += i < other.size() && one[i].query == other[i].query && one[i].scene == other[i].scene;
    }
    EXPECT_EQ(repeated, static_cast<int>(one.size()));
    EXPECT_LT(same, static_cast<int>(one.size()) / 10);
}

TEST(Questions, EmptyAndHostileAnswersAreWrong) {
    for (const char* line :
         {"", "nan nan nan", "inf inf inf", "1e400 0 0", "1 2", "0 0 0 0 0 0 0 0 0", "hello", "miss", "nan", "nan nan nan nan"})
        for (const Question& q : grader::questions_3_recursion(3)) {
            const auto judgement = q.judge(grader::parse_answer(line));
            if (judgement.expected == "miss") continue;  // total reflection: the right answer
            EXPECT_FALSE(judgement.ok) << q.query << " accepted '" << line << "'";
        }
}

TEST(Sweeps, TheSolutionHoldsWithinTheStatedRange) {
    for (const grader::Sweep& sweep : grader::sweeps_3_recursion(5)) {
        int inside = 0;
        for (const auto& point : sweep.points) {
            if (!(point.x >= sweep.pass_from && point.x <= sweep.pass_to)) continue;
            ++inside;
            expect_all_right(point.questions, sweep.id);
        }
        EXPECT_GE(inside, 4) << sweep.id;
    }
}

}  // namespace
}  // namespace rays::tests
