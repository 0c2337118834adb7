#include "grader/mutant_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "core/error.h"
#include "grader/answers.h"
#include "grader/build.h"
#include "grader/course.h"
#include "grader/grade_step.h"
#include "grader/text.h"
#include "references/files.h"
#include "references/in_parallel.h"

namespace rays::grader {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

// Fresh in every real run; fixed here, so that the table does not change from one run to the next.
constexpr std::uint64_t kSeed = 1;

/// A mutant that loops costs its time limit: far above what a right program takes for any of these runs.
constexpr Limits kMutantLimits{10, 15, 2048, 64, 64, 8};

/// What all mutants of a step share.
struct Stage {
    const Step& step;
    std::vector<Question> questions, diagnostic;
    std::vector<Sweep> sweeps;
    std::vector<Answer> solution;  ///< to the diagnostic questions
};

struct Setting {
    const Project& project;
    const Sandbox& sandbox;
    const Builder& builder;
    const Fingerprints& known;
    fs::path folder;
    Limits limits;
};

struct Outcome : MutantOutcome {
    Fingerprint fingerprint;
    std::map<std::string, ChartSeries> naive;  ///< by sweep
};

int step_of(const Mutant& m) { return std::atoi(m.task.c_str()); }

std::vector<Answer> answers_of(const Setting& s, const fs::path& program, const std::vector<Question>& questions, bool& infrastructure) {
    std::vector<const Question*> asked;
    for (const Question& q : questions) asked.push_back(&q);
    const Replies replies = ask(s.sandbox, program, asked, s.limits);
    infrastructure = infrastructure || replies.infrastructure;
    return replies.answers;
}

Stage make_stage(const Setting& s, const Step& step) {
    Stage stage{step, questions_of(step.number, kSeed), diagnostic_questions(step.number, task_ids(step)), sweeps_of(step.number, kSeed), {}};
    bool infrastructure = false;
    stage.solution = answers_of(s, s.project.program("render-solution"), stage.diagnostic, infrastructure);
    if (infrastructure) throw std::runtime_error("render-solution cannot be run: build it first");
    return stage;
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
            note(image_check(bench_, scene));
            if (!variant && !outcome_.caught_by.empty()) return;
        }
        for (const Task& task : stage_.step.tasks) {
            if (task.id == outcome_.mutant.task) continue;
            if (has_fresh_scenes(task.id)) note(fresh_check(bench_, task, 1));
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
            if (sweep.task == task->id && (variant || outcome_.caught_by.empty())) note(sweep_check(bench_, sweep, {}, 1));
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
            if (!asked[i]->judge(replies.answers[i]).ok && std::find(outcome_.caught_by.begin(), outcome_.caught_by.end(), id) == outcome_.caught_by.end())
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
        if (outcome.mutant.sweep.empty() ? sweep.task != outcome.mutant.task : sweep.id != outcome.mutant.sweep) continue;
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

void examine(const Setting& s, const Stage& stage, Outcome& outcome) {
    const fs::path program = build(s, outcome.mutant);
    const Bench bench{s.project, s.sandbox, stage.step, s.project.program("render-solution"), program, {}, kSeed, s.limits, false};
    if (outcome.mutant.kind == Mutant::Kind::naive) return chart_naive(bench, stage, outcome);
    Hunt(bench, stage, outcome).run();
    if (outcome.mutant.kind == Mutant::Kind::variant) return;
    bool infrastructure = false;
    outcome.fingerprint = fingerprint(answers_of(s, program, stage.diagnostic, infrastructure), stage.solution);
}

const char* kind_text(Mutant::Kind kind) { return kind == Mutant::Kind::mutant ? "mutant" : kind == Mutant::Kind::variant ? "variant" : "naive"; }

std::string joined(const std::vector<std::string>& words, std::size_t most) {
    std::string text;
    for (std::size_t i = 0; i < std::min(words.size(), most); ++i) text += (i ? ", " : "") + words[i];
    return text + (words.size() > most ? fmt::format(", and {} more", words.size() - most) : "");
}

std::string verdict_text(const Outcome& o) {
    if (!o.problem.empty()) return "BROKEN: " + plain_lines(o.problem, 2000);
    const std::string by = joined(o.caught_by, 3);
    switch (o.mutant.kind) {
        case Mutant::Kind::variant: return o.caught_by.empty() ? "unhurt" : "HURT by " + by;
        case Mutant::Kind::naive: return o.naive.empty() ? "NO SWEEP" : o.caught_by.empty() ? "charted" : "charted, fails " + by;
        default: break;
    }
    if (o.caught_by.empty()) return "NOT CAUGHT";
    return fmt::format("caught by {}{}; {}", by, o.by_own_task ? "" : " (not its own task's)",
                       o.named == o.mutant.id ? "named" : o.named.empty() ? "NOT NAMED" : "NAMED AS " + o.named);
}

struct Score {
    int mutants = 0, caught = 0, by_own_task = 0, named = 0, variants = 0, hurt = 0, broken = 0;

    bool good() const { return broken == 0 && caught == mutants && 10 * named >= 9 * mutants && hurt == 0; }
};

Score score_of(const std::vector<Outcome>& outcomes) {
    Score score;
    for (const Outcome& o : outcomes) {
        score.broken += !o.problem.empty();
        if (o.mutant.kind == Mutant::Kind::variant) {
            ++score.variants;
            score.hurt += !o.caught_by.empty();
        } else if (o.mutant.kind == Mutant::Kind::mutant) {
            ++score.mutants;
            score.caught += !o.caught_by.empty();
            score.by_own_task += o.by_own_task;
            score.named += o.named == o.mutant.id;
        } else {
            score.broken += o.problem.empty() && o.naive.empty();
        }
    }
    return score;
}

Fingerprints fingerprints_of(const std::vector<Outcome>& outcomes, const std::map<int, Stage>& stages) {
    Fingerprints all;
    for (const auto& [number, stage] : stages) all.steps[number].questions = questions_hash(stage.diagnostic);
    for (const Outcome& o : outcomes) {
        StepFingerprints& step = all.steps[step_of(o.mutant)];
        if (o.mutant.kind == Mutant::Kind::mutant && o.problem.empty()) step.mutants.push_back({o.mutant.id, o.mutant.task, o.mutant.title, o.mutant.seen, o.fingerprint});
        for (const auto& [sweep, series] : o.naive) step.naive[sweep].push_back(series);
    }
    return all;
}

void name(std::vector<Outcome>& outcomes, const Fingerprints& known, const std::map<int, Stage>& stages) {
    for (Outcome& o : outcomes) {
        const auto step = known.steps.find(step_of(o.mutant));
        if (o.mutant.kind != Mutant::Kind::mutant || step == known.steps.end()) continue;
        if (step->second.questions != questions_hash(stages.at(step_of(o.mutant)).diagnostic)) continue;
        if (const auto mutant = nearest_mutant(o.fingerprint, step->second.mutants)) o.named = mutant->id;
    }
}

void write_json(const fs::path& file, const std::vector<Outcome>& outcomes, const Score& score, double seconds) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Outcome& o : outcomes)
        list.push_back({{"id", o.mutant.id}, {"kind", kind_text(o.mutant.kind)}, {"task", o.mutant.task}, {"title", o.mutant.title}, {"caught_by", o.caught_by},
                        {"by_own_task", o.by_own_task}, {"named", o.named}, {"problem", plain_lines(o.problem)}, {"seconds", o.seconds}});
    const nlohmann::ordered_json json{{"mutants", score.mutants}, {"caught", score.caught}, {"by_own_task", score.by_own_task}, {"named", score.named},
                                      {"variants", score.variants}, {"hurt", score.hurt}, {"broken", score.broken}, {"seconds", seconds}, {"outcomes", list}};
    write_atomically(file, json.dump(1) + "\n");
}

