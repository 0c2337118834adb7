// From the points of steps to the rows of the assignment.
#include <fmt/format.h>

#include <algorithm>

#include "grader/grade.h"

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
        if (c.kind != "image" || !counts(row, step, c.task)) continue;
        sum.points += c.points;
        sum.max += c.max;
    }
}

bool concerns(const RubricRow& row, const Step& step) {
    return std::any_of(step.tasks.begin(), step.tasks.end(), [&](const Task& t) { return counts(row, step, t.id); });
}

}  // namespace

std::vector<RubricResult> rubric_results(const Rubric& rubric, const std::vector<Step>& all_steps,
                                         const std::vector<StepResult>& graded) {
    std::vector<RubricResult> rows;
    for (const RubricRow& row : rubric.rows) {
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

void add_up(Results& results) {
    results.points = results.max = 0;
    for (const RubricResult& row : results.rubric) {
        if (!row.graded || row.extra) continue;
        results.points += row.points;
        results.max += row.max;
    }
}

}  // namespace rays::grader
