// One mutant: built, hunted by the checks, its answers taken down.
#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "grader/answers.h"
#include "grader/course.h"
#include "grader/fresh_scenes.h"
#include "grader/mutant_examination.h"
#include "support/files.h"

namespace rays::grader {
namespace {

namespace fs = std::filesystem;

// Fresh in every real run; fixed here, so that the table does not change from one run to the next.
constexpr std::uint64_t kSeed = 1;

std::vector<Answer> answers_of(const Setting& s, const fs::path& program, const std::vector<Question>& questions,
                               const Limits& limits, bool& infrastructure) {
    std::vector<const Question*> asked;
    for (const Question& q : questions) asked.push_back(&q);
    const Replies replies = ask(s.sandbox, program, asked, limits);
    infrastructure = infrastructure || replies.infrastructure;
    return replies.answers;
}

double seconds_for_all(const Setting& s, const std::vector<Question>& questions) {
    std::vector<const Question*> asked;
    for (const Question& q : questions) asked.push_back(&q);
    return ask(s.sandbox, s.project.program("render-solution"), asked, s.limits).ended.cpu_s;
}

fs::path build(const Setting& s, const Mutant& m) {
    const fs::path folder = s.folder / m.id;
    fs::create_directories(folder);
    const fs::path source = folder / fs::path(m.file).filename(), object = folder / "mutant.o";
    write_atomically(source, apply(m, read_file(s.project.root / "solutions" / m.file)));
    const Built compiled = s.builder.compile(m.file, source, object, "-O1");
    if (!compiled.good) throw InputError("does not compile: " + compiled.message);
    const Built program = s.builder.link({{m.file, object}}, folder / "render");
    if (!program.good) throw InputError("does not link: " + program.message);
    return program.file;
}

bool caught(const Check& c) { return c.verdict != Verdict::pass; }

/// Runs checks until one catches the mutant; a variant has to go through all of them.
class Hunt {
public:
    Hunt(const Bench& bench, const Stage& stage, Outcome& outcome) : bench_(bench), stage_(stage), outcome_(outcome) {}

    void run() {
        const bool variant = outcome_.mutant.kind == Mutant::Kind::variant;
        own_task();
        if (!variant && !outcome_.caught_by.empty()) return;
        other_units();
        if (!variant && !outcome_.caught_by.empty()) return;
        for (const SceneTask& scene : stage_.step.scenes) {
            // Noisy pictures take seconds: those of its own task, and whatever shows several tasks together.
            const bool is_its =
                std::find(scene.tasks.begin(), scene.tasks.end(), outcome_.mutant.task) != scene.tasks.end();
            if (scene.samples > 0 && !is_its && scene.tasks.size() < 3) continue;
            note(scene.samples > 0 ? statistical_check(bench_, scene) : image_check(bench_, scene));
            if (!variant && !outcome_.caught_by.empty()) return;
        }
        for (const Task& task : stage_.step.tasks) {
            if (task.id == outcome_.mutant.task) continue;
            if (has_fresh_scenes(task.id) && !has_noisy_fresh_scenes(task.id)) note(fresh_check(bench_, task, 1));
            for (const Sweep& sweep : stage_.sweeps)
                if (sweep.task == task.id) note(sweep_check(bench_, sweep, {}, 1));
            if (!variant && !outcome_.caught_by.empty()) return;
        }
    }

private:
    void own_task() {
        const Task* task = stage_.step.find(outcome_.mutant.task);
        if (!task) throw InputError("its task is not in step.json");
        note(unit_check(bench_, *task, stage_.questions, 1));
        const bool variant = outcome_.mutant.kind == Mutant::Kind::variant;
        for (const Sweep& sweep : stage_.sweeps)
            if (sweep.task == task->id && (variant || outcome_.caught_by.empty()))
                note(sweep_check(bench_, sweep, {}, 1));
        if (has_fresh_scenes(task->id) && (variant || outcome_.caught_by.empty())) note(fresh_check(bench_, *task, 1));
        outcome_.by_own_task = !outcome_.caught_by.empty();
    }

    // One process for all: which task's question caught it is told by the question.
    void other_units() {
        std::vector<const Question*> asked;
        for (const Question& q : stage_.questions)
            if (q.task != outcome_.mutant.task) asked.push_back(&q);
        const Replies replies = ask(bench_.sandbox, bench_.student, asked, bench_.limits);
        for (std::size_t i = 0; i < asked.size(); ++i) {
            const std::string id = asked[i]->task + ".unit";
            if (!asked[i]->judge(replies.answers[i]).ok &&
                std::find(outcome_.caught_by.begin(), outcome_.caught_by.end(), id) == outcome_.caught_by.end())
                outcome_.caught_by.push_back(id);
        }
    }

    void note(const Check& c) {
        if (c.verdict == Verdict::infrastructure_error) throw std::runtime_error(c.id + ": " + c.message);
        if (caught(c)) outcome_.caught_by.push_back(c.id);
    }

    const Bench& bench_;
    const Stage& stage_;
    Outcome& outcome_;
};

void chart_naive(const Bench& bench, const Stage& stage, Outcome& outcome) {
    for (const Sweep& sweep : stage.sweeps) {
        if (outcome.mutant.sweep.empty() ? sweep.task != outcome.mutant.task : sweep.id != outcome.mutant.sweep)
            continue;
        const Check check = sweep_check(bench, sweep, {}, 1);
        for (ChartSeries series : check.chart->series) {
            if (series.role != "student") continue;
            series.name = outcome.mutant.title;
            series.role = "naive";
            outcome.naive[sweep.id] = series;
        }
        if (caught(check)) outcome.caught_by.push_back(check.id);
    }
}

}  // namespace

int step_of(const Mutant& m) { return std::atoi(m.task.c_str()); }

Stage make_stage(const Setting& s, const Step& step) {
    Stage stage{step,
                questions_of(step.number, kSeed),
                diagnostic_questions(step.number, task_ids(step)),
                sweeps_of(step.number, kSeed),
                {},
                s.limits};
    bool infrastructure = false;
    stage.solution = answers_of(s, s.project.program("render-solution"), stage.diagnostic, s.limits, infrastructure);
    if (infrastructure) throw std::runtime_error("render-solution cannot be run: build it first");
    // What loops costs its limit, several times over. Measured, no run of a right program takes more than 0.3 s or, in
    // step 4, than all questions together: seven times that is no mistake's slowness.
    if (!s.project.sanitized())
        stage.limits.cpu_s = std::min(s.limits.cpu_s, 2 + 4 * seconds_for_all(s, stage.questions));
    return stage;
}

void examine(const Setting& s, const Stage& stage, Outcome& outcome) {
    const fs::path program = build(s, outcome.mutant);
    const Bench bench{s.project, s.sandbox,    stage.step, s.project.program("render-solution"), program, {},
                      kSeed,     stage.limits, false};
    if (outcome.mutant.kind == Mutant::Kind::naive) return chart_naive(bench, stage, outcome);
    Hunt(bench, stage, outcome).run();
    if (outcome.mutant.kind == Mutant::Kind::variant) return;
    bool infrastructure = false;
    outcome.fingerprint =
        fingerprint(answers_of(s, program, stage.diagnostic, stage.limits, infrastructure), stage.solution);
}

}  // namespace rays::grader
