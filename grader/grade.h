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
    std::vector<int> steps;                           ///< empty: all that are built
    std::string from = "student";                     ///< or "solution"
    std::optional<std::filesystem::path> submission;  ///< a folder with the student's files; else the working copy
    std::filesystem::path out;                        ///< gets results.json, images/ and index.html
    std::optional<std::uint64_t> seed;                ///< of questions and fresh scenes; else a new one for every run
    bool report = true;
};

/// Throws InputError for wrong use.
Results grade(const Project& project, const GradeOptions& options);

/// The rows of the rubric: a row gets the share of its points that its tasks and their pictures earned.
std::vector<RubricResult> rubric_results(const Rubric& rubric, const std::vector<Step>& all_steps,
                                         const std::vector<StepResult>& graded);

/// Sum of the graded rows, extra ones left out.
void add_up(Results& results);

}  // namespace rays::grader
