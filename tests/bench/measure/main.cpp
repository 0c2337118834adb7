// measure-1: CPU time per ray and error of the methods of step 1, for the `Real` of this build. All options are Google
// Benchmark's, e.g. --benchmark_filter=sphere --benchmark_format=json. `rays-chart` runs it in both builds, in turns.
#include "core/vec.h"
#include "subject.h"

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::AddCustomContext("real", sizeof(rays::Real) == sizeof(double) ? "double" : "float");
    rays::bench::add_primitives();
    rays::bench::add_root_methods();
    rays::bench::add_patch_methods();
    return benchmark::RunSpecifiedBenchmarks() > 0 ? 0 : 2;
}
