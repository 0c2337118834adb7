// Processor time of whole processes, from start to exit, compared in turns.
#pragma once

#include <vector>

#include "statistics.h"
#include "support/process.h"

namespace rays::bench {

/// Runs every command `rounds` times, in turns: first to last in one round, last to first in the next, so that a slow
/// moment of the machine meets all of them. Returns the user and system time of each run, children included: one list a
/// command, one value a round. Clock time is never looked at: POV-Ray waits most of it.
/// Throws std::runtime_error with the command's own words when a run fails.
std::vector<std::vector<double>> time_in_turns(const std::vector<Command>& commands, int rounds);

struct PairedTimes {
    Spread first_s, second_s;  ///< user and system time, children included
    Spread ratio;              ///< of the first's to the second's, pair by pair
};

/// From the times of two commands, round by round.
PairedTimes paired(const std::vector<double>& first, const std::vector<double>& second);

/// Runs both commands in turns, after one run of each that does not count. Throws as time_in_turns.
PairedTimes time_in_pairs(const Command& first, const Command& second, int rounds);

/// One run: its processor time and its standard output. Throws as time_in_turns.
Ended run_or_throw(const Command& command);

}  // namespace rays::bench
