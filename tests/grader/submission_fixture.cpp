#include "submission_fixture.h"

#include <algorithm>
#include <fstream>

#include "schema_check.h"

namespace rays::grader {

namespace fs = std::filesystem;

void SubmissionsTest::put(const std::string& file, const std::string& text) const {
    fs::create_directories((submission() / file).parent_path());
    std::ofstream(submission() / file) << text;
}

std::string SubmissionsTest::solution_with(const std::string& line, const std::string& at) const {
    return "#include <cstdio>\n#include <cstdlib>\n#include <cmath>\n#include <unistd.h>\n" +
           replaced(solution(), at, at + "\n" + line + "\n");
}

void SubmissionsTest::expect_small_page(std::size_t steps) const {
    constexpr std::size_t kWhole = 3'000'000, kFixed = 200'000;
    EXPECT_LE(fs::file_size(out() / "index.html"), kFixed + steps * ((kWhole - kFixed) / 8));
}

Results SubmissionsTest::run(std::vector<int> steps, bool report, const fs::path& charts) const {
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

std::vector<Verdict> verdicts(const StepResult& step, const std::string& kind) {
    std::vector<Verdict> list;
    for (const Check& c : step.checks)
        if (c.kind == kind && c.mode == "isolated") list.push_back(c.verdict);
    return list;
}

bool has(const std::vector<Verdict>& list, Verdict v) { return std::find(list.begin(), list.end(), v) != list.end(); }

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    const auto found = text.find(what);
    EXPECT_NE(found, std::string::npos) << "the solution has changed";
    return found == std::string::npos ? text : text.replace(found, what.size(), by);
}

}  // namespace rays::grader
