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

PairedTimes time_in_pairs(const Command& first, const Command& second, int rounds) {
    run_or_throw(first);
    run_or_throw(second);
    std::vector<double> firsts, seconds, ratios;
    for (int round = 0; round < rounds; ++round) {
        const bool swapped = round % 2 == 1;
        const double a = run_or_throw(swapped ? second : first).cpu_s;
        const double b = run_or_throw(swapped ? first : second).cpu_s;
        firsts.push_back(swapped ? b : a);
        seconds.push_back(swapped ? a : b);
        ratios.push_back(firsts.back() / seconds.back());
    }
    return {spread(firsts), spread(seconds), spread(ratios)};
}

}  // namespace rays::bench
