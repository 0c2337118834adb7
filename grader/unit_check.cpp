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

    int answered() const { return asked - unfinished - missing; }
    bool none_wrong() const { return right + unfinished == asked; }
    /// What crashed on the way to an unwritten task is another one's.
    bool not_begun() const { return unfinished > 0 && answered() == 0; }
};

using Shown = std::vector<AskedQuestion>;

Tally judge(const std::vector<const Question*>& questions, const Replies& replies, Check& check) {
    Tally tally;
    Shown wrong, unfinished, right;
    const auto show = [&](Shown& list, std::size_t most, std::size_t i, const Judgement& j) {
        if (list.size() == most) return;
        const Question& q = *questions[i];
        list.push_back({q.about, q.query, plain_lines(q.scene, kShownScene), j.expected,
                        shown_answer(replies.answers[i], replies, 200), j.ok});
    };
    for (std::size_t i = 0; i < questions.size(); ++i) {
        const Answer& answer = replies.answers[i];
        const Judgement j = questions[i]->judge(answer);
        const bool waits = answer.kind == Answer::Kind::unfinished;
        ++tally.asked;
        tally.right += j.ok;
        tally.unfinished += waits;
        tally.missing += !answer.came();
        if (j.ok)
            show(right, kShownRight, i, j);
        else
            show(waits ? unfinished : wrong, kShownWrong, i, j);
        if (!j.ok && !waits && tally.first_wrong.empty())
            tally.first_wrong = fmt::format("{}: expected {}, got {}", questions[i]->about, j.expected,
                                            shown_answer(answer, replies, 120));
    }
    // What waits for another task is shown where nothing is wrong.
    for (const Shown* list : {wrong.empty() ? &unfinished : &wrong, &right})
        check.questions.insert(check.questions.end(), list->begin(), list->end());
    return tally;
}

std::string counted(const Tally& t, const std::string& task) {
    if (t.unfinished == 0) return fmt::format("{} of {} questions answered right", t.right, t.asked);
    if (t.unfinished == t.asked) return fmt::format("all {} questions wait for task {}", t.asked, task);
    return fmt::format("{} of {} answered questions right; {} wait for task {}", t.right, t.answered(), t.unfinished,
                       task);
}

Verdict verdict_of(const Tally& t, const Replies& replies) {
    if (t.right == t.asked && t.asked > 0) return Verdict::pass;
    if (t.not_begun()) return Verdict::not_started;
    if (t.missing > 0 && replies.ended.timed_out) return Verdict::time_out;
    if (t.missing > 0 && replies.ended.signal) return Verdict::crash;
    if (t.none_wrong()) return Verdict::partial;
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
    const Tally tally = judge(asked, replies, check);
    check.verdict = verdict_of(tally, replies);
    check.points = tally.asked ? points_for(double(tally.right) / tally.asked, max) : 0;
    check.waits = tally.unfinished > 0 && tally.none_wrong();
    check.message = counted(tally, unfinished_task(replies.answers));
    if (!replies.problem.empty()) check.message += "; " + replies.problem;
    if (!tally.first_wrong.empty() && !tally.not_begun()) check.message += "; " + tally.first_wrong;
    return check;
}

}  // namespace rays::grader
