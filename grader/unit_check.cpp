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
    return {q.about, q.query, plain_lines(q.scene, kShownScene), j.expected, came ? plain(a.text) : "(no answer)",
            j.ok};
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
            tally.first_wrong =
                fmt::format("{}: expected {}, got {}", questions[i]->about, j.expected, plain(answers[i].text, 120));
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
    Check check = new_check(task.id + ".unit", task.id, "unit", task.title + ": questions", max);
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
    if (tally.unfinished > 0)
        check.message += fmt::format("; {} wait for task {}", tally.unfinished, unfinished_task(replies.answers));
    if (!replies.problem.empty()) check.message += "; " + replies.problem;
    if (tally.unfinished < tally.asked && !tally.first_wrong.empty()) check.message += "; " + tally.first_wrong;
    return check;
}

}  // namespace rays::grader
