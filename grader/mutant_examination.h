// One mutant: built, hunted by the checks, its answers taken down.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "grader/build.h"
#include "grader/fingerprints.h"
#include "grader/grade_step.h"
#include "grader/mutants.h"

namespace rays::grader {

/// What all mutants of a step share.
struct Stage {
    const Step& step;
    std::vector<Question> questions, diagnostic;
    std::vector<Sweep> sweeps;
    std::vector<Answer> solution;  ///< to the diagnostic questions
    Limits limits;                 ///< of one run of a mutant
};

struct Setting {
    const Project& project;
    const Sandbox& sandbox;
    const Builder& builder;
    std::filesystem::path folder;
    Limits limits;
};

struct Outcome {
    Mutant mutant;
    std::string problem;                 ///< it does not apply or compile, or a check could not be run
    std::vector<std::string> caught_by;  ///< ids of checks, the task's own first
    bool by_own_task = false;            ///< was it caught by a check of the task it belongs to?
    std::string named;                   ///< id of the mutant that the diagnosis names
    double seconds = 0;
    Fingerprint fingerprint;
    std::map<std::string, ChartSeries> naive;  ///< by sweep
};

int step_of(const Mutant& mutant);

/// Throws std::runtime_error when the solution's program cannot be run.
Stage make_stage(const Setting& setting, const Step& step);

/// Builds the mutant and runs checks: its own task's first, the others' until one catches it. A variant has to go
/// through all of them, a naive method through the sweeps. Throws for whatever makes it no mutant.
void examine(const Setting& setting, const Stage& stage, Outcome& outcome);

}  // namespace rays::grader
