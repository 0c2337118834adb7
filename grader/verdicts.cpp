#include "grader/verdicts.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "grader/text.h"

namespace rays::grader {

std::optional<Finding> against_run(const Ended& e) {
    if (e.ok()) return {};
    const std::string how = how_it_ended(e);
    if (!e.started) return Finding{Verdict::infrastructure_error, how};
    if (e.timed_out) return Finding{Verdict::time_out, how};
    if (e.flooded) return Finding{Verdict::fail, how};
    if (e.signal) return Finding{Verdict::crash, how + kFindTheCrash};
    return Finding{Verdict::fail, how + ": " + plain(e.err)};
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
