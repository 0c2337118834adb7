// Questions of tasks 1.4, 1.5 and 1.7: planes, triangles, boxes and discs.
#include <fmt/format.h>

#include <cmath>

#include "questions/step_1.h"

namespace rays::grader::step_1 {

namespace {

/// A unit vector with at least 0.2 of it along n, up to the sign of n.
V across(Dice& dice, const V& n) {
    for (;;) {
        const V d = dice.unit();
        if (std::abs(glm::dot(d, n)) > 0.2L) return d;
    }
}

/// One of three kinds of axes: the answer must not depend on which coordinate is the small one.
V any_normal(Dice& dice, int kind) {
    if (kind < 3) {
        V n(0);
        n[kind] = dice.coin() ? 1 : -1;
        return n;
    }
    return dice.unit();
}

}  // namespace

std::vector<Question> planes(std::uint64_t seed) {
    Dice dice(seed);
    Notebook book("1.4");
    for (int kind = 0; kind < 5; ++kind) {
        const V n = any_normal(dice, kind);
        const L offset = dice.round_between(-3, 3);
        book.objects(fmt::format("plane {{ {}, {} }}\n", vector(n), number(offset)));
        const V unit = glm::normalize(rounded(n));
        V x, y;
        frame(unit, x, y);
        const V point = offset * unit + dice.between(-5, 5) * x + dice.between(-5, 5) * y;
        const V d = across(dice, unit);
        const Shot shot = aim(point, d, dice.between(1, 9), dice.between(0.2, 5));
        book.root(shot, "a slanting ray");
        book.root(aim(point, -d, dice.between(1, 9)), "from the other side: planes have two");
        book.ask(nearest_query(shot), "the normal is the plane's, whoever looks", hits_with_normal(shot, unit, false));
        book.miss(aim(point, d, -dice.between(1, 9)), "the plane lies behind the origin");
        book.ask(root_query(shot, shot.t * 1.01L), "the range begins behind the plane", misses_it());
        book.ask(root_query(aim(point + unit, x, 3), 0, 1e6L), "a parallel ray", misses_it());
        const V grazing = glm::normalize(x + 1e-3L * unit);
        book.root(aim(point, grazing, 100), "one part in a thousand from parallel");
    }
    return book.take();
}

namespace {

struct Corners {
    V a, b, c;

