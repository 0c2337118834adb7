// What Google Benchmark's programs write as JSON.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "statistics.h"

namespace rays::bench {

/// The single runs in it, means and the like left out; from one document, or several one after the other. Throws
/// std::runtime_error when it is no such thing, or does not count in nanoseconds.
std::vector<nlohmann::json> benchmark_runs(const std::string& benchmark_json);

/// One benchmark that was repeated.
struct Timed {
    std::string settings;                    ///< the benchmark's label
    std::vector<double> ns;                  ///< CPU time of a ray (of an iteration over the counter `rays`), by round
    std::map<std::string, double> counters;  ///< of the last run

    /// The counter. Throws std::runtime_error when there is none.
    double counter(const std::string& name) const;
};

/// By the benchmark's name as it was registered.
using TimedByName = std::map<std::string, Timed>;

/// Adds all runs. Throws as benchmark_runs.
void add_runs(TimedByName& timed, const std::string& benchmark_json);

/// Of two that ran in turns: round by round, the first's time over the second's.
Spread ratio_of_times(const Timed& first, const Timed& second);

}  // namespace rays::bench
