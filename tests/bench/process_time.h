// Processor time of whole processes, from start to exit, compared in pairs.
#pragma once

#include "statistics.h"
#include "support/process.h"

namespace rays::bench {

struct PairedTimes {
    Spread first_s, second_s;  ///< user and system time, children included
    Spread ratio;              ///< of the first's to the second's, pair by pair
};

/// Runs both commands `rounds` times in turns (first second, second first, ...), so that a slow moment of the machine
/// meets both, after one run of each that does not count. Clock time is never looked at: POV-Ray waits most of it.
/// Throws std::runtime_error with the command's own words when a run fails.
PairedTimes time_in_pairs(const Command& first, const Command& second, int rounds);

/// One run: its processor time and its standard output. Throws as time_in_pairs.
Ended run_or_throw(const Command& command);

}  // namespace rays::bench
