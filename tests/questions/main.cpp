// The grader's questions on the student's desk: the same ones as `rays grade` asks, as tests of this process, so that a
// debugger stops at the mistake. A test has the id of the grader's check: 1.3.unit, 1.3.distance.
//
//     questions-1 --gtest_filter='1.3.*' --seed 123
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <string_view>

#include "asked.h"
#include "grader/course.h"

namespace rays::tests {
namespace {

using grader::Answer;
using grader::Question;

constexpr int kShownWrong = 3;

class Check : public testing::Test {
public:
    explicit Check(std::vector<Question> questions) : questions_(std::move(questions)) {}

    void TestBody() override {
        const std::vector<Answer> answers = asked(questions_);
        std::size_t wrong = 0, unfinished = 0;
        std::string shown;
        for (std::size_t i = 0; i < questions_.size(); ++i) {
            const Question& q = questions_[i];
            const auto judgement = q.judge(answers[i]);
            unfinished += answers[i].kind == Answer::Kind::unfinished;
            if (judgement.ok || wrong++ >= kShownWrong) continue;
            shown += fmt::format("\n{}\n{}{}\nexpected {}\ngot      {}\n", q.about, q.scene, q.query,
                                 judgement.expected, answers[i].text);
        }
        if (unfinished == questions_.size()) GTEST_SKIP() << "not started: " << answers.at(0).text;
        EXPECT_EQ(wrong, 0u) << "of " << questions_.size() << " questions; the first:" << shown;
    }

private:
    std::vector<Question> questions_;
};

void add(const std::string& suite, const std::string& name, std::vector<Question> questions) {
    testing::RegisterTest(suite.c_str(), name.c_str(), nullptr, nullptr, __FILE__, __LINE__,
                          [questions = std::move(questions)]() -> Check* { return new Check(questions); });
}

void add_step(int step, std::uint64_t seed) {
    std::vector<std::string> tasks;  // in their order
    std::map<std::string, std::vector<Question>> of_task;
    for (Question& q : grader::questions_of(step, seed)) {
        if (!of_task.count(q.task)) tasks.push_back(q.task);
        of_task[q.task].push_back(std::move(q));
    }
    const auto sweeps = grader::sweeps_of(step, seed);
    for (const std::string& task : tasks) {
        add(task, "unit", of_task[task]);
        for (const auto& sweep : sweeps) {
            if (sweep.task != task) continue;
            std::vector<Question> graded;
            for (const auto& point : sweep.points)
                if (point.x >= sweep.pass_from && point.x <= sweep.pass_to)
                    graded.insert(graded.end(), point.questions.begin(), point.questions.end());
            add(task, sweep.id.substr(task.size() + 1), std::move(graded));
        }
    }
}

/// The value of --seed, 1 without; gtest has taken its own arguments out.
std::uint64_t seed_of(int argc, char** argv) {
    for (int i = 1; i + 1 < argc; ++i)
        if (std::string_view(argv[i]) == "--seed") return std::strtoull(argv[i + 1], nullptr, 10);
    return 1;
}

}  // namespace
}  // namespace rays::tests

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    for (const int step : {QUESTIONS_OF_STEPS}) rays::tests::add_step(step, rays::tests::seed_of(argc, argv));
    return RUN_ALL_TESTS();
}
