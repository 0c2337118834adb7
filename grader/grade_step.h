// One step, graded: its checks run, explained and added up.
#pragma once

#include <optional>
#include <string>

#include "grader/checks.h"
#include "grader/fingerprints.h"

namespace rays::grader {

struct StepOrder {
    Bench bench;
    std::filesystem::path all_mine;    ///< may be empty
    std::string build_error;           ///< not empty: nothing can be run
    std::filesystem::path submission;  ///< where the student's files are, for the lines in the result
    const StepFingerprints* fingerprints = nullptr;
    int workers = 1;
};

StepResult grade_step(const StepOrder& order);

/// The checks of a task share its points: questions 6, fresh scenes 2, sweeps together 2; what a task does not have
/// leaves its share to the others.
struct Shares {
    double unit = 0, fresh = 0, each_sweep = 0;
};
Shares shares_of(double points, bool unit, bool fresh, std::size_t sweeps);

/// The mutant that the student's answers look like, if any.
std::optional<KnownMutant> diagnose(const Bench& bench, const StepFingerprints& fingerprints);

std::vector<std::string> task_ids(const Step& step);

}  // namespace rays::grader
