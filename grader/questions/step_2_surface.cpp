// Questions about what a surface is: its colour, its side, the light it needs no lamp for, Lambert's law (2.1 to 2.3).
#include <fmt/format.h>

#include <cmath>

#include "questions/step_2.h"

namespace rays::grader::step_2 {
namespace {

V rotated(V p, const V& degrees) {
    const auto turn = [](double& a, double& b, double angle) {
        const double c = std::cos(radians(angle)), s = std::sin(radians(angle)), a0 = a;
        a = a0 * c - b * s;
        b = a0 * s + b * c;
    };
    turn(p.y, p.z, degrees.x);
    turn(p.z, p.x, degrees.y);
    turn(p.x, p.y, degrees.z);
    return p;
}

std::string checkered(const V& even, const V& odd, const std::string& transform = "") {
    return "checker " + rgb(even) + " " + rgb(odd) + " " + transform;
}

const char* const kMatt = "ambient 0 diffuse 1";

void ask_plain_checkers(Notebook& notes, Dice& dice) {
    const V even = dice.color(), odd = dice.color();
    notes.scene(header() + sphere({0, 0, 0}, 1, checkered(even, odd), kMatt));
    const auto color_of = [&](const V& cube) { return std::fmod(cube.x + cube.y + cube.z, 2.0) == 0 ? even : odd; };
    for (int i = 0; i < 8; ++i) {
        const V cube(dice.whole(-9, 9), dice.whole(-9, 9), dice.whole(-9, 9));
        const V inside(dice.between(0.1, 0.9), dice.between(0.1, 0.9), dice.between(0.1, 0.9));
        notes.ask("pigment 0 " + numbers(cube + inside), "checker: floor also below zero, all three coordinates count",
                  close_to(color_of(cube)));
    }
    for (int i = 0; i < 3; ++i) {
        const V cube(dice.whole(-9, 9), 0, dice.whole(-9, 9));
        const double dust = i == 0 ? 0 : i == 1 ? -1e-13 : 1e-13;
        notes.ask("pigment 0 " + numbers(cube + V(0.3, dust, 0.6)),
                  "checker on a surface at a whole number: 1e-10 is added before floor, rounding must not flicker",
                  close_to(color_of(cube)));
    }
}

void ask_transformed_checkers(Notebook& notes, Dice& dice) {
    const V even = dice.color(), odd = dice.color();
    const V scale(dice.round_between(0.2, 0.9), dice.round_between(1.5, 3), dice.round_between(0.2, 3));
    const V turn(dice.round_between(10, 80), dice.round_between(-80, -10), dice.round_between(100, 170));
    const V shift = dice.position(5);
    notes.scene(header() + sphere({0, 0, 0}, 1,
                                  checkered(even, odd,
                                            fmt::format("scale {} rotate {} translate {}", vector(scale), vector(turn),
                                                        vector(shift))),
                                  kMatt));
    for (int i = 0; i < 8; ++i) {
        const V cube(dice.whole(-9, 9), dice.whole(-9, 9), dice.whole(-9, 9));
        const V local = cube + V(dice.between(0.1, 0.9), dice.between(0.1, 0.9), dice.between(0.1, 0.9));
        notes.ask("pigment 0 " + numbers(rotated(scale * local, turn) + shift),
                  "transformed checker: the point goes back into pattern space",
                  close_to(std::fmod(cube.x + cube.y + cube.z, 2.0) == 0 ? even : odd));
    }
}

}  // namespace

std::vector<Question> pigments(std::uint64_t seed) {
    Dice dice(seed);
    Notebook notes("2.1");
    const V plain = dice.color();
    notes.scene(header() + sphere({0, 0, 0}, 1, rgb(plain), kMatt));
    for (int i = 0; i < 3; ++i)
        notes.ask("pigment 0 " + numbers(dice.position(9)), "one colour everywhere", close_to(plain));
    ask_plain_checkers(notes, dice);
    ask_transformed_checkers(notes, dice);
    for (int i = 0; i < 10; ++i) {
        const V normal = dice.unit();
        // Grazing, too: the side is told by the sign, however small.
        const double angle = i < 6 ? dice.between(0, 1.5) : kPi / 2 - std::pow(10, -i + 3);
        const bool away = i % 2 == 1;
        const V viewer = tilted(normal, away ? kPi - angle : angle, dice.between(0, 6));
        notes.ask("facing " + numbers(normal) + " " + numbers(viewer),
                  away ? "the normal points away from the viewer: turned" : "the normal points to the viewer: kept",
                  close_to(away ? -normal : normal, kGeometry));
    }
    notes.ask("facing 0 1 0 1 0 0", "seen edge on: kept", close_to(V(0, 1, 0), kGeometry));
    return notes.take();
}

std::vector<Question> ambients(std::uint64_t seed) {
    Dice dice(seed);
    Notebook notes("2.2");
    for (int world = 0; world < 3; ++world) {
        const V ambient_light = world == 0 ? V(1) : dice.color();
        std::string sdl = header(ambient_light);
        std::vector<V> truth;
        std::vector<std::string> about;
        for (int i = 0; i < 8; ++i) {
            Finish finish;
            if (i != 1) finish.ambient = i < 4 ? V(dice.round_between(0.05, 0.9)) : dice.color();
            if (i == 1 || i > 4) finish.emission = i == 5 ? V(dice.round_between(0.1, 2)) : dice.color();
            finish.diffuse = 0.7;
            finish.phong = 0.5;
            const V color = i == 7 ? V(0) : dice.color();
            sdl += sphere({3.0 * i, 0, 0}, 1, rgb(color), finish.text());
            truth.push_back(color * (finish.ambient * ambient_light + finish.emission));
            about.push_back(i == 1   ? "emission alone is tinted by the surface and owes nothing to ambient light"
                            : i == 7 ? "a black surface shows no ambient light"
                            : i > 4  ? "ambient and emission add up"
                                     : "ambient times ambient light times colour");
        }
        notes.scene(sdl);
        for (std::size_t i = 0; i < truth.size(); ++i)
            notes.ask("ambient " + std::to_string(i), about[i], close_to(truth[i]));
    }
    return notes.take();
}

std::vector<Question> diffuses(std::uint64_t seed) {
    Dice dice(seed);
    Notebook notes("2.3");
    for (int world = 0; world < 4; ++world) {
        Finish finish;
        finish.diffuse = world == 2 ? 1 : dice.round_between(0.2, 0.9);
        finish.brilliance = world == 3 ? dice.round_between(1.5, 4) : 1;
        finish.phong = 0.8;
        finish.ambient = V(0.3);
        const V color = dice.color();
        notes.scene(header() + sphere({0, 0, 0}, 1, rgb(color), finish.text()));
        const auto ask = [&](double angle, const std::string& about) {
            const V n = dice.unit(), l = tilted(n, angle, dice.between(0, 6));
            const V v = tilted(n, dice.between(0, 1.5), dice.between(0, 6));
            notes.ask("diffuse 0 " + numbers(n) + " " + numbers(l) + " " + numbers(v), about,
                      close_to(finish.diffuse * std::pow(std::max(0.0, std::cos(angle)), finish.brilliance) * color));
        };
        if (world == 3) {
            for (int i = 0; i < 3; ++i) ask(dice.between(0.1, 1.5), "brilliance is the power of the cosine");
            ask(dice.between(1.65, 3.1), "light from behind the surface: none, whatever its power");
            continue;
        }
        for (int i = 0; i < 4; ++i)
            ask(dice.between(0.1, 1.5), "diffuse times the cosine; no 1 / pi; no matter from where it is seen");
        ask(0, "light along the normal: the whole diffuse part");
        ask(radians(60), "light at 60 degrees: half");
        ask(kPi / 2 - 1e-3, "grazing light");
        for (int i = 0; i < 3; ++i) ask(dice.between(1.65, 3.1), "light from behind the surface: none");
    }
    return notes.take();
}

}  // namespace rays::grader::step_2
