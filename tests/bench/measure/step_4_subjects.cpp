#include "step_4_subjects.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <optional>

#include "4_partitioning/structures.h"
#include "contender.h"

namespace rays::bench {
namespace {

constexpr std::size_t kFewest = 10, kFewestForAny = 500'000;

/// Bodies with their rays and all structures over them. Each is made when first asked for: a filter leaves much out.
class Stage {
public:
    explicit Stage(std::function<Bodies()> make) : make_(std::move(make)) {}

    const Bodies& bodies() {
        if (!bodies_) bodies_ = std::make_unique<Bodies>(make_());
        return *bodies_;
    }
    const Batch& primary() { return batches().first; }
    const Batch& bounced() { return batches().second; }
    const Structure& structure(const Contender& contender) {
        auto& found = structures_[contender.name];
        if (!found) found = contender.build(bodies());
        return *found;
    }

private:
    const std::pair<Batch, Batch>& batches() {
        if (!batches_) {
            const auto truth = make_bvh(bodies().scene);
            batches_ = std::make_unique<std::pair<Batch, Batch>>();
            batches_->first = primary_rays(bodies(), *truth);
            batches_->second = bounced_rays(batches_->first, *truth);
        }
        return *batches_;
    }

    std::function<Bodies()> make_;
    std::unique_ptr<Bodies> bodies_;
    std::unique_ptr<std::pair<Batch, Batch>> batches_;
    std::map<std::string, std::unique_ptr<Structure>> structures_;
};

using SharedStage = std::shared_ptr<Stage>;

struct RaySet {
    const char* name;
    const Batch& (Stage::*batch)();
};
constexpr RaySet kRaySets[] = {{"primary", &Stage::primary}, {"bounced", &Stage::bounced}};

void count(benchmark::State& state, const Batch& batch, const Bodies& bodies) {
    state.counters["rays"] = static_cast<double>(batch.rays.size());
    state.counters["bodies"] = static_cast<double>(bodies.count);
}

void add_nearest(const std::string& name, const SharedStage& stage, const Contender& contender, RaySet set) {
    const auto wrong = std::make_shared<std::optional<Disagreement>>();
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
        const Batch& batch = (*stage.*set.batch)();
        const Structure& structure = stage->structure(contender);
        if (!*wrong) *wrong = disagreement(batch, structure.distances(batch));
        for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(structure.nearest(batch));
        count(state, batch, stage->bodies());
        state.counters["lost"] = static_cast<double>((*wrong)->lost);
        state.counters["found"] = static_cast<double>((*wrong)->found);
        state.counters["elsewhere"] = static_cast<double>((*wrong)->elsewhere);
        state.SetLabel(contender.settings);
    });
}

void add_any(const std::string& name, const SharedStage& stage, const Contender& contender, RaySet set) {
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
        const Batch& batch = (*stage.*set.batch)();
        const Structure& structure = stage->structure(contender);
        for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(structure.occluded(batch));
        count(state, batch, stage->bodies());
        state.SetLabel(contender.settings);
    });
}

void add_build(const std::string& name, const SharedStage& stage, const Contender& contender) {
    using Clock = std::chrono::steady_clock;
    auto* registered = benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
        const Bodies& bodies = stage->bodies();
        std::unique_ptr<Structure> built;
        std::chrono::duration<double> on_the_clock{0};
        for ([[maybe_unused]] auto _ : state) {
            state.PauseTiming();
            built.reset();
            state.ResumeTiming();
            const auto start = Clock::now();
            built = contender.build(bodies);
            on_the_clock += Clock::now() - start;
        }
        state.counters["rays"] = 1;
        state.counters["bodies"] = static_cast<double>(bodies.count);
        state.counters["bytes"] = static_cast<double>(built->bytes());
        state.counters["seconds"] = on_the_clock.count() / static_cast<double>(state.iterations());
        state.SetLabel(contender.settings);
    });
    registered->MeasureProcessCPUTime();
}

void add_stage(const std::string& bodies, std::size_t size, std::function<Bodies()> make) {
    const auto stage = std::make_shared<Stage>(std::move(make));
    std::vector<Contender> contenders = our_contenders();
    for (Contender& other : other_contenders()) contenders.push_back(std::move(other));
    const auto takes_part = [&](const Contender& c) { return c.most == 0 || size <= c.most; };
    // Those that are compared run one after the other.
    for (const RaySet& set : kRaySets) {
        const std::string what = fmt::format("/{}/{}/", set.name, bodies);
        for (const Contender& contender : contenders) {
            const bool slow = contender.most != 0;  // one kind of rays is enough then
            if (takes_part(contender) && !(slow && set.batch != &Stage::bounced))
                add_nearest("nearest" + what + contender.name, stage, contender, set);
        }
        for (const Contender& contender : contenders)
            if (takes_part(contender) && size >= kFewestForAny)
                add_any("any" + what + contender.name, stage, contender, set);
    }
    for (const Contender& contender : contenders)
        if (contender.name != "none") add_build(fmt::format("build/{}/{}", bodies, contender.name), stage, contender);
}

}  // namespace

void add_structures(std::size_t most) {
    for (std::size_t n = kFewest; n <= most; n *= 10) {
        add_stage(fmt::format("spheres/{}", n), n, [n] { return random_spheres(n); });
        add_stage(fmt::format("triangles/{}", n), n, [n] { return random_triangles(n); });
    }
    add_stage("flake", 820 * 1008, [] { return tessellated_flake(); });
}

}  // namespace rays::bench