std::vector<Outcome> wanted(const Project& project, const MutantOptions& options) {
    std::vector<Outcome> list;
    for (Mutant& m : read_mutants(project.mutants())) {
        const bool step = options.steps.empty() || std::find(options.steps.begin(), options.steps.end(), step_of(m)) != options.steps.end();
        const bool id = options.only.empty() || std::find(options.only.begin(), options.only.end(), m.id) != options.only.end();
        if (!step || !id) continue;
        Outcome outcome;
        outcome.mutant = std::move(m);
        list.push_back(std::move(outcome));
    }
    if (list.empty()) throw InputError(project.mutants().string() + ": no such mutants");
    return list;
}

// Fingerprints of the steps that were not run stay.
void update(const fs::path& file, const Fingerprints& fresh) {
    Fingerprints all = read_fingerprints(file);
    for (const auto& [number, step] : fresh.steps) all.steps[number] = step;
    write_fingerprints(all, file);
}

}  // namespace

int run_mutants(const Project& project, const MutantOptions& options) {
    if (options.update && !options.only.empty()) throw InputError("--update needs all mutants of a step: leave out --only");
    const auto begin = Clock::now();
    std::vector<Outcome> outcomes = wanted(project, options);
    const auto steps = read_steps(project.steps());
    const auto sandbox = make_sandbox();
    const Builder builder(project);
    const fs::path fingerprint_file = project.mutants() / "fingerprints.json";
    const Fingerprints known = options.update ? Fingerprints() : read_fingerprints(fingerprint_file);
    Limits limits = kMutantLimits;
    if (project.sanitized()) limits.memory_mb = 0;
    const Setting setting{project, *sandbox, builder, known, project.build / "mutants", limits};
    std::map<int, Stage> stages;
    for (const Step& step : steps)
        if (std::any_of(outcomes.begin(), outcomes.end(), [&](const Outcome& o) { return step_of(o.mutant) == step.number; })) stages.emplace(step.number, make_stage(setting, step));
    in_parallel(outcomes.size(), std::max(2, static_cast<int>(std::thread::hardware_concurrency())), [&](std::size_t i) {
        Outcome& o = outcomes[i];
        const auto start = Clock::now();
        try {
            const auto stage = stages.find(step_of(o.mutant));
            if (stage == stages.end()) throw InputError("there is no step for task " + o.mutant.task);
            examine(setting, stage->second, o);
        } catch (const std::exception& e) {
            o.problem = e.what();
        }
        o.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    });
    const Fingerprints fresh = fingerprints_of(outcomes, stages);
    if (options.update) update(fingerprint_file, fresh);
    name(outcomes, options.update ? fresh : known, stages);
    for (const Outcome& o : outcomes)
        fmt::print("{:<8} {:<8} {:5.1f} s  {}  ({})\n", o.mutant.id, kind_text(o.mutant.kind), o.seconds, verdict_text(o), o.mutant.title);
    const Score score = score_of(outcomes);
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    fmt::print("\n{} of {} mutants caught ({} by a check of their own task), {} named right, {} of {} correct variants hurt, {} broken; {:.0f} s\n", score.caught,
               score.mutants, score.by_own_task, score.named, score.hurt, score.variants, score.broken, seconds);
    if (!options.json.empty()) write_json(options.json, outcomes, score, seconds);
    return score.good() ? kSuccess : kCheckFailed;
}

}  // namespace rays::grader
