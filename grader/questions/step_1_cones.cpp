// Questions of task 1.8: cylinders and cones, closed and open.
#include <fmt/format.h>

#include <cmath>

#include "questions/step_1.h"

namespace rays::grader::step_1 {

namespace {

/// A frustum in space, with what one needs to aim at it.
struct Frustum {
    V base, cap;
    L base_radius, cap_radius;
    V axis, x, y;  ///< unit
    L height;

    Frustum(const V& b, L rb, const V& c, L rc) : base(b), cap(c), base_radius(rb), cap_radius(rc) {
        height = glm::length(cap - base);
        axis = (cap - base) / height;
        frame(axis, x, y);
    }

    V out(L angle) const { return std::cos(angle) * x + std::sin(angle) * y; }
    L radius(L s) const { return base_radius + s * (cap_radius - base_radius); }
    V mantle(L s, L angle) const { return base + s * height * axis + radius(s) * out(angle); }
    V normal(L angle) const { return glm::normalize(height * out(angle) - (cap_radius - base_radius) * axis); }
    std::string text(bool open) const {
        const std::string end = open ? " open }\n" : " }\n";
        if (base_radius == cap_radius)
            return fmt::format("cylinder {{ {}, {}, {}{}", vector(base), vector(cap), number(base_radius), end);
        return fmt::format("cone {{ {}, {}, {}, {}{}", vector(base), number(base_radius), vector(cap),
                           number(cap_radius), end);
    }
};

Frustum any_frustum(Dice& dice, int kind) {
    for (;;) {
        const V base = dice.position(2), cap = dice.position(2);
        if (glm::length(cap - base) < 1) continue;
        const L r = dice.round_between(0.4, 1.5);
        if (kind == 0) return {base, r, cap, r};                                          // cylinder
        if (kind == 1) return {base, r, cap, rounded(r * dice.round_between(0.2, 0.7))};  // narrower at the cap
        if (kind == 2) return {base, rounded(r * dice.round_between(0.2, 0.7)), cap, r};  // wider
        return {base, r, cap, 0};                                                         // to a point
    }
}

/// A unit vector with at least 0.2 of it along n.
V along(Dice& dice, const V& n) {
    for (;;) {
        const V d = dice.unit();
        if (glm::dot(d, n) > 0.2L) return d;
    }
}

void ask_closed(Dice& dice, Notebook& book, const Frustum& f) {
    // The closed solid is convex: a ray that meets a face from its outer side has not been inside before.
    book.objects(f.text(false));
    const L s = dice.between(0.1, 0.8), angle = dice.between(0, 6.28);
    const V n = f.normal(angle);
    const Shot mantle = aim(f.mantle(s, angle), along(dice, -n), dice.between(1, 9), dice.between(0.2, 5));
    book.ask(nearest_query(mantle), "the mantle from outside, with its outward normal",
             hits_with_normal(mantle, n, false));
    book.root(mantle, "the mantle from outside");
    const V base_point = f.base + dice.between(0.05, 0.95) * f.base_radius * f.out(angle);
    const Shot base = aim(base_point, along(dice, f.axis), dice.between(1, 9));
    book.ask(nearest_query(base), "the base, with its outward normal", hits_with_normal(base, -f.axis, false));
    if (f.cap_radius > 0) {
        const V cap_point = f.cap + dice.between(0.05, 0.95) * f.cap_radius * f.out(angle);
        const Shot cap = aim(cap_point, along(dice, -f.axis), dice.between(1, 9));
        book.ask(nearest_query(cap), "the cap, with its outward normal", hits_with_normal(cap, f.axis, false));
    }
    const V outwards = along(dice, n);
    const Shot inside = aim(f.mantle(s, angle), outwards, 0.02L);
    book.ask(nearest_query(inside), "the mantle from inside", hits_with_normal(inside, n, false));
    book.miss(aim(f.mantle(s, angle), outwards, -3), "the solid lies behind the origin");
    const V beside = f.base + 0.5L * f.height * f.axis + (std::max(f.base_radius, f.cap_radius) * 1.02L) * f.out(angle);
    book.miss(aim(beside, f.axis, 9), "parallel to the axis, outside");
    const Shot within = aim(f.base + 0.5L * std::min(f.base_radius, f.cap_radius) * f.out(angle), f.axis, 5);
    book.root(within, "parallel to the axis, inside: the base");
    const V generator = glm::normalize(f.mantle(1, angle) - f.mantle(0, angle));
    const Shot beside_generator = aim(f.base + f.base_radius * 0.6L * f.out(angle), generator, 5);
    book.root(beside_generator, "parallel to a generator, inside: the base");
    V across_ray = glm::normalize(glm::cross(f.axis, f.out(angle)));
    book.miss(aim(f.mantle(s, angle) + 0.02L * n, across_ray, 7), "past the mantle, across the axis");
    book.miss(aim(f.base - 0.05L * f.height * f.axis, f.out(angle), 7), "past the base, parallel to it");
}

void ask_open(Dice& dice, Notebook& book, const Frustum& f) {
    // In through the open base, and on to the mantle from within.
    book.objects(f.text(true));
    for (int tries = 0, asked = 0; asked < 2 && tries < 1000; ++tries) {
        const L angle = dice.between(0, 6.28), s = dice.between(0.2, 0.9);
        const V entry = f.base + dice.between(0, 0.9) * f.base_radius * f.out(dice.between(0, 6.28));
        const V goal = f.mantle(s, angle), d = glm::normalize(goal - entry);
        if (glm::dot(d, f.normal(angle)) < 0.15L) continue;
        const Shot shot = aim(goal, d, glm::length(goal - entry) + dice.between(1, 5));
        book.root(shot, "open: in through the base, which is not there");
        book.ask(nearest_query(shot), "open: the outward normal from within",
                 hits_with_normal(shot, f.normal(angle), false));
        ++asked;
    }
    const L inner = 0.5L * std::min(f.base_radius, f.cap_radius);
    if (inner > 0) book.miss(aim(f.base + inner * f.out(1), f.axis, 5), "open: straight through, along the axis");
}

}  // namespace

std::vector<Question> cones(std::uint64_t seed) {
    Dice dice(seed);
    Notebook book("1.8");
    for (int kind = 0; kind < 4; ++kind) {
        const Frustum f = any_frustum(dice, kind);
        ask_closed(dice, book, f);
        ask_open(dice, book, any_frustum(dice, kind));
    }
    return book.take();
}

}  // namespace rays::grader::step_1
