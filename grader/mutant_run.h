// `rays mutants`: is every typical mistake caught, by the check meant for it, and named?
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/project.h"

namespace rays::grader {

struct MutantOptions {
    std::vector<int> steps;         ///< empty: all
    std::vector<std::string> only;  ///< ids; empty: all
    bool update = false;            ///< write fingerprints.json
    std::filesystem::path json;
};

/// 0 when every mutant is caught, nine of ten are named right, and no variant loses a point; else 1.
int run_mutants(const Project& project, const MutantOptions& options);

}  // namespace rays::grader
