#include "grader/grade.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <random>
#include <thread>

#include "core/error.h"
#include "grader/grade_step.h"
#include "grader/student_build.h"
#include "grader/student_speed.h"
#include "grader/submission/archive.h"
#include "grader/submission/handed_in.h"
#include "grader/text.h"
#include "references/manifest.h"
#include "support/files.h"
#ifdef RAYSTEPS_REPORT
#include "report/report.h"
#endif

namespace rays::grader {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

std::string value_in(const fs::path& file, const std::string& key) {
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
        if (!line.starts_with(key)) continue;
        const auto begin = line.find_first_not_of(" \t:=\"", key.size());
        const auto end = line.find_last_not_of(" \"");
        if (begin != std::string::npos) return line.substr(begin, end - begin + 1);
    }
    return "unknown";
}

std::string compiler_of(const Project& project) {
    Command command{{project.setting("CMAKE_CXX_COMPILER"), "--version"}, {}, {}, {}, true};
    const Ended ended = run_command(command);
    return ended.ok() ? plain(ended.out.substr(0, ended.out.find('\n'))) : "unknown";
}

std::string povray_of(const Project& project) {
    try {
        return load_manifest(project.references() / "manifest.json").povray;
    } catch (const InputError&) {
        return "unknown";
    }
}

Limits limits_for(const Project& project) {
    Limits limits;
    if (project.sanitized()) limits.memory_mb = 0;  // AddressSanitizer maps terabytes of address space
    return limits;
}

std::uint64_t fresh_seed() {
    std::random_device device;
    return device();  // 32 bits: easy to type again
}

Results describe(const Project& project, const GradeOptions& options, const Limits& limits, const Sandbox& sandbox) {
    Results r;
    r.created = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}",
                            fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())));
    r.submission_name = options.submission
                            ? plain(fs::absolute(*options.submission).lexically_normal().filename().string())
                            : "working copy";
    r.submission_from = options.submission ? "submission" : options.from;
    r.cpu = value_in("/proc/cpuinfo", "model name");
    r.os = value_in("/etc/os-release", "PRETTY_NAME");
    r.cores = static_cast<int>(std::thread::hardware_concurrency());
    r.raysteps = project.version;
    r.povray = povray_of(project);
    r.compiler = compiler_of(project);
    r.real = project.setting("RAYSTEPS_REAL");
    r.sandbox_tier = sandbox.tier();
    r.cpu_s = limits.cpu_s;
    r.memory_mb = limits.memory_mb;
    r.processes = limits.processes;
    r.output_mb = limits.output_mb;
    r.seed = options.seed ? *options.seed : fresh_seed();
    return r;
}

std::vector<Step> wanted_steps(const std::vector<Step>& all, const std::vector<int>& numbers) {
    std::vector<Step> wanted;
    for (const int n : numbers)
        if (std::none_of(all.begin(), all.end(), [&](const Step& s) { return s.number == n; }))
            throw InputError(
                fmt::format("there is no step {} yet; built are the folders of steps/ with a step.json", n));
    for (const Step& s : all)
        if (numbers.empty() || std::find(numbers.begin(), numbers.end(), s.number) != numbers.end())
            wanted.push_back(s);
    return wanted;
}

StudentPrograms solution_as_student(const Project& project, const std::vector<Step>& steps) {
    StudentPrograms programs;
    programs.all_mine = project.program("render-solution");
    for (const Step& s : steps) programs.isolated[s.number] = programs.all_mine;
    return programs;
}

// For a person who waits; the result itself goes to standard output.
void say(const std::string& what) {
    static const bool terminal = ::isatty(STDERR_FILENO) == 1;
    if (terminal) fmt::print(stderr, "\r\x1b[K{}", what);
}

void add_report(const fs::path& out) {
#ifdef RAYSTEPS_REPORT
    try {
        write_report(out / "results.json", out / "index.html");
    } catch (const std::exception& e) {
        // The grade stands without its page.
        fmt::print(stderr, "rays-grader: no report page: {}\n", e.what());
    }
#else
    static_cast<void>(out);
#endif
}

// The first infrastructure error of any check makes the whole result one: it is no grade.
void look_for_infrastructure_errors(Results& results) {
    const auto look = [&](const std::vector<Check>& checks) {
        for (const Check& c : checks)
            if (c.verdict == Verdict::infrastructure_error && results.infrastructure_error.empty())
                results.infrastructure_error = c.id + ": " + c.message;
    };
    for (const StepResult& s : results.steps) look(s.checks);
    if (results.handed_in) look(results.handed_in->checks);
}

