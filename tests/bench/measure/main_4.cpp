// measure-4: CPU time of a ray, build and memory of the structures of step 4, beside Embree where it is installed. The
// options are Google Benchmark's, and
//     --most=N      sets of up to N bodies, default 1000000
//     --rounds=N    everything so often, all of it in each round: structures that are compared run side by side. With
//                   --benchmark_format=json each round is a document of its own.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <charconv>
#include <memory>
#include <string_view>

#include "step_4_subjects.h"

namespace {

/// Takes `option`, e.g. --most=N, out of the arguments. False when N is no number.
bool take_number(std::string_view option, int& argc, char** argv, std::size_t& number) {
    int kept = 0;
    bool good = true;
    for (int i = 0; i < argc; ++i) {
        const std::string_view word = argv[i];
        if (!word.starts_with(option)) {
            argv[kept++] = argv[i];
            continue;
        }
        const char* const end = word.data() + word.size();
        const auto read = std::from_chars(word.data() + option.size(), end, number);
        good = good && read.ec == std::errc() && read.ptr == end;
    }
    argc = kept;
    return good;
}

/// A reporter for each round: Google Benchmark 1.7.1 crashes when it is to use its own one twice.
std::unique_ptr<benchmark::BenchmarkReporter> make_reporter(bool json) {
    if (json) return std::make_unique<benchmark::JSONReporter>();
    return std::make_unique<benchmark::ConsoleReporter>();
}

}  // namespace

int main(int argc, char** argv) {
    std::size_t most = 1'000'000, rounds = 1;
    bool understood = take_number("--most=", argc, argv, most);
    understood = take_number("--rounds=", argc, argv, rounds) && understood;
    const bool json = std::find(argv, argv + argc, std::string_view("--benchmark_format=json")) != argv + argc;
    benchmark::Initialize(&argc, argv);
    if (!understood || benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    rays::bench::add_structures(most);
    for (std::size_t round = 0; round < rounds; ++round)
        if (benchmark::RunSpecifiedBenchmarks(make_reporter(json).get()) == 0) return 2;
    return 0;
}
