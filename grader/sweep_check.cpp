// Stability: a question over decades of a parameter, charted for the solution, the student and the naive method.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "grader/answers.h"
#include "grader/checks.h"

namespace rays::grader {
namespace {

// Where the best answer has no error at all, a logarithmic chart still needs a number: one below every rounding.
constexpr double kNoError = 1e-18;

/// One program's way through a sweep.
struct Line {
    ChartSeries series;
    int right = 0, counted = 0;     ///< points within the stated range
    int wrong = 0, unfinished = 0;  ///< answers within it
    std::string first_wrong;
};

bool in_range(const Sweep& sweep, const Sweep::Point& point) {
    return point.x >= sweep.pass_from && point.x <= sweep.pass_to;
}

std::vector<const Question*> questions_of(const Sweep& sweep) {
    std::vector<const Question*> questions;
    for (const Sweep::Point& p : sweep.points)
        for (const Question& q : p.questions) questions.push_back(&q);
    return questions;
}

// Over decades the worst answer counts. A linear axis holds yes-or-no questions, of which it shows the share of wrong
// answers.
double charted(const Sweep& sweep, const std::vector<double>& errors) {
    double worst = 0, sum = 0;
    for (const double e : errors) {
        worst = std::isfinite(e) ? std::max(worst, e) : INFINITY;
        if (!std::isfinite(worst)) return INFINITY;
        sum += e;
    }
    if (sweep.log_y) return std::max(worst, kNoError);
    return errors.empty() ? 0 : sum / static_cast<double>(errors.size());
}

// The answers to this point's questions begin at `at`.
void add_point(Line& line, const Sweep& sweep, const Sweep::Point& point, const Replies& replies, std::size_t at) {
    std::vector<double> errors;
    bool good = true;
    for (const Question& q : point.questions) {
        const Answer& answer = replies.answers[at++];
        const Judgement j = q.judge(answer);
        errors.push_back(j.error);
        good = good && j.ok;
        if (j.ok || !in_range(sweep, point)) continue;
        const bool waits = answer.kind == Answer::Kind::unfinished;
        ++(waits ? line.unfinished : line.wrong);
        if (!waits && line.first_wrong.empty())
            line.first_wrong = fmt::format("first at {} = {:.3g}: expected {}, got {}", sweep.x_label, point.x,
                                           j.expected, shown_answer(answer, replies, 120));
    }
    const double shown = charted(sweep, errors);
    line.series.points.emplace_back(point.x, std::isfinite(shown) ? std::optional(shown) : std::nullopt);
    if (!in_range(sweep, point)) return;
    ++line.counted;
    line.right += good;
}

Line line_of(const Sweep& sweep, const Replies& replies, const char* role) {
    Line line;
    line.series.name = line.series.role = role;
    std::size_t at = 0;
    for (const Sweep::Point& p : sweep.points) {
        add_point(line, sweep, p, replies, at);
        at += p.questions.size();
    }
    return line;
}

Verdict verdict_of(const Line& line, const Replies& replies) {
    if (line.counted > 0 && line.right == line.counted) return Verdict::pass;
    const bool missing =
        std::any_of(replies.answers.begin(), replies.answers.end(), [](const Answer& a) { return !a.came(); });
    if (missing && replies.ended.timed_out) return Verdict::time_out;
    if (missing && replies.ended.signal) return Verdict::crash;
    // Where the method is not needed (a transform that is the identity, say) an unwritten task is right by luck.
    if (line.unfinished > 0 && line.wrong == 0 && 2 * line.right <= line.counted) return Verdict::not_started;
    return 2 * line.right > line.counted ? Verdict::partial : Verdict::fail;
}

Check empty_check(const Sweep& sweep, double max) {
    Check check = new_check(sweep.id, sweep.task, "stability", sweep.title, max);
    check.chart =
        Chart{sweep.title, sweep.x_label, sweep.y_label, sweep.log_x, sweep.log_y, sweep.pass_from, sweep.pass_to, {}};
    return check;
}

}  // namespace

Check sweep_check(const Bench& bench, const Sweep& sweep, const std::vector<ChartSeries>& naive, double max) {
    Check check = empty_check(sweep, max);
    const auto questions = questions_of(sweep);
    const bool same = bench.student == bench.solution;
    const Replies solution = ask(bench.sandbox, bench.solution, questions, bench.limits);
    const Replies student = same ? solution : ask(bench.sandbox, bench.student, questions, bench.limits);
    check.seconds = student.ended.wall_s;
    if (solution.infrastructure || student.infrastructure) {
        check.verdict = Verdict::infrastructure_error;
        check.message = solution.infrastructure ? solution.problem : student.problem;
        return check;
    }
    const Line line = line_of(sweep, student, same ? "solution" : "student");
    if (!same) check.chart->series.push_back(line_of(sweep, solution, "solution").series);
    check.chart->series.push_back(line.series);
    check.chart->series.insert(check.chart->series.end(), naive.begin(), naive.end());
    check.verdict = verdict_of(line, student);
    check.waits = line.unfinished > 0 && line.wrong == 0;
    check.points = line.counted ? points_for(double(line.right) / line.counted, max) : 0;
    check.message = fmt::format("right at {} of {} points from {:.3g} to {:.3g}", line.right, line.counted,
                                sweep.pass_from, sweep.pass_to);
    if (line.unfinished > 0)
        check.message +=
            fmt::format("; {} answers wait for task {}", line.unfinished, unfinished_task(student.answers));
    if (!line.first_wrong.empty()) check.message += "; " + line.first_wrong;
    if (!student.problem.empty()) check.message += "; " + student.problem;
    return check;
}

}  // namespace rays::grader
