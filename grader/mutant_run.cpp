#include "grader/mutant_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "core/error.h"
#include "grader/mutant_examination.h"
#include "grader/text.h"
#include "references/in_parallel.h"
#include "support/files.h"

namespace rays::grader {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// A mutant that loops costs its time limit, and one that fills the memory the time to fill it: both are far above what
/// a right program takes for any of these runs (less than 160 MB).
constexpr Limits kMutantLimits{5, 15, 512, 64, 64, 8};

const char* kind_text(Mutant::Kind kind) {
    return kind == Mutant::Kind::mutant ? "mutant" : kind == Mutant::Kind::variant ? "variant" : "naive";
}

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
        case Mutant::Kind::naive:
            return o.naive.empty() ? "NO SWEEP" : o.caught_by.empty() ? "charted" : "charted, fails " + by;
        default: break;
    }
    if (o.caught_by.empty()) return "NOT CAUGHT";
    return fmt::format("caught by {}{}; {}", by, o.by_own_task ? "" : " (not its own task's)",
                       o.named == o.mutant.id ? "named"
                       : o.named.empty()      ? "NOT NAMED"
                                              : "NAMED AS " + o.named);
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
        if (o.mutant.kind == Mutant::Kind::mutant && o.problem.empty())
            step.mutants.push_back({o.mutant.id, o.mutant.task, o.mutant.title, o.mutant.seen, o.fingerprint});
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
        list.push_back({{"id", o.mutant.id},
                        {"kind", kind_text(o.mutant.kind)},
                        {"task", o.mutant.task},
                        {"title", o.mutant.title},
                        {"caught_by", o.caught_by},
                        {"by_own_task", o.by_own_task},
                        {"named", o.named},
                        {"problem", plain_lines(o.problem)},
                        {"seconds", o.seconds}});
    const nlohmann::ordered_json json{
        {"mutants", score.mutants}, {"caught", score.caught},     {"by_own_task", score.by_own_task},
        {"named", score.named},     {"variants", score.variants}, {"hurt", score.hurt},
        {"broken", score.broken},   {"seconds", seconds},         {"outcomes", list}};
    write_atomically(file, json.dump(1) + "\n");
}

std::vector<Outcome> wanted(const Project& project, const MutantOptions& options) {
    std::vector<Outcome> list;
    for (Mutant& m : read_mutants(project.mutants())) {
        const bool step = options.steps.empty() ||
                          std::find(options.steps.begin(), options.steps.end(), step_of(m)) != options.steps.end();
        const bool id =
            options.only.empty() || std::find(options.only.begin(), options.only.end(), m.id) != options.only.end();
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
    if (options.update && !options.only.empty())
        throw InputError("--update needs all mutants of a step: leave out --only");
    const auto begin = Clock::now();
    std::vector<Outcome> outcomes = wanted(project, options);
    const auto steps = read_steps(project.steps());
    const auto sandbox = make_sandbox();
    const Builder builder(project);
    const fs::path fingerprint_file = project.mutants() / "fingerprints.json";
    const Fingerprints known = options.update ? Fingerprints() : read_fingerprints(fingerprint_file);
    Limits limits = kMutantLimits;
    if (project.sanitized()) limits.memory_mb = 0;
    const Setting setting{project, *sandbox, builder, project.build / "mutants", limits};
    std::map<int, Stage> stages;
    for (const Step& step : steps)
        if (std::any_of(outcomes.begin(), outcomes.end(),
                        [&](const Outcome& o) { return step_of(o.mutant) == step.number; }))
            stages.emplace(step.number, make_stage(setting, step));
    in_parallel(outcomes.size(), std::max(2, static_cast<int>(std::thread::hardware_concurrency())),
                [&](std::size_t i) {
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
        fmt::print("{:<8} {:<8} {:5.1f} s  {}  ({})\n", o.mutant.id, kind_text(o.mutant.kind), o.seconds,
                   verdict_text(o), o.mutant.title);
    const Score score = score_of(outcomes);
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    fmt::print(
        "\n{} of {} mutants caught ({} by a check of their own task), {} named right, {} of {} correct variants hurt, "
        "{} broken; {:.0f} s\n",
        score.caught, score.mutants, score.by_own_task, score.named, score.hurt, score.variants, score.broken, seconds);
    if (!options.json.empty()) write_json(options.json, outcomes, score, seconds);
    return score.good() ? kSuccess : kCheckFailed;
}

}  // namespace rays::grader
