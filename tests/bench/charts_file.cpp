#include "charts_file.h"

#include <algorithm>
#include <fstream>
#include <thread>

namespace rays::bench {
namespace {

using nlohmann::json;

/// "key : value" or KEY="value", as in /proc/cpuinfo and /etc/os-release.
std::string value_in(const char* file, const std::string& key) {
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
        if (!line.starts_with(key)) continue;
        const auto begin = line.find_first_not_of(" \t:=\"", key.size());
        if (begin != std::string::npos) return line.substr(begin, line.find_last_not_of('"') + 1 - begin);
    }
    return "";
}

json this_machine() {
    return {{"cpu", value_in("/proc/cpuinfo", "model name")},
            {"cores", static_cast<int>(std::thread::hardware_concurrency())},
            {"os", value_in("/etc/os-release", "PRETTY_NAME")}};
}

}  // namespace

json charts_file(std::vector<json> charts, const std::string& povray) {
    std::stable_sort(charts.begin(), charts.end(),
                     [](const json& a, const json& b) { return a.at("step") < b.at("step"); });
    return {{"schema", "raysteps-charts/1"},
            {"machine", this_machine()},
            {"versions", {{"raysteps", RAYSTEPS_VERSION}, {"povray", povray}, {"compiler", RAYSTEPS_COMPILER}}},
            {"charts", charts}};
}

std::vector<json> kept_charts(const std::filesystem::path& file, const std::vector<int>& measured_steps) {
    std::ifstream in(file);
    const json known = json::parse(in, nullptr, false);
    if (!known.is_object() || known.value("schema", json()) != "raysteps-charts/1") return {};
    if (known.value("machine", json()) != this_machine()) return {};
    std::vector<json> kept;
    for (const json& chart : known.value("charts", json::array())) {
        if (!chart.is_object() || !chart.value("step", json()).is_number_integer()) continue;
        const int step = chart["step"];
        if (std::find(measured_steps.begin(), measured_steps.end(), step) == measured_steps.end())
            kept.push_back(chart);
    }
    return kept;
}

}  // namespace rays::bench
