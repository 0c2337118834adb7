// Questions about lights with an area (5.8) and about time (5.9).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "questions/step_5.h"

namespace rays::grader::step_5 {
namespace {

using construct::number;
using construct::numbers;
using construct::vector;

struct AreaLight {
    V location, point_at, color, u, v;
    std::string kind = "", words = "";  ///< "spotlight ..", "circular orient"

    std::string text() const {
        return fmt::format("light_source {{ {}, rgb {} {}\n  area_light {}, {}, 5, 5 {} }}\n", vector(location),
                           vector(color), kind, vector(u), vector(v), words);
    }
};

V colour(Dice& dice) { return {dice.round_between(0.1, 2), dice.round_between(0.1, 2), dice.round_between(0.1, 2)}; }

AreaLight area_light(Dice& dice, bool spot, const std::string& words) {
    AreaLight light{dice.position(5),
                    dice.position(5),
                    colour(dice),
                    construct::rounded(dice.round_between(0.5, 4) * dice.unit()),
                    V(0),
                    "",
                    words};
    V x, y;
    construct::frame(glm::normalize(light.u), x, y);
    // Neither at right angles to the other axis nor as long.
    light.v = construct::rounded(dice.round_between(0.5, 4) *
                                 glm::normalize(x + dice.between(-0.6, 0.6) * glm::normalize(light.u)));
    if (spot)
        light.kind = fmt::format("spotlight radius 20 falloff 30 tightness 1 point_at {}", vector(light.point_at));
    return light;
}

/// The light is moved as a whole, is no area any more, and keeps its colour. The moves, to be judged.
std::vector<V> moves(const Table& t, const AreaLight& light, bool has_target, Claims& claims) {
    std::vector<V> all;
    for (std::size_t i = 0; i < t.rows(); ++i) {
        const V move = t.triple(i) - light.location;
        if (has_target)
            claims.within(glm::length(t.triple(i, 3) - light.point_at - move), 0, 1e-6L,
                          "distance of point_at from where the same move brings it");
        claims.within(glm::length(t.triple(i, 6) - light.color), 0, 1e-5L, "difference to the light's whole colour");
        claims.holds(t.at(i, 9) == 0, "a light without an area");
        all.push_back(move);
    }
    return all;
}

constexpr std::size_t kWidth = 10;

void ask_area(Notebook& book, Dice& dice, const std::string& words, bool spot) {
    AreaLight light = area_light(dice, spot, words);
    const bool orient = words.find("orient") != std::string::npos;
    if (orient) light.v = construct::rounded(glm::length(light.u) * glm::normalize(light.v));
    const Centers centers = orient ? Centers{40, 40, dice.round_between(0, 0.999)} : random_centers(dice, 40);
    const V side = dice.unit();
    const std::string what = orient ? "a ball" : words == "circular" ? "an ellipse" : "a parallelogram";
    book.scene(construct::scene_of(light.text()));
    book.ask("light_at 0 " + centers.text(),
             fmt::format("{}{}: moved as a whole to its points", what, spot ? " of a spotlight" : ""),
             rows_hold(centers.count(), kWidth, what + " of light, evenly", [=](const Table& t, Claims& claims) {
                 const auto all = moves(t, light, spot, claims);
                 if (orient) {
                     std::vector<V> points;
                     for (const V& m : all) points.push_back(m / (glm::length(light.u) / 2));
                     return claim_ball(claims, points, side);
                 }
                 std::vector<V2> points;
                 for (const V& m : all) {
                     const InPlane at = in_plane(m, light.u, light.v);
                     claims.within(at.off, 0, 1e-6L, "distance from the light's plane");
                     points.push_back(words == "circular" ? 2.0L * at.at : at.at);
                 }
                 if (words == "circular")
                     claim_disc(claims, centers, points);
                 else
                     claim_square(claims, centers, points);
             }));
}

void ask_plain(Notebook& book, Dice& dice, bool spot) {
    AreaLight light = area_light(dice, spot, "");
    const std::string text =
        fmt::format("light_source {{ {}, rgb {} {} }}\n", vector(light.location), vector(light.color), light.kind);
    book.scene(construct::scene_of(text));
    book.ask("light_at 0 " + chance(dice), "a light without an area stays as it is",
             rows_hold(1, kWidth, "the light as it is", [=](const Table& t, Claims& claims) {
                 for (const V& m : moves(t, light, spot, claims))
                     claims.within(glm::length(m), 0, 1e-9L, "how far it was moved");
             }));
}

}  // namespace

std::vector<Question> area_lights(std::uint64_t seed) {
    Dice dice(seed);
    Notebook book("5.8");
    for (int i = 0; i < 6; ++i) ask_area(book, dice, "", i >= 3);
    for (int i = 0; i < 6; ++i) ask_area(book, dice, "circular", i >= 3);
    for (int i = 0; i < 6; ++i) ask_area(book, dice, "circular orient", i >= 3);
    for (int i = 0; i < 6; ++i) ask_plain(book, dice, i >= 3);
    return book.take();
}

// ---- 5.9 ---------------------------------------------------------------------------------------------------------------

namespace {

void ask_shutter(Notebook& book, Dice& dice) {
    const L open = dice.round_between(0, 0.6), close = open + dice.round_between(0.1, 0.4);
    book.scene(
        fmt::format("#version 3.7;\nglobal_settings {{ assumed_gamma 1 }}\ncamera {{ location -5 * z\n#ifdef "
                    "(Raysteps) shutter {}, {} #end\n}}\n",
                    number(open), number(close)));
    book.ask("shutter grid 100 1 0", "times from open to close, evenly",
             rows_hold(100, 1, fmt::format("evenly from {} to {}", number(open), number(close)),
                       [=](const Table& t, Claims& claims) {
                           std::vector<L> times;
                           for (std::size_t i = 0; i < t.rows(); ++i) times.push_back(t.at(i, 0));
                           std::sort(times.begin(), times.end());
                           // Whichever way round: as many before each time as it is late.
                           for (std::size_t i = 0; i < times.size(); ++i)
                               claims.within(times[i], open + (L(i) + 0.5L) / 100 * (close - open), 1e-6L,
                                             "one of a hundred times");
                       }));
    book.ask("shutter 0 0.5 0.5", "the first or the last time",
             rows_hold(1, 1, fmt::format("{} or {}", number(open), number(close)), [=](const Table& t, Claims& claims) {
                 claims.holds(std::abs(t.at(0, 0) - open) < 1e-6L || std::abs(t.at(0, 0) - close) < 1e-6L,
                              fmt::format("{} (or {})", number(open), number(close)));
             }));
    const L still = dice.round_between(0.1, 1);
    book.scene(
        fmt::format("#version 3.7;\nglobal_settings {{ assumed_gamma 1 }}\ncamera {{ location -5 * z\n#ifdef "
                    "(Raysteps) shutter {0}, {0} #end\n}}\n",
                    number(still)));
    book.ask("shutter " + chance(dice), "a shutter that is open for no time", is_number(still, 1e-9L));
}

struct Track {
    L first, last;
    std::vector<L> samples;

