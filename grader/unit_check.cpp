#include <fmt/format.h>

#include <algorithm>

#include "grader/answers.h"
#include "grader/checks.h"
#include "grader/text.h"
#include "grader/verdicts.h"

namespace rays::grader {
namespace {

constexpr std::size_t kShownWrong = 6, kShownRight = 2, kShownScene = 3000;

struct Tally {
    int right = 0, unfinished = 0, missing = 0, asked = 0;
    std::string first_wrong;
};

AskedQuestion shown(const Question& q, const Answer& a, const Judgement& j) {
    const bool came = a.kind != Answer::Kind::missing;
    return {q.about, q.query, plain_lines(q.scene, kShownScene), j.expected, came ? plain(a.text) : "(no answer)", j.ok};
}

Tally judge(const std::vector<const Question*>& questions, const std::vector<Answer>& answers, Check& check) {
    Tally tally;
    std::size_t wrong = 0, right = 0;
    std::vector<AskedQuestion> right_ones;
    for (std::size_t i = 0; i < questions.size(); ++i) {
        const Judgement j = questions[i]->judge(answers[i]);
        ++tally.asked;
        tally.right += j.ok;
        tally.unfinished += answers[i].kind == Answer::Kind::unfinished;
        tally.missing += answers[i].kind == Answer::Kind::missing;
        if (j.ok && right++ < kShownRight) right_ones.push_back(shown(*questions[i], answers[i], j));
        if (j.ok) continue;
        if (tally.first_wrong.empty())
            tally.first_wrong = fmt::format("{}: expected {}, got {}", questions[i]->about, j.expected, plain(answers[i].text, 120));
        if (wrong++ < kShownWrong) check.questions.push_back(shown(*questions[i], answers[i], j));
    }
    check.questions.insert(check.questions.end(), right_ones.begin(), right_ones.end());
    return tally;
}

// The task that stands in the way, as the first answer says.
std::string unfinished_task(const std::vector<Answer>& answers) {
    for (const Answer& a : answers)
        if (a.kind == Answer::Kind::unfinished) return plain(a.text.substr(std::string("unfinished ").size()), 12);
    return {};
}

Verdict verdict_of(const Tally& t, const Replies& replies) {
    if (t.right == t.asked && t.asked > 0) return Verdict::pass;
    if (t.missing > 0 && replies.ended.timed_out) return Verdict::time_out;
    if (t.missing > 0 && replies.ended.signal) return Verdict::crash;
    if (t.unfinished == t.asked) return Verdict::not_started;
    return 2 * t.right > t.asked ? Verdict::partial : Verdict::fail;
}

}  // namespace

double points_for(double share_right, double max) { return max * std::clamp(2 * share_right - 1, 0.0, 1.0); }

Check unit_check(const Bench& bench, const Task& task, const std::vector<Question>& questions, double max) {
    Check check;
    check.id = task.id + ".unit";
    check.task = task.id;
    check.kind = "unit";
    check.title = task.title + ": questions";
    check.max = max;
    std::vector<const Question*> asked;
    for (const Question& q : questions)
        if (q.task == task.id) asked.push_back(&q);
    const Replies replies = ask(bench.sandbox, bench.student, asked, bench.limits);
    check.seconds = replies.ended.wall_s;
    if (replies.infrastructure) {
        check.verdict = Verdict::infrastructure_error;
        check.message = replies.problem;
        return check;
    }
    const Tally tally = judge(asked, replies.answers, check);
    check.verdict = verdict_of(tally, replies);
    check.points = tally.asked ? points_for(double(tally.right) / tally.asked, max) : 0;
    check.message = fmt::format("{} of {} questions answered right", tally.right, tally.asked);
    if (tally.unfinished > 0) check.message += fmt::format("; {} wait for task {}", tally.unfinished, unfinished_task(replies.answers));
    if (!replies.problem.empty()) check.message += "; " + replies.problem;
    if (tally.unfinished < tally.asked && !tally.first_wrong.empty()) check.message += "; " + tally.first_wrong;
    return check;
}

Check sweep_check(const Bench& bench, const Sweep& sweep, const std::vector<ChartSeries>& naive, double max) {
    // Where the best possible answer has no error, a logarithmic chart still needs a number: below every rounding.
    constexpr double kNoError = 1e-18;
    Check check;
    check.id = sweep.id;
    check.task = sweep.task;
    check.kind = "stability";
    check.title = sweep.title;
    check.max = max;
    check.chart = Chart{sweep.title, sweep.x_label, sweep.y_label, sweep.log_x, sweep.log_y, sweep.pass_from, sweep.pass_to, {}};
    std::vector<const Question*> asked;
    for (const Sweep::Point& p : sweep.points)
        for (const Question& q : p.questions) asked.push_back(&q);
    const auto series = [&](const std::vector<Answer>& answers, const char* role, int& right, int& counted, std::string& first) {
        ChartSeries line{role, role, {}};
        std::size_t at = 0;
        for (const Sweep::Point& p : sweep.points) {
            double worst = 0;
            bool good = true;
            for (const Question& q : p.questions) {
                const Judgement j = q.judge(answers[at++]);
                worst = std::isfinite(j.error) ? std::max(worst, j.error) : INFINITY;
                good = good && j.ok;
                if (!j.ok && first.empty() && p.x >= sweep.pass_from && p.x <= sweep.pass_to)
                    first = fmt::format("first at {} = {:.3g}: expected {}, got {}", sweep.x_label, p.x, j.expected, plain(answers[at - 1].text, 120));
            }
            line.points.emplace_back(p.x, std::isfinite(worst) ? std::optional(sweep.log_y ? std::max(worst, kNoError) : worst) : std::nullopt);
            if (!(p.x >= sweep.pass_from && p.x <= sweep.pass_to)) continue;
            ++counted;
            right += good;
        }
        return line;
    };
    const Replies solution = ask(bench.sandbox, bench.solution, asked, bench.limits);
    const Replies student = bench.student == bench.solution ? solution : ask(bench.sandbox, bench.student, asked, bench.limits);
    check.seconds = student.ended.wall_s;
    if (solution.infrastructure || student.infrastructure) {
        check.verdict = Verdict::infrastructure_error;
        check.message = solution.infrastructure ? solution.problem : student.problem;
        return check;
    }
    int right = 0, counted = 0, solution_right = 0, solution_counted = 0;
    std::string first, solution_first;
    check.chart->series.push_back(series(solution.answers, "solution", solution_right, solution_counted, solution_first));
    if (bench.student != bench.solution) check.chart->series.push_back(series(student.answers, "student", right, counted, first));
    else right = solution_right, counted = solution_counted, first = solution_first;
    check.chart->series.insert(check.chart->series.end(), naive.begin(), naive.end());
    const bool unfinished = std::all_of(student.answers.begin(), student.answers.end(), [](const Answer& a) { return a.kind == Answer::Kind::unfinished; });
    const bool missing = std::any_of(student.answers.begin(), student.answers.end(), [](const Answer& a) { return a.kind == Answer::Kind::missing; });
    check.verdict = counted > 0 && right == counted               ? Verdict::pass
                    : unfinished                                  ? Verdict::not_started
                    : missing && student.ended.timed_out          ? Verdict::time_out
                    : missing && student.ended.signal             ? Verdict::crash
                    : 2 * right > counted                         ? Verdict::partial
                                                                  : Verdict::fail;
    check.points = counted ? points_for(double(right) / counted, max) : 0;
    check.message = fmt::format("right at {} of {} points from {:.3g} to {:.3g}", right, counted, sweep.pass_from, sweep.pass_to);
    if (unfinished) check.message += "; the task is not written yet";
    else if (!first.empty()) check.message += "; " + first;
    if (!student.problem.empty()) check.message += "; " + student.problem;
    return check;
}

}  // namespace rays::grader
