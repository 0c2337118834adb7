#include "grader/summary.h"

#include <fmt/format.h>

#include <set>

#include "grader/text.h"

namespace rays::grader {
namespace {

std::string points(double p) { return fmt::format("{:.4g}", p); }

// Hints belong to a task and are told once, under its first check that is not right.
std::string check_lines(const Check& c, const std::filesystem::path& out, bool with_hints) {
    std::string text =
        fmt::format("    {} [{}{}] {}: {}\n", plain(c.id), c.kind, c.mode == "isolated" ? "" : ", all mine",
                    to_string(c.verdict), plain(c.message, 400));
    for (const Diagnosis& d : c.diagnosis) {
        if (d.kind == "hint" && !with_hints) continue;
        text += fmt::format("        {}{}: {}\n", d.kind,
                            d.mutant.empty() ? std::string() : fmt::format(" {}", plain(d.mutant)), plain(d.text, 400));
    }
    if (c.image && !c.image->student.empty()) {
        text += fmt::format("        pictures: {}", (out / c.image->student).string());
        if (!c.image->reference.empty())
            text += fmt::format("  {}", (out / c.image->reference).lexically_normal().string());
        text += '\n';
    }
    return text;
}

// A build error is the same for all checks of a step: told once.
std::string wrong_checks(const StepResult& step, const std::filesystem::path& out) {
    if (step.verdict == Verdict::build_error)
        return step.checks.empty() ? std::string() : fmt::format("    {}\n", plain_lines(step.checks.front().message));
    std::string text;
    std::set<std::string> told;  // tasks whose hints were
    std::set<std::string> begun;
    for (const TaskResult& t : step.tasks)
        if (t.verdict == Verdict::partial) begun.insert(t.id);
    int not_started = 0;
    for (const Check& c : step.checks) {
        // A task that is partly right says what its rest waits for.
        const bool waits = c.verdict == Verdict::not_started;
        const bool asked_for = waits && !is_picture(c) && begun.count(c.task) != 0;
        not_started += waits && !asked_for;
        if (asked_for) text += check_lines(c, out, false);
        if (c.verdict != Verdict::pass && !waits) text += check_lines(c, out, told.insert(c.task).second);
    }
    if (not_started) text += fmt::format("    {} checks wait for tasks that are not started\n", not_started);
    return text;
}

std::string step_text(const StepResult& step, const std::filesystem::path& out) {
    std::string text = fmt::format("Step {}  {:<44} {:<14} {:>6} / {}\n", step.number, plain(step.title),
                                   to_string(step.verdict), points(step.points), points(step.max));
    for (const TaskResult& t : step.tasks)
        text += fmt::format("  {:<5} {:<44} {:<14} {:>6} / {}\n", t.id, plain(t.title, 44), to_string(t.verdict),
                            points(t.points), points(t.max));
    double earned = 0, max = 0;
    int passed = 0, pictures = 0;
    for (const Check& c : step.checks) {
        if (!is_picture(c) || c.mode != "isolated") continue;
        earned += c.points;
        max += c.max;
        passed += c.verdict == Verdict::pass;
        ++pictures;
    }
    text += fmt::format("        {:<59} {:>6} / {}\n", fmt::format("pictures: {} of {} as POV-Ray's", passed, pictures),
                        points(earned), points(max));
    return text + wrong_checks(step, out);
}

std::string handed_in_text(const HandedIn& handed_in, const std::filesystem::path& out) {
    std::string text = fmt::format("{:<52} {:<14} {:>6} / {}\n", "Pictures and report", to_string(handed_in.verdict),
                                   points(handed_in.points), points(handed_in.max));
    for (const Check& c : handed_in.checks)
        if (c.max > 0)
            text += fmt::format("  {:<50} {:<14} {:>6} / {}\n", plain(c.title, 50), to_string(c.verdict),
                                points(c.points), points(c.max));
    for (const Check& c : handed_in.checks)
        if (c.verdict != Verdict::pass) text += check_lines(c, out, true);
    return text;
}

std::string rubric_text(const Results& r) {
    std::string text = "The assignment\n";
    for (const RubricResult& row : r.rubric)
        text += row.graded
                    ? fmt::format("  {:<65} {:>6} / {}{}\n", plain(row.title), points(row.points), points(row.max),
                                  row.extra ? "  extra" : "")
                    : fmt::format("  {:<65}      - / {}  {}\n", plain(row.title), points(row.max), plain(row.note));
    return text;
}

}  // namespace

std::string summary(const Results& r, const std::filesystem::path& out) {
    std::string text;
    for (const StepResult& step : r.steps) text += step_text(step, out) + "\n";
    if (r.handed_in) text += handed_in_text(*r.handed_in, out) + "\n";
    if (!r.rubric.empty()) text += rubric_text(r) + "\n";
    if (!r.infrastructure_error.empty())
        text += "INFRASTRUCTURE ERROR, this is no grade: " + plain(r.infrastructure_error, 600) + "\n";
    if (r.real == "float")
        text += "Built with RAYSTEPS_REAL=float: exact pictures and full marks are promised for double only.\n";
    text +=
        fmt::format("Score: {} of {} points that can be graded today{}; seed {}, {:.1f} s, sandbox tier \"{}\"{}\n",
                    points(r.points), points(r.max), r.extra > 0 ? fmt::format(", and {} extra", points(r.extra)) : "",
                    r.seed, r.seconds, r.sandbox_tier, r.complete ? "" : "; PARTIAL RESULT");
    return text + "Results: " + (out / "results.json").string() + "\n";
}

}  // namespace rays::grader
