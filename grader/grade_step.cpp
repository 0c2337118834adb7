#include "grader/grade_step.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <functional>

#include "grader/answers.h"
#include "grader/cost_maps.h"
#include "grader/course.h"
#include "grader/student_build.h"
#include "grader/verdicts.h"
#include "references/in_parallel.h"

namespace rays::grader {
namespace {

namespace fs = std::filesystem;

using CheckMaker = std::function<std::vector<Check>()>;

bool wrong(const Check& c) { return !c.waits && (c.verdict == Verdict::fail || c.verdict == Verdict::partial); }

std::vector<CheckMaker> task_checks(const StepOrder& order, const Task& task, const std::vector<Question>& questions,
                                    const std::vector<Sweep>& sweeps) {
    const auto is_its = [&](const auto& x) { return x.task == task.id; };
    const bool unit = std::any_of(questions.begin(), questions.end(), is_its), fresh = has_fresh_scenes(task.id);
    const Shares shares = shares_of(task.points, unit, fresh,
                                    static_cast<std::size_t>(std::count_if(sweeps.begin(), sweeps.end(), is_its)));
    const Bench& bench = order.bench;
    std::vector<CheckMaker> makers;
    if (unit) makers.push_back([&, shares] { return std::vector{unit_check(bench, task, questions, shares.unit)}; });
    if (fresh) makers.push_back([&, shares] { return std::vector{fresh_check(bench, task, shares.fresh)}; });
    for (const Sweep& sweep : sweeps) {
        if (!is_its(sweep)) continue;
        makers.push_back([&, shares] {
            static const std::vector<ChartSeries> none;
            const bool known = order.fingerprints && order.fingerprints->naive.count(sweep.id);
            return std::vector{
                sweep_check(bench, sweep, known ? order.fingerprints->naive.at(sweep.id) : none, shares.each_sweep)};
        });
    }
    return makers;
}

Check copied_as_all_mine(Check check) {
    check.id += ".all_mine";
    check.mode = "all mine";
    check.points = check.max = 0;
    return check;
}

// Where the step alone is wrong already, its picture among the student's other steps says nothing new.
std::vector<Check> picture_checks(const StepOrder& order, const SceneTask& scene) {
    std::vector<Check> checks{scene.statistical() ? statistical_check(order.bench, scene)
                                                  : image_check(order.bench, scene)};
    if (checks.front().verdict != Verdict::pass || order.all_mine.empty()) return checks;
    if (order.all_mine == order.bench.student) {
        checks.push_back(copied_as_all_mine(checks.front()));
        return checks;
    }
    checks.push_back(scene.statistical() ? statistical_all_mine_check(order.bench, scene, order.all_mine)
                                         : all_mine_check(order.bench, scene, order.all_mine));
    if (wrong(checks.back()))
        checks.back().message += "; with the solution's other steps it is right: another step of yours plays a part";
    return checks;
}

std::vector<Check> run_all(const std::vector<CheckMaker>& makers, int workers) {
    std::vector<std::vector<Check>> results(makers.size());
    in_parallel(makers.size(), workers, [&](std::size_t i) {
        try {
            results[i] = makers[i]();
        } catch (const std::exception& e) {
            Check broken;
            broken.id = "grader";
            broken.verdict = Verdict::infrastructure_error;
            broken.message = e.what();
            results[i] = {broken};
        }
    });
    std::vector<Check> checks;
    for (auto& list : results) checks.insert(checks.end(), list.begin(), list.end());
    return checks;
}

Check not_built(const std::string& id, const std::string& task, const std::string& kind, double max,
                const std::string& message) {
    Check check = new_check(id, task, kind, id, max);
    check.verdict = Verdict::build_error;
    check.message = message;
    return check;
}

std::vector<Check> build_error_checks(const Step& step, const std::string& message) {
    std::vector<Check> checks;
    for (const Task& t : step.tasks) checks.push_back(not_built(t.id + ".unit", t.id, "unit", t.points, message));
    for (const SceneTask& s : step.scenes)
        checks.push_back(not_built(fmt::format("{}.picture.{}", step.number, fs::path(s.scene).stem().string()),
                                   s.tasks.empty() ? "" : s.tasks.front(), s.statistical() ? "statistical" : "image",
                                   s.points, message));
    return checks;
}

// A picture known by heart is no ray tracing: it counts when a fresh scene of one of its tasks comes out right, too.
void withhold_unconfirmed_pictures(const Step& step, std::vector<Check>& checks) {
    for (const SceneTask& scene : step.scenes) {
        int right = 0;
        std::string asked;
        for (const Check& c : checks) {
            const bool its =
                c.kind == "fresh" && std::find(scene.tasks.begin(), scene.tasks.end(), c.task) != scene.tasks.end();
            if (its) asked += (asked.empty() ? "" : ", ") + c.task;
            right += its && (c.verdict == Verdict::pass || c.verdict == Verdict::partial);
        }
        for (Check& c : checks) {
            // A noisy picture may be right and yet too noisy: it has points, too.
            const bool earns = c.verdict == Verdict::pass || (c.kind == "statistical" && c.verdict == Verdict::partial);
            if (!is_picture(c) || c.mode != "isolated" || !earns || c.image->scene != scene.scene || asked.empty() ||
                right > 0)
                continue;
            c.points = 0;
            c.verdict = Verdict::partial;
            c.waits = true;
            c.message += fmt::format("; it does not count yet: no fresh scene of task {} is right so far", asked);
        }
    }
}

// A fresh scene needs more than its own task. Where nothing of that is written, a crash is another function's.
void forgive_unwritten_tasks(std::vector<Check>& checks) {
    const auto unwritten = [&](const std::string& task) {
        return std::any_of(checks.begin(), checks.end(), [&](const Check& c) {
            return c.task == task && c.kind == "unit" && c.verdict == Verdict::not_started;
        });
    };
    for (Check& c : checks) {
        if (c.kind != "fresh" || (c.verdict != Verdict::crash && c.verdict != Verdict::time_out)) continue;
        if (!unwritten(c.task)) continue;
        c.verdict = Verdict::not_started;
        c.message = fmt::format("task {} is not written yet, and another one stands in its way: {}", c.task, c.message);
    }
}

void add_mutant(const StepOrder& order, std::vector<Check>& checks) {
    if (!order.fingerprints || std::none_of(checks.begin(), checks.end(), wrong)) return;
    const auto mutant = diagnose(order.bench, *order.fingerprints);
    if (!mutant) return;
    const auto concerns = [&](const Check& c) { return wrong(c) && c.task == mutant->task; };
    const bool any = std::any_of(checks.begin(), checks.end(), concerns);
    for (Check& c : checks) {
        if (any ? !concerns(c) : !wrong(c)) continue;
        c.diagnosis.push_back({"mutant",
                               fmt::format("your answers equal those of a known mistake: {}{}", mutant->title,
                                           mutant->seen.empty() ? "" : " (seen as: " + mutant->seen + ")"),
                               mutant->id});
    }
}

// Who has not started gets the first hint, who is stuck all of them.
void add_hints(const Step& step, std::vector<Check>& checks) {
    for (Check& c : checks) {
        const Task* task = step.find(c.task);
        if (!task || c.mode != "isolated") continue;
        const std::size_t most = wrong(c) ? task->hints.size() : c.verdict == Verdict::not_started ? 1 : 0;
        for (std::size_t i = 0; i < std::min(most, task->hints.size()); ++i)
            c.diagnosis.push_back({"hint", task->hints[i], {}});
    }
}

// The line where the student still has to write, or the starter's comment above it.
int line_of(const fs::path& file, const std::string& task) {
    std::ifstream in(file);
    int number = 0, comment = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        if (line.find("unfinished(\"" + task + "\")") != std::string::npos) return number;
        if (comment == 0 && line.find("Task " + task + ":") != std::string::npos) comment = number;
    }
    return comment;
}

TaskResult task_result(const StepOrder& order, const Task& task, const std::vector<Check>& checks) {
    TaskResult result;
    result.id = task.id;
    result.title = task.title;
    result.max = task.points;
    std::vector<Verdict> verdicts;
    bool helped = false;
    for (const Check& c : checks) {
        if (c.task != task.id || is_picture(c)) continue;
        verdicts.push_back(c.verdict);
        result.points += c.points;
        helped = helped || wrong(c) || c.verdict == Verdict::crash || c.verdict == Verdict::time_out;
    }
    result.verdict = combine(verdicts);
    // What only waits for other tasks needs no hint, and neither does a mistake that the compiler has named.
    helped = helped || result.verdict == Verdict::not_started;
    if (helped && !task.hints.empty()) result.hint = task.hints.front();
    const std::string file = order.bench.step.id + "/" + task.file;
    result.file = "steps/" + file;
    result.line = line_of(submitted_file(order.bench.project, order.submission, file), task.id);
    return result;
}

// The picture, and the rays of the pixel that is most wrong: with the same sides as in the check.
std::string picture_command(const Check& c, int step) {
    const ImageResult& image = *c.image;
    const std::string view =
        fmt::format("--width {} --height {} --from {}", image.width, image.height,
                    c.mode == "isolated" ? fmt::format("student-{}", step) : "student") +
        (image.partition.empty() ? "" : " --partition " + image.partition) +
        (c.statistics ? fmt::format(" --pattern sobol --samples {} --seed 1", c.statistics->samples) : "");
    std::string text = fmt::format("./rays render scenes/{} -o picture.png {}", image.scene, view);
    if (image.beyond_rounding > 0)
        text +=
            fmt::format("\n./rays explain scenes/{} --pixel {},{} {}", image.scene, image.worst_x, image.worst_y, view);
    return text;
}

void add_reproduce(const StepOrder& order, std::vector<Check>& checks) {
    for (Check& c : checks)
        c.reproduce = is_picture(c) && c.image
                          ? picture_command(c, order.bench.step.number)
                          : fmt::format("./rays grade {} --seed {}", order.bench.step.number, order.bench.seed);
}

}  // namespace

