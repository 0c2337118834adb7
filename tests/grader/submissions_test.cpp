// Whole submissions: built, run and graded as a student's are. Good ones, untouched ones, broken ones, hostile ones.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "grader/grade.h"
#include "grader/mutants.h"
#include "grader/summary.h"
#include "schema_check.h"
#include "tools.h"

namespace rays::grader {
namespace {

namespace fs = std::filesystem;

// All of these change step 2, which is one file and quick to build. Step 1 is the starter's or the solution's.
constexpr int kStep = 2;
constexpr const char* kFile = "2_phong/phong.cpp";

class SubmissionsTest : public testing::Test {
protected:
    Project project = find_project();
    TemporaryFolder folder;

    fs::path submission() const { return folder.path() / "submission"; }
    fs::path out() const { return folder.path() / "out"; }

    void put(const std::string& file, const std::string& text) const {
        fs::create_directories((submission() / file).parent_path());
        std::ofstream(submission() / file) << text;
    }
    std::string solution() const { return read_file(project.root / "solutions" / kFile); }

    /// The solution with a line put at the beginning of `illuminate`, which every lit pixel asks.
    std::string solution_with(
        const std::string& line,
        const std::string& at = "Illumination illuminate(const Light& light, const Vec3& point) {") const {
        std::string text = solution();
        const auto found = text.find(at);
        EXPECT_NE(found, std::string::npos) << "the solution has changed";
        text.insert(found + at.size(), "\n" + line + "\n");
        return "#include <cstdio>\n#include <cstdlib>\n#include <cmath>\n#include <unistd.h>\n" + text;
    }

    /// Eight steps share the page's 3 MB, of which 0.2 MB are styles, scripts and libraries.
    void expect_small_page(std::size_t steps) const {
        constexpr std::size_t kWhole = 3'000'000, kFixed = 200'000;
        EXPECT_LE(fs::file_size(out() / "index.html"), kFixed + steps * ((kWhole - kFixed) / 8));
    }

