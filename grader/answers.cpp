#include "grader/answers.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "grader/text.h"
#include "grader/verdicts.h"

namespace rays::grader {
namespace {

/// All answers of step 5 together are some 20 MB of points.
constexpr int kMostText_mb = 64;
constexpr int kMostLosses = 4;
// Where several tasks are asked at once none may use up all of them: what crashes in every scene of one task may well
// answer the small questions of the next.
constexpr int kMostLossesOfOneOfMany = 2;

std::vector<std::string_view> lines_of(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const auto end = text.find('\n');
        if (end == std::string_view::npos) break;  // a line without its end was cut off
        lines.push_back(text.substr(0, end));
        text.remove_prefix(end + 1);
    }
    return lines;
}

struct Run {
    Ended ended;
    std::vector<Answer> answers;  ///< those that came
    bool surplus = false;         ///< more lines than questions
};

Run run_once(const Sandbox& sandbox, const std::filesystem::path& program,
             const std::vector<const Question*>& questions, const Limits& limits) {
    Run run;
    Job job;
    job.program = program;
    job.arguments = {"--answer"};
    job.input = question_text(questions);
    job.limits = limits;
    job.limits.text_mb = std::max(limits.text_mb, kMostText_mb);
    run.ended = sandbox.run(job).ended;
    const auto lines = lines_of(run.ended.out);
    run.surplus = lines.size() > questions.size();
    for (std::size_t i = 0; i < std::min(lines.size(), questions.size()); ++i)
        run.answers.push_back(parse_answer(lines[i]));
    return run;
}

void ask_one_by_one(const Sandbox& sandbox, const std::filesystem::path& program,
                    const std::vector<const Question*>& questions, Limits limits, Replies& replies) {
    limits.wall_s = std::min(limits.wall_s, 5.0);
    limits.cpu_s = std::min(limits.cpu_s / 4, 4.0);
    const bool of_many = std::any_of(questions.begin(), questions.end(),
                                     [&](const Question* q) { return q->task != questions.front()->task; });
    const int most_of_task = of_many ? kMostLossesOfOneOfMany : kMostLosses;
    int losses = 0;
    std::map<std::string, int> of_task;
    for (std::size_t i = 0; i < questions.size() && losses < kMostLosses; ++i) {
        if (replies.answers[i].came() || of_task[questions[i]->task] == most_of_task) continue;
        Run run = run_once(sandbox, program, {questions[i]}, limits);
        if (run.ended.ok() && run.answers.size() == 1 && !run.surplus) {
            replies.answers[i] = run.answers[0];
        } else {
            replies.answers[i].kind = Answer::Kind::lost;
            ++losses, ++of_task[questions[i]->task];
        }
    }
}

}  // namespace

std::string shown_answer(const Answer& answer, const Replies& replies, std::size_t limit) {
    if (answer.came()) return answer.text.empty() ? "an empty line" : plain(answer.text, limit);
    if (replies.ended.timed_out) return "no answer (the program had run out of time)";
    return replies.ended.signal ? "no answer (the program had crashed)" : "no answer";
}

std::string unfinished_task(const std::vector<Answer>& answers) {
    for (const Answer& a : answers)
        if (a.kind == Answer::Kind::unfinished) return plain(a.text.substr(std::string("unfinished ").size()), 12);
    return {};
}

Replies ask(const Sandbox& sandbox, const std::filesystem::path& program, const std::vector<const Question*>& questions,
            const Limits& limits) {
    Replies replies;
    replies.answers.resize(questions.size());
    if (questions.empty()) return replies;
    Run run = run_once(sandbox, program, questions, limits);
    replies.ended = run.ended;
    replies.infrastructure = !run.ended.started;
    if (replies.infrastructure) {
        replies.problem = run.ended.problem;
        return replies;
    }
    if (run.surplus) {
        // No line can be trusted to be the answer to its question.
        replies.problem = fmt::format(
            "more lines than the {} questions asked: does your code write to descriptors that are not its own?",
            questions.size());
        return replies;
    }
    const bool whole = run.ended.ok() && run.answers.size() == questions.size();
    std::copy(run.answers.begin(), run.answers.end(), replies.answers.begin());
    if (whole) return replies;
    if (run.ended.ok()) {
        replies.problem = fmt::format("{} answers to {} questions", run.answers.size(), questions.size());
        return replies;
    }
    replies.problem = "the program " + how_it_ended(run.ended);
    if (run.ended.signal && !run.ended.timed_out) replies.problem += kFindTheCrash;
    if (run.ended.exit > 0) replies.problem += ": " + plain(run.ended.err);
    ask_one_by_one(sandbox, program, questions, limits, replies);
    return replies;
}

}  // namespace rays::grader