std::vector<std::string> task_ids(const Step& step) {
    std::vector<std::string> ids;
    for (const Task& t : step.tasks) ids.push_back(t.id);
    return ids;
}

Shares shares_of(double points, bool unit, bool fresh, std::size_t sweeps) {
    constexpr double kUnit = 6, kFresh = 2, kSweeps = 2;
    const double whole = (unit ? kUnit : 0) + (fresh ? kFresh : 0) + (sweeps ? kSweeps : 0);
    if (whole == 0) return {};
    return {unit ? points * kUnit / whole : 0, fresh ? points * kFresh / whole : 0,
            sweeps ? points * kSweeps / whole / double(sweeps) : 0};
}

std::optional<KnownMutant> diagnose(const Bench& bench, const StepFingerprints& fingerprints) {
    const auto questions = diagnostic_questions(bench.step.number, task_ids(bench.step));
    if (questions_hash(questions) != fingerprints.questions) return {};
    std::vector<const Question*> asked;
    for (const Question& q : questions) asked.push_back(&q);
    const Replies student = ask(bench.sandbox, bench.student, asked, bench.limits);
    const Replies solution = ask(bench.sandbox, bench.solution, asked, bench.limits);
    return nearest_mutant(fingerprint(student.answers, solution.answers), fingerprints.mutants,
                          unfinished_questions(student.answers));
}

