#include "grader/verdicts.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "grader/text.h"

namespace rays::grader {

std::optional<Finding> against_run(const Ended& e) {
    if (!e.started) return Finding{Verdict::infrastructure_error, e.problem};
    if (e.timed_out)
        return Finding{Verdict::time_out,
                       fmt::format("stopped after {:.1f} s ({:.1f} s of processor time)", e.wall_s, e.cpu_s)};
    if (e.flooded) return Finding{Verdict::fail, "stopped: it printed more text than allowed"};
    if (e.signal) return Finding{Verdict::crash, "crashed: " + signal_text(e.signal)};
    if (e.exit != 0) return Finding{Verdict::fail, fmt::format("ended with status {}: {}", e.exit, plain(e.err))};
    return {};
}

std::vector<UnfinishedPlace> unfinished_places(const std::string& stats) {
    std::vector<UnfinishedPlace> places;
    try {
        const auto json = nlohmann::json::parse(stats);
        for (const auto& j : json.at("unfinished")) {
            if (places.size() == 100) break;
            places.push_back({plain(j.at("task").get<std::string>(), 8), plain(j.at("file").get<std::string>()),
                              j.at("line").get<int>()});
        }
    } catch (const nlohmann::json::exception&) {
        // Statistics that are no statistics say nothing: the picture is judged as it is.
    }
    return places;
}

Verdict combine(const std::vector<Verdict>& verdicts) {
    if (verdicts.empty()) return Verdict::not_started;
    if (std::all_of(verdicts.begin(), verdicts.end(), [&](Verdict v) { return v == verdicts.front(); }))
        return verdicts.front();
    const auto has = [&](Verdict v) { return std::find(verdicts.begin(), verdicts.end(), v) != verdicts.end(); };
    for (const Verdict v : {Verdict::infrastructure_error, Verdict::build_error})
        if (has(v)) return v;
    if (has(Verdict::pass) || has(Verdict::partial)) return Verdict::partial;
    for (const Verdict v : {Verdict::crash, Verdict::time_out, Verdict::fail})
        if (has(v)) return v;
    return verdicts.front();
}

}  // namespace rays::grader
