// How a run of a program ended, as a verdict.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grader/results.h"
#include "support/process.h"

namespace rays::grader {

/// What every message about a crash ends with.
inline constexpr const char* kFindTheCrash = "; build with the debug preset to see the line: steps/README.md";

struct Finding {
    Verdict verdict;
    std::string message;
};

/// What stands against a run before one looks at its output: not started, a signal, time, a flood of text, a failure
/// status. Nothing when it ended well.
std::optional<Finding> against_run(const Ended& ended);

/// The tasks that a program's own statistics call unfinished: "1.3", with file and line. `stats` is hostile text.
struct UnfinishedPlace {
    std::string task, file;
    int line = 0;
};
std::vector<UnfinishedPlace> unfinished_places(const std::string& stats);

/// One verdict for many: all alike, or partial when some passed, or the worst.
Verdict combine(const std::vector<Verdict>& verdicts);

}  // namespace rays::grader
