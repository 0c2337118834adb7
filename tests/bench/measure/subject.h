// A subject: one method on one target, a benchmark of Google's with the method's accuracy as counters.
#pragma once

#include <benchmark/benchmark.h>

#include <memory>
#include <string>

#include "core/shapes.h"
#include "target.h"

namespace rays::bench {

/// Registers the benchmark `name`. method(ray) -> std::optional<Root> is inlined into the loop over the rays, as it is
/// into a renderer's loop over objects, so neighbouring rays overlap in the processor: this is throughput.
/// The counters: rays (an iteration's time is that of so many), and the errors of Accuracy.
template <class Method>
void add_subject(const std::string& name, const std::string& settings, const std::shared_ptr<const Target>& target,
                 Method method) {
    Answers answers;
    for (const Ray& ray : target->rays) answers.push_back(method(ray));
    const Accuracy accuracy = judge(*target, answers);
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
        for ([[maybe_unused]] auto _ : state) {
            Real sum = 0;
            for (const Ray& ray : target->rays)
                if (const auto root = method(ray)) sum += root->t;
            benchmark::DoNotOptimize(sum);
        }
        state.SetLabel(settings);
        state.counters["rays"] = static_cast<double>(target->rays.size());
        state.counters["error_median"] = accuracy.median;
        state.counters["error_mean"] = accuracy.mean;
        state.counters["error_largest"] = accuracy.largest;
        state.counters["wrong"] = accuracy.wrong;
    });
}

// ---- Step 1
// ----------------------------------------------------------------------------------------------------------

/// One patch, of size 1, with silhouettes and up to six roots a ray.
BicubicPatch wavy_patch();

/// Every primitive once, then the methods with a knob.
void add_primitives();
void add_root_methods();
void add_patch_methods();

}  // namespace rays::bench
