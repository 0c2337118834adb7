// Questions about when samples are enough (5.11), dimensions (5.12) and what a scene needs (5.13).
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "questions/step_5.h"

namespace rays::grader::step_5 {
namespace {

using construct::number;

constexpr L kInfinite = std::numeric_limits<L>::infinity();
const std::string kScene = construct::scene_of("");

// ---- 5.11 --------------------------------------------------------------------------------------------------------------

using Lanes = std::array<L, 4>;
using Groups = std::array<Lanes, 4>;

std::string error_query(int samples, const Groups& sums) {
    std::string text = fmt::format("standard_error {}", samples);
    for (const Lanes& group : sums)
        for (const L lane : group) text += " " + number(lane);
    return text;
}

/// From the groups' means, in long double.
L standard_error(int samples, const Groups& sums) {
    L largest = 0;
    for (std::size_t lane = 0; lane < 4; ++lane) {
        L mean = 0, squares = 0;
        for (const Lanes& g : sums) mean += g[lane] / samples;
        for (const Lanes& g : sums) squares += std::pow(g[lane] * 4 / samples - mean, 2);
        largest = std::max(largest, std::sqrt(squares / 12));
    }
    return largest;
}

void ask_closed_errors(Notebook& book) {
    // Means 1, 2, 3, 4: the variance is 5/3, a quarter of it 5/12.
    Groups sums{};
    for (std::size_t g = 0; g < 4; ++g) sums[g][0] = 2 * L(g + 1);
    book.ask(error_query(8, sums), "groups whose means are 1, 2, 3, 4", is_number(std::sqrt(5.0L / 12), 1e-4L));
    book.ask(error_query(8, {{{1, 1, 1, 0}, {1, 1, 1, 0}, {1, 1, 1, 0}, {1, 1, 1, 0}}}), "groups that agree",
             is_number(0, 1e-6L));
    for (const int samples : {0, 1, 2, 3})
        book.ask(error_query(samples, sums), fmt::format("{} samples say nothing", samples), is_number(kInfinite, 0));
}

void ask_errors(Notebook& book, Dice& dice) {
    for (const std::size_t only : {0u, 1u, 2u, 3u, 4u, 4u, 4u, 4u}) {
        const int samples = 4 * dice.whole(1, 64);
        Groups sums{};
        for (Lanes& g : sums)
            for (std::size_t lane = 0; lane < 4; ++lane)
                g[lane] = only == 4 || only == lane ? dice.round_between(0, 2) * samples / 4 : L(samples) / 4;
        for (Lanes& g : sums)
            for (L& lane : g) lane = construct::rounded(lane);
        const L truth = standard_error(samples, sums);
        book.ask(error_query(samples, sums),
                 only < 4 ? fmt::format("only lane {} is uncertain", only) : "the lane where it is largest counts",
                 is_number(truth, 1e-4L * truth + 1e-6L));
    }
}

std::string enough_query(L own, L wanted, const std::vector<L>& around) {
    std::string text = fmt::format("is_enough {} {} {}", number(own), number(wanted), around.size());
    for (const L e : around) text += " " + number(e);
    return text;
}

void ask_enough(Notebook& book, Dice& dice) {
    const L wanted = dice.round_between(0.01, 0.1);
    const auto around = [&](std::size_t n, double least, double most) {
        std::vector<L> errors;
        while (errors.size() < n) errors.push_back(wanted * dice.between(least, most));
        return errors;
    };
    const auto ask = [&](L own, const std::vector<L>& errors, bool truth, const std::string& about) {
        book.ask(enough_query(own, wanted, errors), about, construct::says(truth));
    };
    ask(wanted * dice.between(0.1, 0.9), around(8, 0, 0.9), true, "small everywhere");
    ask(wanted * dice.between(0.1, 0.9), around(8, 1.1, 2), true, "neighbours a little above");
    ask(0, {}, true, "a picture of one pixel");
    ask(wanted, around(3, 0, 1), true, "exactly as wanted, in a corner");
    ask(wanted * dice.between(1.05, 3), around(8, 0, 0.5), false, "its own error is too large");
    for (const std::size_t n : {8u, 5u, 3u}) {
        auto errors = around(n, 0, 0.5);
        errors[static_cast<std::size_t>(dice.whole(0, int(n) - 1))] = wanted * dice.between(8, 30);
        ask(wanted * dice.between(0, 0.5), errors, false, fmt::format("one of {} neighbours is far from enough", n));
    }
    auto errors = around(8, 0, 0.5);
    errors.back() = kInfinite;
    ask(wanted * 0.5L, errors, false, "of a neighbour nothing is known");
    ask(kInfinite, around(8, 0, 0.5), false, "of itself nothing is known");
    ask(std::numeric_limits<L>::quiet_NaN(), around(8, 0, 0.5), false, "not a number is not enough");
}

}  // namespace

std::vector<Question> errors(std::uint64_t seed) {
    Dice dice(seed);
    Notebook book("5.11");
    book.scene(kScene);
    ask_closed_errors(book);
    ask_errors(book, dice);
    for (int i = 0; i < 2; ++i) ask_enough(book, dice);
    return book.take();
}

// ---- 5.12 --------------------------------------------------------------------------------------------------------------

std::vector<Question> dimensions(std::uint64_t seed) {
    Dice dice(seed);
    Notebook book("5.12");
    book.scene(kScene);
    const auto ask = [&](int lights, int surfaces) {
        const auto count = static_cast<std::size_t>(3 + 2 * lights + surfaces);
        book.ask(fmt::format("dimensions {} {}", lights, surfaces),
                 fmt::format("{} lights, {} rough surfaces: all of their own", lights, surfaces),
                 rows_hold(count, 1, fmt::format("{} different numbers", count), [=](const Table& t, Claims& claims) {
                     const std::set<double> different(t.numbers.begin(), t.numbers.end());
                     claims.holds(different.size() == count,
                                  fmt::format("{} different numbers, not {}", count, different.size()));
                     claims.holds(*different.begin() >= 0, "no number below zero");
                 }));
    };
    for (int lights = 0; lights <= 8; ++lights) ask(lights, dice.whole(1, 20));
    for (int lights = 0; lights <= 8; ++lights) ask(lights, dice.whole(40, 400));
    for (int i = 0; i < 6; ++i) ask(dice.whole(9, 300), dice.whole(1, 300));
    return book.take();
}

// ---- 5.13 --------------------------------------------------------------------------------------------------------------

namespace {

/// A camera with square pixels and nothing askew, however long its vectors.
struct View {
    LensCamera camera;
    int width, height;

