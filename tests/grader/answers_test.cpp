#include "grader/answers.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tools.h"

namespace rays::grader {
namespace {

using Kind = Answer::Kind;

TEST(ParseAnswer, ReadsEveryKind) {
    EXPECT_EQ(parse_answer("miss").kind, Kind::miss);
    EXPECT_EQ(parse_answer("unfinished 1.3").kind, Kind::unfinished);
    EXPECT_EQ(parse_answer("error too few numbers").kind, Kind::error);
    const Answer hit = parse_answer("hit 1.5 -2e3 0");
    EXPECT_EQ(hit.kind, Kind::value);
    EXPECT_EQ(hit.numbers, (std::vector<double>{1.5, -2000, 0}));
    EXPECT_EQ(parse_answer("0.25 0.5 1\r").numbers, (std::vector<double>{0.25, 0.5, 1}));
    EXPECT_EQ(parse_answer("-0.30000000000000004 5e-324").numbers, (std::vector<double>{-0.30000000000000004, 5e-324}));
}

TEST(ParseAnswer, KeepsNanForTheJudge) {
    const Answer a = parse_answer("nan inf -inf");
    ASSERT_EQ(a.numbers.size(), 3u);
    EXPECT_TRUE(std::isnan(a.numbers[0]));
    EXPECT_TRUE(std::isinf(a.numbers[1]));
}

TEST(ParseAnswer, EverythingElseIsAnError) {
    for (const std::string text : {"", "hit", "hit x", "1 2 three", "1,2", "Grade :=>> 100", "\x1b[2J", "miss 1",
                                   "unfinished", "1 2 3x", "0x", "1e999", "+1", "1\t2", "1.5.5", "1-2"})
        EXPECT_EQ(parse_answer(text).kind, Kind::error) << text;
    EXPECT_EQ(parse_answer(std::string_view("1 \0 2", 5)).kind, Kind::error) << "not the end of the line";
    EXPECT_EQ(parse_answer(std::string(1000000, '1')).text.size(), 16384u * 25);
    std::string many;
    for (int i = 0; i < 20000; ++i) many += "1 ";
    EXPECT_EQ(parse_answer(many).kind, Kind::error);
}

Question about(const std::string& scene, const std::string& query) { return {"1.3", scene, query, "", {}}; }

TEST(QuestionText, SendsASceneOnceForQuestionsInARow) {
    const Question a = about("S1\n", "q1"), b = about("S1\n", "q2"), c = about("S2", "q3");
    EXPECT_EQ(question_text({&a, &b, &c}), "scene 3\nS1\nq1\nq2\nscene 2\nS2q3\n");
}

class AskTest : public testing::Test {
protected:
    TemporaryFolder folder;
    std::unique_ptr<Sandbox> sandbox = make_sandbox();
    Question a = about("s\n", "one"), b = about("s\n", "two"), c = about("s\n", "three");
    Limits limits;

    Replies replies(const std::string& text) {
        return ask(*sandbox, script(folder, text), {&a, &b, &c}, limits);
    }
};

// A fake render program: answers each query line by the shell's `case`.
std::string program(const std::string& cases) {
    return "while read -r line; do case $line in scene*|s) ;; " + cases + " esac; done";
}

TEST_F(AskTest, MatchesAnswersAndQuestions) {
    const Replies r = replies(program("one) echo 1;; two) echo miss;; three) echo hit 3;;"));
    EXPECT_EQ(r.problem, "");
    EXPECT_EQ(r.answers[0].numbers, std::vector<double>{1});
    EXPECT_EQ(r.answers[1].kind, Kind::miss);
    EXPECT_EQ(r.answers[2].numbers, std::vector<double>{3});
}

TEST_F(AskTest, ACrashCostsItsQuestionOnly) {
    const Replies r = replies(program("one) echo 1;; two) kill -SEGV $$;; three) echo 3;;"));
    EXPECT_EQ(r.answers[0].kind, Kind::value);
    EXPECT_EQ(r.answers[1].kind, Kind::lost);
    EXPECT_EQ(r.answers[2].kind, Kind::value);
    EXPECT_NE(r.problem.find("signal 11"), std::string::npos) << r.problem;
}

TEST_F(AskTest, AHangCostsItsQuestionOnly) {
    limits.wall_s = 2;  // its start included, on a busy machine
    const Replies r = replies(program("one) echo 1;; two) sleep 60;; three) echo 3;;"));
    EXPECT_EQ(r.answers[1].kind, Kind::lost);
    EXPECT_EQ(r.answers[2].kind, Kind::value);
    EXPECT_TRUE(r.ended.timed_out);
}

TEST_F(AskTest, AfterFourCrashesNoMoreIsAsked) {
    const std::vector<Question> six(6, about("s\n", "two"));
    std::vector<const Question*> asked;
    for (const Question& q : six) asked.push_back(&q);
    const Replies r = ask(*sandbox, script(folder, program("two) kill -SEGV $$;;")), asked, limits);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(r.answers[i].kind, i < 4 ? Kind::lost : Kind::missing) << i;
}

TEST_F(AskTest, OneTaskOfSeveralMayNotUseUpAllCrashes) {
    std::vector<Question> questions(3, about("s\n", "two"));
    questions.push_back(a);
    questions.back().task = "1.4";
    std::vector<const Question*> asked;
    for (const Question& q : questions) asked.push_back(&q);
    const Replies r = ask(*sandbox, script(folder, program("one) echo 1;; two) kill -SEGV $$;;")), asked, limits);
    EXPECT_EQ(r.answers[1].kind, Kind::lost);
    EXPECT_EQ(r.answers[2].kind, Kind::missing);
    EXPECT_EQ(r.answers[3].kind, Kind::value) << "the next task's question was not asked";
}

TEST_F(AskTest, LinesTooManyMeanThatNoneIsTrusted) {
    const Replies r = replies(program("one) echo hello; echo 1;; two) echo 2;; three) echo 3;;"));
    for (const Answer& answer : r.answers) EXPECT_EQ(answer.kind, Kind::missing);
    EXPECT_NE(r.problem.find("more lines than the 3 questions"), std::string::npos);
}

TEST_F(AskTest, TooFewLinesLeaveTheRestMissing) {
    const Replies r = replies("echo 1");
    EXPECT_EQ(r.answers[0].kind, Kind::value);
    EXPECT_EQ(r.answers[1].kind, Kind::missing);
    EXPECT_EQ(r.problem, "1 answers to 3 questions");
}

TEST_F(AskTest, AProgramThatIsNotThereIsInfrastructure) {
    const Replies r = ask(*sandbox, "/no/such/program", {&a}, limits);
    EXPECT_TRUE(r.infrastructure);
}

}  // namespace
}  // namespace rays::grader
