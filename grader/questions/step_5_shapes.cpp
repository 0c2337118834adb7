// Questions about shapes (5.5) and filters (5.6): where the centres of a grid come to lie.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "questions/step_5.h"

namespace rays::grader::step_5 {
namespace {

using construct::number;

const std::string kScene = construct::scene_of("");

Judge points_of_grid(const Centers& centers, std::string in_short,
                     std::function<void(const std::vector<V2>&, Claims&)> claims) {
    return rows_hold(centers.count(), 2, std::move(in_short),
                     [=](const Table& table, Claims& c) { claims(points_in(table), c); });
}

/// Where formulas divide by zero or take roots of what is below it.
const std::array<const char*, 7> kCorners{"0 0 0",
                                          "0.5 0.5 0.5",
                                          "0 0.5 0.25",
                                          "0.5 0 0.75",
                                          "0.99999994039535522 0.99999994039535522 0.99999994039535522",
                                          "0 0.99999994039535522 0",
                                          "0.99999994039535522 0 0.5"};

void ask_disc(Notebook& book, Dice& dice) {
    for (int i = 0; i < 4; ++i) {
        const Centers centers = random_centers(dice, 64);
        book.ask("disc " + centers.text(), "a grid's centres fill the disc evenly",
                 points_of_grid(centers, "the unit disc, evenly",
                                [=](const std::vector<V2>& p, Claims& claims) { claim_disc(claims, centers, p); }));
    }
    for (const char* u : kCorners)
        book.ask(fmt::format("disc {}", u), "a corner or the middle of the square",
                 rows_hold(1, 2, "a point of the disc", [](const Table& t, Claims& claims) {
                     claims.holds(
                         glm::length(t.pair(0)) <= 1 + 1e-6L && std::abs(t.at(0, 0)) + std::abs(t.at(0, 1)) < 1.5L,
                         "a point of the disc");
                 }));
}

void ask_polygon(Notebook& book, Dice& dice) {
    for (const int corners : {3, 4, 5, 6, 7, 8, dice.whole(9, 16)}) {
        const Centers centers{64, 64, dice.round_between(0, 0.999)};  // as many columns to every side, or one more
        book.ask(fmt::format("polygon {} {}", corners, centers.text()),
                 fmt::format("a grid's centres fill a polygon of {} corners evenly", corners),
                 points_of_grid(centers, "the polygon, evenly", [=](const std::vector<V2>& p, Claims& claims) {
                     claim_polygon(claims, centers, p, corners);
                 }));
    }
    for (const char* u : kCorners) {
        const int corners = dice.whole(3, 12);
        book.ask(fmt::format("polygon {} {}", corners, u), "a corner or the middle of the square",
                 rows_hold(1, 2, "a point of the polygon", [=](const Table& t, Claims& claims) {
                     for (int k = 0; k < corners; ++k) {
                         const L angle = (2 * k + 1) * construct::kPi / corners;
                         claims.holds(t.at(0, 0) * std::sin(angle) + t.at(0, 1) * std::cos(angle) <=
                                          std::cos(construct::kPi / corners) + 1e-6L,
                                      "a point of the polygon whose first corner is (0, 1)");
                     }
                 }));
    }
}

void ask_ball(Notebook& book, Dice& dice) {
    for (int i = 0; i < 4; ++i) {
        const Centers centers{64, 64, dice.round_between(0, 0.999)};
        const V side = dice.unit();
        book.ask(
            "ball " + centers.text(), "seen from every side a uniform disc",
            rows_hold(centers.count(), 3, "a ball that looks like a uniform disc", [=](const Table& t, Claims& claims) {
                std::vector<V> points;
                for (std::size_t k = 0; k < t.rows(); ++k) points.push_back(t.triple(k));
                claim_ball(claims, points, side);
            }));
    }
    for (const char* u : kCorners)
        book.ask(fmt::format("ball {}", u), "a corner or the middle of the cube",
                 rows_hold(1, 3, "a point of the ball", [](const Table& t, Claims& claims) {
                     const L r = glm::length(t.triple(0));
                     claims.holds(r <= 1 + 1e-6L, "a point of the ball");
                 }));
}

}  // namespace

std::vector<Question> shapes(std::uint64_t seed) {
    Dice dice(seed);
    Notebook book("5.5");
    book.scene(kScene);
    ask_disc(book, dice);
    ask_polygon(book, dice);
    ask_ball(book, dice);
    return book.take();
}

// ---- 5.6 ---------------------------------------------------------------------------------------------------------------

namespace {

L mitchell(L x) {
    x = std::abs(x);
    if (x < 1) return (21 * x * x * x - 36 * x * x + 16) / 18;
    if (x < 2) return (-7 * x * x * x + 36 * x * x - 60 * x + 32) / 18;
    return 0;
}
L tent(L x) { return std::max(0.0L, 1 - std::abs(x)); }
L box(L x) { return std::abs(x) <= 0.5L ? 1 : 0; }

struct Kind {
    const char* name;
    L reach;
    L (*value)(L);
    bool unsigned_weight;  ///< every sample counts 1

