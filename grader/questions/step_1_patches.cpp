// Questions of task 1.11. That a ray meets nothing before the chosen point, or nothing at all, is certified by
// subdivision: a piece of the patch stays in the convex hull of its control points.
#include <array>
#include <cmath>

#include "questions/step_1.h"

namespace rays::grader::step_1 {

namespace {

using Net = std::array<V, 16>;  ///< [4 * i + j] belongs to u_i, v_j

V bezier(const std::array<V, 4>& k, L t) {
    const L s = 1 - t;
    return s * s * s * k[0] + 3 * s * s * t * k[1] + 3 * s * t * t * k[2] + t * t * t * k[3];
}
V slope(const std::array<V, 4>& k, L t) {
    const L s = 1 - t;
    return 3 * s * s * (k[1] - k[0]) + 6 * s * t * (k[2] - k[1]) + 3 * t * t * (k[3] - k[2]);
}

struct PointOfPatch {
    V p, normal;  ///< normal of any length
};

PointOfPatch at(const Net& net, L u, L v) {
    std::array<V, 4> rows, columns;
    for (std::size_t i = 0; i < 4; ++i) {
        rows[i] = bezier({net[4 * i], net[4 * i + 1], net[4 * i + 2], net[4 * i + 3]}, v);
        columns[i] = bezier({net[i], net[4 + i], net[8 + i], net[12 + i]}, u);
    }
    return {bezier(rows, u), glm::cross(slope(rows, u), slope(columns, v))};
}

/// Control points with x and y across the ray and z along it.
Net seen_along(const Net& net, const V& origin, const V& unit) {
    V x, y;
    frame(unit, x, y);
    Net seen;
    for (std::size_t i = 0; i < 16; ++i) {
        const V p = net[i] - origin;
        seen[i] = {glm::dot(p, x), glm::dot(p, y), glm::dot(p, unit)};
    }
    return seen;
}

void halve(const Net& net, std::size_t first, std::size_t step, Net& left, Net& right) {
    const V a = net[first], b = net[first + step], c = net[first + 2 * step], d = net[first + 3 * step];
    const V ab = (a + b) / 2.0L, bc = (b + c) / 2.0L, cd = (c + d) / 2.0L;
    const V abc = (ab + bc) / 2.0L, bcd = (bc + cd) / 2.0L, middle = (abc + bcd) / 2.0L;
    left[first] = a, left[first + step] = ab, left[first + 2 * step] = abc, left[first + 3 * step] = middle;
    right[first] = middle, right[first + step] = bcd, right[first + 2 * step] = cd, right[first + 3 * step] = d;
}

/// True when the patch certainly does not meet the z axis for `from` < z < `to`.
bool is_free(const Net& net, L from, L to, int levels = 14) {
    V low = net[0], high = net[0];
    for (const V& p : net) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    if (low.x > 0 || high.x < 0 || low.y > 0 || high.y < 0 || low.z > to || high.z < from) return true;
    if (levels == 0) return false;
    Net left, right;
    for (std::size_t i = 0; i < 4; ++i)
        levels % 2 == 0 ? halve(net, i, 4, left, right) : halve(net, 4 * i, 1, left, right);
    return is_free(left, from, to, levels - 1) && is_free(right, from, to, levels - 1);
}

/// A wavy sheet over [-1.5, 1.5]^2, turned in space.
Net any_net(Dice& dice, double waves, bool folded) {
    V x, y;
    const V z = dice.unit();
    frame(z, x, y);
    const V middle = dice.position(1);
    Net net;
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
            // Folded: the inner columns change places, so that the sheet lies in three layers like an S.
            const auto row = static_cast<std::size_t>(i);
            const L across = folded ? std::array<L, 4>{-1.5L, 2.5L, -2.5L, 1.5L}[row] : i - 1.5L;
            const L height = folded ? std::array<L, 4>{-1, -1, 1, 1}[row] : dice.between(-waves, waves);
            net[static_cast<std::size_t>(4 * i + j)] = rounded(middle + across * x + (j - 1.5L) * y + height * z);
        }
    }
    return net;
}

std::string text(const Net& net) {
    std::string points;
    for (std::size_t i = 0; i < 16; ++i) points += (i == 0 ? "" : ", ") + vector(net[i]);
    return "bicubic_patch { type 1 flatness 0 u_steps 5 v_steps 5 " + points + " }\n";
}

