#include "process_time.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace rays::bench {

Ended run_or_throw(const Command& command) {
    Ended ended = run_command(command);
    if (ended.ok()) return ended;
    const std::string& words = ended.err.empty() ? ended.out : ended.err;
    throw std::runtime_error(fmt::format("{} {}\n{}", command.argv.at(0), how_it_ended(ended),
                                         words.substr(words.size() - std::min<std::size_t>(words.size(), 2000))));
}

std::vector<std::vector<double>> time_in_turns(const std::vector<Command>& commands, int rounds) {
    std::vector<std::vector<double>> times(commands.size());
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t i = 0; i < commands.size(); ++i) {
            const std::size_t which = round % 2 == 0 ? i : commands.size() - 1 - i;
            times[which].push_back(run_or_throw(commands[which]).cpu_s);
        }
    }
    return times;
}

PairedTimes paired(const std::vector<double>& first, const std::vector<double>& second) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < first.size(); ++i) ratios.push_back(first[i] / second.at(i));
    return {spread(first), spread(second), spread(ratios)};
}

PairedTimes time_in_pairs(const Command& first, const Command& second, int rounds) {
    time_in_turns({first, second}, 1);
    const auto times = time_in_turns({first, second}, rounds);
    return paired(times[0], times[1]);
}

}  // namespace rays::bench