    /// Of value(x) g(x), by the midpoint rule.
    L integral(const std::function<L(L)>& g, L to) const {
        constexpr int kSteps = 4000;
        const L step = (to + reach) / kSteps;
        L sum = 0;
        for (int i = 0; i < kSteps; ++i) {
            const L x = -reach + (i + 0.5L) * step;
            sum += value(x) * g(x);
        }
        return sum * step;
    }
    L up_to(L x) const {
        return integral([](L) { return 1.0L; }, x);
    }
    L amount() const {
        return integral([&](L x) { return value(x) < 0 ? -1.0L : 1.0L; }, reach);
    }
};
const std::array<Kind, 3> kKinds{{{"box", 0.5L, box, true}, {"tent", 1, tent, true}, {"mitchell", 2, mitchell, false}}};

struct Sample {
    V2 offset;
    L weight;
};

Judge filter_of_grid(const Kind& kind, const Centers& centers,
                     std::function<void(const std::vector<Sample>&, Claims&)> claimed) {
    return rows_hold(centers.count(), 3, fmt::format("offsets of the {} filter", kind.name),
                     [=](const Table& t, Claims& claims) {
                         std::vector<Sample> all;
                         for (std::size_t i = 0; i < t.rows(); ++i) all.push_back({t.pair(i), t.at(i, 2)});
                         claims.holds(std::all_of(all.begin(), all.end(),
                                                  [&](const Sample& s) {
                                                      return std::abs(s.offset.x) <= kind.reach + 1e-6L &&
                                                             std::abs(s.offset.y) <= kind.reach + 1e-6L;
                                                  }),
                                      fmt::format("no offset beyond {}", double(kind.reach)));
                         claimed(all, claims);
                     });
}

/// Moments of the filter and of where its samples lie, and its weights.
void ask_moments(Notebook& book, Dice& dice, const Kind& kind) {
    const Centers centers = random_centers(dice, 64);
    book.ask(
        fmt::format("filter {} {}", kind.name, centers.text()),
        fmt::format("moments and weights of the {} filter", kind.name),
        filter_of_grid(kind, centers, [=](const std::vector<Sample>& s, Claims& claims) {
            const auto mean = [&](const std::function<L(const Sample&)>& f) {
                return mean_of(s.size(), [&](std::size_t i) { return f(s[i]); });
            };
            const L amount = kind.amount();
            for (const Sample& one : s)
                claims.within(std::abs(one.weight), amount * amount, 1e-4L, "amount of a weight");
            // Of the strips in which the filter is negative a grid's centres hit one more or one less.
            claims.within(mean([](const Sample& q) { return q.weight; }), 1, kind.unsigned_weight ? 1e-4L : 0.05L,
                          "mean of the weights");
            const L square = kind.integral([](L x) { return x * x; }, kind.reach);
            const L margin = 0.02L * kind.reach * kind.reach;
            claims.within(mean([](const Sample& q) { return q.weight * q.offset.x * q.offset.x; }), square, margin,
                          "mean of weight x^2");
            claims.within(mean([](const Sample& q) { return q.weight * q.offset.y * q.offset.y; }), square, margin,
                          "mean of weight y^2");
            claims.within(mean([](const Sample& q) { return q.weight * q.offset.x * q.offset.y; }), 0, margin,
                          "mean of weight x y");
            claims.within(mean([](const Sample& q) { return q.weight * q.offset.x; }), 0, margin, "mean of weight x");
            claims.within(mean([](const Sample& q) { return q.weight * q.offset.y; }), 0, margin, "mean of weight y");
        }));
}

/// What the filter makes of an edge at some place: all that lies to one side of it.
void ask_edge(Notebook& book, Dice& dice, const Kind& kind) {
    const Centers centers = random_centers(dice, 64);
    const L x = dice.round_between(-0.9 * double(kind.reach), 0.9 * double(kind.reach)),
            y = dice.round_between(-0.9 * double(kind.reach), 0.9 * double(kind.reach));
    book.ask(fmt::format("filter {} {}", kind.name, centers.text()),
             fmt::format("an edge at {} seen through the {} filter", number(x), kind.name),
             filter_of_grid(kind, centers, [=](const std::vector<Sample>& s, Claims& claims) {
                 const auto mean = [&](const std::function<bool(const Sample&)>& f) {
                     return mean_of(s.size(), [&](std::size_t i) { return f(s[i]) ? s[i].weight : 0; });
                 };
                 const L fx = kind.up_to(x), fy = kind.up_to(y);
                 claims.within(mean([&](const Sample& q) { return q.offset.x < x; }), fx, 0.04L,
                               fmt::format("mean weight left of {}", number(x)));
                 claims.within(mean([&](const Sample& q) { return q.offset.y < y; }), fy, 0.04L,
                               fmt::format("mean weight above {}", number(y)));
                 claims.within(mean([&](const Sample& q) { return q.offset.x < x && q.offset.y < y; }), fx * fy, 0.06L,
                               "mean weight within a corner");
                 const auto bare = [&](const std::function<bool(const Sample&)>& f) {
                     return mean_of(s.size(), [&](std::size_t i) { return f(s[i]) ? 1 : 0; });
                 };
                 const L share =
                     kind.integral([&](L at) { return kind.value(at) < 0 ? -1.0L : 1.0L; }, x) / kind.amount();
                 claims.within(bare([&](const Sample& q) { return q.offset.x < x; }), share, 0.03L,
                               fmt::format("share of offsets left of {}", number(x)));
             }));
}

}  // namespace

std::vector<Question> filters(std::uint64_t seed) {
    Dice dice(seed);
    Notebook book("5.6");
    book.scene(kScene);
    for (const Kind& kind : kKinds) {
        for (int i = 0; i < 2; ++i) ask_moments(book, dice, kind);
        for (int i = 0; i < 5; ++i) ask_edge(book, dice, kind);
        for (const char* u : {kCorners[0], kCorners[1], kCorners[4]})
            book.ask(fmt::format("filter {} {}", kind.name, u), "a corner or the middle of the square",
                     rows_hold(1, 3, "an offset within the filter", [=](const Table& t, Claims& claims) {
                         claims.holds(
                             std::abs(t.at(0, 0)) <= kind.reach + 1e-6L && std::abs(t.at(0, 1)) <= kind.reach + 1e-6L,
                             "an offset within the filter");
                         claims.within(std::abs(t.at(0, 2)), kind.amount() * kind.amount(), 1e-4L,
                                       "amount of the weight");
                     }));
    }
    return book.take();
}

}  // namespace rays::grader::step_5
