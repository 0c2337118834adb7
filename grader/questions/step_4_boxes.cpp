// Questions about boxes around primitives (4.1) and rays against boxes (4.2).
#include <fmt/format.h>

#include <cmath>

#include "questions/step_4.h"

namespace rays::grader::step_4 {
namespace {

using construct::number;
using construct::numbers;
using construct::vector;

/// All of the tight box is inside, and no more than a loose box's worth around it.
Judge encloses(const Box& tight) {
    return [=](const Answer& answer) {
        const std::string expected = "a box around " + tight.text();
        if (!has(answer, 6)) return verdict(false, expected);
        const V size = tight.max - tight.min;
        const L room = std::max({size.x, size.y, size.z, 1e-3L});
        bool ok = true;
        for (int a = 0; a < 3; ++a) {
            const L low = answer.numbers[std::size_t(a)], high = answer.numbers[std::size_t(a) + 3];
            // The truth itself is rounded once; a student's bounds may be, too, when they err outwards elsewhere.
            const L rounding = 1e-12L * (1 + std::abs(tight.min[a]) + std::abs(tight.max[a]));
            ok = ok && low <= tight.min[a] + rounding && high >= tight.max[a] - rounding &&
                 high - low <= size[a] + 2 * room;
        }
        return verdict(ok, expected);
    };
}

Judge unbounded() {
    return [](const Answer& answer) {
        bool ok = has(answer, 6);
        bool infinite = false;
        for (std::size_t i = 0; ok && i < 6; ++i) infinite = infinite || std::isinf(answer.numbers[i]);
        return verdict(ok && infinite, "a box that is infinite");
    };
}

Box around(const std::vector<V>& points) {
    Box box{points.front(), points.front()};
    for (const V& p : points) box = {glm::min(box.min, p), glm::max(box.max, p)};
    return box;
}

Box around_disc(const V& center, const V& normal, L radius) {
    const V reach = radius * glm::sqrt(glm::max(V(0), V(1) - normal * normal));
    return {center - reach, center + reach};
}

V turned_about_y(const V& p, L degrees) {  // POV-Ray turns left-handed
    const L angle = degrees * construct::kPi / 180, c = std::cos(angle), s = std::sin(angle);
    return {c * p.x + s * p.z, p.y, c * p.z - s * p.x};
}

void ask(Notebook& book, const std::string& object, const Box& tight, const std::string& about, int primitive = 0) {
    book.objects(object + "\n");
    book.ask(fmt::format("bounds {}", primitive), about, encloses(tight));
}

void ask_round_shapes(Notebook& book, Dice& dice) {
    const V c = dice.position(5);
    const L r = dice.round_between(0.1, 3);
    ask(book, fmt::format("sphere {{ {}, {} }}", vector(c), number(r)), {c - r, c + r}, "a sphere");
    const V base = dice.position(4),
            cap = construct::rounded(base + V(dice.round_between(1, 2), dice.round_between(1, 3), 0.5L));
    const L r0 = dice.round_between(0.2, 1), r1 = dice.round_between(0, 1);
    const V axis = glm::normalize(cap - base);
    const Box one = around_disc(base, axis, r0), other = around_disc(cap, axis, r1);
    ask(book, fmt::format("cone {{ {}, {}, {}, {} }}", vector(base), number(r0), vector(cap), number(r1)),
        {glm::min(one.min, other.min), glm::max(one.max, other.max)}, "a slanted cone: both of its discs");
    const L major = dice.round_between(1, 2), minor = dice.round_between(0.1, 0.5);
    const V shift = dice.position(3);
    const V reach(major + minor, minor, major + minor);
    ask(book, fmt::format("torus {{ {}, {} translate {} }}", number(major), number(minor), vector(shift)),
        {shift - reach, shift + reach}, "a torus");
    // Stretched and turned, as no sphere can be: an ellipsoid, whose reach along an axis is the length of a row.
    const L turn = dice.round_between(10, 80);
    const V stretch(2, 0.5L, 1);
    V extent(0);
    for (int i = 0; i < 3; ++i) {
        V column(0);
        column[i] = stretch[i];
        column = turned_about_y(column, turn);
        extent += column * column;
    }
    extent = glm::sqrt(extent);
    ask(book,
        fmt::format("sphere {{ 0, 1 scale {} rotate {} * y translate {} }}", vector(stretch), number(turn),
                    vector(shift)),
        {shift - extent, shift + extent}, "a stretched and turned sphere");
}

void ask_flat_shapes(Notebook& book, Dice& dice) {
    const V a = dice.position(5), b = dice.position(5), c = dice.position(5);
    ask(book, fmt::format("triangle {{ {}, {}, {} }}", vector(a), vector(b), vector(c)), around({a, b, c}),
        "a triangle");
    ask(book,
        fmt::format("mesh {{ triangle {{ 0, x, y }} triangle {{ {}, {}, {} }} }}", vector(a), vector(b), vector(c)),
        around({V(glm::vec3(a)), V(glm::vec3(b)), V(glm::vec3(c))}), "a face of a mesh, not the whole mesh", 1);
    const L h = dice.round_between(-3, 3);
    ask(book,
        fmt::format("polygon {{ 5, <0, 0, {0}>, <2, 0, {0}>, <3, 2, {0}>, <0, 1, {0}>, <0, 0, {0}> }}", number(h)),
        {V(0, 0, h), V(3, 2, h)}, "a polygon across the z axis: flat");
    const V n = construct::rounded(dice.unit()), p = dice.position(3);
    const L r = dice.round_between(0.5, 2);
    ask(book, fmt::format("disc {{ {}, {}, {} }}", vector(p), vector(n), number(r)),
        around_disc(p, glm::normalize(n), r), "a disc");
    const L turn = dice.round_between(10, 80);
    std::vector<V> corners;
    for (int i = 0; i < 8; ++i)
        corners.push_back(turned_about_y(V(i & 1, 2 * (i >> 1 & 1), 3 * (i >> 2 & 1)), turn) + p);
    ask(book, fmt::format("box {{ 0, <1, 2, 3> rotate {} * y translate {} }}", number(turn), vector(p)),
        around(corners), "a turned box: all eight corners");
}

void ask_clipped_and_unbounded(Notebook& book, Dice& dice) {
    book.objects(fmt::format("plane {{ y, {} }}\n", number(dice.round_between(-2, 2))));
    book.ask("bounds 0", "a plane has no bounds", unbounded());
    const V c = dice.position(3);
    ask(book,
        fmt::format("sphere {{ {}, 2 clipped_by {{ box {{ {}, {} }} }} }}", vector(c), vector(c), vector(c + V(5))),
        {c, c + V(2)}, "a sphere clipped by a box");
    ask(book,
        fmt::format("quadric {{ <1, 0, 1>, <0, 0, 0>, <0, 0, 0>, -4 clipped_by {{ box {{ {}, {} }} }} }}",
                    vector(V(-1, -3, -1)), vector(V(1, 3, 1))),
        {V(-1, -3, -1), V(1, 3, 1)}, "an endless quadric, made finite by its clip");
}

// ---- 4.2 --------------------------------------------------------------------------------------------------------------

Judge enters_and_exits(const Stretch& s) {
    if (!(s.enter <= s.exit)) return construct::misses_it();
    return [=](const Answer& answer) {
        const bool ok = has(answer, 2) && close(answer.numbers[0], s.enter) && close(answer.numbers[1], s.exit);
        return verdict(ok, fmt::format("hit {} {}", number(s.enter), number(s.exit)));
    };
}

void ask_clip(Notebook& book, const Box& box, const Beam& beam, const std::string& about) {
    const Stretch s = stretch_in(box, beam);
    // A ray past an edge within rounding may go either way.
    if (std::abs(s.exit - s.enter) > 1e-6L * (1 + std::abs(s.enter)) || s.exit == s.enter)
        book.ask("clip " + box.text() + " " + beam.text(), about, enters_and_exits(s));
}

V share(Dice& dice) { return {dice.between(0.1, 0.9), dice.between(0.1, 0.9), dice.between(0.1, 0.9)}; }

void ask_slanted(Notebook& book, Dice& dice) {
    const Box box = random_box(dice);
    const V inside = box.at(share(dice));
    for (int octant = 0; octant < 8; ++octant) {
        V d = glm::abs(dice.unit()) + 0.1L;
        for (int a = 0; a < 3; ++a)
            if (octant >> a & 1) d[a] = -d[a];
        ask_clip(book, box, from_to(inside - 20.0L * d, inside),
                 "a slanted ray, signs of the direction number " + std::to_string(octant));
    }
    ask_clip(book, box, from_to(inside, inside + dice.unit()), "from inside: it enters where the range begins");
    Beam behind = from_to(inside + 20.0L * V(1, 0.5L, 0.2L), inside + 21.0L * V(1, 0.5L, 0.2L));
    ask_clip(book, box, behind, "the box lies behind");
    behind.t_min = -100;
    ask_clip(book, box, behind, "a range that looks back");
    Beam before = from_to(inside - V(20, 1, 2), inside);
    before.t_max = 0.01L;
    ask_clip(book, box, before, "the range ends before the box");
    before.t_max = 1;
    ask_clip(book, box, before, "the range ends in the box");
    ask_clip(book, box, from_to(box.max + V(3, 3, 0.1L), box.max + V(2, 4, 0)), "past the box");
}

void ask_parallel(Notebook& book, Dice& dice) {
    const Box box = random_box(dice);
    for (int axis = 0; axis < 3; ++axis) {
        const V inside = construct::rounded(box.at(share(dice)));
        V d(dice.coin() ? 0.0L : -0.0L);
        d[axis] = dice.coin() ? 1 : -1;
        Beam beam{construct::rounded(inside - 10.0L * d), d};
        ask_clip(book, box, beam, "along an axis: two zeros in the direction");
        const int other = (axis + 1) % 3;
        beam.origin[other] = box.min[other];
        ask_clip(book, box, beam, "along an axis, in a face of the box: the faces belong to it");
        beam.origin[other] = box.max[other];
        ask_clip(book, box, beam, "along an axis, in the far face of the box");
        beam.origin[other] = box.max[other] + 0.5L;
        ask_clip(book, box, beam, "along an axis, beside the box");
        Box flat = box;
        flat.max[axis] = flat.min[axis];
        ask_clip(book, flat, {construct::rounded(inside - 10.0L * d), d}, "a flat box, straight through");
    }
}

}  // namespace

std::vector<Question> bounds(std::uint64_t seed) {
    Dice dice(seed);
    Notebook book("4.1");
    for (int i = 0; i < 3; ++i) {
        ask_round_shapes(book, dice);
        ask_flat_shapes(book, dice);
        ask_clipped_and_unbounded(book, dice);
    }
    return book.take();
}

std::vector<Question> clips(std::uint64_t seed) {
    Dice dice(seed);
    Notebook book("4.2");
    book.objects("sphere { 0, 1 }\n");
    ask_slanted(book, dice);
    ask_parallel(book, dice);
    const Box box = random_box(dice);
    for (const char* odd : {"nan 0 0 1 0 0", "0 0 0 nan 1 0", "0 0 0 0 0 nan"})
        book.ask("clip " + box.text() + " " + odd + " 0 1e30", "not a number is no ray", construct::misses_it());
    return book.take();
}

}  // namespace rays::grader::step_4
