// measure-4: CPU time of a ray, build and memory of the structures of step 4, beside Embree where it is installed. All
// options are Google Benchmark's, and --most=N: sets of up to N bodies, default 1000000. Structures that are compared
// belong in one run, their repetitions mixed:
//
//     measure-4 --benchmark_filter=flake --benchmark_repetitions=7 --benchmark_enable_random_interleaving=true
#include <benchmark/benchmark.h>

#include <charconv>
#include <string_view>

#include "step_4_subjects.h"

namespace {

/// Takes --most=N out of the arguments. False when N is no number.
bool take_most(int& argc, char** argv, std::size_t& most) {
    constexpr std::string_view kOption = "--most=";
    int kept = 0;
    bool good = true;
    for (int i = 0; i < argc; ++i) {
        const std::string_view word = argv[i];
        if (!word.starts_with(kOption)) {
            argv[kept++] = argv[i];
            continue;
        }
        const char* const end = word.data() + word.size();
        const auto read = std::from_chars(word.data() + kOption.size(), end, most);
        good = good && read.ec == std::errc() && read.ptr == end;
    }
    argc = kept;
    return good;
}

}  // namespace

int main(int argc, char** argv) {
    std::size_t most = 1'000'000;
    const bool understood = take_most(argc, argv, most);
    benchmark::Initialize(&argc, argv);
    if (!understood || benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    rays::bench::add_structures(most);
    return benchmark::RunSpecifiedBenchmarks() > 0 ? 0 : 2;
}
