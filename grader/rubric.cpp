// From the points of steps to the rows of the assignment.
#include <fmt/format.h>

#include <algorithm>

#include "grader/grade.h"
#include "grader/submission/handed_in.h"

namespace rays::grader {
namespace {

struct Sum {
    double points = 0, max = 0;
    int missing_step = 0;  ///< a step that counts for the row but was not graded in this run
};

bool counts(const RubricRow& row, const Step& step, const std::string& task) {
    const Task* t = step.find(task);
    return t && std::find(row.counts.begin(), row.counts.end(), t->rubric) != row.counts.end();
}

void add_step(Sum& sum, const RubricRow& row, const Step& step, const StepResult& result) {
    for (const TaskResult& t : result.tasks) {
        if (!counts(row, step, t.id)) continue;
        sum.points += t.points;
        sum.max += t.max;
    }
    for (const Check& c : result.checks) {
        if (!is_picture(c) || !counts(row, step, c.task)) continue;
        sum.points += c.points;
        sum.max += c.max;
    }
}

bool is_handed_in(const RubricRow& row) { return row.id == "pictures" || row.id == "report"; }

RubricResult handed_in_row(const RubricRow& row, const std::optional<HandedIn>& handed_in) {
    RubricResult r{row.id, row.title, 0, row.points, row.extra, handed_in.has_value(), row.note};
    if (!handed_in) {
        r.note = "not graded in this run: comes with a submission (./rays submission) and all steps";
        return r;
    }
    for (const Check& c : handed_in->checks)
        if (row_of(c) == row.id) r.points += c.points;
    return r;
}

bool concerns(const RubricRow& row, const Step& step) {
    return std::any_of(step.tasks.begin(), step.tasks.end(), [&](const Task& t) { return counts(row, step, t.id); });
}

}  // namespace

std::vector<RubricResult> rubric_results(const Rubric& rubric, const std::vector<Step>& all_steps,
                                         const std::vector<StepResult>& graded,
                                         const std::optional<HandedIn>& handed_in) {
    std::vector<RubricResult> rows;
    for (const RubricRow& row : rubric.rows) {
        if (is_handed_in(row)) {
            rows.push_back(handed_in_row(row, handed_in));
            continue;
        }
        Sum sum;
        for (const Step& step : all_steps) {
            if (!concerns(row, step)) continue;
            const auto result =
                std::find_if(graded.begin(), graded.end(), [&](const StepResult& r) { return r.id == step.id; });
            if (result != graded.end())
                add_step(sum, row, step, *result);
            else
                sum.missing_step = step.number;
        }
        RubricResult r{row.id, row.title, 0, row.points, row.extra, true, row.note};
        r.graded = sum.max > 0 && !sum.missing_step;
        if (r.graded)
            r.points = row.points * sum.points / sum.max;
        else if (sum.missing_step)
            r.note = fmt::format("not graded in this run: needs step {}", sum.missing_step);
        else
            r.note = "not graded yet" + (row.note.empty() ? "" : ": " + row.note);
        rows.push_back(r);
    }
    return rows;
}

void add_up(Results& results, double extra_limit) {
    results.points = results.max = results.extra = 0;
    for (const RubricResult& row : results.rubric) {
        if (!row.graded) continue;
        if (row.extra) {
            results.extra = std::min(extra_limit, results.extra + row.points);
            continue;
        }
        results.points += row.points;
        results.max += row.max;
    }
}

}  // namespace rays::grader
