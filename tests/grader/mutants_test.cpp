#include "grader/mutants.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "grader/fingerprints.h"
#include "grader/grade_step.h"
#include "grader/project.h"
#include "tools.h"

namespace rays::grader {
namespace {

constexpr const char* kGood = R"(# a comment
id: M1.3
task: 1.3
title: only the smaller root is returned
seen: inside a sphere nothing is seen
file: solutions/1_ray_casting/quadrics.cpp
<<<<
    return a;
# not a comment
====
    return b;
>>>>
<<<<
two
====
>>>>

# between blocks
id: V1
kind: variant
task: 1.3
title: other
file: solutions/1_ray_casting/quadrics.cpp
<<<<
x
====
y
>>>>
)";

std::string error_of(const std::string& text) {
    try {
        parse_mutants(text, "file.txt");
    } catch (const InputError& e) {
        return e.what();
    }
    return "no error";
}

TEST(ParseMutants, ReadsBlocks) {
    const auto list = parse_mutants(kGood, "file.txt");
    ASSERT_EQ(list.size(), 2u);
    EXPECT_EQ(list[0].id, "M1.3");
    EXPECT_EQ(list[0].kind, Mutant::Kind::mutant);
    EXPECT_EQ(list[0].file, "1_ray_casting/quadrics.cpp");
    ASSERT_EQ(list[0].hunks.size(), 2u);
    EXPECT_EQ(list[0].hunks[0].before, "    return a;\n# not a comment");
    EXPECT_EQ(list[0].hunks[1].after, "");
    EXPECT_EQ(list[1].kind, Mutant::Kind::variant);
}

TEST(ParseMutants, NamesTheLineOfAMistake) {
    EXPECT_EQ(error_of("task: 1.3\n"), "file.txt:1: expected 'id: ...', found: task: 1.3");
    EXPECT_EQ(error_of("id: A\ncolour: red\n"), "file.txt:2: unknown field: colour: red");
    EXPECT_EQ(error_of("id: A\n<<<<\nx\n====\ny\n"), "file.txt:5: no line >>>> before the end of the file");
    EXPECT_EQ(error_of("id: A\n<<<<\n====\ny\n>>>>\n"), "file.txt:5: nothing between <<<< and ====");
    EXPECT_EQ(error_of("id: A\ntask: 1.1\ntitle: t\nfile: solutions/x.cpp\n"), "file.txt:1: A has no <<<<");
    EXPECT_EQ(error_of("id: A\nkind: monster\n"), "file.txt:2: kind: monster: need mutant, variant or naive");
    EXPECT_EQ(error_of("id: A\nfile: steps/x.cpp\n"), "file.txt:2: unknown field: file: steps/x.cpp");
}

TEST(ApplyMutant, WantsEveryHunkExactlyOnce) {
    const auto m = parse_mutants(kGood, "file.txt")[0];
    EXPECT_EQ(apply(m, "1\n    return a;\n# not a comment\n2 two 3"), "1\n    return b;\n2  3");
    EXPECT_THROW(apply(m, "    return a;\n# not a comment\n"), InputError);
    EXPECT_THROW(apply(m, "    return a;\n# not a comment\n two two"), InputError);
}

TEST(CommittedMutants, ApplyToTheSolutions) {
    const Project project = find_project();
    const auto steps = read_steps(project.steps());
    for (const Mutant& m : read_mutants(project.mutants())) {
        EXPECT_NO_THROW(apply(m, read_file(project.root / "solutions" / m.file))) << m.id;
        const int number = std::atoi(m.task.c_str());
        for (const Step& step : steps) {
            if (step.number != number) continue;
            EXPECT_NE(step.find(m.task), nullptr) << m.id << " is about the unknown task " << m.task;
        }
    }
}

TEST(CommittedSteps, FreshScenesOfAStructuresWalkAreRenderedWithIt) {
    for (const Step& step : read_steps(find_project().steps())) {
        if (step.number != 4) continue;
        EXPECT_EQ(step.find("4.4")->partition, "grid");
        EXPECT_EQ(step.find("4.7")->partition, "octree");
        EXPECT_EQ(step.find("4.1")->partition, "") << "as the program chooses";
    }
}

TEST(CommittedFingerprints, BelongToTodaysQuestionsAndMutants) {
    const Project project = find_project();
    const Fingerprints known = read_fingerprints(project.mutants() / "fingerprints.json");
    std::map<int, std::vector<std::string>> ids;
    for (const Mutant& m : read_mutants(project.mutants()))
        if (m.kind == Mutant::Kind::mutant) ids[std::atoi(m.task.c_str())].push_back(m.id);
    for (const Step& step : read_steps(project.steps())) {
        ASSERT_TRUE(known.steps.count(step.number)) << "run rays mutants --update";
        const StepFingerprints& k = known.steps.at(step.number);
        EXPECT_EQ(k.questions, questions_hash(diagnostic_questions(step.number, task_ids(step))))
            << "run rays mutants " << step.number << " --update";
        std::vector<std::string> have;
        for (const KnownMutant& m : k.mutants) have.push_back(m.id);
        EXPECT_EQ(have, ids[step.number]) << "run rays mutants " << step.number << " --update";
    }
}

}  // namespace
}  // namespace rays::grader
