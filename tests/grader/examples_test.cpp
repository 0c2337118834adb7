// Three submissions, from the working copy to the points: packed by `rays submission`, graded from the archive.
#include <gtest/gtest.h>

#include <algorithm>

#include "example_submissions.h"
#include "grader/grade.h"
#include "grader/grade_step.h"
#include "grader/submission/hand_in.h"
#include "grader/summary.h"
#include "schema_check.h"
#include "support/files.h"

namespace rays::grader {
namespace {

namespace fs = std::filesystem;

class ExamplesTest : public testing::Test {
protected:
    Project project = find_project();
    TemporaryFolder folder;

    HandInResult pack(const std::string& name) const {
        write_example(project, name, folder.path());
        const fs::path program = example_program(project, name, folder.path());
        return hand_in(project, {folder.path(), folder.path() / "submission", program}, archive());
    }

    Results grade_archive() const {
        GradeOptions options;
        options.submission = archive();
        options.out = folder.path() / "out";
        options.seed = 11;
        options.report = false;
        const Results results = grade(project, options);
        EXPECT_EQ(results.infrastructure_error, "");
        const auto schema = nlohmann::json::parse(read_file(project.root / "grader" / "results.schema.json"));
        EXPECT_EQ(schema_problems(nlohmann::json::parse(read_file(options.out / "results.json")), schema),
                  std::vector<std::string>{});
        return results;
    }

    fs::path archive() const { return folder.path() / "handed_in.tar.gz"; }
};

const RubricResult& row(const Results& results, const std::string& id) {
    const auto found =
        std::find_if(results.rubric.begin(), results.rubric.end(), [&](const RubricResult& r) { return r.id == id; });
    if (found == results.rubric.end()) throw std::runtime_error("no row " + id);
    return *found;
}

const Check& check_named(const std::vector<Check>& checks, const std::string& id) {
    const auto found = std::find_if(checks.begin(), checks.end(), [&](const Check& c) { return c.id == id; });
    if (found == checks.end()) throw std::runtime_error("no check " + id);
    return *found;
}

bool says(const Check& check, const std::string& words) { return check.message.find(words) != std::string::npos; }

std::vector<std::string> named_mistakes(const Results& results) {
    std::vector<std::string> names;
    for (const StepResult& step : results.steps)
        for (const Check& check : step.checks)
            for (const Diagnosis& d : check.diagnosis)
                if (d.kind == "mutant" && std::find(names.begin(), names.end(), d.mutant) == names.end())
                    names.push_back(d.mutant);
    std::sort(names.begin(), names.end());
    return names;
}

bool hinted(const Results& results, const std::string& task) {
    for (const StepResult& step : results.steps)
        for (const Check& check : step.checks)
            for (const Diagnosis& d : check.diagnosis)
                if (check.task == task && check.verdict != Verdict::pass && d.kind == "hint") return true;
    return false;
}

TEST_F(ExamplesTest, ThePerfectOneGetsAllPoints) {
    const HandInResult packed = pack("perfect");
    EXPECT_TRUE(is_complete(packed)) << hand_in_text(packed, archive());
    const Results r = grade_archive();
    for (const char* id : {"spheres", "polygons", "phong", "pictures", "reflection"})
        EXPECT_NEAR(row(r, id).points, 20, 1e-9) << id;
    EXPECT_NEAR(row(r, "report").points, 10, 1e-9) << summary(r, "out");
    EXPECT_NEAR(r.points, 110, 1e-9);
    EXPECT_NEAR(r.max, 110, 1e-9);
    EXPECT_NEAR(row(r, "refraction").points, 10, 1e-9);
    EXPECT_NEAR(row(r, "partitioning").points, 10, 1e-9);
    EXPECT_NEAR(row(r, "distributed").points, 10, 1e-9);
    EXPECT_NEAR(r.extra, 30, 1e-9) << "extra rows give 30 at most";
    for (const Check& c : r.handed_in->checks) EXPECT_EQ(c.verdict, Verdict::pass) << c.id << ": " << c.message;
    EXPECT_NE(r.handed_in->report.find("the octree's walk"), std::string::npos) << "the prose reaches the instructor";
}

TEST_F(ExamplesTest, TheHalfFinishedOneGetsWhatItShows) {
    EXPECT_FALSE(is_complete(pack("half_finished")));
    const Results r = grade_archive();
    // All tasks of the row are written, but some of its pictures hold other shapes that are not.
    EXPECT_GT(row(r, "spheres").points, 15);
    EXPECT_LT(row(r, "spheres").points, 20);
    EXPECT_NEAR(row(r, "phong").points, 20, 4);
    EXPECT_GT(row(r, "polygons").points, 5);
    EXPECT_LT(row(r, "polygons").points, 16);
    EXPECT_NEAR(row(r, "pictures").points, 10, 1e-9) << "spheres and Phong are shown";
    // Claims 2 of 4, commands 2 of 4, and 4 of 10 points of form.
    EXPECT_NEAR(row(r, "report").points, 2 + 2 + 0.8, 1e-9) << summary(r, "out");
    const auto& checks = r.handed_in->checks;
    EXPECT_EQ(check_named(checks, "handed_in.3.polygons").verdict, Verdict::not_started);
    EXPECT_TRUE(says(check_named(checks, "handed_in.3.polygons"), "waits for task 1.6"));
    EXPECT_EQ(check_named(checks, "pictures.recursive_reflection").verdict, Verdict::fail);
    EXPECT_TRUE(
        says(check_named(checks, "pictures.recursive_reflection"), "does not show it: 0 %, need at least 0.2 %"))
        << "one reflection deep is not three: " << check_named(checks, "pictures.recursive_reflection").message;
}

TEST_F(ExamplesTest, ThreeMistakesAreNamedAndCostTheirPoints) {
    pack("three_mistakes");
    const Results r = grade_archive();
    EXPECT_EQ(named_mistakes(r), (std::vector<std::string>{"M1.9", "M2.3", "M3.22"}));
    EXPECT_TRUE(hinted(r, "1.6") && hinted(r, "2.4") && hinted(r, "3.1"));
    EXPECT_NEAR(row(r, "spheres").points, 20, 1e-9);
    EXPECT_LT(row(r, "polygons").points, 18);
    EXPECT_LT(row(r, "phong").points, 18);
    EXPECT_LT(row(r, "reflection").points, 18);
    // A mirror direction that is wrong spoils every picture with a mirror, so little is left of that row.
    for (const char* id : {"polygons", "phong"}) EXPECT_GT(row(r, id).points, 6) << id;
    EXPECT_GT(row(r, "reflection").points, 2);
    EXPECT_NEAR(row(r, "partitioning").points, 10, 1e-9);
    EXPECT_NEAR(row(r, "pictures").points, 5, 1e-9) << "only the spheres are right";
    // Every command reproduces its picture, and the prose is fine; but one of four claims holds.
    EXPECT_NEAR(row(r, "report").points, 4 * 0.25 + 4 + 2, 1e-9) << summary(r, "out");
    for (const char* id : {"handed_in.2.polygons", "handed_in.3.highlights", "handed_in.4.lattice"}) {
        const Check& check = check_named(r.handed_in->checks, id);
        EXPECT_EQ(check.verdict, Verdict::fail);
        EXPECT_TRUE(says(check, "differ from the solution's picture")) << check.message;
        EXPECT_FALSE(check.diagnosis.empty()) << id << " is not explained";
    }
}

}  // namespace
}  // namespace rays::grader
