#include "grader/results.h"

#include <gtest/gtest.h>

#include <cmath>

#include "grader/project.h"
#include "grader/summary.h"
#include "schema_check.h"
#include "tools.h"

namespace rays::grader {
namespace {

using nlohmann::json;

// Every optional part is there, hostile text and numbers that JSON does not have as well.
Results full() {
    Results r;
    r.created = "2026-01-31T12:00:00Z";
    r.submission_name = "x";
    r.submission_from = "submission";
    r.real = "double";
    r.sandbox_tier = "limits";
    r.complete = true;
    r.rubric = {{"spheres", "Spheres", 20, 20, false, true, ""},
                {"report", "Report", 0, 10, false, false, "not graded yet"}};
    Check c;
    c.id = "1.3.unit";
    c.task = "1.3";
    c.kind = "unit";
    c.points = 7 - 1e-12;
    c.max = 7;
    c.message = "\x1b[31m\"quoted\" \xff\xfe";
    c.diagnosis = {{"mutant", "like M1.3", "M1.3"}, {"hint", "h", {}}};
    c.questions = {{"about", "root", "sphere", "hit 1", "</script>", false}};
    c.chart =
        Chart{"t", "x", "y", true, true, 1, 10, {{"student", "student", {{1, 1e-16}, {10, std::nullopt}, {100, NAN}}}}};
    c.image.emplace();
    c.image->max_error = INFINITY;
    c.image->worst_student = {NAN, 1, INFINITY};
    c.image->student = "images/x.exr";
    c.image->trees = RayTrees{"a", "b", "c"};
    StepResult s{"1_ray_casting",
                 "Ray casting",
                 1,
                 Verdict::partial,
                 7,
                 8,
                 {{"1.3", "Sphere", Verdict::not_started, 0, 8, "hint", "f", 3}},
                 {c}};
    CostScene costs{"4_partitioning/x.pov", 160, 120, 3, 4, {1, 2, 3}, {0, 0, 1}, 7.5, {}};
    costs.maps = {{"grid", "student", Verdict::not_started, "waits for task 4.3"},
                  {"grid", "solution", Verdict::pass, "", "images/m.exr", {1.5, 9}, {2, 8}, {{0, 0, 0, 1, 1, 1}}, 3}};
    s.cost_maps = {costs};
    r.steps = {s};
    return r;
}

json schema() { return json::parse(read_file(find_project().root / "grader" / "results.schema.json")); }

TEST(ResultsJson, FollowsTheSchema) {
    EXPECT_EQ(schema_problems(json::parse(to_json(full())), schema()), std::vector<std::string>{});
    Results empty;
    empty.submission_from = "student";
    empty.real = "double";
    EXPECT_EQ(schema_problems(json::parse(to_json(empty)), schema()), std::vector<std::string>{})
        << "a partial result is valid, too";
}

TEST(ResultsJson, TheSchemaIsStrict) {
    json j = json::parse(to_json(full()));
    j["steps"][0]["verdict"] = "great";
    j["steps"][0]["checks"][0]["surprise"] = 1;
    j["score"]["points"] = -1;
    j.erase("seed");
    EXPECT_EQ(schema_problems(j, schema()).size(), 4u);
    j = json::parse(to_json(full()));
    json& costs = j["steps"][0]["cost_maps"][0];
    costs["maps"][0]["structure"] = "a list";
    costs["maps"][1]["cells"][0].push_back(1);
    costs["maps"][1]["nodes"]["mean"] = -1;
    costs["ray"].erase("direction");
    EXPECT_EQ(schema_problems(j, schema()).size(), 4u);
}

TEST(ResultsJson, RoundsPointsAndKeepsVerdicts) {
    const json j = json::parse(to_json(full()));
    EXPECT_EQ(j["steps"][0]["checks"][0]["points"], 7);
    EXPECT_EQ(j["steps"][0]["tasks"][0]["verdict"], "not started");
    EXPECT_TRUE(j["steps"][0]["checks"][0]["image"]["worst"]["student"][0].is_null());
    EXPECT_TRUE(j["steps"][0]["checks"][0]["chart"]["series"][0]["points"][1][1].is_null());
}

TEST(ResultsJson, CostMapsHaveNumbersOnlyWhereThereIsAFile) {
    const json costs = json::parse(to_json(full()))["steps"][0]["cost_maps"][0];
    EXPECT_EQ(costs["ray"]["distance"], 7.5);
    EXPECT_EQ(costs["maps"][0], (json{{"structure", "grid"},
                                      {"whose", "student"},
                                      {"verdict", "not started"},
                                      {"message", "waits for task 4.3"}}));
    EXPECT_EQ(costs["maps"][1]["tests"], (json{{"mean", 1.5}, {"max", 9}}));
    EXPECT_EQ(costs["maps"][1]["cells"][0].size(), 6u);
    EXPECT_EQ(costs["maps"][1]["cells_left_out"], 3);
    Results none = full();
    none.steps[0].cost_maps.clear();
    EXPECT_FALSE(json::parse(to_json(none))["steps"][0].contains("cost_maps")) << "optional";
}

TEST(ResultsJson, IsReadBack) {
    const TemporaryFolder folder;
    write_results(full(), folder.path() / "results.json");
    const Results r = read_results(folder.path() / "results.json");
    EXPECT_EQ(r.steps.at(0).checks.at(0).diagnosis.at(0).mutant, "M1.3");
    EXPECT_EQ(r.steps.at(0).tasks.at(0).verdict, Verdict::not_started);
    EXPECT_EQ(r.rubric.at(1).graded, false);
}

TEST(ResultsJson, AnInfrastructureErrorIsNoGrade) {
    Results r = full();
    r.infrastructure_error = "disk full";
    EXPECT_EQ(json::parse(to_json(r))["status"], "infrastructure error");
    EXPECT_NE(summary(r, "out").find("this is no grade: disk full"), std::string::npos);
}

TEST(Summary, IsPlainText) {
    for (const char c : summary(full(), "out")) EXPECT_TRUE(c == '\n' || (c >= 0x20 && c < 0x7f)) << int(c);
    EXPECT_NE(summary(full(), "out").find("out/images/x.exr"), std::string::npos);
}

TEST(Summary, SaysWhatTheRestOfAHalfRightTaskWaitsFor) {
    Results r = full();
    StepResult& step = r.steps.at(0);
    step.tasks.at(0).verdict = Verdict::partial;
    step.checks.push_back(new_check("1.3.fresh", step.tasks.at(0).id, "fresh", "Sphere: fresh scenes", 2));
    step.checks.back().verdict = Verdict::not_started;
    step.checks.back().message = "the picture waits for task 1.15";
    EXPECT_NE(summary(r, "out").find("1.3.fresh [fresh] not started: the picture waits for task 1.15"),
              std::string::npos);
    step.tasks.at(0).verdict = Verdict::not_started;
    EXPECT_EQ(summary(r, "out").find("the picture waits"), std::string::npos) << "else only their number is told";
}

TEST(Summary, SaysThatExactnessIsDoubles) {
    Results r = full();
    r.real = "float";
    EXPECT_NE(summary(r, "out").find("promised for double only"), std::string::npos);
    r.real = "double";
    EXPECT_EQ(summary(r, "out").find("promised"), std::string::npos);
}

}  // namespace
}  // namespace rays::grader