/// A ray whose first meeting is at (u, v), or nothing if none was found.
bool ask_point(Dice& dice, Notebook& book, const Net& net, L u, L v, const std::string& about) {
    const auto [p, normal] = at(net, u, v);
    const V n = glm::normalize(normal);
    for (int tries = 0; tries < 60; ++tries) {
        const V d = dice.unit();
        if (!(std::abs(glm::dot(d, n)) > 0.3L)) continue;
        const L distance = dice.between(1, 7);
        if (!is_free(seen_along(net, p - distance * d, d), 0, distance - 0.02L)) continue;
        const Shot shot = aim(p, d, distance, dice.between(0.2, 5));
        book.root(shot, about);
        book.ask(nearest_query(shot), about + ": its normal", hits_with_normal(shot, n, true));
        return true;
    }
    return false;
}

/// A ray through a point of the surface's continuation, (u, v) outside of the unit square, that meets nothing.
bool ask_outside(Dice& dice, Notebook& book, const Net& net, L u, L v) {
    const auto [p, normal] = at(net, u, v);
    for (int tries = 0; tries < 60; ++tries) {
        const V d = dice.unit();
        if (!(std::abs(glm::dot(d, glm::normalize(normal))) > 0.3L)) continue;
        if (!is_free(seen_along(net, p - 5.0L * d, d), 0, 100)) continue;
        book.miss(aim(p, d, 5), "beyond an edge, where the surface would go on: u and v run from 0 to 1");
        return true;
    }
    return false;
}

}  // namespace

std::vector<Question> patches(std::uint64_t seed) {
    Dice dice(seed);
    Notebook book("1.11");
    for (int i = 0; i < 4; ++i) {
        const Net net = any_net(dice, 0.8, false);
        book.objects(text(net));
        ask_point(dice, book, net, dice.between(0.05, 0.95), dice.between(0.05, 0.95),
                  "an inner point of a wavy patch");
        ask_point(dice, book, net, dice.between(0.005, 0.02), dice.between(0.1, 0.9), "close to the edge u = 0");
        ask_point(dice, book, net, dice.between(0.1, 0.9), dice.between(0.98, 0.995), "close to the edge v = 1");
        ask_point(dice, book, net, 0.99L, 0.01L, "close to a corner");
        const L along = dice.between(0.1, 0.9);
        ask_outside(dice, book, net, -0.03L, along);
        ask_outside(dice, book, net, 1.03L, along);
        ask_outside(dice, book, net, along, -0.03L);
        ask_outside(dice, book, net, along, 1.03L);
    }
    for (int i = 0; i < 3; ++i) {
        const Net net = any_net(dice, 0, true);
        book.objects(text(net));
        for (int k = 0; k < 4; ++k)
            ask_point(dice, book, net, dice.between(0.02, 0.98), dice.between(0.05, 0.95),
                      "a folded patch: the first of several layers");
    }
    // Flat and regular: at (u, v) lies corner + u right + v up.
    const V right(3, 0.75L, 0), up(0, 1.5L, 0.375L), corner = dice.position(1);
    Net flat;
    for (std::size_t k = 0; k < 16; ++k) flat[k] = rounded(corner + (k / 4) / 3.0L * right + (k % 4) / 3.0L * up);
    book.objects(text(flat));
    const V d = glm::normalize(glm::cross(right, up));
    for (const V2 uv : {V2(0.5L, 0.5L), V2(0.02L, 0.97L), V2(0.9L, 0.1L), V2(0.25L, 0.75L)})
        book.root(aim(corner + uv.x * right + uv.y * up, dice.coin() ? d : -d, 4), "a flat patch is a parallelogram");
    for (const V2 uv : {V2(-0.02L, 0.5L), V2(1.02L, 0.5L), V2(0.5L, -0.02L), V2(0.5L, 1.02L)})
        book.miss(aim(corner + uv.x * right + uv.y * up, d, 4), "just outside of a flat patch");
    book.miss(aim(corner + 0.5L * right + 0.5L * up, d, -2), "the patch lies behind the origin");
    return book.take();
}

}  // namespace rays::grader::step_1
