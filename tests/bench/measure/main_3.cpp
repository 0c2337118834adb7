// measure-3: CPU time and error of the Fresnel formulas of step 3. All options are Google Benchmark's.
#include <benchmark/benchmark.h>

#include "step_3_subjects.h"

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    rays::bench::add_fresnel();
    return benchmark::RunSpecifiedBenchmarks() > 0 ? 0 : 2;
}
