// The structures of step 4 among themselves and beside Embree: rays, build and memory, from ten bodies to millions.
#include <fmt/format.h>

#include <array>
#include <optional>
#include <stdexcept>

#include "charts.h"

namespace rays::bench {
namespace {

struct Shown {
    const char *name, *title, *role;
};
constexpr std::array<Shown, 5> kStructures{{{"none", "none: all are asked", "naive"},
                                            {"grid", "grid", "grid"},
                                            {"octree", "octree", "octree"},
                                            {"bvh", "bvh", "solution"},
                                            {"embree", "Embree", "embree"}}};

struct SetAndRays {
    const char *measured, *shown;
};
constexpr SetAndRays kBesideEmbree[] = {{"nearest/primary/flake", "flake"},
                                        {"nearest/bounced/flake", "flake, bounced"},
                                        {"any/bounced/flake", "flake, bounced, any"},
                                        {"nearest/primary/triangles/1000000", "triangles"},
                                        {"nearest/bounced/triangles/1000000", "triangles, bounced"},
                                        {"any/bounced/triangles/1000000", "triangles, bounced, any"},
                                        {"nearest/primary/spheres/1000000", "spheres"},
                                        {"nearest/bounced/spheres/1000000", "spheres, bounced"},
                                        {"any/bounced/spheres/1000000", "spheres, bounced, any"}};

/// Of all measurements "prefix/N/structure" one series, in ascending N.
template <class MakePoint>
std::optional<Series> over_count(const TimedByName& timed, const std::string& prefix, const Shown& structure,
                                 MakePoint make_point, std::size_t fewest = 10) {
    Series series{.name = structure.title, .role = structure.role, .joined = true};
    for (std::size_t n = fewest; n <= 10'000'000; n *= 10) {
        const auto found = timed.find(fmt::format("{}/{}/{}", prefix, n, structure.name));
        if (found != timed.end()) series.points.push_back(make_point(static_cast<double>(n), found->second));
    }
    if (series.points.empty()) return std::nullopt;
    return series;
}

double mrays(double ns) { return 1e3 / ns; }

Chart growth(Laboratory& laboratory, const std::string& bodies) {
    const TimedByName& timed = laboratory.structures();
    Chart chart{.id = "4.growth." + bodies,
                .step = 4,
                .title = fmt::format("Time of a ray among more and more {}", bodies),
                .text = fmt::format(
                    "Random {} in a cube that cover a view of it once, however many there are; nearest hits of rays "
                    "that bounce diffusely. The time of the cache is in it: a million do not fit.",
                    bodies),
                .x = {bodies, "", true},
                .y = {"CPU time of a ray", "ns", true},
                .rounds = laboratory.long_rounds()};
    for (const Shown& structure : kStructures) {
        auto series = over_count(timed, "nearest/bounced/" + bodies, structure, [](double n, const Timed& t) {
            const Spread time = spread(t.ns);
            return point_of(exactly(n), time, "", fmt::format("{}; {:.3g} Mrays/s", t.settings, mrays(time.median)));
        });
        if (series) chart.series.push_back(std::move(*series));
    }
    return chart;
}

/// Spheres and triangles of each structure.
template <class MakePoint>
Chart growth_of(Laboratory& laboratory, const std::string& id, const Axis& y, MakePoint make_point,
                std::size_t fewest = 10) {
    const TimedByName& timed = laboratory.structures();
    Chart chart{.id = id, .step = 4, .x = {"bodies", "", true}, .y = y, .rounds = laboratory.long_rounds()};
    for (const Shown& structure : kStructures) {
        for (const std::string bodies : {"spheres", "triangles"}) {
            auto series = over_count(timed, "build/" + bodies, structure, make_point, fewest);
            if (!series) continue;
            series->name += ", " + bodies;
            chart.series.push_back(std::move(*series));
        }
    }
    return chart;
}

Point ratio_to_embree(const std::string& set, const Timed& ours, const Timed& embree) {
    return {.x = ratio_of_times(embree, ours),
            .label = set,
            .settings = fmt::format("{:.3g} and {:.3g} Mrays/s", mrays(spread(ours.ns).median),
                                    mrays(spread(embree.ns).median))};
}

/// How often Embree answers otherwise than the bvh, over all sets.
std::string disagreements(const TimedByName& timed) {
    double rays = 0, lost = 0, found = 0, elsewhere = 0;
    for (const auto& [name, t] : timed) {
        if (!name.starts_with("nearest/") || !name.ends_with("/embree")) continue;
        rays += t.counter("rays");
        lost += t.counter("lost");
        found += t.counter("found");
        elsewhere += t.counter("elsewhere");
    }
    return fmt::format(
        "Of {:.3g} rays Embree misses {} that we hit, hits {} that we miss, and hits {} elsewhere: rays that graze, in "
        "float and in double; all of our structures agree with each other.",
        rays, lost, found, elsewhere);
}

/// No structure of ours may differ from the others. Throws std::runtime_error.
void check_agreement(const TimedByName& timed) {
    for (const auto& [name, t] : timed) {
        if (!name.starts_with("nearest/") || name.ends_with("/embree")) continue;
        if (!(t.counter("lost") + t.counter("found") + t.counter("elsewhere") == 0))
            throw std::runtime_error(name + " answers otherwise than the bvh");
    }
}

}  // namespace

Chart growth_with_spheres(Laboratory& laboratory) { return growth(laboratory, "spheres"); }
Chart growth_with_triangles(Laboratory& laboratory) { return growth(laboratory, "triangles"); }

Chart growth_of_build(Laboratory& laboratory) {
    Chart chart =
        growth_of(laboratory, "4.build", {"CPU time of the build, a body", "us", true}, [](double n, const Timed& t) {
            std::vector<double> us;
            for (const double ns : t.ns) us.push_back(ns / 1e3 / n);
            return point_of(exactly(n), spread(us), "",
                            fmt::format("{}; {:.3g} s on the clock", t.settings, t.counter("seconds")));
        });
    chart.title = "Building among more and more bodies";
    chart.text = "Of all threads together. Level lines grow linearly.";
    return chart;
}

/// Of fewer bodies the allocator's own bookkeeping would be weighed.
constexpr std::size_t kFewestWeighed = 1000;

Chart growth_of_memory(Laboratory& laboratory) {
    Chart chart = growth_of(
        laboratory, "4.memory", {"memory of the structure, a body", "bytes", true},
        [](double n, const Timed& t) {
            return Point{.x = exactly(n),
                         .y = t.counter("bytes") / n,
                         .settings = fmt::format("{}; {:.3g} MB", t.settings, t.counter("bytes") / 1e6)};
        },
        kFewestWeighed);
    chart.title = "Memory among more and more bodies";
    chart.text =
        "What stays allocated after the build, the bodies themselves not counted; of Embree, what it says that it "
        "allocates.";
    return chart;
}

Chart beside_embree(Laboratory& laboratory) {
    const TimedByName& timed = laboratory.structures();
    check_agreement(timed);
    Chart chart{.id = "4.embree",
                .step = 4,
                .kind = ChartKind::ratios,
                .title = "Rays a second as a share of Embree's",
                .text =
                    "A flake of 826 560 triangles, 10^6 random triangles or spheres; nearest or any hits of camera "
                    "rays or of rays that "
                    "bounce diffusely. One ray a call, one thread, the same bodies and rays; Embree in float, ours in "
                    "double with the "
                    "point and the normal of every hit. " +
                    disagreements(timed),
                .x = {"our rate / Embree's", "", true},
                .rounds = laboratory.long_rounds()};
    for (const char* name : {"bvh", "octree", "grid"}) {
        Series series{.name = name, .role = name == std::string("bvh") ? "solution" : name};
        for (const SetAndRays& row : kBesideEmbree) {
            const auto ours = timed.find(fmt::format("{}/{}", row.measured, name));
            const auto embree = timed.find(fmt::format("{}/embree", row.measured));
            if (ours != timed.end() && embree != timed.end())
                series.points.push_back(ratio_to_embree(row.shown, ours->second, embree->second));
        }
        if (!series.points.empty()) chart.series.push_back(std::move(series));
    }
    return chart;
}

}  // namespace rays::bench
