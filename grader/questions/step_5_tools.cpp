#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "questions/step_5.h"

namespace rays::grader::step_5 {

using construct::number;

void Claims::holds(bool ok, const std::string& what) {
    if (!ok && broken_.empty()) broken_ = what;
}

void Claims::within(L value, L truth, L margin, const std::string& what) {
    holds(std::abs(value - truth) <= margin,
          fmt::format("{}: {:.6g} +- {:.2g} (found {:.6g})", what, double(truth), double(margin), double(value)));
}

Judgement Claims::judgement(const std::string& in_short) const {
    const bool ok = broken_.empty();
    return {ok, ok ? static_cast<double>(error_) : std::numeric_limits<double>::infinity(), ok ? in_short : broken_};
}

Judge rows_hold(std::size_t rows, std::size_t width, std::string in_short, Claimed claimed) {
    return [=](const Answer& answer) {
        Claims claims;
        const bool whole =
            answer.kind == Answer::Kind::value && answer.numbers.size() == rows * width &&
            std::all_of(answer.numbers.begin(), answer.numbers.end(), [](double v) { return std::isfinite(v); });
        claims.holds(whole, fmt::format("{} finite numbers: {}", rows * width, in_short));
        if (whole) claimed({answer.numbers, width}, claims);
        return claims.judgement(in_short);
    };
}

Judge is_number(L truth, L margin) {
    return [=](const Answer& answer) {
        Claims claims;
        const bool one = answer.kind == Answer::Kind::value && answer.numbers.size() == 1;
        const L found = one ? answer.numbers[0] : std::numeric_limits<L>::quiet_NaN();
        if (std::isinf(truth))
            claims.holds(found == truth, number(truth));
        else
            claims.within(found, truth, margin, "the number");
        claims.error(std::abs(found - truth));
        return claims.judgement(number(truth));
    };
}

// ---- Points of the unit square -----------------------------------------------------------------------------------------

std::vector<V2> points_in(const Table& table) {
    std::vector<V2> points;
    for (std::size_t i = 0; i < table.rows(); ++i) points.push_back(table.pair(i));
    return points;
}

L mean_of(std::size_t count, const std::function<L(std::size_t)>& f) {
    L sum = 0;
    for (std::size_t i = 0; i < count; ++i) sum += f(i);
    return sum / static_cast<L>(count);
}

void claim_in_square(Claims& claims, const std::vector<V2>& points) {
    claims.holds(std::all_of(points.begin(), points.end(),
                             [](const V2& p) { return p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1; }),
                 "every point in [0, 1)^2");
}

void claim_random(Claims& claims, const std::vector<V2>& p) {
    const std::size_t n = p.size();
    const L per = kSigmas / std::sqrt(static_cast<L>(n));
    claim_in_square(claims, p);
    for (int a = 0; a < 2; ++a) {
        const std::string axis = a == 0 ? "x" : "y";
        claims.within(mean_of(n, [&](std::size_t i) { return p[i][a]; }), 0.5L, per * std::sqrt(1.0L / 12),
                      "mean of " + axis);
        claims.within(mean_of(n, [&](std::size_t i) { return (p[i][a] - 0.5L) * (p[i][a] - 0.5L); }), 1.0L / 12,
                      per * std::sqrt(1.0L / 180), "variance of " + axis);
        claims.within(mean_of(n - 1, [&](std::size_t i) { return (p[i][a] - 0.5L) * (p[i + 1][a] - 0.5L); }), 0,
                      per / 12, "covariance of " + axis + " with the next one's");
        claims.within(mean_of(n - 1, [&](std::size_t i) { return (p[i][a] - 0.5L) * (p[i + 1][1 - a] - 0.5L); }), 0,
                      per / 12, "covariance of " + axis + " with the next one's other number");
    }
    claims.within(mean_of(n, [&](std::size_t i) { return (p[i].x - 0.5L) * (p[i].y - 0.5L); }), 0, per / 12,
                  "covariance of x and y");
}

void claim_equal_shares(Claims& claims, const std::vector<int>& counts, const std::string& what) {
    int all = 0;
    for (const int c : counts) all += c;
    const L share = static_cast<L>(all) / static_cast<L>(counts.size());
    for (const int c : counts) claims.within(c, share, kSigmas * std::sqrt(share) + 1, what);
}

int Grid::cell(const V2& p) const {
    const auto along = [](L at, int n) { return std::clamp(static_cast<int>(std::floor(at * n + 1e-9L)), 0, n - 1); };
    return along(p.x, columns) + columns * along(p.y, rows);
}

V2 Grid::within(const V2& p) const {
    const int c = cell(p);
    return {p.x * columns - c % columns, p.y * rows - c / columns};
}

Grid grid_for(int samples) {
    const int columns = static_cast<int>(std::sqrt(samples + 0.5));
    return {columns, (samples + columns - 1) / columns};
}

int most_in_a_cell(const Grid& grid, const std::vector<V2>& points) {
    std::vector<int> counts(static_cast<std::size_t>(grid.count()));
    for (const V2& p : points) ++counts[static_cast<std::size_t>(grid.cell(p))];
    return *std::max_element(counts.begin(), counts.end());
}

int most_in_a_strip(int strips, const std::vector<V2>& points, int axis) {
    return most_in_a_cell(axis == 0 ? Grid{strips, 1} : Grid{1, strips}, points);
}

Judge stratified(int samples, bool strips) {
    return rows_hold(
        static_cast<std::size_t>(samples), 2, strips ? "one in each cell, column and row" : "no two points in one cell",
        [=](const Table& table, Claims& claims) {
            const auto points = points_in(table);
            claim_in_square(claims, points);
            // On its side the grid is as good.
            const Grid grid = grid_for(samples), turned{grid.rows, grid.columns};
            claims.holds(most_in_a_cell(grid, points) == 1 || most_in_a_cell(turned, points) == 1,
                         fmt::format("no two of {} points in one of {} x {} cells", samples, grid.columns, grid.rows));
            if (!strips) return;
            for (int axis = 0; axis < 2; ++axis)
                claims.holds(most_in_a_strip(grid.count(), points, axis) == 1,
                             fmt::format("no two of {} points in one of {} {}", samples, grid.count(),
                                         axis ? "rows" : "columns"));
        });
}

// ---- Maps from the unit square -----------------------------------------------------------------------------------------

std::string Centers::text() const { return fmt::format("grid {} {} {}", columns, rows, number(third)); }

Centers random_centers(Dice& dice, int most) {
    const int columns = dice.whole(most - 8, most), rows = dice.whole(most - 8, most);
    return {columns, rows, dice.round_between(0, 0.999)};
}

void claim_equal_areas(Claims& claims, const Centers& centers, const std::vector<V2>& p, L area, L share) {
    const auto n = static_cast<std::size_t>(centers.columns);
    const L each = area / static_cast<L>(centers.count());
    std::size_t good = 0, all = 0;
    for (std::size_t row = 0; row + 1 < static_cast<std::size_t>(centers.rows); ++row)
        for (std::size_t column = 0; column + 1 < n; ++column) {
            const V2 &a = p[row * n + column], &b = p[row * n + column + 1], &c = p[(row + 1) * n + column + 1],
                     &d = p[(row + 1) * n + column];
            const V2 across = c - a, other = d - b;
            const L found = std::abs(across.x * other.y - across.y * other.x) / 2;
            good += std::abs(found / each - 1) < 0.05L;
            ++all;
        }
    claims.holds(static_cast<L>(good) >= share * static_cast<L>(all),
                 fmt::format("equal areas to equal areas (so are {} of {} small squares)", good, all));
}

namespace {

constexpr L kInside = 1 + 1e-6L;

struct Moments {
    const std::vector<V2>& p;
    L operator()(int i, int j) const {
        return mean_of(p.size(), [&](std::size_t k) { return std::pow(p[k].x, i) * std::pow(p[k].y, j); });
    }
};

void claim_centered(Claims& claims, const Moments& m, L square, L fourth, L margin) {
    claims.within(m(2, 0), square, margin, "mean of x^2");
    claims.within(m(0, 2), square, margin, "mean of y^2");
    claims.within(m(1, 1), 0, margin, "mean of x y");
    claims.within(m(1, 0), 0, 2 * margin, "mean of x");
    claims.within(m(0, 1), 0, 2 * margin, "mean of y");
    claims.within(m(4, 0), fourth, margin, "mean of x^4");
    claims.within(m(0, 4), fourth, margin, "mean of y^4");
}

}  // namespace

void claim_disc(Claims& claims, const Centers& centers, const std::vector<V2>& p) {
    claims.holds(std::all_of(p.begin(), p.end(), [](const V2& q) { return glm::length(q) <= kInside; }),
                 "every point in the disc");
    // Four standard deviations of as many points without any order would be 0.016: a grid's images are far better.
    claim_centered(claims, {p}, 0.25L, 0.125L, 0.004L);
    claims.within(mean_of(p.size(), [&](std::size_t i) { return glm::dot(p[i], p[i]) * glm::dot(p[i], p[i]); }),
                  1.0L / 3, 0.006L, "mean of r^4");
    // Squares that become circles have a row and a column of centres more or less on either side of one.
    const L edge = 2.2L / std::min(centers.columns, centers.rows);
    for (const L inner : {0.25L, 0.5L, 0.75L})
        claims.within(mean_of(p.size(), [&](std::size_t i) { return glm::dot(p[i], p[i]) < inner ? 1 : 0; }), inner,
                      edge, "share of points within the disc's inner part");
    claim_equal_areas(claims, centers, p, construct::kPi);
}

void claim_polygon(Claims& claims, const Centers& centers, const std::vector<V2>& p, int corners) {
    const L half = construct::kPi / corners, apothem = std::cos(half);
    std::vector<int> counts(static_cast<std::size_t>(corners));
    std::vector<L> out;
    for (const V2& q : p) {
        L farthest = -2;
        std::size_t side = 0;
        for (int k = 0; k < corners; ++k) {
            const L angle = (2 * k + 1) * half, reach = (q.x * std::sin(angle) + q.y * std::cos(angle)) / apothem;
            if (reach > farthest) farthest = reach, side = static_cast<std::size_t>(k);
        }
        out.push_back(farthest);
        ++counts[side];
    }
    claims.holds(std::all_of(out.begin(), out.end(), [](L r) { return r <= kInside; }),
                 "every point in the polygon whose first corner is (0, 1)");
    claims.within(mean_of(out.size(), [&](std::size_t i) { return out[i] * out[i]; }), 0.5L, 0.02L,
                  "mean of the square of how far out");
    claims.within(mean_of(out.size(), [&](std::size_t i) { return std::pow(out[i], 4); }), 1.0L / 3, 0.02L,
                  "mean of the fourth power of how far out");
    const L share = static_cast<L>(p.size()) / corners;
    for (const int c : counts) claims.within(c, share, 0.25L * share, "points between the centre and one side");
    if (corners <= 8) claim_equal_areas(claims, centers, p, corners * std::sin(2 * half) / 2, 0.75L);
}

void claim_square(Claims& claims, const Centers& centers, const std::vector<V2>& p) {
    claims.holds(std::all_of(p.begin(), p.end(),
                             [](const V2& q) { return std::abs(q.x) <= kInside / 2 && std::abs(q.y) <= kInside / 2; }),
                 "every point with a and b in [-1/2, 1/2]");
    claim_centered(claims, {p}, 1.0L / 12, 1.0L / 80, 0.0015L);
    claim_equal_areas(claims, centers, p, 1);
}

void claim_ball(Claims& claims, const std::vector<V>& p, const V& side) {
    claims.holds(std::all_of(p.begin(), p.end(), [](const V& q) { return glm::length(q) <= kInside; }),
                 "every point in the ball");
    const auto mean = [&](const std::function<L(const V&)>& f) {
        return mean_of(p.size(), [&](std::size_t i) { return f(p[i]); });
    };
    claims.within(mean([](const V& q) { return glm::dot(q, q); }), 0.75L, 0.015L, "mean of r^2");
    claims.within(mean([](const V& q) { return glm::dot(q, q) * glm::dot(q, q); }), 0.625L, 0.02L, "mean of r^4");
    V x, y;
    construct::frame(side, x, y);
    for (const V& d : {V(1, 0, 0), V(0, 1, 0), V(0, 0, 1), side, x, y}) {
        claims.within(mean([&](const V& q) { return glm::dot(q, d); }), 0, 0.02L, "mean along a direction");
        claims.within(mean([&](const V& q) { return glm::dot(q, d) * glm::dot(q, d); }), 0.25L, 0.01L,
                      "mean square along a direction");
        claims.within(mean([&](const V& q) { return std::pow(glm::dot(q, d), 4); }), 0.125L, 0.01L,
                      "mean fourth power along a direction");
    }
    for (const L inner : {0.25L, 0.5L, 0.75L})
        claims.within(
            mean([&](const V& q) { return std::pow(glm::dot(q, x), 2) + std::pow(glm::dot(q, y), 2) < inner ? 1 : 0; }),
            inner, 0.03L, "share within the inner part of the disc that is seen");
}

InPlane in_plane(const V& p, const V& a, const V& b) {
    const L aa = glm::dot(a, a), ab = glm::dot(a, b), bb = glm::dot(b, b), pa = glm::dot(p, a), pb = glm::dot(p, b);
    const L det = aa * bb - ab * ab;
    const V2 at((pa * bb - pb * ab) / det, (pb * aa - pa * ab) / det);
    return {at, glm::length(p - at.x * a - at.y * b)};
}

std::string chance(Dice& dice) {
    const L u = dice.round_between(0, 0.999), v = dice.round_between(0, 0.999);
    return fmt::format("{} {} {}", number(u), number(v), number(dice.round_between(0, 0.999)));
}

}  // namespace rays::grader::step_5
