// Questions about what a light sends: fading, the cone, direction and colour (2.6 to 2.8).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "questions/step_2.h"

namespace rays::grader::step_2 {
namespace {

std::string light(const V& location, const V& color, const std::string& words) {
    return fmt::format("light_source {{ {}, {} {} }}\n", vector(location), rgb(color), words);
}

/// The smooth step of POV-Ray's rims, from a number that goes from 0 at the dark end to 1 at the full one.
double rim(double s) { return s * s * (3 - 2 * s); }

}  // namespace

std::vector<Question> fadings(std::uint64_t seed) {
    Dice dice(seed);
    Notebook notes("2.6");
    const auto ask = [&](double distance, double truth, const std::string& about) {
        notes.ask("fading 0 " + number(distance), about, close_to(truth, kGeometry));
    };
    notes.scene(header() + light(dice.position(5), V(1), ""));
    ask(dice.between(1, 9), 1, "a light without fading does not fade");
    ask(dice.between(100, 900), 1, "a light without fading does not fade, however far");
    for (const char* half : {"fade_distance 2", "fade_power 2"}) {
        notes.scene(header() + light(dice.position(5), V(1), half));
        ask(dice.between(3, 9), 1, "fading needs both fade_distance and fade_power");
    }
    for (const double power : {1.0, 2.0, 3.0, 1.5}) {
        const double unit = dice.round_between(0.5, 4);
        notes.scene(header() +
                    light(dice.position(5), V(1), fmt::format("fade_distance {} fade_power {}", unit, power)));
        const auto truth = [&](double d) { return 2 / (1 + std::pow(d / unit, power)); };
        ask(unit, 1, "at fade_distance the factor is 1");
        ask(0, 2, "at the light the factor is 2: nothing is clamped");
        ask(unit / 4, truth(unit / 4), "nearer than fade_distance: more than 1");
        const double d = dice.round_between(5, 9);
        ask(d, truth(d), "2 / (1 + (d / D)^p)");
        notes.ask("fading 0 " + number(1e6 * unit), "far away: as d^-p", close_to(truth(1e6 * unit), {2e-6, 1e-30}));
    }
    // Doubling the distance of a tiny fade_distance is the inverse-square law of physics.
    notes.scene(header() + light(dice.position(5), V(1), "fade_distance 0.001 fade_power 2"));
    for (const double d : {1.0, 2.0, 4.0, 8.0})
        notes.ask("fading 0 " + number(d), "far beyond fade_distance, twice as far is a quarter of the light",
                  close_to(2e-6 / (d * d + 1e-6), {2e-6, 1e-14}));
    return notes.take();
}

namespace {

struct Beam {
    V location, axis;
    std::string words(const std::string& more) const { return more + " point_at " + vector(location + 4.0 * axis); }
};

Beam beam(Dice& dice) {
    // The axis has a clean length, so that point_at says the same direction to every reader.
    return {dice.position(3), dice.unit()};
}

void ask_spot(Notebook& notes, Dice& dice, double radius, double falloff, double tightness) {
    const Beam b = beam(dice);
    std::string words = "spotlight";
    if (radius >= 0)
        words += fmt::format(" radius {} falloff {}", radius, falloff);
    else
        radius = 30, falloff = 45;  // POV-Ray's defaults
    if (tightness > 0) words += fmt::format(" tightness {}", tightness);
    notes.scene(header() + light(b.location, V(1), b.words(words)));
    const auto ask = [&](double angle, double truth, const std::string& about) {
        const V p = b.location + dice.between(1, 9) * tilted(b.axis, radians(angle), dice.between(0, 6));
        notes.ask("cone_of_light 0 " + numbers(p), about,
                  close_to(truth * std::pow(std::cos(radians(angle)), tightness), kGeometry));
    };
    const double full = std::cos(radians(radius)), end = std::cos(radians(falloff));
    const double middle = (radius + falloff) / 2;
    const double between = (std::cos(radians(middle)) - end) / (full - end);
    if (radius > 0) ask(radius / 2, 1, "within radius: all of it (times cosine^tightness)");
    if (radius > 0) ask(0.95 * radius, 1, "still within radius: all of it");
    ask(middle, rim(between), "between radius and falloff: a smooth step of the angle's cosine");
    ask(falloff - (falloff - radius) / 5,
        rim((std::cos(radians(falloff - (falloff - radius) / 5)) - end) / (full - end)), "near the rim");
    ask(falloff + 2, 0, "beyond falloff: nothing");
    const V behind = b.location - dice.between(1, 9) * tilted(b.axis, radians(radius / 2), dice.between(0, 6));
    notes.ask("cone_of_light 0 " + numbers(behind), "behind the spotlight: nothing", close_to(0, kGeometry));
}

void ask_cylinder(Notebook& notes, Dice& dice, double radius, double falloff, double tightness) {
    const Beam b = beam(dice);
    notes.scene(header() +
                light(b.location, V(1),
                      b.words(fmt::format("cylinder radius {} falloff {} tightness {}", radius, falloff, tightness))));
    const auto ask = [&](double from_axis, double along, double truth, const std::string& about) {
        const V p = b.location + along * b.axis + from_axis * tilted(b.axis, kPi / 2, dice.between(0, 6));
        notes.ask("cone_of_light 0 " + numbers(p), about,
                  close_to(truth * std::pow(1 - from_axis / falloff, tightness), kGeometry));
    };
    const double middle = 0.3 * radius + 0.7 * falloff;
    ask(radius / 2, dice.between(1, 9), 1, "cylinder: full within radius, a distance from the axis");
    ask(middle, dice.between(1, 9), rim((falloff - middle) / (falloff - radius)),
        "cylinder: a smooth step of the distance");
    const V outside = b.location + 5.0 * b.axis + 1.1 * falloff * across(b.axis);
    notes.ask("cone_of_light 0 " + numbers(outside), "cylinder: nothing beyond falloff", close_to(0, kGeometry));
    notes.ask("cone_of_light 0 " + numbers(b.location - 2.0 * b.axis), "cylinder: nothing behind it",
              close_to(0, kGeometry));
}

}  // namespace

std::vector<Question> cones(std::uint64_t seed) {
    Dice dice(seed);
    Notebook notes("2.7");
    notes.scene(header() + light(dice.position(3), V(1), ""));
    notes.ask("cone_of_light 0 " + numbers(dice.position(9)), "a point light shines everywhere",
              close_to(1, kGeometry));
    ask_spot(notes, dice, -1, -1, 0);
    ask_spot(notes, dice, dice.round_between(5, 15), dice.round_between(30, 50), 0);
    ask_spot(notes, dice, dice.round_between(5, 15), dice.round_between(30, 50), dice.round_between(2, 20));
    ask_spot(notes, dice, 0, dice.round_between(40, 70), 0);
    ask_cylinder(notes, dice, dice.round_between(0.5, 1), dice.round_between(2, 3), 0);
    ask_cylinder(notes, dice, dice.round_between(0.5, 1), dice.round_between(2, 3), dice.round_between(1, 5));
    const Beam b = beam(dice);
    notes.scene(header() + light(b.location, V(1), b.words("spotlight parallel radius 5 falloff 10")));
    notes.ask("cone_of_light 0 " + numbers(b.location + 2.0 * b.axis + 3.0 * across(b.axis)),
              "a spotlight made parallel has no rim", close_to(1, kGeometry));
    notes.ask("cone_of_light 0 " + numbers(b.location - 2.0 * b.axis),
              "a spotlight made parallel lights nothing behind it", close_to(0, kGeometry));
    return notes.take();
}

namespace {

void ask_arrival(Notebook& notes, const V& p, const V& to_light, double distance, const V& color,
                 const std::string& about) {
    // Light in float lanes, direction and distance in Real: one tolerance for all seven numbers, relative to each part.
    const auto judge_light = close_to(color);
    const auto judge_direction = close_to(to_light, kGeometry);
    const auto judge_distance = close_to(distance, kGeometry);
    notes.ask("illuminate 0 " + numbers(p), about, [=](const Answer& answer) {
        Answer part = answer;
        const auto judged = [&](const Judge& judge, std::size_t first, std::size_t count) {
            if (answer.numbers.size() == 7)
                part.numbers.assign(answer.numbers.begin() + static_cast<long>(first),
                                    answer.numbers.begin() + static_cast<long>(first + count));
            return judge(part);
        };
        const Judgement d = judged(judge_direction, 0, 3), r = judged(judge_distance, 3, 1);
        const Judgement c = judged(judge_light, 4, 3);
        return Judgement{d.ok && r.ok && c.ok, std::max({d.error, r.error, c.error}),
                         d.expected + " " + r.expected + " " + c.expected};
    });
}

void ask_point_light(Notebook& notes, Dice& dice, const V& color) {
    const V location = dice.position(5);
    notes.scene(header() + light(location, color, ""));
    for (int i = 0; i < 4; ++i) {
        const V direction = dice.unit();
        const double distance = i == 0 ? 1 : std::pow(10, dice.between(-2, 3));
        ask_arrival(notes, location - distance * direction, direction, distance, color,
                    "point light: unit direction towards it, its distance, its colour as the scene says");
    }
    notes.ask("illuminate 0 " + numbers(location), "a light at the very point sends nothing, and no NaN",
              [](const Answer& answer) {
                  Judgement judgement{answer.kind == Answer::Kind::value && answer.numbers.size() == 7, 0,
                                      "finite numbers, then 0 0 0"};
                  for (std::size_t i = 0; i < answer.numbers.size(); ++i)
                      judgement.ok =
                          judgement.ok && (i < 4 ? std::isfinite(answer.numbers[i]) : answer.numbers[i] == 0);
                  judgement.error = judgement.ok ? 0 : 1;
                  return judgement;
              });
}

void ask_faded_light(Notebook& notes, Dice& dice) {
    const V location = dice.position(5), color = dice.color();
    const double unit = dice.round_between(1, 3);
    notes.scene(header() + light(location, color, fmt::format("fade_distance {} fade_power 2", unit)));
    for (const double distance : {unit, 3 * unit, 0.01 * unit}) {
        const V direction = dice.unit();
        ask_arrival(notes, location - distance * direction, direction, distance,
                    2 / (1 + (distance / unit) * (distance / unit)) * color,
                    "a fading light: its colour times the factor");
    }
}

/// `kind`: the words that make it a light whose rays are parallel.
void ask_parallel(Notebook& notes, Dice& dice, const std::string& kind, double fade) {
    const Beam b = beam(dice);
    const V color = dice.color();
    const std::string fading = fade > 0 ? fmt::format(" fade_distance {} fade_power 2", fade) : "";
    notes.scene(header() + light(b.location, color, b.words(kind) + fading));
    for (int i = 0; i < 4; ++i) {
        const double ahead = dice.between(1, 9);
        const V p = b.location + ahead * b.axis + dice.between(0.2, 0.8) * tilted(b.axis, kPi / 2, dice.between(0, 6));
        const double factor = fade > 0 ? 2 / (1 + ahead * ahead / (fade * fade)) : 1;
        ask_arrival(notes, p, -b.axis, ahead, factor * color,
                    "parallel light: one direction everywhere, distance to the plane across it");
    }
}

void ask_spotlight(Notebook& notes, Dice& dice) {
    const Beam b = beam(dice);
    const V color = dice.color();
    notes.scene(header() + light(b.location, color, b.words("spotlight radius 10 falloff 30")));
    for (const double angle : {4.0, 20.0, 35.0}) {
        const V direction = tilted(b.axis, radians(angle), dice.between(0, 6));
        const double distance = dice.between(1, 9), end = std::cos(radians(30)), full = std::cos(radians(10));
        const double s = std::min(1.0, std::max(0.0, (std::cos(radians(angle)) - end) / (full - end)));
        ask_arrival(notes, b.location + distance * direction, -direction, distance, rim(s) * color,
                    "spotlight: as a point light, times the cone");
    }
}

}  // namespace

std::vector<Question> illuminations(std::uint64_t seed) {
    Dice dice(seed);
    Notebook notes("2.8");
    ask_point_light(notes, dice, V(0.5));
    ask_point_light(notes, dice, dice.color());
    ask_faded_light(notes, dice);
    ask_parallel(notes, dice, "parallel", 0);
    ask_parallel(notes, dice, "parallel", 2);
    ask_parallel(notes, dice, "cylinder radius 1 falloff 2", 0);
    ask_spotlight(notes, dice);
    return notes.take();
}

}  // namespace rays::grader::step_2
