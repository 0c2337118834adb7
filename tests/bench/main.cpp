// rays-chart: measures speed against accuracy and writes charts.json and the report that draws it. See --help.
#include <fmt/chrono.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>

#include "charts/charts.h"
#include "charts_file.h"
#include "core/error.h"
#include "references/povray.h"
#include "report/report.h"
#include "support/files.h"

namespace {

namespace fs = std::filesystem;
using namespace rays;
using namespace rays::bench;

std::string now() {
    return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}",
                       fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())));
}

std::vector<int> steps_with_charts() {
    std::vector<int> steps;
    for (const NamedChart& chart : all_charts())
        if (steps.empty() || steps.back() != chart.step) steps.push_back(chart.step);
    return steps;
}

/// Writes after every chart, so that a run that is stopped leaves what it has measured.
void measure(const std::vector<int>& steps, Laboratory& laboratory, const fs::path& out) {
    const std::string povray = Povray().version();
    auto charts = kept_charts(out / "charts.json", steps);
    for (const NamedChart& named : all_charts()) {
        if (std::find(steps.begin(), steps.end(), named.step) == steps.end()) continue;
        Chart chart = named.make(laboratory);
        if (chart.series.empty()) continue;
        mark_front(chart);
        std::fputs(as_text(chart).c_str(), stdout);
        std::fflush(stdout);
        charts.push_back(to_json(chart, now(), laboratory.rounds()));
        write_atomically(out / "charts.json", charts_file(charts, povray).dump(1) + "\n");
    }
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Measures speed against accuracy and draws it into the report.", "rays chart"};
    std::vector<int> steps;
    Laboratory::Settings settings;
    fs::path out = "report/out";
    app.add_option("steps", steps, "steps whose charts are measured anew; default: all that have charts")
        ->check(CLI::IsMember(steps_with_charts()));
    app.add_option("--bin", settings.bin, "programs of the release build")->required()->check(CLI::ExistingDirectory);
    app.add_option("--float-bin", settings.float_bin, "measuring programs of the build in float")
        ->required()
        ->check(CLI::ExistingDirectory);
    app.add_option("--scenes", settings.scenes, "folder of the scenes")->required()->check(CLI::ExistingDirectory);
    app.add_option("--out", out, "folder for charts.json and index.html")
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    app.add_option("--rounds", settings.rounds, "how often methods are measured; six give a 95 % interval")
        ->check(CLI::Range(1, 1000));
    app.add_option("--long-rounds", settings.long_rounds,
                   "the same of whole pictures and of structures over many bodies")
        ->check(CLI::Range(1, 1000));
    app.add_flag("--large", settings.large, "also what takes minutes: 10^7 bodies, the scenes of scenes/bench");
    app.add_option("--seconds", settings.seconds, "least time of one method in one round")
        ->check(CLI::Range(0.001, 60.0));
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return app.exit(e) == 0 ? kSuccess : kBadInput;
    }
    try {
        Laboratory laboratory(settings);
        measure(steps.empty() ? steps_with_charts() : steps, laboratory, out);
        write_report(out / "results.json", out / "index.html");
        return kSuccess;
    } catch (const InputError& e) {
        std::fprintf(stderr, "rays-chart: %s\n", e.what());
        return kBadInput;
    } catch (const std::exception& e) {
        std::fprintf(stderr, "rays-chart: %s\n", e.what());
        return kCheckFailed;
    }
}
