// Stability of step 5: numbers of samples that fill no grid, sizes near zero, angles near the horizon.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "questions/step_5.h"

namespace rays::grader {
namespace {

using namespace step_5;
using construct::number;
using construct::numbers;
using construct::vector;

const std::string kScene = construct::scene_of("");

Sweep::Point point(double x, const std::string& task, const std::string& scene, const std::string& query,
                   const std::string& about, Judge judge) {
    return {x, {{task, scene, query, about, std::move(judge)}}};
}

/// The share of points that share a cell with another: 0, for any number.
Judge share_in_one_cell(int samples, bool strips) {
    return [=, judge = stratified(samples, strips)](const Answer& answer) {
        Judgement j = judge(answer);
        if (answer.numbers.size() != 2 * std::size_t(samples)) return j;
        const Grid grid = grid_for(samples);
        std::vector<int> counts(static_cast<std::size_t>(grid.count()));
        for (const V2& p : points_in({answer.numbers, 2})) ++counts[static_cast<std::size_t>(grid.cell(p))];
        int shared = 0;
        for (const int c : counts) shared += c > 1 ? c : 0;
        j.error = double(shared) / samples;
        return j;
    };
}

Sweep numbers_of_samples(const std::string& task, const std::string& pattern, bool strips, Dice& dice) {
    Sweep sweep{task + ".samples",
                task,
                "Any number of samples in cells (" + pattern + ")",
                "samples a pixel",
                "share of points that share a cell",
                true,
                false,
                1,
                4096,
                {}};
    for (const int n : {1, 2, 3, 5, 7, 10, 17, 31, 50, 97, 127, 256, 509, 1021, 2039, 4096}) {
        const std::string query = fmt::format("points {} {} {} {} 0 {} sample {} nothing 1", pattern,
                                              dice.whole(0, 1000000), dice.whole(0, 100000), dice.whole(0, 20), n, n);
        sweep.points.push_back(
            point(n, task, kScene, query, fmt::format("{} points", n), share_in_one_cell(n, strips)));
    }
    return sweep;
}

Sweep far_samples(Dice& dice) {
    Sweep sweep{"5.4.index",
                "5.4",
                "Sobol's sequence, farther and farther on",
                "number of the first of 1024 samples",
                "share of points where another one is",
                true,
                false,
                1,
                1 << 29,
                {}};
    for (int k = 0; k < 30; k += k < 10 ? 10 : 2) {
        const int first = k == 0 ? 0 : 1 << k, block = 1024;
        const std::string query = fmt::format("points sobol {} {} {} {} {} sample {} nothing 1", dice.whole(0, 1000000),
                                              dice.whole(0, 100000), dice.whole(0, 20), first, first + block, block);
        const auto judge = [=](const Answer& answer) {
            Judgement j =
                rows_hold(block, 2, "1024 points, one in each column and row", [=](const Table& table, Claims& claims) {
                    const auto points = points_in(table);
                    claim_in_square(claims, points);
                    for (const int axis : {0, 1})
                        claims.holds(most_in_a_strip(block, points, axis) == 1, "one point in each of 1024 strips");
                })(answer);
            if (answer.numbers.size() != 2 * std::size_t(block)) return j;
            std::vector<double> x;
            for (const V2& p : points_in({answer.numbers, 2})) x.push_back(double(p.x));
            std::sort(x.begin(), x.end());
            j.error = double(x.end() - std::unique(x.begin(), x.end())) / block;
            return j;
        };
        sweep.points.push_back(
            point(std::max(1, first), "5.4", kScene, query, "points all over the square, each of its own", judge));
    }
    return sweep;
}

Sweep small_apertures(Dice& dice) {
    Sweep sweep{"5.7.aperture",
                "5.7",
                "An aperture that closes to a pinhole",
                "aperture",
                "distance of a ray from the point in focus, relative",
                true,
                true,
                1e-12,
                10,
                {}};
    for (int e = -12; e <= 1; ++e) {
        LensCamera camera = upright_camera(dice);
        camera.aperture = construct::rounded(std::pow(10.0L, e));
        const FilmPoint film = film_point(dice);
        const Centers centers{48, 48};
        sweep.points.push_back(point(std::pow(10.0, e), "5.7", camera.scene(),
                                     "lens_ray " + film.text() + " " + centers.text(),
                                     "rays that meet in the plane in focus", meets_in_focus(camera, film, centers)));
    }
    return sweep;
}

Sweep small_lights(Dice& dice) {
    Sweep sweep{"5.8.size",
                "5.8",
                "A light that shrinks to a point",
                "width of the light",
                "distance from the light's middle",
                true,
                true,
                1e-12,
                10,
                {}};
    for (int e = -15; e <= 1; ++e) {
        const double size = std::pow(10.0, e);
        Sweep::Point at{size, {}};
        for (const char* words : {"", "circular", "circular orient"}) {
            const V location = dice.position(5), u = construct::rounded(L(size) * V(1, 0, 0)),
                    v = construct::rounded(L(size) * V(0, 0, 1));
            const std::string scene =
                construct::scene_of(fmt::format("light_source {{ {}, rgb 1 area_light {}, {}, 5, 5 {} }}\n",
                                                vector(location), vector(u), vector(v), words));
            at.questions.push_back({"5.8", scene, "light_at 0 grid 16 16 0", "points of a small light",
                                    rows_hold(256, 10, "points of the light", [=](const Table& t, Claims& claims) {
                                        L widest = 0;
                                        for (std::size_t i = 0; i < t.rows(); ++i) {
                                            const V off = t.triple(i) - location;
                                            widest = std::max(widest, glm::length(off));
                                            claims.holds(glm::length(off) <= L(size) * std::sqrt(0.5L) + 1e-14L,
                                                         "no point beyond the light");
                                        }
                                        claims.holds(widest >= 0.4L * L(size) - 1e-14L, "points up to the light's rim");
                                        claims.error(widest);
                                    })});
        }
        sweep.points.push_back(std::move(at));
    }
    return sweep;
}

Sweep far_times(Dice& dice) {
    Sweep sweep{"5.9.beyond",
                "5.9",
                "Times farther and farther beyond the table",
                "time beyond the ends",
                "error of the value",
                true,
                true,
                1e-6,
                1e30,
                {}};
    for (const int e : {-6, -3, 0, 3, 6, 9, 12, 18, 24, 30, 100, 300}) {
        const L far = construct::rounded(std::pow(10.0L, e));
        const std::array<L, 4> samples{dice.round_between(1, 9), dice.round_between(-9, -1), dice.round_between(-9, -1),
                                       dice.round_between(1, 9)};
        std::string query = "value_at 0 1 4";
        for (const L s : samples) query += " " + number(s);
        query += fmt::format(" 2 {} {}", number(-far), number(1 + far));
        sweep.points.push_back(
            point(double(far), "5.9", kScene, query, "before the first sample and after the last",
                  rows_hold(2, 1, "the first and the last sample", [=](const Table& t, Claims& claims) {
                      claims.error(std::max(std::abs(t.at(0, 0) - samples[0]), std::abs(t.at(1, 0) - samples[3])));
                      claims.within(t.at(0, 0), samples[0], 1e-9L, "the first sample");
                      claims.within(t.at(1, 0), samples[3], 1e-9L, "the last sample");
                  })));
    }
    return sweep;
}

Judge proper_normals(const V& geometric, const V& viewer, std::size_t count) {
    return rows_hold(count, 3, "unit normals that face the viewer and mirror above the surface",
                     [=](const Table& t, Claims& claims) { claim_proper_normals(claims, t, geometric, viewer); });
}

Sweep roughness(Dice& dice) {
    Sweep sweep{"5.10.glossy",
                "5.10",
                "From nearly a mirror to as rough as can be",
                "glossy",
                "how far mirror rays go below the surface",
                true,
                true,
                1e-6,
                1,
                {}};
    for (const double glossy : {1e-6, 1e-5, 1e-4, 1e-3, 0.01, 0.03, 0.1, 0.2, 0.3, 0.5, 0.7, 1.0}) {
        Sweep::Point at{glossy, {}};
        for (const L degrees : {0.0L, 30.0L, 60.0L, 85.0L}) {
            const V n = construct::rounded(dice.unit());
            V x, y;
            construct::frame(n, x, y);
            const L angle = degrees * construct::kPi / 180;
            const V viewer = construct::rounded(std::cos(angle) * n + std::sin(angle) * x);
            at.questions.push_back({"5.10", rough_scene(glossy),
                                    "tilt 0 " + numbers(n) + " " + numbers(n) + " " + numbers(viewer) + " grid 32 32 0",
                                    fmt::format("seen from {} degrees", double(degrees)),
                                    proper_normals(n, viewer, 1024)});
        }
        sweep.points.push_back(std::move(at));
    }
    return sweep;
}

Sweep grazing(Dice& dice) {
    Sweep sweep{"5.10.grazing",
                "5.10",
                "Rough surfaces seen along them",
                "angle between the surface and the viewer, in radians",
                "how far mirror rays go below the surface",
                true,
                true,
                1e-7,
                1,
                {}};
    for (const double angle : {1.0, 0.3, 0.1, 0.03, 0.01, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) {
        Sweep::Point at{angle, {}};
        for (const double glossy : {0.001, 0.1, 1.0}) {
            const V n = construct::rounded(dice.unit());
            V x, y;
            construct::frame(n, x, y);
            const V viewer = construct::rounded(std::sin(L(angle)) * n + std::cos(L(angle)) * x);
            at.questions.push_back({"5.10", rough_scene(glossy),
                                    "tilt 0 " + numbers(n) + " " + numbers(n) + " " + numbers(viewer) + " grid 32 32 0",
                                    fmt::format("glossy {}", glossy), proper_normals(n, viewer, 1024)});
        }
        sweep.points.push_back(std::move(at));
    }
    return sweep;
}

/// Groups that differ by little from a large mean.
Sweep large_means(Dice& dice) {
    Sweep sweep{"5.11.mean",
                "5.11",
                "Small differences of bright pixels",
                "mean, where the groups differ by about 1",
                "relative error of the standard error",
                true,
                true,
                1,
                1e5,
                {}};
    for (const double mean : {1.0, 10.0, 100.0, 1e3, 1e4, 1e5, 1e6}) {
        std::string query = "standard_error 4";
        std::array<L, 4> groups;
        for (std::size_t g = 0; g < 4; ++g) groups[g] = mean + L(g) + dice.whole(0, 8) / 8.0L;
        for (const L g : groups) query += fmt::format(" {} 0 0 0", number(g));
        const L average = (groups[0] + groups[1] + groups[2] + groups[3]) / 4;
        L squares = 0;
        for (const L g : groups) squares += (g - average) * (g - average);
        const L truth = std::sqrt(squares / 12);
        sweep.points.push_back(point(mean, "5.11", kScene, query, "groups that differ by about 1",
                                     rows_hold(1, 1, number(truth), [=](const Table& t, Claims& claims) {
                                         claims.error(std::abs(t.at(0, 0) / truth - 1));
                                         claims.within(t.at(0, 0), truth, 0.02L * truth, "the standard error");
                                     })));
    }
    return sweep;
}

}  // namespace

std::vector<Sweep> sweeps_5_distributed(std::uint64_t seed) {
    Dice dice(seed * 16 + 15);
    std::vector<Sweep> sweeps{numbers_of_samples("5.2", "jittered", false, dice)};
    sweeps.push_back(numbers_of_samples("5.3", "multi_jittered", true, dice));
    sweeps.push_back(far_samples(dice));
    sweeps.push_back(small_apertures(dice));
    sweeps.push_back(small_lights(dice));
    sweeps.push_back(far_times(dice));
    sweeps.push_back(roughness(dice));
    sweeps.push_back(grazing(dice));
    sweeps.push_back(large_means(dice));
    return sweeps;
}

}  // namespace rays::grader
