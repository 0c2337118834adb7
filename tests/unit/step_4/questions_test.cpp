// What the grader asks about step 4: the solution answers everything, for any seed, and every sweep within its stated
// range; nonsense is never right.
#include <map>

#include "../questions_in_process.h"

namespace rays::tests {
namespace {

class OfSeed : public testing::TestWithParam<int> {};

TEST_P(OfSeed, TheSolutionAnswersEveryQuestion) {
    expect_all_right(grader::questions_4_partitioning(static_cast<std::uint64_t>(GetParam())), "seed");
}

INSTANTIATE_TEST_SUITE_P(Questions, OfSeed, testing::Range(1, 6));

TEST(Questions, AtLeast24ATask) {
    std::map<std::string, int> count;
    for (const grader::Question& q : grader::questions_4_partitioning(7)) ++count[q.task];
    EXPECT_EQ(count.size(), 9u);
    for (const auto& [task, n] : count) EXPECT_GE(n, 24) << task;
}

TEST(Questions, AnotherSeedAsksOtherQuestions) {
    const auto one = grader::questions_4_partitioning(1), again = grader::questions_4_partitioning(1),
               other = grader::questions_4_partitioning(2);
    ASSERT_EQ(one.size(), again.size());
    std::size_t same = 0;
    for (std::size_t i = 0; i < one.size(); ++i) {
        EXPECT_TRUE(one[i].query == again[i].query && one[i].scene == again[i].scene);
        same += i < other.size() && one[i].query == other[i].query && one[i].scene == other[i].scene;
    }
    EXPECT_LT(same, one.size() / 5) << "of " << one.size();
}

TEST(Questions, EmptyAndHostileAnswersAreWrong) {
    for (const char* line : {"", "nan nan nan", "inf inf", "1e400 0 0", "0 0 0 0 0 0 0 0 0", "hello", "300 300 300", "-1"})
        for (const grader::Question& q : grader::questions_4_partitioning(3))
            EXPECT_FALSE(q.judge(parsed(line)).ok) << q.query << " accepted '" << line << "'";
}

TEST(Sweeps, TheSolutionHoldsWithinTheStatedRange) {
    for (const grader::Sweep& sweep : grader::sweeps_4_partitioning(5)) {
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