// Where submission.json is looked for: in what was submitted, or beside the working copy's steps. Pictures need all
// steps, so a run that grades some of them only does not look at them; nor is the solution a submission.
std::optional<fs::path> handed_in_folder(const Project& project, const GradeOptions& options,
                                         const fs::path& submission) {
    if (!options.steps.empty()) return {};
    if (options.submission) return submission;
    const fs::path working_copy = project.root / "submission";
    if (options.from == "student" && fs::exists(working_copy / kSubmissionFile)) return working_copy;
    return {};
}

// Are there charts of speed for the student's points to stand in?
bool take_charts(const GradeOptions& options, const fs::path& out) {
    const fs::path there = out / "charts.json";
    if (options.charts.empty()) return fs::exists(there);
    if (!fs::is_regular_file(options.charts))
        throw InputError(options.charts.string() + ": no such file; ./rays chart writes report/out/charts.json");
    if (!fs::exists(there) || !fs::equivalent(options.charts, there))
        write_atomically(there, read_file(options.charts));
    return true;
}

fs::path submitted_folder(const Project& project, const GradeOptions& options, const fs::path& scratch) {
    if (!options.submission) return project.root / (options.from == "solution" ? "solutions" : "steps");
    if (fs::is_directory(*options.submission)) return fs::absolute(*options.submission);
    if (!fs::is_regular_file(*options.submission))
        throw InputError(options.submission->string() + ": no such folder or archive");
    return unpack(*options.submission, scratch);
}

}  // namespace

Results grade(const Project& project, const GradeOptions& options) {
    const auto begin = Clock::now();
    if (options.from != "student" && options.from != "solution")
        throw InputError("--from " + options.from + ": need student or solution");
    const TemporaryFolder scratch;
    const fs::path submission = submitted_folder(project, options, scratch.path());
    const auto all_steps = read_steps(project.steps());
    const auto steps = wanted_steps(all_steps, options.steps);
    const Rubric rubric = read_rubric(project.root / "grader" / "rubric.json");
    const Fingerprints fingerprints = read_fingerprints(project.mutants() / "fingerprints.json");
    const auto sandbox = make_sandbox();
    const Limits limits = limits_for(project);
    const fs::path out = fs::absolute(options.out).lexically_normal();
    fs::create_directories(out / "images");
    const bool charted = take_charts(options, out);
    Results results = describe(project, options, limits, *sandbox);
    const auto save = [&](bool complete) {
        results.complete = complete;
        results.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
        results.rubric = rubric_results(rubric, all_steps, results.steps, results.handed_in);
        add_up(results, rubric.extra_limit);
        look_for_infrastructure_errors(results);
        write_results(results, out / "results.json");
    };
    save(false);
    say("building the submission");
    const TemporaryFolder objects;
    const int workers = std::max(1, results.cores);
    const StudentPrograms programs =
        options.from == "solution" && !options.submission
            ? solution_as_student(project, all_steps)
            : build_student(Builder(project), project, all_steps, steps, submission, objects.path(), workers);
    results.infrastructure_error = programs.infrastructure_error;
    if (!fs::exists(project.program("render-solution"))) results.infrastructure_error = "render-solution is not built";
    for (const Step& step : steps) {
        if (!results.infrastructure_error.empty()) break;
        say(fmt::format("grading step {}", step.number));
        const bool built = programs.isolated.count(step.number) != 0;
        const auto known = fingerprints.steps.find(step.number);
        StepOrder order{{project, *sandbox, step, project.program("render-solution"),
                         built ? programs.isolated.at(step.number) : fs::path(), out, results.seed, limits},
                        programs.all_mine,
                        built ? std::string() : programs.build_errors.at(step.number),
                        submission,
                        known == fingerprints.steps.end() ? nullptr : &known->second,
                        workers};
        results.steps.push_back(grade_step(order));
        if (charted && built) {
            say(fmt::format("timing step {}", step.number));
            results.steps.back().speed = time_student(order.bench);
        }
        save(false);
    }
    if (const auto folder = handed_in_folder(project, options, submission);
        folder && results.infrastructure_error.empty()) {
        say("grading pictures and report");
        results.handed_in = grade_handed_in(
            {project, *sandbox, project.program("render-solution"), programs.all_mine, *folder, out, limits, workers},
            rubric);
    }
    save(true);
    if (options.report) {
        say("writing the report");
        add_report(out);
    }
    say("");
    return results;
}

}  // namespace rays::grader
