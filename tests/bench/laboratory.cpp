#include "laboratory.h"

#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "references/povray.h"
#include "support/files.h"
#include "support/process.h"

namespace rays::bench {
namespace {

namespace fs = std::filesystem;

constexpr double kLongest_s = 1200;  ///< of one run: slower than this nothing can be charted

/// A trusted program and its arguments, in a folder of its own.
Command trusted(std::vector<std::string> argv, const fs::path& folder) {
    Command command;
    command.argv = std::move(argv);
    command.folder = folder;
    command.limits = only_time(kLongest_s);
    return command;
}

Command measuring(const fs::path& bin, int step, double seconds) {
    return trusted({(bin / fmt::format("measure-{}", step)).string(), "--benchmark_format=json",
                    fmt::format("--benchmark_min_time={}", seconds)},
                   {});
}

Command povray(const fs::path& scene, int width, int height, const fs::path& folder) {
    const fs::path program = find_program("povray");
    if (program.empty()) throw std::runtime_error("POV-Ray is not installed: apt-get install povray povray-includes");
    Command command = trusted({program.string()}, folder);
    for (const auto& option : Povray::frame_options(scene.string(), {width, height}, "povray.exr"))
        command.argv.push_back(option);
    for (const fs::path& library : {scene.parent_path(), find_povray_includes()})
        command.argv.push_back("+L" + library.string());
    return command;
}

}  // namespace

void add_round(MeasuredByName& measured, const std::string& benchmark_json) {
    const auto json = nlohmann::json::parse(benchmark_json, nullptr, false);
    if (json.is_discarded() || !json.contains("benchmarks"))
        throw std::runtime_error("a measuring program did not write Google Benchmark's JSON");
    for (const auto& run : json.at("benchmarks")) {
        Measured& m = measured[run.at("name").get<std::string>()];
        if (run.at("time_unit") != "ns") throw std::runtime_error("a measuring program does not count in nanoseconds");
        m.ns.push_back(run.at("cpu_time").get<double>() / run.at("rays").get<double>());
        m.settings = run.value("label", "");
        m.error_median = run.at("error_median");
        m.error_mean = run.at("error_mean");
        m.error_largest = run.at("error_largest");
        m.wrong = run.at("wrong");
    }
}

const BothReals& Laboratory::methods(int step) {
    const auto emplaced = methods_.try_emplace(step);
    BothReals& found = emplaced.first->second;
    if (!emplaced.second) return found;
    const auto measure = [&](bool in_float) {
        const auto command = measuring(in_float ? settings_.float_bin : settings_.bin, step, settings_.seconds);
        add_round(in_float ? found.in_float : found.in_double, run_or_throw(command).out);
    };
    for (int round = 0; round < settings_.rounds; ++round) {
        std::fprintf(stderr, "rays-chart: methods of step %d, round %d of %d\n", step, round + 1, settings_.rounds);
        measure(round % 2 == 1);
        measure(round % 2 == 0);
    }
    return found;
}

PairedTimes Laboratory::against_povray(const std::string& scene, int width, int height) const {
    std::fprintf(stderr, "rays-chart: %s beside POV-Ray\n", scene.c_str());
    const TemporaryFolder folder;
    const fs::path file = fs::absolute(settings_.scenes / scene);
    const Command ours =
        trusted({fs::absolute(settings_.bin / "render-solution").string(), file.string(), "-o", "rays.exr", "--width",
                 std::to_string(width), "--height", std::to_string(height), "--threads", "1"},
                folder.path());
    return time_in_pairs(povray(file, width, height, folder.path()), ours, settings_.rounds);
}

}  // namespace rays::bench