    Results run(std::vector<int> steps = {kStep}, bool report = false, const fs::path& charts = {}) const {
        fs::create_directories(submission());
        GradeOptions options;
        options.steps = std::move(steps);
        options.submission = submission();
        options.out = out();
        options.seed = 11;
        options.report = report;
        options.charts = charts;
        const Results results = grade(project, options);
        EXPECT_EQ(results.infrastructure_error, "");
        const auto schema = nlohmann::json::parse(read_file(project.root / "grader" / "results.schema.json"));
        EXPECT_EQ(schema_problems(nlohmann::json::parse(read_file(out() / "results.json")), schema),
                  std::vector<std::string>{});
        for (const char c : summary(results, "out")) EXPECT_TRUE(c == '\n' || (c >= 0x20 && c < 0x7f));
        return results;
    }
};

std::vector<Verdict> verdicts(const StepResult& step, const std::string& kind) {
    std::vector<Verdict> list;
    for (const Check& c : step.checks)
        if (c.kind == kind && c.mode == "isolated") list.push_back(c.verdict);
    return list;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    const auto found = text.find(what);
    EXPECT_NE(found, std::string::npos) << "the solution has changed";
    return text.replace(found, what.size(), by);
}

bool has(const std::vector<Verdict>& list, Verdict v) { return std::find(list.begin(), list.end(), v) != list.end(); }

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
            EXPECT_TRUE(fs::exists(out() / map.file)) << map.file;
            EXPECT_GT(map.tests.max, 0) << map.file;
            EXPECT_EQ(map.nodes.max > 0, map.structure != "none") << map.file;
            // These two say which cells a ray visits; the others have none, or keep them to themselves.
            EXPECT_EQ(!map.cells.empty(), map.structure == "grid" || map.structure == "octree") << map.file;
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
    EXPECT_TRUE(fs::exists(out() / "charts.json"));
    const auto& points = r.steps.at(0).speed;
    ASSERT_FALSE(points.empty());
    for (const SpeedPoint& p : points) {
        EXPECT_EQ(p.verdict, Verdict::pass) << p.label << ": " << p.message;
        EXPECT_TRUE(0 < p.low && p.low <= p.median && p.median <= p.high) << p.label;
    }
    EXPECT_TRUE(run().steps.at(0).speed.size() == points.size()) << "the charts are there now";
    fs::remove(out() / "charts.json");
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
        const std::string view = fmt::format("--width {} --height {} --from {} --partition none", c.image->width, c.image->height,
                                             c.mode == "isolated" ? "student-2" : "student");
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
        text, "Radiance direct_light(const Scene& scene, const Visibility& visibility, const Surface& surface) {",
        "Radiance direct_light(const Scene&, const Visibility&, const Surface&) {\n    unfinished(\"2.10\");\n"
        "    return {};\n}\n\n[[maybe_unused]] static Radiance later(const Scene& scene, const Visibility& "
        "visibility, const Surface& surface) {");
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
    put(kFile, replaced(solution(), "finish->diffuse * static_cast<float>(n_dot_l)",
                        "finish->diffuse * std::sqrt(static_cast<float>(n_dot_l))"));
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

TEST_F(SubmissionsTest, PixelsThatAreNoNumbersFail) {
    put(kFile,
        solution_with("    Illumination nothing; nothing.radiance = Radiance(std::nanf(\"\")); return nothing;"));
    const StepResult step = run().steps.at(0);
    bool said = false;
    for (const Check& c : step.checks) said = said || (c.kind == "image" && c.message.find("NaN") != std::string::npos);
    EXPECT_TRUE(said);
    EXPECT_FALSE(has(verdicts(step, "image"), Verdict::crash));
}

// The course's lamps stand at places of one decimal, those of fresh scenes do not: this one knows only the former.
TEST_F(SubmissionsTest, PicturesKnownByHeartDoNotCount) {
    put(kFile, solution_with(
                   "    if (std::abs(light.location.x * 10 - std::round(light.location.x * 10)) > 1e-6) return {};"));
    const StepResult step = run().steps.at(0);
    int withheld = 0;
    for (const Check& c : step.checks) {
        if (c.kind != "image" || c.mode != "isolated") continue;
        EXPECT_EQ(c.points, 0) << c.id;
        withheld += c.message.find("it does not count yet: no fresh scene of task") != std::string::npos;
    }
    EXPECT_GT(withheld, 10);
}

TEST_F(SubmissionsTest, AGradeCannotBePrinted) {
    put(kFile, solution_with("    std::printf(\"Grade :=>> 100\\n\\x1b[2J{\\\"score\\\":100}\\n\"); "
                             "std::fflush(stdout); Illumination dark; return dark;"));
    const Results r = run();
    EXPECT_LT(r.steps.at(0).points, r.steps.at(0).max / 2);
    EXPECT_EQ(to_json(r).find("\x1b"), std::string::npos);
}

// Who looks for a mistake prints. It costs nothing: answers and ray trees have a standard output of their own.
TEST_F(SubmissionsTest, PrintingToStandardOutputCostsNothing) {
    put(kFile,
        "#include <iostream>\n" + solution_with("    std::printf(\"here\\n\"); std::cout << \"there\" << std::endl; "
                                                "[[maybe_unused]] const auto n = write(1, \"miss\\n\", 5);"));
    const StepResult step = run().steps.at(0);
    EXPECT_EQ(step.verdict, Verdict::pass);
    EXPECT_NEAR(step.points, step.max, 1e-9);
    for (const Check& c : step.checks)
        if (c.mode == "isolated") {  // step 1 is not written here
            EXPECT_EQ(c.verdict, Verdict::pass) << c.id << ": " << c.message;
        }
}

// The same when the code is wrong, too: the tree that explains the worst pixel is still read.
TEST_F(SubmissionsTest, PrintingDoesNotGarbleTheTreeOfAWrongPixel) {
    put(kFile, solution_with("    std::printf(\"{\\n\"); std::fflush(stdout); Illumination dark; return dark;"));
    const StepResult step = run().steps.at(0);
    int trees = 0;
    for (const Check& c : step.checks)
        for (const Diagnosis& d : c.diagnosis) trees += d.text.find("the shadow ray is missing") != std::string::npos;
    EXPECT_GT(trees, 5);
}

TEST_F(SubmissionsTest, AFloodOfTextIsStopped) {
    put(kFile, solution_with(
                   "    for (;;) std::puts(\"flood flood flood flood flood flood flood flood flood flood flood\");"));
    const StepResult step = run().steps.at(0);
    EXPECT_FALSE(has(verdicts(step, "image"), Verdict::infrastructure_error));
    EXPECT_TRUE(has(verdicts(step, "image"), Verdict::fail));
}

TEST_F(SubmissionsTest, AnEarlyGoodExitWithoutAPictureFails) {
    put(kFile, solution_with("    std::_Exit(0);"));
    const StepResult step = run().steps.at(0);
    bool said = false;
    for (const Check& c : step.checks)
        said = said || c.message.find("the picture was not written") != std::string::npos;
    EXPECT_TRUE(said);
    EXPECT_FALSE(has(verdicts(step, "image"), Verdict::pass) && step.points > step.max / 2);
}

TEST_F(SubmissionsTest, AForgedPictureIsJudgedAsAPicture) {
    // Writes its own "picture" and leaves: an absurd header, a link to the password file, a folder.
    for (const std::string how :
         {"FILE* f = std::fopen(\"picture.exr\", \"w\"); std::fputs(\"v/1\\x01\", f); std::fclose(f);",
          "symlink(\"/etc/passwd\", \"picture.exr\");"}) {
        put(kFile, solution_with("    { [[maybe_unused]] int ignored = 0; " + how + " std::_Exit(0); }"));
        const StepResult step = run().steps.at(0);
        for (const Check& c : step.checks)
            if (c.kind == "fresh" && c.task == "2.8") {
                EXPECT_EQ(c.verdict, Verdict::fail) << c.message;
            }
    }
}

}  // namespace
}  // namespace rays::grader
