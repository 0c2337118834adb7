#include "laboratory.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "support/files.h"

namespace rays::bench {
namespace {

namespace fs = std::filesystem;

/// On the terminal: charts take minutes.
void say(const std::string& what) { fmt::print(stderr, "rays-chart: {}\n", what); }

std::vector<std::string> benchmark_options(double seconds, const std::string& filter = ".") {
    return {"--benchmark_format=json", fmt::format("--benchmark_min_time={}", seconds), "--benchmark_filter=" + filter};
}

Command measuring(const fs::path& program, std::vector<std::string> options) {
    options.insert(options.begin(), program.string());
    return trusted(std::move(options), {});
}

}  // namespace

void add_round(MeasuredByName& measured, const std::string& benchmark_json) {
    for (const auto& run : benchmark_runs(benchmark_json)) {
        Measured& m = measured[run.at("name").get<std::string>()];
        m.ns.push_back(run.at("cpu_time").get<double>() / run.at("rays").get<double>());
        m.settings = run.value("label", "");
        m.error_median = run.at("error_median");
        m.error_mean = run.at("error_mean");
        m.error_largest = run.at("error_largest");
        m.wrong = run.at("wrong");
    }
}

std::vector<std::string> scenes_of(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".pov") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

const BothReals& Laboratory::methods(int step) {
    const auto emplaced = methods_.try_emplace(step);
    BothReals& found = emplaced.first->second;
    if (!emplaced.second) return found;
    const auto measure = [&](bool in_float) {
        const fs::path& bin = in_float ? settings_.float_bin : settings_.bin;
        const auto command = measuring(bin / fmt::format("measure-{}", step), benchmark_options(settings_.seconds));
        add_round(in_float ? found.in_float : found.in_double, run_or_throw(command).out);
    };
    for (int round = 0; round < settings_.rounds; ++round) {
        say(fmt::format("methods of step {}, round {} of {}", step, round + 1, settings_.rounds));
        measure(round % 2 == 1);
        measure(round % 2 == 0);
    }
    return found;
}

const TimedByName& Laboratory::structures() {
    if (!structures_.empty()) return structures_;
    say("structures of step 4 and Embree");
    auto options = benchmark_options(settings_.seconds / 2);
    options.push_back(fmt::format("--most={}", settings_.large ? 10'000'000 : 1'000'000));
    options.push_back(fmt::format("--rounds={}", settings_.long_rounds));
    add_runs(structures_, run_or_throw(measuring(settings_.bin / "measure-4", options)).out);
    return structures_;
}

const std::vector<KnobRun>& Laboratory::knobs() {
    if (!knobs_.empty()) return knobs_;
    for (const Knob& knob : read_knobs(settings_.bin, 4))
        if (fs::exists(knob.program)) knobs_.push_back({knob, {}});
    for (int round = 0; round < settings_.long_rounds; ++round) {
        say(fmt::format("knobs of step 4, round {} of {}", round + 1, settings_.long_rounds));
        for (KnobRun& run : knobs_) {
            const std::string structure = run.knob.name.substr(0, run.knob.name.find('-'));
            const std::string filter = fmt::format("^(nearest/bounced|build)/(spheres|triangles)/100000/{}", structure);
            add_runs(run.timed,
                     run_or_throw(measuring(run.knob.program, benchmark_options(settings_.seconds, filter))).out);
        }
    }
    return knobs_;
}

std::vector<WholeProgram> Laboratory::whole_programs(const std::string& folder, int side) const {
    const TemporaryFolder temporary;
    std::vector<WholeProgram> programs;
    std::vector<Command> commands;
    for (const std::string& name : scenes_of(settings_.scenes / folder)) {
        programs.push_back({folder + "/" + name});
        const Picture picture{scene(folder + "/" + name + ".pov"), {side, side}};
        commands.push_back(povray_command(picture, temporary.path(), "povray.exr"));
        const auto ours = program("render-solution");
        commands.push_back(raysteps_command(ours, picture, temporary.path(), "rays.exr"));
        commands.push_back(raysteps_command(ours, picture, temporary.path(), "single.exr", {"--no-packets"}));
    }
    say(fmt::format("{} scenes of {} beside POV-Ray", programs.size(), folder));
    const auto times = time_in_turns(commands, settings_.long_rounds);
    for (std::size_t i = 0; i < programs.size(); ++i) {
        programs[i].povray_s = times[3 * i];
        programs[i].raysteps_s = times[3 * i + 1];
        programs[i].single_s = times[3 * i + 2];
    }
    return programs;
}

std::vector<Tried> Laboratory::try_all(const std::vector<Try>& tries, int rounds) const {
    std::vector<Command> commands;
    for (const Try& t : tries) commands.push_back(t.command);
    const auto times = time_in_turns(commands, rounds);
    std::vector<Tried> result;
    for (std::size_t i = 0; i < tries.size(); ++i) result.push_back({spread(times[i]), load_rgb_exr(tries[i].output)});
    return result;
}

}  // namespace rays::bench