    V at(L wb, L wc) const { return (1 - wb - wc) * a + wb * b + wc * c; }
    V normal() const { return glm::normalize(glm::cross(b - a, c - a)); }
    std::string text() const { return fmt::format("triangle {{ {}, {}, {} }}\n", vector(a), vector(b), vector(c)); }
};

Corners any_triangle(Dice& dice, int kind) {
    for (;;) {
        Corners t{dice.position(2), dice.position(2), dice.position(2)};
        if (kind < 3) t.b[kind] = t.c[kind] = t.a[kind];  // one coordinate the same: its plane is an axis plane
        const V n = glm::cross(t.b - t.a, t.c - t.a);
        const L longest = std::max({glm::length(t.b - t.a), glm::length(t.c - t.a), glm::length(t.c - t.b)});
        if (glm::length(n) > 0.4L * longest * longest) return t;
    }
}

/// Weights of an inner point, each at least `margin`.
V2 inner_weights(Dice& dice, L margin) {
    const L s = std::sqrt(dice.between(0, 1)), t = dice.between(0, 1);
    return V2(s * (1 - t), s * t) * (1 - 3 * margin) + margin;
}

void ask_smooth(Dice& dice, Notebook& book, const Corners& t) {
    // Normals within 45 degrees of the true one, as POV-Ray wants them: all on one side.
    const auto bent = [&] { return rounded(glm::normalize(t.normal() + 0.9L * dice.unit())); };
    const V na = bent(), nb = bent(), nc = bent();
    book.objects(fmt::format("smooth_triangle {{ {}, {}, {}, {}, {}, {} }}\n", vector(t.a), vector(na), vector(t.b),
                             vector(nb), vector(t.c), vector(nc)));
    const V2 w = inner_weights(dice, 0.02L);
    const Shot shot = aim(t.at(w.x, w.y), across(dice, t.normal()), dice.between(1, 6));
    const auto unit = [](const V& v) { return glm::normalize(v); };
    book.ask(nearest_query(shot), "smooth: the interpolated normal of the corners",
             hits_with_shading_normal(shot, unit((1 - w.x - w.y) * unit(na) + w.x * unit(nb) + w.y * unit(nc))));
    book.ask(nearest_query(shot), "smooth: the true normal is that of the flat triangle",
             hits_with_normal(shot, t.normal(), true));
    const Shot at_b = aim(t.at(0.98L, 0.01L), across(dice, t.normal()), 3);
    book.ask(nearest_query(at_b), "smooth: close to the second corner, nearly its normal",
             hits_with_shading_normal(at_b, unit(0.01L * unit(na) + 0.98L * unit(nb) + 0.01L * unit(nc))));
}

}  // namespace

std::vector<Question> triangles(std::uint64_t seed) {
    Dice dice(seed);
    Notebook book("1.5");
    for (int kind = 0; kind < 5; ++kind) {
        const Corners t = any_triangle(dice, kind);
        book.objects(t.text());
        const V n = t.normal();
        const V2 w = inner_weights(dice, 0.01L);
        const V d = across(dice, n);
        const Shot shot = aim(t.at(w.x, w.y), d, dice.between(1, 9), dice.between(0.2, 5));
        book.root(shot, "an inner point");
        book.root(aim(t.at(w.x, w.y), -d, dice.between(1, 9)), "the same from the other side");
        book.ask(nearest_query(shot), "its normal", hits_with_normal(shot, n, true));
        book.miss(aim(t.at(w.x, w.y), d, -dice.between(1, 9)), "the triangle lies behind the origin");
        const L along = dice.between(0.1, 0.9);
        book.miss(aim(t.at(-0.01L, along), d, 4), "outside of the edge from a to c");
        book.miss(aim(t.at(along, -0.01L), d, 4), "outside of the edge from a to b");
        book.miss(aim(t.at(1.01L - along, along), d, 4), "outside of the edge from b to c");
        book.root(aim(t.at(0.99L - along * 0.98L, along * 0.98L), d, 4), "just inside of the edge from b to c");
        book.miss(aim(t.at(1.02L, 0.01L), d, 4), "beyond corner b");
        const V in_plane = glm::normalize(t.b - t.a);
        if (kind < 3) book.miss(aim(t.at(-0.2L, 0.3L), rounded(in_plane), 4), "a ray in the triangle's plane, past it");
        ask_smooth(dice, book, t);
    }
    return book.take();
}

std::vector<Question> boxes_and_discs(std::uint64_t seed) {
    Dice dice(seed);
    Notebook book("1.7");
    for (int axis = 0; axis < 3; ++axis) {
        const V low = dice.position(2), high = low + rounded(V(dice.round_between(0.5, 2), dice.round_between(0.5, 2),
                                                               dice.round_between(0.5, 2)));
        book.objects(fmt::format("box {{ {}, {} }}\n", vector(low), vector(rounded(high))));
        for (const bool at_high : {false, true}) {
            V n(0);
            n[axis] = at_high ? 1 : -1;
            V point;
            for (int i = 0; i < 3; ++i) point[i] = glm::mix(low[i], rounded(high)[i], dice.between(0.05, 0.95));
            point[axis] = at_high ? rounded(high)[axis] : low[axis];
            V d = across(dice, n);
            if (glm::dot(d, n) > 0) d = -d;
            const Shot shot = aim(point, d, dice.between(1, 9), dice.between(0.2, 5));
            book.root(shot, "a face from outside");
            book.ask(nearest_query(shot), "its normal points outwards", hits_with_normal(shot, n, false));
            const Shot inside = aim(point, -d, 0.02L);
            book.ask(nearest_query(inside), "from inside: the exit, and its outward normal",
                     hits_with_normal(inside, n, false));
            book.root(aim(point, -n, 3), "straight on: two components of the direction are zero");
            book.miss(aim(point, d, -100), "the box lies behind the origin");
            V past = point;
            past[(axis + 1) % 3] = rounded(high)[(axis + 1) % 3] + 0.01L;
            book.miss(aim(past, -n, 3), "parallel to two pairs of faces, just outside of one");
        }
    }
    for (int kind = 0; kind < 4; ++kind) {
        const V center = dice.position(2), n = any_normal(dice, kind), unit = glm::normalize(rounded(n));
        const L radius = dice.round_between(0.5, 2), hole = rounded(radius * dice.round_between(0.2, 0.6));
        V x, y;
        frame(unit, x, y);
        const L angle = dice.between(0, 6.28);
        const V out = std::cos(angle) * x + std::sin(angle) * y;
        const V d = across(dice, unit);
        book.objects(fmt::format("disc {{ {}, {}, {} }}\n", vector(center), vector(n), number(radius)));
        const Shot shot = aim(center + 0.97L * radius * out, d, 4);
        book.ask(nearest_query(shot), "a disc near its rim", hits_with_normal(shot, unit, false));
        book.root(aim(center + 0.01L * out, -d, 4), "a disc near its middle, from the other side");
        book.miss(aim(center + 1.02L * radius * out, d, 4), "just outside of the rim");
        book.miss(aim(center + 0.5L * radius * out + 0.1L * unit, out, 4), "parallel to the disc");
        book.objects(
            fmt::format("disc {{ {}, {}, {}, {} }}\n", vector(center), vector(n), number(radius), number(hole)));
        book.miss(aim(center + 0.97L * hole * out, d, 4), "through the hole");
        book.root(aim(center + 1.03L * hole * out, d, 4), "just outside of the hole");
    }
    return book.take();
}

}  // namespace rays::grader::step_1
