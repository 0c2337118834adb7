// Questions about one surface: mirror directions, Snell's law, Fresnel's, finishes that reflect (3.1 to 3.4).
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "questions/step_3.h"

namespace rays::grader::step_3 {
namespace {

// Indices of refraction that one meets: water, glass, flint, diamond, and their inverses.
constexpr double kIndices[] = {1.333, 1.5, 1.5168, 1.7, 2.417};

void ask_refract(Notebook& notes, const Meeting& m, double ior, const V& truth, const std::string& about) {
    notes.ask("refract " + m.text() + " " + number(ior), about, close_to(truth, kGeometry));
}

std::string angles(double cosine, double ior) { return number(cosine) + " " + number(ior); }

Judge of_unit_length() {
    return [](const Answer& answer) {
        Judgement judgement{false, std::numeric_limits<double>::infinity(), "a direction of length 1"};
        if (answer.kind != Answer::Kind::value || answer.numbers.size() != 3) return judgement;
        judgement.error = std::abs(glm::length(V(answer.numbers[0], answer.numbers[1], answer.numbers[2])) - 1);
        judgement.ok = judgement.error <= kGeometry.relative;
        return judgement;
    };
}

/// Schlick 1994, the cosine taken on the thinner side.
double schlick_truth(double angle, double ior) {
    const double r0 = std::pow((1 - ior) / (1 + ior), 2);
    const double sine = std::sin(angle) / ior;
    if (ior < 1 && sine >= 1) return 1;
    const double thin = ior < 1 ? std::asin(sine) : angle;
    return r0 + (1 - r0) * std::pow(1 - std::cos(thin), 5);
}

}  // namespace

std::vector<Question> mirrors(std::uint64_t seed) {
    Dice dice(seed);
    Notebook notes("3.1");
    notes.scene(world());
    for (int i = 0; i < 12; ++i) {
        const double angle = dice.between(0.02, 1.5);
        const Meeting m = meeting(dice, angle);
        notes.ask("reflect " + m.text(), "the angle in is the angle out, in one plane with the normal",
                  close_to(mirrored(m, angle), kGeometry));
    }
    for (int i = 0; i < 2; ++i) {
        const Meeting m = meeting(dice, 0);
        notes.ask("reflect " + m.text(), "straight on: back to where it came from", close_to(-m.direction, kGeometry));
    }
    for (const double dust : {1e-4, 1e-8, 0.0}) {
        const Meeting m = meeting(dice, kPi / 2 - dust);
        notes.ask("reflect " + m.text(), "grazing: straight on", close_to(mirrored(m, kPi / 2 - dust), kGeometry));
    }
    for (int i = 0; i < 6; ++i) {
        const V d = dice.unit();
        notes.ask("bounce " + numbers(d) + " 3 3 1 0 0 0 1 0 0 0 1", "a corner of three mirrors sends a ray back",
                  close_to(-d, kGeometry));
    }
    for (int i = 0; i < 4; ++i) {
        // Two mirrors that meet at an angle a turn a ray by 2 a a pair of bounces, about their common edge.
        const double a = dice.between(0.1, 1.4), start = dice.between(0, 6), up = dice.between(-0.9, 0.9);
        const int pairs = dice.whole(1, 40);
        const auto ray = [&](double at) {
            const double flat = std::sqrt(1 - up * up);
            return V(flat * std::cos(at), flat * std::sin(at), up);
        };
        notes.ask(fmt::format("bounce {} {} 2 1 0 0 {} {} 0", numbers(ray(start)), 2 * pairs, std::cos(a), std::sin(a)),
                  "between two mirrors a ray turns by twice their angle, every pair of bounces",
                  close_to(ray(start + 2 * a * pairs), kGeometry));
    }
    for (int i = 0; i < 3; ++i) {
        // Normals as scenes have them, of length 1 to six digits: a direction that is not normalised gathers what they
        // are off, here to some percent.
        std::string mirrors;
        for (int k = 0; k < 5; ++k) {
            const V n = dice.unit();
            mirrors += fmt::format(" {:.6f} {:.6f} {:.6f}", n.x, n.y, n.z);
        }
        notes.ask(fmt::format("bounce {} 200000 5{}", numbers(dice.unit()), mirrors),
                  "mirrors whose normals are written with six digits: still of unit length", of_unit_length());
    }
    return notes.take();
}

std::vector<Question> refractions(std::uint64_t seed) {
    Dice dice(seed);
    Notebook notes("3.2");
    notes.scene(world());
    for (const double n : kIndices) {
        const double angle = dice.between(0.1, 1.5);
        const Meeting in = meeting(dice, angle);
        ask_refract(notes, in, n, behind(in, angle_behind(angle, n)), "into the denser medium: towards the normal");
        const double below = dice.between(0.1, 0.97) * critical_angle(1 / n);
        const Meeting out = meeting(dice, below);
        ask_refract(notes, out, 1 / n, behind(out, angle_behind(below, 1 / n)),
                    "into the thinner medium: away from the normal");
        const double above = critical_angle(1 / n) + dice.between(0.02, 0.98) * (kPi / 2 - critical_angle(1 / n));
        notes.ask("refract " + meeting(dice, above).text() + " " + number(1 / n),
                  "beyond the critical angle: nothing is refracted", nothing());
    }
    for (const double k : {1e-3, 1e-6}) {
        const double n = 1 / single(dice.round_between(1.2, 2.4)), critical = critical_angle(n);
        const Meeting m = meeting(dice, critical * (1 - k));
        ask_refract(notes, m, n, behind(m, angle_behind(critical * (1 - k), n)), "just below the critical angle");
        notes.ask("refract " + meeting(dice, critical * (1 + k)).text() + " " + number(n),
                  "just beyond the critical angle", nothing());
    }
    for (int i = 0; i < 3; ++i) {
        const double angle = dice.between(0, 1.57);
        const Meeting m = meeting(dice, angle);
        ask_refract(notes, m, 1, m.direction, "equal indices: straight on");
    }
    for (const double n : {0.4, 1.5}) {
        const Meeting m = meeting(dice, 0);
        ask_refract(notes, m, n, m.direction, "along the normal: straight on, whatever the index");
    }
    for (int i = 0; i < 3; ++i) {
        // The truth of the way in, asked on the way out.
        const double n = dice.between(1.1, 2.5), angle = dice.between(0.1, 1.5), inner = angle_behind(angle, n);
        const Meeting in = meeting(dice, angle);
        const Meeting back{-behind(in, inner), -in.normal, -in.sideways};
        ask_refract(notes, back, 1 / n, -in.direction, "light goes the same way back");
    }
    for (const double n : {1e-3, 0.1, 10.0, 1e3}) {
        const double angle = n < 1 ? 0.5 * critical_angle(n) : 1.2;
        const Meeting m = meeting(dice, angle);
        ask_refract(notes, m, n, behind(m, angle_behind(angle, n)), "indices far from 1");
    }
    return notes.take();
}

std::vector<Question> fresnels(std::uint64_t seed) {
    Dice dice(seed);
    Notebook notes("3.3");
    notes.scene(world());
    const auto ask = [&](double angle, double n, double truth, const char* about) {
        notes.ask("fresnel " + angles(std::cos(angle), n), about, close_to(truth, {1e-5, 1e-6}));
    };
    for (const double usual : kIndices) {
        const double n = usual * dice.between(0.97, 1.03);
        ask(0, n, std::pow((n - 1) / (n + 1), 2), "straight on: ((n - 1) / (n + 1))^2, 0.04 for glass");
        const double angle = dice.between(0.3, 1.5);
        ask(angle, n, reflectance(angle, n), "half of r_s^2 + r_p^2");
        const double brewster = std::atan(n);
        ask(brewster, n, 0.5 * std::pow(std::cos(2 * brewster), 2),
            "Brewster's angle: r_p is nothing, r_s is cos(2 angle)");
        const double inner = dice.between(0.2, 0.95) * critical_angle(1 / n);
        ask(inner, 1 / n, reflectance(angle_behind(inner, 1 / n), n),
            "from inside as from outside, at the angles of one ray");
    }
    for (const double usual : {1 / 1.5, 1 / 1.333}) {
        const double n = usual * dice.between(0.97, 1.03);
        ask(critical_angle(n) + dice.between(0.02, 0.6), n, 1, "total reflection: 1");
        ask(critical_angle(n) * (1 - 1e-4), n, reflectance(critical_angle(n) * (1 - 1e-4), n),
            "nearly total reflection");
    }
    ask(kPi / 2, dice.between(1.2, 2), 1, "grazing: 1");
    for (int i = 0; i < 3; ++i) ask(dice.between(0, 1.4), 1, 0, "equal indices reflect nothing");
    for (int i = 0; i < 3; ++i) {
        const double n = dice.between(1.2, 2.5);
        const double angle = dice.between(0.3, 1.5), inner = dice.between(0.2, 0.95) * critical_angle(1 / n);
        const Tolerance close{1e-5, 1e-6};
        notes.ask("schlick " + angles(std::cos(angle), n), "Schlick: F0 + (1 - F0) (1 - c)^5",
                  close_to(schlick_truth(angle, n), close));
        notes.ask("schlick " + angles(std::cos(inner), 1 / n), "Schlick from inside: the cosine is the refracted one's",
                  close_to(schlick_truth(inner, 1 / n), close));
        notes.ask("schlick " + angles(std::cos(critical_angle(1 / n) + 0.05), 1 / n), "Schlick knows total reflection",
                  close_to(1, close));
    }
    return notes.take();
}

std::vector<Question> finishes(std::uint64_t seed) {
    Dice dice(seed);
    Notebook notes("3.4");
    const auto object = [](const V& color, const std::string& reflection, const std::string& more = "") {
        return sphere({0, 0, 0}, 1, rgb(color),
                      fmt::format("{} reflection {{ {} }} {}", "ambient 0 diffuse 0", reflection, more));
    };
    const auto ask = [&](double angle, double ior, const V& truth, const char* about) {
        const V n = dice.unit(), v = tilted(n, angle, dice.between(0, 6));
        notes.ask(fmt::format("reflectivity 0 {} {} {}", numbers(n), numbers(v), ior), about, close_to(truth));
    };
    for (int i = 0; i < 3; ++i) {
        const V paint = dice.color(), share = dice.color();
        notes.scene(world() + object(paint, rgb(share)));
        ask(dice.between(0, 1.5), 1.5, share, "one colour: the same at every angle, whatever the surface's own colour");
    }
    for (int i = 0; i < 3; ++i) {
        const V low = dice.color(), high = dice.color();
        const double falloff = i == 0 ? 1 : dice.round_between(1.5, 5);
        notes.scene(world() + object(V(1), fmt::format("{}, {} falloff {}", rgb(low), rgb(high), falloff)));
        for (const double angle : {0.0, dice.between(0.4, 1.2), radians(89)}) {
            const double f = std::pow(1 - std::cos(angle), falloff);
            ask(angle, 1.5, low + f * (high - low), "from min at the normal to max at grazing, by (1 - cos)^falloff");
        }
    }
    for (int i = 0; i < 3; ++i) {
        const V low = i == 0 ? V(0) : 0.3 * dice.color(), high = i == 0 ? V(1) : dice.color();
        const double n = single(dice.round_between(1.2, 2.4));
        notes.scene(world() +
                    object(dice.color(), fmt::format("{}, {} fresnel on", rgb(low), rgb(high)), "conserve_energy"));
        for (const double angle : {0.0, dice.between(0.6, 1.4)})
            ask(angle, n, low + reflectance(angle, n) * (high - low), "fresnel: between min and max by Fresnel's law");
        ask(critical_angle(1 / n) + 0.1, 1 / n, high, "fresnel under total reflection: max");
    }
    for (int i = 0; i < 3; ++i) {
        const V paint = dice.color(), share = dice.color();
        const double metallic = i == 0 ? 1 : dice.round_between(0.2, 0.9), angle = dice.between(0, 1.4);
        notes.scene(world() + object(paint, fmt::format("{} metallic {}", rgb(share), metallic)));
        const auto tinted = [&](double at) {
            return share * (V(1) + metallic * (1 - step_2::fresnel(std::cos(at))) * (paint - V(1)));
        };
        ask(angle, 1.5, tinted(angle), "metallic: in the surface's colour, less so at grazing");
        ask(0, 1.5, share * (V(1) + metallic * (paint - V(1))), "metallic, straight on");
    }
    notes.scene(world() + object(V(1), "rgb 0"));
    for (int i = 0; i < 2; ++i) ask(dice.between(0, 1.5), 1.5, V(0), "no reflection");
    return notes.take();
}

}  // namespace rays::grader::step_3
