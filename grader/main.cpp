// rays-grader: grades a submission, and grades the grader with mutants.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <iostream>

#include "core/error.h"
#include "grader/grade.h"
#include "grader/mutant_run.h"
#include "grader/submission/hand_in.h"
#include "grader/summary.h"
#include "support/files.h"

namespace rays::grader {
namespace {

// Neither a grade nor wrong use: the machine or the course's own data failed.
constexpr int kInfrastructureError = 3;

struct Arguments {
    GradeOptions grade;
    MutantOptions mutants;
    std::string submission, out, results;
    std::uint64_t seed = 0;
    bool json = false;
};

int status_of(const Results& results) {
    if (!results.infrastructure_error.empty()) return kInfrastructureError;
    const auto all_passed = [](const std::vector<Check>& checks) {
        return std::all_of(checks.begin(), checks.end(), [](const Check& c) { return c.verdict == Verdict::pass; });
    };
    for (const StepResult& step : results.steps)
        if (!all_passed(step.checks)) return kCheckFailed;
    return results.handed_in && !all_passed(results.handed_in->checks) ? kCheckFailed : kSuccess;
}

int run_grade(const CLI::App& command, Arguments& a) {
    const Project project = find_project();
    if (!a.submission.empty()) a.grade.submission = a.submission;
    if (command.count("--seed")) a.grade.seed = a.seed;
    a.grade.out = a.out.empty() ? project.root / "report" / "out" : std::filesystem::path(a.out);
    const Results results = grade(project, a.grade);
    std::cout << (a.json ? to_json(results) : summary(results, a.grade.out));
    return status_of(results);
}

int run_hand_in(const Arguments& a) {
    const Project project = find_project();
    const std::filesystem::path out = a.out.empty() ? project.root / "submission.tar.gz" : std::filesystem::path(a.out);
    const HandInResult result = hand_in(project, working_copy(project), out);
    std::cout << hand_in_text(result, out);
    return is_complete(result) ? kSuccess : kCheckFailed;
}

int run_summary(const Arguments& a) {
    const std::filesystem::path file = a.results;
    std::cout << summary(read_results(file), file.parent_path());
    return kSuccess;
}

int run(int argc, char** argv) {
    CLI::App app("Grades the student's steps: questions, pictures, fresh scenes, stability.", "rays-grader");
    app.require_subcommand(1);
    Arguments a;
    auto* grade = app.add_subcommand("grade", "grade the working copy, a submission, or the solutions");
    grade->add_option("step", a.grade.steps, "numbers of steps; none: all");
    grade->add_option("--from", a.grade.from, "student or solution")->capture_default_str();
    grade->add_option("--submission", a.submission,
                      "a folder (or .tar.gz, .zip) with the student's files, as in steps/ or flat");
    grade->add_option("--out", a.out, "folder for results.json, images/ and index.html; default report/out");
    grade->add_option(
        "--charts", a.grade.charts,
        "a charts.json of ./rays chart: the student is timed for it; default: the one in the folder of --out");
    grade->add_option("--seed", a.seed, "of questions and fresh scenes; default: a new one for every run");
    grade->add_flag("--json", a.json, "print results.json instead of the summary");
    auto* submission = app.add_subcommand("submission", "render, check and pack what is handed in");
    submission->add_option("--out", a.out, "a folder, or a file that ends in .tar.gz; default submission.tar.gz");
    auto* mutants = app.add_subcommand("mutants", "grade every typical mistake of grader/mutants");
    mutants->add_option("step", a.mutants.steps, "numbers of steps; none: all");
    mutants->add_option("--only", a.mutants.only, "ids of mutants");
    mutants->add_option("--json", a.mutants.json, "write the table to this file");
    mutants->add_flag("--update", a.mutants.update, "write grader/mutants/fingerprints.json anew");
    auto* show = app.add_subcommand("summary", "print a result again");
    show->add_option("results", a.results, "results.json")->required();
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& help) {
        return app.exit(help);
    } catch (const CLI::Error& e) {
        app.exit(e);
        return kBadInput;
    }
    if (grade->parsed()) return run_grade(*grade, a);
    if (submission->parsed()) return run_hand_in(a);
    if (show->parsed()) return run_summary(a);
    return run_mutants(find_project(), a.mutants);
}

}  // namespace
}  // namespace rays::grader

int main(int argc, char** argv) {
    try {
        return rays::grader::run(argc, argv);
    } catch (const rays::InputError& e) {
        std::fprintf(stderr, "rays-grader: %s\n", e.what());
        return rays::kBadInput;
    } catch (const std::exception& e) {
        std::fprintf(stderr, "rays-grader: infrastructure error: %s\n", e.what());
        return rays::grader::kInfrastructureError;
    }
}
