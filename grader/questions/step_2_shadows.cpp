// Questions about shadows (2.9): who blocks whose light. Every answer follows from where things were put.
#include <fmt/format.h>

#include <cmath>

#include "questions/step_2.h"

namespace rays::grader::step_2 {
namespace {

const std::string kGrey = "rgb 0.5";
const std::string kMatt = "ambient 0 diffuse 1";

std::string lamp(const V& location) { return "light_source { " + vector(location) + ", rgb 1 }\n"; }
std::string ball(const V& center, double radius, const std::string& modifiers = "") {
    return sphere(center, radius, kGrey, kMatt, modifiers);
}
std::string worn(const std::string& shape) { return shape + " pigment { " + kGrey + " } finish { " + kMatt + " } }\n"; }

void ask(Notebook& notes, const V& p, const V& n, bool truth, const std::string& about, int light = 0) {
    notes.ask(fmt::format("in_shadow {} {} {}", numbers(p), numbers(n), light), about, says(truth));
}

/// A convex body never shades the side that the light sees, and always the other one.
void ask_lone_sphere(Notebook& notes, Dice& dice) {
    // Away from the origin, where the points of the sphere are rounded: without a lower bound the sphere meets itself.
    const V center = dice.position(60);
    const double radius = dice.round_between(1, 5);
    const V to_light = dice.unit();
    notes.scene(header() + ball(center, radius) + lamp(center + 1000.0 * to_light));
    for (int i = 0; i < 12; ++i) {
        const V n = tilted(to_light, dice.between(0, 1.4), dice.between(0, 6));
        ask(notes, center + radius * n, n, false, "the lit side of a lone sphere does not shade itself");
    }
    for (int i = 0; i < 3; ++i) {
        const V n = tilted(to_light, dice.between(1.8, 3.1), dice.between(0, 6));
        ask(notes, center + radius * n, n, true, "the far side of a sphere is in its own shadow");
    }
}

/// A wall across the way from a floor to the light: only what stands between counts.
void ask_occluder_along_the_way(Notebook& notes, Dice& dice) {
    const V p(dice.round_between(-3, 3), 0, dice.round_between(-3, 3));
    const V light = p + V(dice.round_between(-2, 2), dice.round_between(5, 9), dice.round_between(-2, 2));
    const std::string world = header() + worn("plane { y, 0") + lamp(light);
    const double height = light.y;
    struct Case {
        double y;
        bool blocks;
        const char* about;
    };
    const Case cases[] = {{height / 2, true, "an occluder half way blocks the light"},
                          {height * 1.5, false, "an occluder beyond the light blocks nothing"},
                          {height + 0.01, false, "an occluder just beyond the light blocks nothing"},
                          {height - 0.05, true, "an occluder just before the light blocks it"},
                          {height, false, "an occluder exactly at the light blocks nothing"},
                          {0.02, true, "an occluder close above the surface blocks: the tolerance is small"},
                          {-2, false, "an occluder behind the surface blocks nothing"}};
    for (const Case& c : cases) {
        const V center = p + c.y / height * (light - p);
        notes.scene(world + worn(fmt::format("disc {{ {}, y, 0.5", vector(V(center.x, c.y, center.z)))));
        ask(notes, p, V(0, 1, 0), c.blocks, c.about);
    }
}

void ask_no_shadow(Notebook& notes, Dice& dice) {
    const V p(dice.round_between(-3, 3), 0, dice.round_between(-3, 3));
    const V light = p + V(0, 9, 0);
    const std::string world = header() + worn("plane { y, 0") + lamp(light);
    notes.scene(world + ball(p + V(0, 4, 0), 1, "no_shadow"));
    ask(notes, p, V(0, 1, 0), false, "an object with no_shadow blocks nothing");
    notes.scene(world + ball(p + V(0, 3, 0), 1, "no_shadow") + ball(p + V(0, 6, 0), 1));
    ask(notes, p, V(0, 1, 0), true, "behind an object with no_shadow another one still blocks");
    notes.scene(world + ball(p + V(0, 4, 0), 1) + ball(p + V(0, 7, 0), 1, "no_shadow"));
    ask(notes, p, V(0, 1, 0), true, "before an object with no_shadow another one still blocks");
}

/// Sphere of radius r at height h under a light at height H: the umbra's radius is H tan(asin(r / (H - h))).
void ask_umbra(Notebook& notes, Dice& dice) {
    const double r = dice.round_between(0.5, 1.5), h = dice.round_between(2, 3), top = h + dice.round_between(4, 9);
    notes.scene(header() + worn("plane { y, 0") + ball({0, h, 0}, r) + lamp({0, top, 0}));
    const double umbra = top * std::tan(std::asin(r / (top - h)));
    for (const double share : {0.5, 0.98, 0.995, 1.005, 1.02, 1.5}) {
        const double turn = dice.between(0, 6);
        ask(notes, share * umbra * V(std::cos(turn), 0, std::sin(turn)), V(0, 1, 0), share < 1,
            "the shadow of a sphere ends at H tan(asin(r / (H - h)))");
    }
}

void ask_concave(Notebook& notes, Dice& dice) {
    notes.scene(header() + worn("torus { 2, 0.5") + lamp({-10, 0.2, 0}) + lamp({0, 6, 0}));
    for (int i = 0; i < 3; ++i) {
        const double turn = dice.between(-0.1, 0.1);
        const V inward(-std::cos(turn), 0, -std::sin(turn));
        ask(notes, -1.5 * inward, inward, true, "a torus shades its own inner side");
        ask(notes, -1.5 * inward, inward, false, "light from above the hole reaches the inner side", 1);
    }
}

void ask_sides_and_lights(Notebook& notes, Dice& dice) {
    const V p(dice.round_between(-3, 3), 0, dice.round_between(-3, 3));
    notes.scene(header() + worn("plane { y, 0") + lamp(p + V(1, -6, 2)));
    ask(notes, p, V(0, -1, 0), false, "a plane seen and lit from below does not shade itself");
    notes.scene(header() + worn("plane { y, 0") + lamp(p + V(1, 6, 2)));
    ask(notes, p, V(0, 1, 0), false, "a plane seen and lit from above does not shade itself");
    // A light inside a hollow sphere: seen from within, but not from without.
    const V center = dice.position(4);
    notes.scene(header() + ball(center, 2) + lamp(center + V(0.3, 0.1, -0.2)));
    const V n = dice.unit();
    ask(notes, center + 2.0 * n, -n, false, "a light inside a sphere reaches its inner side");
    ask(notes, center + 5.0 * n, n, true, "a light inside a sphere does not get out");
    // Parallel rays: the lamp's own place does not matter, and its plane is where they begin.
    const std::string sun = "light_source { <0, 8, 0>, rgb 1 parallel point_at <0, 0, 0> }\n";
    notes.scene(header() + worn("plane { y, 0") + sun + ball({5, 4, 0}, 0.5) + ball({-5, 12, 0}, 0.5) +
                ball({2.5, 4, 3}, 0.5));
    ask(notes, {5, 0, 0}, V(0, 1, 0), true, "parallel light is blocked along its one direction");
    ask(notes, {5, 0, 6}, V(0, 1, 0), false, "parallel light is not blocked by what stands towards its location");
    ask(notes, {-5, 0, 0}, V(0, 1, 0), false, "what stands behind a parallel light's plane blocks nothing");
}

void ask_ranges(Notebook& notes, Dice& dice) {
    const V center = dice.position(3), axis = dice.unit();
    notes.scene(header() + ball(center, 1));
    const auto occluded = [&](double length, double t_min, double t_max, bool truth, const char* about) {
        notes.ask(
            fmt::format("occluded {} {} {} {}", numbers(center - 5.0 * axis), numbers(length * axis), t_min, t_max),
            about, says(truth));
    };
    occluded(1, 0, 10, true, "the range holds both roots");
    occluded(1, 5, 10, true, "the range begins inside the sphere: the far root counts");
    occluded(1, 0, 3.9, false, "the range ends before the sphere");
    occluded(1, 6.1, 99, false, "the range begins behind the sphere");
    occluded(1, 4.1, 5.9, false, "the range lies between the roots");
    occluded(2, 0, 2.5, true, "t counts in lengths of the direction");
    occluded(2, 3.1, 9, false, "t counts in lengths of the direction");
    occluded(1, 3, 1, false, "an empty range holds nothing");
}

}  // namespace

std::vector<Question> shadows(std::uint64_t seed) {
    Dice dice(seed);
    Notebook notes("2.9");
    for (const auto part : {ask_lone_sphere, ask_occluder_along_the_way, ask_no_shadow, ask_umbra, ask_concave,
                            ask_sides_and_lights, ask_ranges})
        part(notes, dice);
    return notes.take();
}

}  // namespace rays::grader::step_2
