#include "measurements.h"

#include <sstream>
#include <stdexcept>

namespace rays::bench {

using nlohmann::json;

std::vector<json> benchmark_runs(const std::string& benchmark_json) {
    std::istringstream in(benchmark_json);
    std::vector<json> runs;
    bool any = false;
    while (in >> std::ws && in.peek() != std::istringstream::traits_type::eof()) {
        json all;
        try {
            in >> all;
        } catch (const json::parse_error&) {
            any = false;
            break;
        }
        if (!(any = all.is_object() && all.contains("benchmarks"))) break;
        for (const json& run : all.at("benchmarks")) {
            if (run.value("run_type", "iteration") != "iteration") continue;
            if (run.at("time_unit") != "ns")
                throw std::runtime_error("a measuring program does not count in nanoseconds");
            runs.push_back(run);
        }
    }
    if (!any) throw std::runtime_error("a measuring program did not write Google Benchmark's JSON");
    return runs;
}

double Timed::counter(const std::string& name) const {
    const auto found = counters.find(name);
    if (found == counters.end()) throw std::runtime_error("a measuring program does not count " + name);
    return found->second;
}

void add_runs(TimedByName& timed, const std::string& benchmark_json) {
    for (const json& run : benchmark_runs(benchmark_json)) {
        // Google Benchmark appends how it has measured: time of the process, so many iterations.
        const std::string name = run.at("name");
        Timed& t = timed[name.substr(0, name.find("/process_time"))];
        t.ns.push_back(run.at("cpu_time").get<double>() / run.at("rays").get<double>());
        t.settings = run.value("label", "");
        for (const auto& [key, value] : run.items())
            if (value.is_number()) t.counters[key] = value;
    }
}

Spread ratio_of_times(const Timed& first, const Timed& second) {
    if (first.ns.size() != second.ns.size()) throw std::runtime_error("two benchmarks did not run in turns");
    std::vector<double> ratios;
    for (std::size_t i = 0; i < first.ns.size(); ++i) ratios.push_back(first.ns[i] / second.ns[i]);
    return spread(ratios);
}

}  // namespace rays::bench
