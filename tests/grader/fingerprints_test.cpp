#include "grader/fingerprints.h"

#include <gtest/gtest.h>

#include "grader/answers.h"
#include "tools.h"

namespace rays::grader {
namespace {

std::vector<Answer> answers(const std::vector<std::string>& lines) {
    std::vector<Answer> list;
    for (const auto& line : lines) list.push_back(parse_answer(line));
    return list;
}

const std::vector<std::string> kSolution{"hit 1", "hit 2", "miss", "0.5 0.5 0.5", "hit 7", "1"};

Fingerprint of(const std::vector<std::string>& lines) { return fingerprint(answers(lines), answers(kSolution)); }

KnownMutant known(const std::string& id, const Fingerprint& fingerprint) { return {id, "1.3", id, "", fingerprint}; }

TEST(Fingerprint, IsWhatDiffersBeyondRounding) {
    EXPECT_TRUE(of(kSolution).empty());
    EXPECT_TRUE(of({"hit 1.00001", "hit 2", "miss", "0.5 0.5 0.5", "hit 7", "1"}).empty())
        << "single precision is no mistake";
    const Fingerprint f = of({"hit -1", "hit 2", "hit 5", "nan 0.5 0.5", "hit 7", "1"});
    EXPECT_EQ(f, (Fingerprint{{0, "-1"}, {2, "5"}, {3, "nan 0.5 0.5"}}));
}

TEST(Fingerprint, LeavesOutWhatIsUnfinishedOrWasNotAskedFor) {
    auto list = answers({"unfinished 1.3", "hit 2", "miss", "0.5 0.5 0.5", "hit 7", "1"});
    list.back() = Answer{};
    EXPECT_TRUE(fingerprint(list, answers(kSolution)).empty());
}

TEST(Fingerprint, TakesDownCrashesAndFailuresAlike) {
    auto list = answers({"error out of memory", "hit 2", "miss", "0.5 0.5 0.5", "hit 7", "1"});
    list.back().kind = Answer::Kind::lost;
    EXPECT_EQ(fingerprint(list, answers(kSolution)), (Fingerprint{{0, "none"}, {5, "none"}}));
}

TEST(NearestMutant, NamesTheOneThatHangsWhereTheStudentCrashes) {
    const auto hanging = [](std::size_t question) {
        auto list = answers(kSolution);
        list[question].kind = Answer::Kind::lost;
        return fingerprint(list, answers(kSolution));
    };
    const auto a = known("A", hanging(1)), b = known("B", hanging(4));
    const Fingerprint student = of({"hit 1", "error no memory", "miss", "0.5 0.5 0.5", "hit 7", "1"});
    ASSERT_TRUE(nearest_mutant(student, {a, b}));
    EXPECT_EQ(nearest_mutant(student, {a, b})->id, "A");
    EXPECT_FALSE(nearest_mutant(of({"hit 1", "hit 3", "miss", "0.5 0.5 0.5", "hit 7", "1"}), {a, b}))
        << "a wrong answer is not the one that never came";
}

TEST(NearestMutant, NamesTheOneThatExplains) {
    const auto a = known("A", of({"hit -1", "hit -2", "miss", "0.5 0.5 0.5", "hit 7", "1"}));
    const auto b = known("B", of({"hit 1", "hit 2", "hit 9", "0.5 0.5 0.5", "miss", "1"}));
    const Fingerprint student = of({"hit -1.00001", "hit -2", "miss", "0.5 0.5 0.5", "hit 7", "1"});
    ASSERT_TRUE(nearest_mutant(student, {a, b}));
    EXPECT_EQ(nearest_mutant(student, {a, b})->id, "A");
}

TEST(NearestMutant, RecognisesNan) {
    const auto a = known("A", of({"hit nan", "hit 2", "miss", "0.5 0.5 0.5", "hit 7", "1"}));
    EXPECT_TRUE(nearest_mutant(of({"hit nan", "hit 2", "miss", "0.5 0.5 0.5", "hit 7", "1"}), {a}));
}

TEST(NearestMutant, NamesAMistakeInHalfFinishedWork) {
    const auto a = known("A", of({"hit -1", "hit -2", "hit 3", "0 0 0", "miss", "0"}));
    const auto b = known("B", of({"hit 1", "hit 2", "miss", "0 0 0", "miss", "0"}));
    const std::vector<std::string> half{"hit -1",         "hit -2",         "unfinished 1.5",
                                        "unfinished 1.5", "unfinished 1.5", "unfinished 1.5"};
    const auto unfinished = unfinished_questions(answers(half));
    EXPECT_EQ(unfinished, (std::set<int>{2, 3, 4, 5}));
    ASSERT_TRUE(nearest_mutant(of(half), {a, b}, unfinished));
    EXPECT_EQ(nearest_mutant(of(half), {a, b}, unfinished)->id, "A");
    const std::vector<std::string> right{"hit 1", "hit 2", "unfinished 1.5", "unfinished 1.5", "unfinished 1.5", "1"};
    EXPECT_FALSE(nearest_mutant(of(right), {a, b}, unfinished_questions(answers(right))));
}

TEST(NearestMutant, IsSilentWhenTwoFit) {
    const Fingerprint f = of({"hit -1", "hit 2", "miss", "0.5 0.5 0.5", "hit 7", "1"});
    EXPECT_FALSE(nearest_mutant(f, {known("A", f), known("B", f)}));
}

TEST(NearestMutant, IsSilentWhenNothingFits) {
    const auto a = known("A", of({"hit -1", "hit -2", "miss", "0.5 0.5 0.5", "hit 7", "1"}));
    EXPECT_FALSE(nearest_mutant(of({"hit 5", "hit 6", "miss", "0.5 0.5 0.5", "hit 7", "1"}), {a}))
        << "wrong in the same places, but otherwise";
    EXPECT_FALSE(nearest_mutant(of({"hit -1", "hit 2", "miss", "0.5 0.5 0.5", "hit 7", "1"}), {a}))
        << "half of the mutant's mistakes are missing";
    EXPECT_FALSE(nearest_mutant({}, {a}));
    EXPECT_FALSE(nearest_mutant({}, {known("none", {})})) << "a mutant without a difference explains nothing";
}

TEST(Fingerprints, SurviveTheirFile) {
    Fingerprints all;
    all.steps[1].questions = "abc";
    all.steps[1].mutants = {known("A", {{3, "miss"}, {12, "1 2 3"}})};
    all.steps[1].naive["1.3.distance"] = {{"textbook", "naive", {{1, 1e-16}, {10, std::nullopt}}}};
    const TemporaryFolder folder;
    const auto file = folder.path() / "fingerprints.json";
    write_fingerprints(all, file);
    const Fingerprints read = read_fingerprints(file);
    EXPECT_EQ(read.steps.at(1).questions, "abc");
    EXPECT_EQ(read.steps.at(1).mutants.at(0).fingerprint, all.steps[1].mutants[0].fingerprint);
    EXPECT_EQ(read.steps.at(1).naive.at("1.3.distance").at(0).points, all.steps[1].naive["1.3.distance"][0].points);
    EXPECT_TRUE(read_fingerprints(folder.path() / "none.json").steps.empty());
}

TEST(DiagnosticQuestions, AreTheSameEveryTime) {
    const auto once = diagnostic_questions(2, {"2.1", "2.10"}), again = diagnostic_questions(2, {"2.1", "2.10"});
    EXPECT_EQ(questions_hash(once), questions_hash(again));
    EXPECT_GT(once.size(), 100u);
    EXPECT_NE(questions_hash(once), questions_hash(diagnostic_questions(2, {"2.1"})));
}

TEST(QuestionsHash, LastBitsAreNoOtherQuestion) {
    const auto hash = [](const std::string& scene, const std::string& query) {
        return questions_hash({{"1.3", scene, query, "", {}}});
    };
    const std::string one = hash("sphere { <1, -.5, 0>, 2 }", "root 0 0.30000000000000004 1e-17 -3");
    EXPECT_EQ(one, hash("sphere { <1, -.5, 0>, 2 }", "root 0 0.3 0 -3"));
    EXPECT_NE(one, hash("sphere { <1, -.5, 0>, 2 }", "root 0 0.3001 0 -3"));
    EXPECT_NE(one, hash("sphere { <1, .5, 0>, 2 }", "root 0 0.3 0 -3"));
    EXPECT_NE(one, hash("sphere { <1, -.5, 0>, 2 }", "root 1 0.3 0 -3"));
}

}  // namespace
}  // namespace rays::grader
