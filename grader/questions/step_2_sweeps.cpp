// Where the methods of step 2 break: one question over decades of a parameter.
#include <fmt/format.h>

#include <cmath>

#include "questions/step_2.h"

namespace rays::grader {
namespace step_2 {
namespace {

/// What a sweep calls right: the resolution of the half floats that references are kept in. Relative only.
constexpr Tolerance kHalfFloat{5e-4, 1e-30};

/// Yes-or-no questions have no error to draw, but a rate of acne and leaks.
const char* const kShareWrong = "share of wrong answers";

std::vector<double> decades(double first, double last) {
    std::vector<double> values;
    const int steps = static_cast<int>(std::lround(std::log10(last / first)));
    for (int i = 0; i <= steps; ++i) values.push_back(first * std::pow(10.0, i));
    return values;
}

/// A sweep by its names: id "2.3.grazing" belongs to task "2.3".
Sweep named(std::string id, std::string title, std::string x_label, std::string y_label) {
    Sweep sweep;
    sweep.task = id.substr(0, id.rfind('.'));
    sweep.id = std::move(id);
    sweep.title = std::move(title);
    sweep.x_label = std::move(x_label);
    sweep.y_label = std::move(y_label);
    return sweep;
}

/// A sweep over `values`; `ask` takes down the questions of one of them.
template <class Ask>
Sweep swept(Sweep sweep, const std::vector<double>& values, Ask ask) {
    for (const double x : values) {
        Notebook notes(sweep.task);
        ask(notes, x);
        sweep.points.push_back({x, notes.take()});
    }
    return sweep;
}

Sweep grazing_light(Dice dice) {
    Sweep sweep = named("2.3.grazing", "Lambert's law under grazing light", "n . l", "relative error");
    sweep.pass_from = 1e-9;
    sweep.pass_to = 1;
    return swept(sweep, decades(1e-12, 1), [&](Notebook& notes, double cosine) {
        notes.scene(header() + sphere({0, 0, 0}, 1, "rgb 1", "ambient 0 diffuse 0.75"));
        for (int i = 0; i < 6; ++i) {
            const V n = dice.unit(), l = cosine * n + std::sqrt(1 - cosine * cosine) * across(n);
            notes.ask("diffuse 0 " + numbers(n) + " " + numbers(l) + " " + numbers(n), "light just above the horizon",
                      close_to(V(0.75 * cosine), kHalfFloat));
        }
    });
}

Sweep sharp_highlight(Dice dice) {
    Sweep sweep = named("2.4.exponent", "Half a highlight, ever sharper", "phong_size", "relative error");
    sweep.pass_from = 1;
    sweep.pass_to = 1e4;
    return swept(sweep, {1, 3, 10, 30, 100, 300, 1e3, 3e3, 1e4, 3e4, 1e5, 3e5, 1e6}, [&](Notebook& notes, double size) {
        notes.scene(header() +
                    sphere({0, 0, 0}, 1, "rgb 1", fmt::format("ambient 0 diffuse 0 phong 1 phong_size {}", size)));
        for (int i = 0; i < 6; ++i) {
            // At half the height the mirror direction and the light are acos(2^(-1/m)) apart.
            const V n = dice.unit(), v = tilted(n, 0.3, dice.between(0, 6));
            const V l = tilted(glm::normalize(2 * glm::dot(n, v) * n - v), std::acos(std::exp2(-1 / size)), 1.5);
            notes.ask("phong 0 " + numbers(n) + " " + numbers(l) + " " + numbers(v), "half way down the highlight",
                      close_to(V(0.5), kHalfFloat));
        }
    });
}

Sweep opposite_light(Dice dice) {
    Sweep sweep = named("2.5.opposite", "The half vector of light and viewer nearly opposite",
                        "angle between l and -v, radians", "relative error");
    sweep.pass_from = 1e-12;
    sweep.pass_to = 1;
    return swept(sweep, decades(1e-14, 1), [&](Notebook& notes, double angle) {
        notes.scene(header() + sphere({0, 0, 0}, 1, "rgb 1", "ambient 0 diffuse 0 specular 1 roughness 0.05"));
        for (int i = 0; i < 6; ++i) {
            const V n = dice.unit(), a = across(n);
            const V up = std::sin(angle / 2) * n, along = std::cos(angle / 2) * a;
            notes.ask("blinn 0 " + numbers(n) + " " + numbers(up + along) + " " + numbers(up - along),
                      "the half vector is the normal: the whole highlight", close_to(V(1), kHalfFloat));
        }
    });
}

Sweep narrow_beam(Dice dice) {
    Sweep sweep = named("2.7.narrow", "The rim of an ever narrower spotlight", "falloff, degrees", "relative error");
    // Comparing cosines, as POV-Ray does, is a correct solution: it holds down to here. What lies below is charted
    // only.
    sweep.pass_from = 1e-3;
    sweep.pass_to = 60;
    return swept(sweep, decades(6e-11, 60), [&](Notebook& notes, double falloff) {
        const V axis = dice.unit();
        notes.scene(header() +
                    fmt::format("light_source {{ <0, 0, 0>, rgb 1 spotlight radius {} falloff {} point_at {} }}\n",
                                falloff / 2, falloff, vector(axis)));
        const auto below_one = [](double degrees) { return 2 * std::pow(std::sin(radians(degrees) / 2), 2); };
        for (const double share : {0.6, 0.7, 0.8, 0.9}) {
            const double end = below_one(falloff);
            const double s = (end - below_one(share * falloff)) / (end - below_one(falloff / 2));
            const V p = std::cos(radians(share * falloff)) * axis + std::sin(radians(share * falloff)) * across(axis);
            notes.ask("cone_of_light 0 " + numbers(p), "between radius and falloff",
                      close_to(s * s * (3 - 2 * s), kHalfFloat));
        }
    });
}

Sweep near_light(Dice dice) {
    Sweep sweep = named("2.8.near", "A light ever nearer to the point", "distance", "error of the direction");
    sweep.pass_from = 1e-150;
    sweep.pass_to = 1;
    std::vector<double> distances{1e-300, 1e-200, 1e-160, 1e-150, 1e-100, 1e-50, 1e-20, 1e-15};
    for (const double d : decades(1e-12, 1)) distances.push_back(d);
    return swept(sweep, distances, [&](Notebook& notes, double distance) {
        notes.scene(header() + "light_source { <0, 0, 0>, rgb 1 }\n");
        for (int i = 0; i < 6; ++i) {
            const V direction = dice.unit();
            notes.ask("illuminate 0 " + numbers(-distance * direction), "still a unit vector towards the light",
                      [judge = close_to(direction, kHalfFloat)](const Answer& answer) {
                          Answer part = answer;
                          if (part.numbers.size() == 7) part.numbers.resize(3);
                          return judge(part);
                      });
        }
    });
}

/// Points of a sphere of this size, here; light from 100 radii away. All of them are lit (acne if not); then a bead
/// 0.03 radii above each of them blocks its light (a leak if not).
void ask_acne_and_leaks(Notebook& notes, Dice& dice, double size, const V& center) {
    const auto ball = [](const V& c, double r) { return sphere(c, r, "rgb 1", "ambient 0"); };
    const V to_light = dice.unit();
    const std::string world =
        header() + ball(center, size) + "light_source { " + vector(center + 100 * size * to_light) + ", rgb 1 }\n";
    std::vector<V> normals;
    for (int i = 0; i < 12; ++i) normals.push_back(tilted(to_light, dice.between(0, 1.3), dice.between(0, 6)));
    const auto ask = [&](const V& n, bool truth, const char* about) {
        notes.ask("in_shadow " + numbers(center + size * n) + " " + numbers(n) + " 0", about, says(truth));
    };
    notes.scene(world);
    for (const V& n : normals) ask(n, false, "acne: the lit side of a sphere");
    std::string beads = world;
    for (const V& n : normals) beads += ball(center + size * (n + 0.05 * to_light), 0.02 * size);
    notes.scene(beads);
    for (const V& n : normals) ask(n, true, "leak: a bead close above the surface");
}

Sweep shadows_by_scale(Dice dice) {
    Sweep sweep = named("2.9.scale", "Acne and leaks in scenes of all sizes", "radius of the sphere", kShareWrong);
    sweep.log_y = false;
    sweep.pass_from = 0.1;  // POV-Ray's tolerance is 0.001 of a unit, whatever the scene's size: beads must be larger
    sweep.pass_to = 1e6;
    return swept(sweep, decades(1e-6, 1e6),
                 [&](Notebook& notes, double size) { ask_acne_and_leaks(notes, dice, size, V(0)); });
}

Sweep shadows_by_translation(Dice dice) {
    Sweep sweep =
        named("2.9.translation", "Acne and leaks far from the origin", "distance from the origin", kShareWrong);
    sweep.log_y = false;
    sweep.pass_from = 1;
    sweep.pass_to = 1e7;
    return swept(sweep, decades(1, 1e13), [&](Notebook& notes, double distance) {
        ask_acne_and_leaks(notes, dice, 1, distance * V(0.48, -0.6, 0.64));
    });
}

Sweep shadows_at_grazing_light(Dice dice) {
    Sweep sweep = named("2.9.grazing", "Acne where the light grazes a sphere", "n . l", kShareWrong);
    sweep.log_y = false;
    sweep.pass_from = 1e-9;
    sweep.pass_to = 1;
    return swept(sweep, decades(1e-12, 1), [&](Notebook& notes, double cosine) {
        const V center(31, -17, 58);
        for (int scene = 0; scene < 4; ++scene) {
            const V to_light = dice.unit();
            notes.scene(header() + sphere(center, 3, "rgb 1", "ambient 0") + "light_source { " +
                        vector(center + 100.0 * to_light) + ", rgb 1 parallel point_at " + vector(center) + " }\n");
            for (int i = 0; i < 6; ++i) {
                const V n = tilted(to_light, std::acos(cosine), dice.between(0, 6));
                notes.ask("in_shadow " + numbers(center + 3.0 * n) + " " + numbers(n) + " 0", "lit, but only just",
                          says(false));
            }
        }
    });
}

}  // namespace
}  // namespace step_2

std::vector<Sweep> sweeps_2_phong(std::uint64_t seed) {
    using namespace step_2;
    std::vector<Sweep> all;
    std::uint64_t dice = seed * 16;
    for (const auto make : {grazing_light, sharp_highlight, opposite_light, narrow_beam, near_light, shadows_by_scale,
                            shadows_by_translation, shadows_at_grazing_light})
        all.push_back(make(Dice(dice++)));
    return all;
}

}  // namespace rays::grader
