// Questions about highlights: POV-Ray's phong, its specular (Blinn's half vector), and the colour of metal (2.4, 2.5).
#include <cmath>

#include "questions/step_2.h"

namespace rays::grader::step_2 {
namespace {

struct Directions {
    V n, l, v;
};

std::string query(const char* what, const Directions& d) {
    return std::string(what) + " 0 " + numbers(d.n) + " " + numbers(d.l) + " " + numbers(d.v);
}

/// A viewer `slant` off the normal, and light `off` away from the viewer's mirror direction, turned about it.
Directions around_mirror(Dice& dice, double slant, double off) {
    const V n = dice.unit(), v = tilted(n, slant, dice.between(0, 6));
    const V mirrored = glm::normalize(2 * glm::dot(n, v) * n - v);
    return {n, tilted(mirrored, off, dice.between(0, 6)), v};
}

/// Viewer and light `open` on either side of a half vector that is `off` away from the normal, across their plane.
Directions around_half(Dice& dice, double open, double off) {
    const V half = dice.unit(), side = across(half);
    const V n = glm::normalize(std::cos(off) * half + std::sin(off) * glm::cross(half, side));
    return {n, glm::normalize(std::cos(open) * half + std::sin(open) * side),
            glm::normalize(std::cos(open) * half - std::sin(open) * side)};
}

/// Light below the horizon although the highlight's own cosine is positive: the viewer grazes the surface.
Directions light_behind(Dice& dice, double below) {
    const V n = dice.unit(), a = across(n);
    const double rise = dice.between(0.02, 0.1);
    return {n, glm::normalize(std::cos(below) * a - std::sin(below) * n),
            glm::normalize(-std::cos(rise) * a + std::sin(rise) * n)};
}

std::string scene_of(const Finish& finish, const V& color) {
    return header() + sphere({0, 0, 0}, 1, rgb(color), finish.text());
}

double half_width(double exponent) { return std::acos(std::pow(2.0, -1 / exponent)); }

}  // namespace

std::vector<Question> phongs(std::uint64_t seed) {
    Dice dice(seed);
    Notebook notes("2.4");
    for (int world = 0; world < 3; ++world) {
        Finish finish;
        finish.phong = dice.round_between(0.3, 1);
        finish.phong_size = world == 0 ? 2.5 : world == 1 ? dice.round_between(20, 60) : dice.round_between(100, 400);
        finish.roughness = 0.002;  // another exponent, should the wrong one be taken
        finish.diffuse = 0.4;
        notes.scene(scene_of(finish, dice.color()));
        const auto ask = [&](const Directions& d, double truth, const std::string& about) {
            notes.ask(query("phong", d), about, close_to(V(truth)));
        };
        const double a = finish.phong, m = finish.phong_size, wide = half_width(m);
        ask(around_mirror(dice, dice.between(0.3, 0.9), 0), a, "light in the mirror direction: the whole highlight");
        ask(around_mirror(dice, 0, 0), a, "viewer and light both on the normal: the whole highlight");
        for (int i = 0; i < 3; ++i) {
            const double slant = dice.between(0.1, kPi / 2 - 0.05 - std::min(wide, 1.0));
            ask(around_mirror(dice, slant, wide), a / 2,
                "half the highlight at acos(2^(-1/m)) from the mirror direction");
        }
        for (int i = 0; i < 3; ++i) {
            const double off = dice.between(0, std::min(2 * wide, 0.9));
            ask(around_mirror(dice, dice.between(0, 0.6), off), a * std::pow(std::cos(off), m),
                "phong (r . l)^phong_size");
        }
        for (int i = 0; i < 2; ++i)
            ask(light_behind(dice, dice.between(0.02, 0.2)), 0, "light behind the surface: no highlight");
        for (int i = 0; i < 2; ++i) {
            const V n = dice.unit();  // both low, on the same side: the mirror direction is far from the light
            const double turn = dice.between(0, 3);
            ask({n, tilted(n, 1.2, turn), tilted(n, 1.3, turn + 0.2)}, 0, "r . l negative: no highlight, and no NaN");
        }
    }
    Finish none;
    none.diffuse = 1;
    notes.scene(scene_of(none, dice.color()));
    notes.ask(query("phong", around_mirror(dice, 0.5, 0)), "phong 0: no highlight", close_to(V(0)));
    return notes.take();
}

namespace {

void ask_blinn(Notebook& notes, Dice& dice, double roughness) {
    Finish finish;
    finish.specular = dice.round_between(0.3, 1);
    finish.roughness = roughness;
    finish.phong_size = 3;  // another exponent, should the wrong one be taken
    finish.diffuse = 0.4;
    notes.scene(scene_of(finish, dice.color()));
    const auto ask = [&](const Directions& d, double truth, const std::string& about) {
        notes.ask(query("blinn", d), about, close_to(V(truth)));
    };
    const double a = finish.specular, m = 1 / roughness, wide = half_width(m);
    ask(around_half(dice, dice.between(0.2, 1.2), 0), a, "normal along the half vector: the whole highlight");
    ask(around_half(dice, 0, 0), a, "viewer and light both on the normal: the whole highlight");
    for (int i = 0; i < 2; ++i)
        ask(around_half(dice, dice.between(0.2, 0.8), wide), a / 2,
            "half the highlight at acos(2^-roughness) between n and h");
    for (int i = 0; i < 2; ++i) {
        const double off = dice.between(0, std::min(2 * wide, 0.7));
        ask(around_half(dice, dice.between(0.1, 0.8), off), a * std::pow(std::cos(off), m),
            "specular (n . h)^(1 / roughness)");
    }
    ask(light_behind(dice, dice.between(0.02, 0.1)), 0, "light behind the surface: no highlight");
    if (roughness < 0.02) return;
    const V n = dice.unit();
    const V l = tilted(n, kPi / 2 - 1e-4, dice.between(0, 6));
    ask({n, l, glm::normalize(2 * glm::dot(n, l) * n - l)}, a,
        "light and viewer nearly opposite, both grazing: h is still n");
    ask({n, l, -l}, 0, "light exactly opposite to the viewer: no half vector, no highlight, no NaN");
}

void ask_metal(Notebook& notes, Dice& dice, double metallic) {
    Finish finish;
    finish.specular = finish.phong = 0.8;
    finish.metallic = metallic;
    const V color = dice.color();
    notes.scene(scene_of(finish, color));
    const auto ask = [&](double angle, const std::string& about) {
        const V n = dice.unit(), l = tilted(n, angle, dice.between(0, 6));
        const Directions d{n, l, tilted(n, dice.between(0, 1.4), dice.between(0, 6))};
        notes.ask(query("highlight_color", d), about, close_to(highlight_tint(finish, color, n, l)));
    };
    if (metallic == 0) {
        ask(0.3, "no metal: a white highlight on a coloured surface");
        ask(1.3, "no metal: a white highlight on a coloured surface");
        return;
    }
    ask(0, "metal, light on the normal: the surface's colour");
    ask(1.0, "metal, in between: the surface's colour fades into the light's");
    ask(dice.between(1.2, 1.5), "metal, light low: nearly the light's colour");
}

}  // namespace

std::vector<Question> blinns(std::uint64_t seed) {
    Dice dice(seed);
    Notebook notes("2.5");
    for (const double roughness : {0.25, 0.05, 0.005}) ask_blinn(notes, dice, roughness);
    for (const double metallic : {0.0, 1.0, 0.5}) ask_metal(notes, dice, metallic);
    return notes.take();
}

}  // namespace rays::grader::step_2
