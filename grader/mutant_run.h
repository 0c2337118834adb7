// `rays mutants`: is every typical mistake caught, by the check meant for it, and named?
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/mutants.h"
#include "grader/project.h"

namespace rays::grader {

struct MutantOptions {
    std::vector<int> steps;  ///< empty: all
    std::vector<std::string> only;  ///< ids; empty: all
    bool update = false;     ///< write fingerprints.json
    std::filesystem::path json;
};

struct MutantOutcome {
    Mutant mutant;
    std::string problem;          ///< it does not apply or compile, or a check could not be run
    std::vector<std::string> caught_by;  ///< ids of checks, the task's own first
    bool by_own_task = false;     ///< was it caught by a check of the task it belongs to?
    std::string named;            ///< id of the mutant that the diagnosis names
    double seconds = 0;
};

/// 0 when every mutant is caught, nine of ten are named right, and no variant loses a point; else 1.
int run_mutants(const Project& project, const MutantOptions& options);

}  // namespace rays::grader
