// Questions about rough surfaces (5.10): how far normals tilt, and what they never do.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "questions/step_5.h"

namespace rays::grader::step_5 {

using construct::number;
using construct::numbers;

std::string rough_scene(L glossy) {
    return construct::scene_of(
        fmt::format("sphere {{ 0, 1\n#ifdef (Raysteps) finish {{ glossy {} }} #end\n}}\n", number(glossy)));
}

void claim_proper_normals(Claims& claims, const Table& t, const V& geometric, const V& viewer) {
    // Exactly in the surface, or at right angles to the viewer, but for rounding.
    constexpr L kRounding = 1e-6L;
    for (std::size_t i = 0; i < t.rows(); ++i) {
        const V n = t.triple(i);
        claims.within(glm::length(n), 1, 1e-6L, "length of a normal");
        const L towards = glm::dot(n, viewer);
        claims.holds(towards > -kRounding, "normals that face the viewer");
        const V mirrored = 2 * towards * n - viewer;
        claims.error(std::max(0.0L, -glm::dot(mirrored, geometric)));
        claims.holds(glm::dot(mirrored, geometric) > -kRounding, "mirror rays that leave the true surface");
    }
}

namespace {

struct Place {
    V normal, geometric, viewer;
    std::string text() const { return numbers(normal) + " " + numbers(geometric) + " " + numbers(viewer); }
};

/// A unit vector at this angle from another, to any side.
V at_angle(const V& n, L angle, L side) {
    V x, y;
    construct::frame(n, x, y);
    return std::cos(angle) * n + std::sin(angle) * (std::cos(side) * x + std::sin(side) * y);
}

/// The uniform number that a right tilt was made from is cos^(1/glossy + 2), or 1 less that.
void claim_slopes(Claims& claims, const std::vector<V>& normals, const V& n, L exponent) {
    const auto count = normals.size();
    V x, y;
    construct::frame(n, x, y);
    std::vector<L> power, side;
    for (const V& t : normals) {
        // The cosine of a small angle by its sine: numbers of 17 digits are good to a small part of that.
        const L sine = glm::length(glm::cross(t, n));
        const L cosine = std::sqrt(std::max(0.0L, 1 - sine * sine));
        power.push_back(std::pow(cosine, exponent));
        side.push_back(std::atan2(glm::dot(t, y), glm::dot(t, x)));
    }
    const auto mean = [&](const std::function<L(std::size_t)>& f) { return mean_of(count, f); };
    claims.within(mean([&](std::size_t i) { return power[i]; }), 0.5L, 0.004L, "mean of cos^(m + 2)");
    claims.within(mean([&](std::size_t i) { return power[i] * power[i]; }), 1.0L / 3, 0.004L,
                  "mean square of cos^(m + 2)");
    for (const int turns : {1, 2}) {
        claims.within(mean([&](std::size_t i) { return std::cos(turns * side[i]); }), 0, 0.02L,
                      "mean cosine of the side that it tilts to");
        claims.within(mean([&](std::size_t i) { return std::sin(turns * side[i]); }), 0, 0.02L,
                      "mean sine of the side that it tilts to");
    }
    claims.within(mean([&](std::size_t i) { return (power[i] - 0.5L) * std::cos(side[i]); }), 0, 0.02L,
                  "covariance of angle and side");
}

std::vector<V> normals_in(const Table& t) {
    std::vector<V> all;
    for (std::size_t i = 0; i < t.rows(); ++i) all.push_back(t.triple(i));
    return all;
}

void ask(Notebook& book, Dice& dice, L glossy, const Place& place, const std::string& about,
         std::function<void(const Table&, Claims&)> more) {
    const Centers centers = random_centers(dice);
    book.scene(rough_scene(glossy));
    book.ask("tilt 0 " + place.text() + " " + centers.text(), about,
             rows_hold(centers.count(), 3, "normals tilted by chance", [=](const Table& t, Claims& claims) {
                 claim_proper_normals(claims, t, place.geometric, place.viewer);
                 more(t, claims);
             }));
}

/// So small a tilt that nothing turns away and nothing is mirrored below the surface: the law of the angle by itself.
void ask_law(Notebook& book, Dice& dice, L glossy, L view_angle) {
    const V n = construct::rounded(dice.unit());
    const Place place{n, n, construct::rounded(at_angle(n, view_angle, dice.between(0, 6.28)))};
    ask(book, dice, glossy, place, fmt::format("the law of the tilt, glossy {}", number(glossy)),
        [=](const Table& t, Claims& claims) { claim_slopes(claims, normals_in(t), n, 1 / glossy + 2); });
}

/// Seen straight on: tilts of more than 45 degrees mirror below the surface, and mirrored there become 90 degrees less
/// that.
void ask_horizon(Notebook& book, Dice& dice, L glossy) {
    const V n = construct::rounded(dice.unit());
    const L exponent = 1 / glossy + 2;
    ask(book, dice, glossy, {n, n, n},
        fmt::format("seen straight on, glossy {}: what mirrors below the surface is mirrored there", number(glossy)),
        [=](const Table& t, Claims& claims) {
            const auto normals = normals_in(t);
            for (const L degrees : {10.0L, 20.0L, 30.0L, 40.0L}) {
                const L cosine = std::cos(degrees * construct::kPi / 180), sine = std::sqrt(1 - cosine * cosine);
                const L truth = 1 - std::pow(cosine, exponent) + std::pow(sine, exponent);
                claims.within(
                    mean_of(normals.size(), [&](std::size_t i) { return glm::dot(normals[i], n) > cosine ? 1 : 0; }),
                    truth, 0.03L, fmt::format("share of tilts below {} degrees", double(degrees)));
            }
        });
}

/// What the contract makes of two numbers, in some frame: a law of its own is known for a few views only.
V tilted(const Place& place, L exponent, L u, L v) {
    const L cosine = std::pow(1 - u, 1 / exponent);
    const V straight = cosine * place.normal, whole = at_angle(place.normal, std::acos(cosine), 2 * construct::kPi * v);
    const V n = glm::dot(whole, place.viewer) > 0 ? whole : 2.0L * straight - whole;
    const V mirrored = 2 * glm::dot(n, place.viewer) * n - place.viewer;
    const L above = glm::dot(mirrored, place.geometric);
    return above >= 0 ? n : glm::normalize(mirrored - 2 * above * place.geometric + place.viewer);
}

void claim_means(Claims& claims, const std::vector<V>& normals, const Place& place, L exponent) {
    constexpr int kSteps = 96;
    V mean(0);
    L towards = 0, out = 0;
    for (int i = 0; i < kSteps * kSteps; ++i) {
        const V n =
            tilted(place, exponent, (i % kSteps + 0.5L) / kSteps, (i / kSteps + 0.5L) / kSteps) / L(kSteps * kSteps);
        mean += n;
        towards += glm::dot(n, place.viewer) * glm::dot(n, place.viewer) * L(kSteps * kSteps);
        out += glm::dot(n, place.geometric) * glm::dot(n, place.geometric) * L(kSteps * kSteps);
    }
    const auto found = [&](const std::function<L(const V&)>& f) {
        return mean_of(normals.size(), [&](std::size_t i) { return f(normals[i]); });
    };
    for (int a = 0; a < 3; ++a)
        claims.within(found([&](const V& n) { return n[a]; }), mean[a], 0.03L,
                      fmt::format("mean of the normals' {}", "xyz"[a]));
    claims.within(found([&](const V& n) { return glm::dot(n, place.viewer) * glm::dot(n, place.viewer); }), towards,
                  0.03L, "mean square of the cosine to the viewer");
    claims.within(found([&](const V& n) { return glm::dot(n, place.geometric) * glm::dot(n, place.geometric); }), out,
                  0.03L, "mean square of the cosine to the true normal");
}

/// From the side, where many a tilt turns away: it is taken to the other side, and all others are as they were.
void ask_side(Notebook& book, Dice& dice, L glossy, L view_angle) {
    const V n = construct::rounded(dice.unit()),
            geometric = construct::rounded(at_angle(n, dice.between(0, 0.2), dice.between(0, 6.28)));
    const V viewer = construct::rounded(at_angle(geometric, view_angle, dice.between(0, 6.28)));
    if (!(glm::dot(n, viewer) > 0)) return ask_side(book, dice, glossy, view_angle);
    ask(book, dice, glossy, {n, geometric, viewer},
        fmt::format("glossy {}, seen from {:.0f} degrees", number(glossy), double(view_angle * 180 / construct::kPi)),
        [=](const Table& t, Claims& claims) {
            claim_means(claims, normals_in(t), {n, geometric, viewer}, 1 / glossy + 2);
        });
}

}  // namespace

std::vector<Question> rough_surfaces(std::uint64_t seed) {
    Dice dice(seed);
    Notebook book("5.10");
    for (const L glossy : {0.05L, 0.04L, 0.03L}) ask_law(book, dice, glossy, 0);
    for (int i = 0; i < 3; ++i) ask_law(book, dice, dice.round_between(0.02, 0.045), 0);
    for (const L degrees : {20.0L, 40.0L, 60.0L}) ask_law(book, dice, 0.001L, degrees * construct::kPi / 180);
    for (const L glossy : {1.0L, 0.5L, 0.3L, 0.1L}) ask_horizon(book, dice, glossy);
    for (int i = 0; i < 3; ++i) ask_horizon(book, dice, dice.round_between(0.1, 1));
    for (const L glossy : {1.0L, 0.3L, 0.1L, 0.01L})
        for (const L degrees : {40.0L, 75.0L, 89.0L}) ask_side(book, dice, glossy, degrees * construct::kPi / 180);
    return book.take();
}

}  // namespace rays::grader::step_5
