// Whole submissions: built, run and graded as a student's are. Good ones, untouched ones, broken ones, mistaken ones.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "grader/mutants.h"
#include "submission_fixture.h"

namespace rays::grader {
namespace {

TEST_F(SubmissionsTest, TheSolutionGetsFullMarks) {
    GradeOptions options;
    options.from = "solution";
    options.out = out();
    const Results r = grade(project, options);
    EXPECT_EQ(r.infrastructure_error, "");
    ASSERT_FALSE(r.steps.empty());
    expect_small_page(r.steps.size());
    for (const StepResult& step : r.steps) {
        EXPECT_NEAR(step.points, step.max, 1e-9) << step.id;
        for (const Check& c : step.checks) EXPECT_EQ(c.verdict, Verdict::pass) << c.id << ": " << c.message;
    }
    EXPECT_EQ(r.points, r.max);
    const auto mapped =
        std::find_if(r.steps.begin(), r.steps.end(), [](const StepResult& s) { return !s.cost_maps.empty(); });
    ASSERT_NE(mapped, r.steps.end());
    for (const CostScene& scene : mapped->cost_maps) {
        EXPECT_NE(scene.direction, (std::array<double, 3>{})) << scene.scene;
        for (const CostMap& map : scene.maps) {
            EXPECT_EQ(map.verdict, Verdict::pass) << map.structure << ": " << map.message;
            EXPECT_TRUE(std::filesystem::exists(out() / map.file)) << map.file;
            EXPECT_GT(map.tests.max, 0) << map.file;
            EXPECT_EQ(map.nodes.max > 0, map.structure != "none") << map.file;
            // All structures of the solution say which cells or leaves a ray visits.
            EXPECT_EQ(!map.cells.empty(), map.structure != "none") << map.file;
        }
    }
}

TEST_F(SubmissionsTest, AnUntouchedStarterIsNotStartedOnEveryTask) {
    const Results r = run({}, true);
    expect_small_page(r.steps.size());
    for (const StepResult& step : r.steps) {
        EXPECT_EQ(step.verdict, Verdict::not_started) << step.id;
        EXPECT_EQ(step.points, 0);
        for (const TaskResult& t : step.tasks) {
            EXPECT_EQ(t.verdict, Verdict::not_started) << t.id;
            EXPECT_GT(t.line, 0) << t.id << ": where to write";
        }
        for (const Check& c : step.checks) EXPECT_EQ(c.verdict, Verdict::not_started) << c.id << ": " << c.message;
        for (const CostScene& scene : step.cost_maps)
            for (const CostMap& map : scene.maps)
                EXPECT_EQ(map.verdict,
                          map.whose == "student" && map.structure != "none" ? Verdict::not_started : Verdict::pass)
                    << scene.scene << ", " << map.whose << "'s " << map.structure << ": " << map.message;
    }
}

TEST_F(SubmissionsTest, WithChartsTheStudentIsTimed) {
    put(kFile, solution_with("volatile double x = 0; for (int i = 0; i < 20; ++i) x = x + i;"));
    write_atomically(folder.path() / "charts.json", "{}");
    const Results r = run({kStep}, false, folder.path() / "charts.json");
    EXPECT_TRUE(std::filesystem::exists(out() / "charts.json"));
    const auto& points = r.steps.at(0).speed;
    ASSERT_FALSE(points.empty());
    for (const SpeedPoint& p : points) {
        EXPECT_EQ(p.verdict, Verdict::pass) << p.label << ": " << p.message;
        EXPECT_TRUE(0 < p.low && p.low <= p.median && p.median <= p.high) << p.label;
    }
    EXPECT_TRUE(run().steps.at(0).speed.size() == points.size()) << "the charts are there now";
    std::filesystem::remove(out() / "charts.json");
    EXPECT_TRUE(run().steps.at(0).speed.empty()) << "without charts nobody is timed";
}

TEST_F(SubmissionsTest, AFlatFolderIsASubmission) {
    put("phong.cpp", solution());
    const Results r = run();
    EXPECT_EQ(r.steps.at(0).verdict, Verdict::pass);
    EXPECT_EQ(r.submission_from, "submission");
}

TEST_F(SubmissionsTest, ASyntaxErrorIsABuildError) {
    put(kFile, "this is no C++\n");
    const Results r = run();
    const StepResult& step = r.steps.at(0);
    EXPECT_EQ(step.verdict, Verdict::build_error);
    EXPECT_EQ(step.points, 0);
    for (const Check& c : step.checks) EXPECT_EQ(c.verdict, Verdict::build_error);
    EXPECT_NE(step.checks.at(0).message.find("steps/2_phong/phong.cpp:1"), std::string::npos)
        << step.checks.at(0).message;
}

TEST_F(SubmissionsTest, TheCompilersQuotationMarksArrive) {
    ::setenv("LC_ALL", "C.UTF-8", 1);
    put(kFile, "#include \"2_phong/phong.h\"\nint x = rays::Surface().centre;\n");
    const StepResult step = run().steps.at(0);
    ::unsetenv("LC_ALL");
    EXPECT_NE(step.checks.at(0).message.find("has no member named 'centre'"), std::string::npos)
        << step.checks.at(0).message;
    for (const TaskResult& t : step.tasks) EXPECT_EQ(t.hint, "") << "the compiler has said what is wrong";
    for (const Check& c : step.checks) EXPECT_TRUE(c.diagnosis.empty());
}

TEST_F(SubmissionsTest, AMissingFunctionIsABuildError) {
    put(kFile, "namespace rays {}\n");
    EXPECT_EQ(run().steps.at(0).verdict, Verdict::build_error);
}

TEST_F(SubmissionsTest, ACrashIsACrash) {
    put(kFile, solution_with("    std::abort();"));
    const StepResult step = run().steps.at(0);
    EXPECT_TRUE(has(verdicts(step, "image"), Verdict::crash));
    EXPECT_TRUE(has(verdicts(step, "unit"), Verdict::crash));
    EXPECT_TRUE(has(verdicts(step, "unit"), Verdict::pass)) << "tasks that do not need it are not punished";
    for (const Check& c : step.checks)
        if (c.verdict == Verdict::crash) {
            EXPECT_NE(c.message.find("build with the debug preset"), std::string::npos) << c.id << ": " << c.message;
        }
}

// Nothing of 2.7 is written, and its fresh scenes come upon the crash of 2.8.
TEST_F(SubmissionsTest, AnUnwrittenTaskDoesNotCrash) {
    put(kFile,
        replaced(
            solution_with("    std::abort();"), "Real cone_of_light(const Light& light, const Vec3& point) {",
            "Real cone_of_light(const Light& light, const Vec3& point) {\n    if (light.kind != "
            "Light::Kind::point || point.x == point.x) {\n        unfinished(\"2.7\");\n        return {};\n    }"));
    const StepResult step = run().steps.at(0);
    int seen = 0;
    for (const Check& c : step.checks)
        if (c.task == "2.7" && c.kind != "image") {
            EXPECT_EQ(c.verdict, Verdict::not_started) << c.id << ": " << c.message;
            seen += c.kind == "fresh";
        }
    EXPECT_EQ(seen, 1);
    for (const TaskResult& t : step.tasks)
        if (t.id == "2.7") {
            EXPECT_EQ(t.verdict, Verdict::not_started);
        }
}

TEST_F(SubmissionsTest, AKnownMistakeIsNamedAndExplained) {
    for (const Mutant& m : read_mutants(project.mutants()))
        if (m.id == "M2.3") put(kFile, apply(m, solution()));
    const StepResult step = run().steps.at(0);
    EXPECT_EQ(step.verdict, Verdict::partial);
    std::string named;
    bool tree = false;
    for (const Check& c : step.checks) {
        for (const Diagnosis& d : c.diagnosis) {
            if (d.kind == "mutant") named = d.mutant;
            tree = tree || d.kind == "tree";
        }
    }
    EXPECT_EQ(named, "M2.3");
    EXPECT_TRUE(tree);
    for (const Check& c : step.checks) {
        if (c.kind != "image" || c.verdict != Verdict::fail) continue;
        const std::string view = fmt::format("--width {} --height {} --from {} --partition none", c.image->width,
                                             c.image->height, c.mode == "isolated" ? "student-2" : "student");
        EXPECT_EQ(c.reproduce, fmt::format("./rays render scenes/{0} -o picture.png {3}\n"
                                           "./rays explain scenes/{0} --pixel {1},{2} {3}",
                                           c.image->scene, c.image->worst_x, c.image->worst_y, view));
    }
    EXPECT_GT(step.points, 0);
    EXPECT_LT(step.points, step.max);
}

/// What the grader says must hold: no mistake is named that was not made.
void expect_caught(const StepResult& step, const std::vector<std::string>& caught, const std::string& made) {
    std::vector<std::string> failed;
    for (const Check& c : step.checks) {
        if (c.kind == "unit" && c.verdict != Verdict::pass) failed.push_back(c.id);
        for (const Diagnosis& d : c.diagnosis) {
            if (d.kind != "mutant") continue;
            EXPECT_EQ(d.mutant, made) << c.id << ": " << d.text;
        }
    }
    EXPECT_EQ(failed, caught);
}

// Most of what this mistake would spoil is not written yet.
TEST_F(SubmissionsTest, AKnownMistakeIsNamedInHalfFinishedWork) {
    std::string text = solution_with("    unfinished(\"2.8\");\n    return {};");
    text = replaced(
        text,
        "Radiance direct_light(const Scene& scene, std::span<const Light> lights, const Visibility& visibility,\n      "
        "                const Surface& surface) {",
        "Radiance direct_light(const Scene&, std::span<const Light>, const Visibility&, const Surface&) {\n    "
        "unfinished(\"2.10\");\n"
        "    return {};\n}\n\n[[maybe_unused]] static Radiance later(const Scene& scene, std::span<const Light> "
        "lights, const Visibility& visibility, const Surface& surface) {");
    for (const Mutant& m : read_mutants(project.mutants()))
        if (m.id == "M2.3") text = apply(m, text);
    put(kFile, text);
    std::string named;
    const StepResult step = run().steps.at(0);
    for (const Check& c : step.checks)
        for (const Diagnosis& d : c.diagnosis)
            if (d.kind == "mutant") named = d.mutant;
    EXPECT_EQ(named, "M2.3");
}

// Light falls off with the root of the cosine: wrong, and none of the list.
TEST_F(SubmissionsTest, AnUnknownMistakeIsCaughtAndNotGivenAWrongName) {
    put(kFile, replaced(solution(), "finish->diffuse * falloff", "finish->diffuse * std::sqrt(falloff)"));
    expect_caught(run().steps.at(0), {"2.3.unit", "2.10.unit"}, "none");
}

// One mistake of the list and one that is not: the known one explains only a part of the answers.
TEST_F(SubmissionsTest, TwoMistakesAtOnceAreBothCaught) {
    std::string text = replaced(solution(), "return 2 / (1 + grown);", "return 3 / (2 + grown);");
    for (const Mutant& m : read_mutants(project.mutants()))
        if (m.id == "M2.3") text = apply(m, text);
    put(kFile, text);
    expect_caught(run().steps.at(0), {"2.4.unit", "2.6.unit", "2.8.unit", "2.10.unit"}, "M2.3");
}

}  // namespace
}  // namespace rays::grader
