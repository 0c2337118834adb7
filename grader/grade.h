// `rays grade`: a submission from its files to results.json and the report.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "grader/project.h"
#include "grader/results.h"
#include "grader/step_data.h"

namespace rays::grader {

struct GradeOptions {
    std::vector<int> steps;        ///< empty: all that are built
    std::string from = "student";  ///< or "solution"
    std::optional<std::filesystem::path>
        submission;                     ///< a folder or an archive of the student's; else the working copy
    std::filesystem::path out;          ///< gets results.json, images/ and index.html
    std::optional<std::uint64_t> seed;  ///< of questions and fresh scenes; else a new one for every run
    bool report = true;
    std::filesystem::path charts;  ///< a charts.json that `out` gets a copy of; empty: the one that is there, if any
};

/// Throws InputError for wrong use.
Results grade(const Project& project, const GradeOptions& options);

/// The rows of the rubric: a row gets the share of its points that its tasks and their pictures earned, and the rows
/// "pictures" and "report" what the checks of the hand-in earned.
std::vector<RubricResult> rubric_results(const Rubric& rubric, const std::vector<Step>& all_steps,
                                         const std::vector<StepResult>& graded,
                                         const std::optional<HandedIn>& handed_in = {});

/// Sum of the graded rows, and of the extra ones apart, these at most `extra_limit`.
void add_up(Results& results, double extra_limit = 30);

}  // namespace rays::grader
