// Questions about the whole (2.10): one camera ray, and the light that it must bring home.
#include <fmt/format.h>

#include "questions/step_2.h"

namespace rays::grader::step_2 {
namespace {

/// One sphere to look at, lamps around it, and balls in the way of some of them.
struct World {
    V center{0}, color{1}, ambient_light{1};
    double radius = 2;
    Finish finish;
    std::vector<Lamp> lamps;
    std::vector<bool> blocked;  ///< lamp by lamp: a small ball stands before it

    std::string text() const {
        std::string sdl = header(ambient_light) + sphere(center, radius, rgb(color), finish.text());
        for (std::size_t i = 0; i < lamps.size(); ++i) {
            sdl += lamps[i].text();
            if (blocked[i])
                sdl += sphere(lamps[i].location + 0.1 * (center - lamps[i].location), 1, "rgb 1", "ambient 0");
        }
        return sdl;
    }

    V seen(const V& n, const V& v) const {
        const V p = center + radius * n;
        V sum = color * (finish.ambient * ambient_light + finish.emission);
        for (std::size_t i = 0; i < lamps.size(); ++i)
            if (!blocked[i] || lamps[i].shadowless)
                sum += lamps[i].arriving(p) * shaded(finish, color, n, lamps[i].towards(p), v, lamps[i].shadowless);
        return sum;
    }
};

Finish glossy(Dice& dice) {
    Finish finish;
    finish.ambient = V(dice.round_between(0.05, 0.3));
    finish.diffuse = dice.round_between(0.3, 0.7);
    finish.phong = dice.round_between(0.2, 0.6);
    finish.phong_size = dice.round_between(5, 30);
    finish.specular = dice.round_between(0.2, 0.6);
    finish.roughness = 0.05;
    return finish;
}

World world(Dice& dice, int lamps) {
    World w;
    w.center = dice.position(4);
    w.color = dice.color();
    w.finish = glossy(dice);
    for (int i = 0; i < lamps; ++i) {
        // 20 away in about one direction, so that one side of the sphere sees all of them; 6 from each other, so that
        // the ball before one does not stand before another.
        const V aside = 6.0 * (i - 1) * glm::normalize(V(3, 0, 4));
        w.lamps.push_back({w.center + V(12, 14, -9) + aside + dice.position(0.5), dice.color()});
        w.blocked.push_back(false);
    }
    return w;
}

const V kTowardsLamps = glm::normalize(V(12, 14, -9));

/// Looks at the point of the sphere in direction n from its centre, from where the lamps' mirror images may show.
void look(Notebook& notes, Dice& dice, const World& w, const V& n, const std::string& about) {
    const V v = tilted(n, dice.between(0.2, 0.9), dice.between(0, 6));
    notes.ask("radiance " + numbers(w.center + w.radius * n + 3.0 * v) + " " + numbers(-v), about,
              close_to(w.seen(n, v)));
}

V lit_side(Dice& dice) { return tilted(kTowardsLamps, dice.between(0, 0.7), dice.between(0, 6)); }

void ask_superposition(Notebook& notes, Dice& dice) {
    for (int lamps = 1; lamps <= 3; ++lamps) {
        const World w = world(dice, lamps);
        notes.scene(w.text());
        for (int i = 0; i < 3; ++i)
            look(notes, dice, w, lit_side(dice),
                 fmt::format("{} light{}: ambient once, and every light adds its part", lamps, lamps > 1 ? "s" : ""));
    }
}

void ask_umbra(Notebook& notes, Dice& dice) {
    World w = world(dice, 1);
    w.blocked[0] = true;
    notes.scene(w.text());
    // The ball before the lamp has radius 1 at a tenth of the way: its shadow covers the whole sphere.
    for (int i = 0; i < 3; ++i) look(notes, dice, w, lit_side(dice), "in full shadow the ambient light remains");
    World two = world(dice, 2);
    two.blocked[0] = true;
    notes.scene(two.text());
    for (int i = 0; i < 3; ++i)
        look(notes, dice, two, lit_side(dice), "one light blocked: the other one still adds its part");
}

void ask_dark_side(Notebook& notes, Dice& dice) {
    const World w = world(dice, 2);
    notes.scene(w.text());
    for (int i = 0; i < 3; ++i)
        look(notes, dice, w, tilted(-kTowardsLamps, dice.between(0, 0.6), dice.between(0, 6)),
             "the dark side shows ambient light only");
}

void ask_shadowless(Notebook& notes, Dice& dice) {
    World w = world(dice, 2);
    w.lamps[0].shadowless = true;
    w.blocked[0] = true;
    notes.scene(w.text());
    for (int i = 0; i < 3; ++i)
        look(notes, dice, w, lit_side(dice), "a shadowless light shines through everything, and makes no highlight");
}

void ask_metal_and_fading(Notebook& notes, Dice& dice) {
    World w = world(dice, 2);
    w.finish.metallic = 1;
    w.finish.emission = dice.color() * 0.25;
    w.ambient_light = dice.color();
    for (Lamp& lamp : w.lamps) lamp.fade_distance = 12, lamp.fade_power = 2;
    notes.scene(w.text());
    for (int i = 0; i < 3; ++i) look(notes, dice, w, lit_side(dice), "metal under fading lights");
}

/// From inside a sphere, the normal is turned to the viewer; the shell shades the light outside.
void ask_inside(Notebook& notes, Dice& dice) {
    World w = world(dice, 1);
    w.radius = 5;
    w.lamps[0].location = w.center + dice.position(0.5);
    notes.scene(w.text());
    for (int i = 0; i < 3; ++i) {
        const V n = dice.unit(), p = w.center + w.radius * n, eye = w.center + V(0.7, -0.4, 0.2);
        const V v = glm::normalize(eye - p);
        const V truth =
            w.color * w.finish.ambient + w.lamps[0].color * shaded(w.finish, w.color, -n, w.lamps[0].towards(p), v);
        notes.ask("radiance " + numbers(eye) + " " + numbers(-v), "a sphere lit and seen from inside", close_to(truth));
    }
}

}  // namespace

std::vector<Question> sums(std::uint64_t seed) {
    Dice dice(seed);
    Notebook notes("2.10");
    for (const auto part :
         {ask_superposition, ask_umbra, ask_dark_side, ask_shadowless, ask_metal_and_fading, ask_inside})
        part(notes, dice);
    return notes.take();
}

}  // namespace rays::grader::step_2
