// Where the methods of step 3 break: one question over decades of a parameter.
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "questions/step_3.h"

namespace rays::grader {
namespace step_3 {
namespace {

/// What a sweep calls right: the resolution of the half floats that references are kept in. Relative only.
constexpr Tolerance kHalfFloat{5e-4, 1e-30};

std::vector<double> decades(double first, double last) {
    std::vector<double> values;
    const int steps = static_cast<int>(std::lround(std::log10(last / first)));
    for (int i = 0; i <= steps; ++i) values.push_back(first * std::pow(10.0, i));
    return values;
}

/// A sweep by its names: id "3.2.critical" belongs to task "3.2".
Sweep named(std::string id, std::string title, std::string x_label, std::string y_label, double pass_from,
            double pass_to) {
    Sweep sweep;
    sweep.task = id.substr(0, id.rfind('.'));
    sweep.id = std::move(id);
    sweep.title = std::move(title);
    sweep.x_label = std::move(x_label);
    sweep.y_label = std::move(y_label);
    sweep.pass_from = pass_from;
    sweep.pass_to = pass_to;
    return sweep;
}

/// A sweep over `values`; `ask` takes down the questions of one of them.
template <class Ask>
Sweep swept(Sweep sweep, const std::vector<double>& values, Ask ask) {
    for (const double x : values) {
        Notebook notes(sweep.task);
        notes.scene(world());
        ask(notes, x);
        sweep.points.push_back({x, notes.take()});
    }
    return sweep;
}

/// Judges some number made of the answer: it is an error, and must be small.
Judge small(std::size_t count, std::function<double(const std::vector<double>&)> error, double most,
            std::string expected) {
    return [=](const Answer& answer) {
        Judgement judgement{false, std::numeric_limits<double>::infinity(), expected};
        if (answer.kind != Answer::Kind::value || answer.numbers.size() != count) return judgement;
        const double e = error(answer.numbers);
        if (!std::isfinite(e)) return judgement;
        judgement.error = e;
        judgement.ok = e <= most;
        return judgement;
    };
}

V vector_of(const std::vector<double>& numbers, std::size_t at = 0) {
    return {numbers[at], numbers[at + 1], numbers[at + 2]};
}

// A direction that is normalised errs by some roundings, however many bounces it has behind it; one that is not
// gathers one more at every bounce.
#ifdef RAYSTEPS_REAL_FLOAT
constexpr double kUnit = 1e-6;
#else
constexpr double kUnit = 2e-15;
#endif

Sweep many_bounces(Dice dice) {
    Sweep sweep =
        named("3.1.bounces", "The length of a direction after many mirrors", "bounces", "| |d| - 1 |", 1, 1e6);
    return swept(sweep, {1, 3, 10, 50, 100, 300, 1e3, 1e4, 1e5, 1e6}, [&](Notebook& notes, double bounces) {
        for (int i = 0; i < 4; ++i) {
            std::string mirrors;
            for (int k = 0; k < 5; ++k) mirrors += fmt::format(" {}", numbers(dice.unit()));
            notes.ask(fmt::format("bounce {} {} 5{}", numbers(dice.unit()), bounces, mirrors), "still of unit length",
                      small(
                          3, [](const auto& d) { return std::abs(glm::length(vector_of(d)) - 1); }, kUnit, "length 1"));
        }
    });
}

/// Cosine behind the surface, to the last digit: the angle falls short of the critical one by x of its sine.
Sweep critical_refraction(Dice dice) {
    Sweep sweep = named("3.2.critical", "Snell's law at the critical angle", "1 - sin / sin(critical)",
                        "error of the cosine behind, relative", 1e-9, 0.1);
    return swept(sweep, decades(1e-15, 0.1), [&](Notebook& notes, double x) {
        for (int i = 0; i < 6; ++i) {
            const double n = 1 / dice.between(1.2, 2.4);
            const L sine = L(n) * (1 - L(x)), behind_cosine = std::sqrt(L(x) * (2 - L(x)));
            const Meeting m = meeting(dice, static_cast<double>(std::asin(sine)));
            const auto error = [m, truth = static_cast<double>(behind_cosine)](const auto& d) {
                return std::abs(-glm::dot(vector_of(d), m.normal) / truth - 1);
            };
            notes.ask("refract " + m.text() + " " + number(n), "refracted, but only just",
                      small(3, error, 5e-4, "a grazing ray"));
        }
    });
}

Sweep critical_side(Dice dice) {
    Sweep sweep = named("3.2.side", "Which side of the critical angle", "distance from it, relative",
                        "share of wrong answers", 1e-12, 0.1);
    sweep.log_y = false;
    return swept(sweep, decades(1e-16, 0.1), [&](Notebook& notes, double x) {
        for (int i = 0; i < 8; ++i) {
            const double n = 1 / dice.between(1.2, 2.4), critical = critical_angle(n);
            const bool beyond = i % 2 == 1;
            const Meeting m = meeting(dice, critical * (beyond ? 1 + x : 1 - x));
            notes.ask("refract " + m.text() + " " + number(n), beyond ? "just beyond" : "just below",
                      [beyond](const Answer& a) {
                          const bool ok = beyond ? a.kind == Answer::Kind::miss
                                                 : a.kind == Answer::Kind::value && a.numbers.size() == 3;
                          return Judgement{ok, ok ? 0.0 : 1.0, beyond ? "miss" : "a direction"};
                      });
        }
    });
}

/// What of a direction lies along the surface, against what Snell's law wants.
Judge sideways(const Meeting& m, double truth) {
    return small(
        3, [m, truth](const auto& d) { return std::abs(glm::dot(vector_of(d), m.sideways) / truth - 1); }, 5e-4,
        "sin(angle) / index along the surface");
}

Sweep near_the_normal(Dice dice) {
    Sweep sweep = named("3.2.normal", "Snell's law near the normal", "angle to the normal, radians",
                        "error of the sine, relative", 1e-9, 1);
    return swept(sweep, decades(1e-12, 1), [&](Notebook& notes, double angle) {
        for (int i = 0; i < 6; ++i) {
            const double n = dice.between(1.2, 2.4);
            const Meeting m = meeting(dice, angle);
            notes.ask("refract " + m.text() + " " + number(n), "a sine divided by the index",
                      sideways(m, std::sin(angle) / n));
        }
    });
}

Sweep all_indices(Dice dice) {
    Sweep sweep = named("3.2.index", "Snell's law for indices far from 1", "relative index",
                        "error of the sine, relative", 1e-3, 1e3);
    return swept(
        sweep, {1e-6, 1e-4, 1e-3, 1e-2, 0.1, 0.5, 1, 1.5, 2, 10, 100, 1e3, 1e4, 1e6}, [&](Notebook& notes, double n) {
            for (int i = 0; i < 6; ++i) {
                const double angle = n < 1 ? dice.between(0.1, 0.99) * critical_angle(n) : dice.between(0.05, 1.5);
                const Meeting m = meeting(dice, angle);
                notes.ask("refract " + m.text() + " " + number(n), "a sine divided by the index",
                          sideways(m, std::sin(angle) / n));
            }
        });
}

Sweep fresnel_by_angle(Dice) {
    Sweep sweep =
        named("3.3.angle", "Fresnel and what stands in for it, glass from outside", "cosine", "error, absolute", 0, 1);
    sweep.log_x = false;
    std::vector<double> cosines;
    for (int i = 0; i <= 40; ++i) cosines.push_back(i / 40.0);
    return swept(sweep, cosines, [&](Notebook& notes, double c) {
        const double truth = reflectance(std::acos(c), 1.5);
        notes.ask("fresnel " + number(c) + " 1.5", "half of r_s^2 + r_p^2",
                  small(
                      1, [truth](const auto& f) { return std::abs(f[0] - truth); }, 1e-5, number(truth)));
    });
}

Sweep fresnel_from_inside(Dice) {
    Sweep sweep =
        named("3.3.inside", "Fresnel and what stands in for it, glass from inside", "cosine", "error, absolute", 0, 1);
    sweep.log_x = false;
    std::vector<double> cosines;
    for (int i = 0; i <= 40; ++i) cosines.push_back(i / 40.0);
    return swept(sweep, cosines, [&](Notebook& notes, double c) {
        const double truth = reflectance(std::acos(c), 1 / 1.5);
        notes.ask("fresnel " + number(c) + " " + number(1 / 1.5), "half of r_s^2 + r_p^2; 1 beyond the critical angle",
                  small(
                      1, [truth](const auto& f) { return std::abs(f[0] - truth); }, 1e-5, number(truth)));
    });
}

Sweep glass_of_all_sizes(Dice dice) {
    Sweep sweep =
        named("3.10.scale", "Coloured glass in scenes of all sizes", "size of the scene", "relative error", 1e-2, 1e6);
    return swept(sweep, decades(1e-6, 1e6), [&](Notebook& notes, double size) {
        for (int i = 0; i < 3; ++i) {
            const V color = dice.color();
            const double thick = dice.between(0.5, 2);
            notes.scene(world(10, 0, "rgb 1") +
                        fmt::format("box {{ <{0}, {0}, 0>, <{1}, {1}, {2}> pigment {{ rgbt 1 }} finish {{ ambient 0 "
                                    "diffuse 0 }} interior {{ "
                                    "ior 1.5 fade_distance {3} fade_power 1001 fade_color {4} }} }}\n",
                                    -size, size, thick * size, size, rgb(color)));
            notes.ask(fmt::format("radiance 0 0 {} 0 0 1", -size), "the same glass, larger: the same colour",
                      close_to(V(std::exp((color.x - 1) * thick), std::exp((color.y - 1) * thick),
                                 std::exp((color.z - 1) * thick)),
                               kHalfFloat));
        }
    });
}

/// Out of a slab in the direction of entry, whatever the angle.
Sweep slabs(Dice dice) {
    Sweep sweep = named("3.10.slab", "Out of a slab as into it", "cosine of the angle of entry",
                        "angle between the two, in units of the cosine", 1e-4, 1);
    return swept(sweep, decades(1e-6, 1), [&](Notebook& notes, double cosine) {
        for (int i = 0; i < 4; ++i) {
            const double n = single(dice.round_between(1.2, 2.4));
            const V in(std::sqrt(1 - cosine * cosine), 0, cosine);
            notes.scene(world() + fmt::format("box {{ <-9000, -9000, 0>, <9000, 9000, 1> pigment {{ rgbt 1 }} finish "
                                              "{{ ambient 0 diffuse 0 }} interior {{ ior {} }} }}\n",
                                              n));
            notes.ask(
                "last_ray " + numbers(-in / cosine) + " " + numbers(in), "parallel to itself",
                small(
                    7,
                    [=](const auto& ray) { return ray[6] == 3 ? glm::length(vector_of(ray, 3) - in) / cosine : 1.0; },
                    5e-4, numbers(in)));
        }
    });
}

/// Between two mirrors: the series, cut by depth.
Sweep corridors(Dice dice) {
    Sweep sweep = named("3.9.depth", "Two mirrors that face each other", "max_trace_level", "relative error", 1, 256);
    return swept(sweep, {1, 2, 3, 4, 6, 8, 16, 32, 64, 128, 256}, [&](Notebook& notes, double levels) {
        for (int i = 0; i < 3; ++i) {
            const double share = dice.round_between(0.9, 0.99), far = dice.round_between(2, 9);
            const std::string look = fmt::format(
                "pigment {{ rgb 1 }} finish {{ ambient 0 diffuse 0 emission 0.01 reflection {{ {} }} }}", share);
            notes.scene(world(static_cast<int>(levels)) +
                        fmt::format("plane {{ -z, {} {} }}\nplane {{ z, {} {} }}\n", -far, look, -far, look));
            const L s = static_cast<float>(share), truth = 0.01L * (1 - std::pow(s, L(levels))) / (1 - s);
            notes.ask("radiance 0 0 0 0 0 1", "one term more for each level",
                      close_to(V(static_cast<double>(truth)), kHalfFloat));
        }
    });
}

/// What adc_bailout costs: no more than itself times the branches that it cut.
Sweep bailouts(Dice dice) {
    Sweep sweep = named("3.11.bailout", "What pruning takes away", "adc_bailout", "darker by", 1e-6, 0.5);
    return swept(
        sweep, {1e-6, 1e-5, 1e-4, 1e-3, 1.0 / 255, 1e-2, 3e-2, 0.1, 0.2, 0.5}, [&](Notebook& notes, double adc) {
            notes.scene(world(60, adc, "rgb 1") + "sphere { 0, 1 " + lossless(1.5) +
                        " }\nsphere { <0.6, 0.3, -1.6>, 0.5 " + lossless(1.7) + " }\n");
            for (int i = 0; i < 8; ++i) {
                const V from(dice.between(-1, 1), dice.between(-1, 1), -6),
                    at(dice.between(-0.8, 0.8), dice.between(-0.8, 0.8), 0);
                notes.ask(
                    "residual " + numbers(from) + " " + numbers(at - from),
                    "all around is 1: what is missing was pruned", [](const Answer& a) {
                        Judgement j{false, std::numeric_limits<double>::infinity(), "1 - pruned <= radiance <= 1"};
                        if (a.kind != Answer::Kind::value || a.numbers.size() != 4) return j;
                        j.error = std::abs(1 - a.numbers[0]);
                        // Float sums of some hundred branches.
                        j.ok = a.numbers[0] <= 1 + 1e-5 && a.numbers[0] + a.numbers[3] >= 1 - 1e-5;
                        return j;
                    });
            }
        });
}

}  // namespace
}  // namespace step_3

std::vector<Sweep> sweeps_3_recursion(std::uint64_t seed) {
    using namespace step_3;
    std::vector<Sweep> all;
    std::uint64_t dice = seed * 16;
    for (const auto make : {many_bounces, critical_refraction, critical_side, near_the_normal, all_indices,
                            fresnel_by_angle, fresnel_from_inside, corridors, glass_of_all_sizes, slabs, bailouts})
        all.push_back(make(Dice(dice++)));
    return all;
}

}  // namespace rays::grader
