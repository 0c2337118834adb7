// Whole submissions, made of the solution with something changed, and graded as a student's are.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "grader/grade.h"
#include "grader/summary.h"
#include "tools.h"

namespace rays::grader {

class SubmissionsTest : public testing::Test {
protected:
    // All of these change step 2, which is one file and quick to build. Step 1 is the starter's or the solution's.
    static constexpr int kStep = 2;
    static constexpr const char* kFile = "2_phong/phong.cpp";

    Project project = find_project();
    TemporaryFolder folder;

    std::filesystem::path submission() const { return folder.path() / "submission"; }
    std::filesystem::path out() const { return folder.path() / "out"; }

    void put(const std::string& file, const std::string& text) const;
    std::string solution() const { return read_file(project.root / "solutions" / kFile); }
    /// The solution with a line put at the beginning of `illuminate`, which every lit pixel asks.
    std::string solution_with(
        const std::string& line,
        const std::string& at = "Illumination illuminate(const Light& light, const Vec3& point) {") const;
    /// Graded, with or without the page, and timed for these charts; results and summary are what they promise to be.
    Results run(std::vector<int> steps = {kStep}, bool report = false, const std::filesystem::path& charts = {}) const;
    /// Eight steps share the page's 3 MB, of which 0.2 MB are styles, scripts and libraries.
    void expect_small_page(std::size_t steps) const;
};

/// Of the checks of a kind that were asked of this step alone.
std::vector<Verdict> verdicts(const StepResult& step, const std::string& kind);
bool has(const std::vector<Verdict>& list, Verdict v);

/// With `what`, which must be there, replaced.
std::string replaced(std::string text, const std::string& what, const std::string& by);

}  // namespace rays::grader