StepResult grade_step(const StepOrder& order) {
    const Step& step = order.bench.step;
    StepResult result{step.id, step.title, step.number, Verdict::fail, 0, step.points(), {}, {}};
    const auto questions = questions_of(step.number, order.bench.seed);
    const auto sweeps = sweeps_of(step.number, order.bench.seed);
    if (!order.build_error.empty()) {
        result.checks = build_error_checks(step, order.build_error);
    } else {
        std::vector<CheckMaker> makers;
        for (const Task& task : step.tasks)
            for (CheckMaker& maker : task_checks(order, task, questions, sweeps)) makers.push_back(std::move(maker));
        for (const SceneTask& scene : step.scenes) makers.push_back([&] { return picture_checks(order, scene); });
        result.checks = run_all(makers, order.workers);
        withhold_unconfirmed_pictures(step, result.checks);
        forgive_unwritten_tasks(result.checks);
        add_mutant(order, result.checks);
        add_hints(step, result.checks);
        result.cost_maps = map_costs(order.bench, order.workers);
    }
    add_reproduce(order, result.checks);
    std::vector<Verdict> verdicts;
    for (const Check& c : result.checks) {
        result.points += c.points;
        if (c.mode == "isolated") verdicts.push_back(c.verdict);
    }
    for (const Task& task : step.tasks) result.tasks.push_back(task_result(order, task, result.checks));
    result.verdict = combine(verdicts);
    return result;
}

}  // namespace rays::grader