    std::string query(const std::vector<L>& times) const {
        std::string text = fmt::format("value_at {} {} {}", number(first), number(last), samples.size());
        for (const L s : samples) text += " " + number(s);
        text += fmt::format(" {}", times.size());
        for (const L t : times) text += " " + number(t);
        return text;
    }
    L step() const { return (last - first) / static_cast<L>(samples.size() - 1); }
};

Track track(Dice& dice, int samples) {
    Track t{dice.round_between(-2, 2), 0, {}};
    t.last = construct::rounded(t.first + dice.round_between(0.5, 3));
    for (int i = 0; i < samples; ++i) t.samples.push_back(dice.round_between(-10, 10));
    return t;
}

Judge values_are(std::vector<L> truth) {
    return rows_hold(truth.size(), 1, fmt::format("{}, ...", number(truth[0])), [=](const Table& t, Claims& claims) {
        for (std::size_t i = 0; i < truth.size(); ++i) {
            claims.error(std::abs(t.at(i, 0) - truth[i]));
            claims.within(t.at(i, 0), truth[i], 1e-6L * (1 + std::abs(truth[i])),
                          fmt::format("value number {}", i + 1));
        }
    });
}

void ask_track(Notebook& book, Dice& dice, int samples) {
    const Track t = track(dice, samples);
    const auto n = static_cast<std::size_t>(samples);
    std::vector<L> times, truth;
    for (std::size_t i = 0; i < n; ++i)
        times.push_back(construct::rounded(t.first + L(i) * t.step())), truth.push_back(t.samples[i]);
    book.ask(t.query(times), fmt::format("{} samples: what they are, where they are", samples), values_are(truth));
    times.clear(), truth.clear();
    for (int i = 0; i < 8; ++i) {
        const auto k = static_cast<std::size_t>(dice.whole(0, samples - 2));
        const L share = dice.round_between(0.05, 0.95);
        times.push_back(construct::rounded(t.first + (L(k) + share) * t.step()));
        truth.push_back(t.samples[k] + share * (t.samples[k + 1] - t.samples[k]));
    }
    book.ask(t.query(times), fmt::format("{} samples: in between, on the straight line", samples), values_are(truth));
    const L far = dice.round_between(0.1, 100);
    book.ask(t.query({t.first - far, t.last + far, t.first - 1e6L, t.last + 1e6L}),
             fmt::format("{} samples: before the first and after the last", samples),
             values_are({t.samples.front(), t.samples.back(), t.samples.front(), t.samples.back()}));
}

void ask_one_sample(Notebook& book, Dice& dice) {
    const Track t = track(dice, 1);
    book.ask(t.query({t.first, t.last, (t.first + t.last) / 2, t.first - 5, t.last + 5}), "a table of one sample",
             values_are(std::vector<L>(5, t.samples[0])));
}

}  // namespace

std::vector<Question> times(std::uint64_t seed) {
    Dice dice(seed);
    Notebook book("5.9");
    for (int i = 0; i < 3; ++i) ask_shutter(book, dice);
    book.scene(construct::scene_of(""));
    for (const int samples : {2, 3, 5, 20, dice.whole(6, 12)}) ask_track(book, dice, samples);
    for (int i = 0; i < 2; ++i) ask_one_sample(book, dice);
    return book.take();
}

}  // namespace rays::grader::step_5