    /// Where the edges of the lens see a point of this depth in the plane of focus: by similar triangles, in pixels
    /// there.
    L blur(L depth) const {
        const L film = glm::length(camera.direction), sharp = camera.focus * film, lens = camera.aperture / 2;
        const L pixel = glm::length(camera.right) / width * (camera.orthographic ? 1 : camera.focus);
        return lens * (std::isinf(depth) ? 1 : std::abs(depth - sharp) / depth) / pixel;
    }
    std::string query(L nearest, L farthest) const {
        return fmt::format("blur {} {} {} {}", width, height, number(nearest), number(farthest));
    }
};

View view(Dice& dice, bool turned) {
    View v{upright_camera(dice), 4 * dice.whole(20, 100), 3 * dice.whole(20, 100)};
    const V n = turned ? dice.unit() : V(0, 0, 1);
    V x, y;
    construct::frame(n, x, y);
    const L right = dice.round_between(0.8, 2);
    v.camera.direction = construct::rounded(glm::length(v.camera.direction) * n);
    v.camera.right = construct::rounded(right * x);
    v.camera.up = construct::rounded(right * v.height / v.width * y);
    return v;
}

void ask_blur(Notebook& book, Dice& dice, bool orthographic) {
    for (int i = 0; i < 2; ++i) {
        View v = view(dice, i == 1);
        v.camera.orthographic = orthographic;
        book.scene(v.camera.scene());
        const L sharp = v.camera.focus * glm::length(v.camera.direction);
        const L nearer = construct::rounded(sharp * dice.round_between(0.2, 0.8)),
                beyond = construct::rounded(sharp * dice.round_between(1.2, 5));
        const auto ask = [&](L nearest, L farthest, const std::string& about) {
            const L truth = std::max(v.blur(nearest), v.blur(farthest));
            book.ask(v.query(nearest, farthest), about, is_number(truth, 1e-6L * (1 + truth)));
        };
        const std::string kind = orthographic ? ", orthographic" : "";
        ask(nearer, construct::rounded(sharp * 1.01L), "the near end is less sharp" + kind);
        ask(construct::rounded(sharp * 0.99L), beyond, "the far end is less sharp" + kind);
        ask(construct::rounded(sharp * 0.8L), kInfinite, "to infinity" + kind);
        ask(nearer, nearer, "all at one depth" + kind);
    }
}

}  // namespace

std::vector<Question> blurs(std::uint64_t seed) {
    Dice dice(seed);
    Notebook book("5.13");
    ask_blur(book, dice, false);
    ask_blur(book, dice, true);
    for (int i = 0; i < 3; ++i) {
        View v = view(dice, true);
        v.camera.aperture = 0;
        book.scene(v.camera.scene());
        book.ask(v.query(dice.round_between(0.1, 3), i == 0 ? kInfinite : 100), "a closed aperture blurs nothing",
                 is_number(0, 1e-12L));
    }
    book.scene(kScene);
    for (int i = 0; i < 6; ++i) {
        const L diameter = dice.round_between(0.1, 3), to_edge = dice.round_between(1, 10),
                behind = dice.round_between(0.1, 20);
        const L truth = diameter * behind / to_edge;
        book.ask(fmt::format("penumbra {} {} {}", number(diameter), number(to_edge), number(behind)),
                 "similar triangles at the edge", is_number(truth, 1e-6L * truth));
    }
    book.ask(fmt::format("penumbra {} inf {}", number(dice.round_between(0.1, 3)), number(dice.round_between(1, 10))),
             "no edge at all", is_number(0, 0));
    book.ask(fmt::format("penumbra 0 {} {}", number(dice.round_between(0.1, 3)), number(dice.round_between(1, 10))),
             "a point light", is_number(0, 1e-12L));
    return book.take();
}

}  // namespace rays::grader::step_5
