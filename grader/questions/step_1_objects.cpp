// Questions of tasks 1.12, 1.13 and 1.15: transforms, bounds, clips, the nearest of all.
#include <fmt/format.h>

#include <cmath>

#include "questions/step_1.h"

namespace rays::grader::step_1 {

namespace {

using M = glm::mat<3, 3, L>;

/// A linear map and a shift, with doubles for numbers.
struct Map {
    M linear;  ///< columns are the images of the axes
    V shift;

    V point(const V& p) const { return linear * p + shift; }
    V normal(const V& n) const { return glm::normalize(glm::transpose(glm::inverse(linear)) * n); }
    /// POV-Ray's matrix: the images of the axes, row by row, then the shift.
    std::string text() const {
        std::string rows;
        for (int i = 0; i < 3; ++i)
            rows += fmt::format("{}, {}, {}, ", number(linear[i].x), number(linear[i].y), number(linear[i].z));
        return fmt::format("matrix <{}{}, {}, {}>", rows, number(shift.x), number(shift.y), number(shift.z));
    }
};

Map any_map(Dice& dice) {
    for (;;) {
        const Map map{M(dice.position(2), dice.position(2), dice.position(2)), dice.position(3)};
        const L volume = std::abs(glm::determinant(map.linear));
        if (volume > 1 && volume < 8) return map;
    }
}

V along(Dice& dice, const V& n) {
    for (;;) {
        const V d = dice.unit();
        if (glm::dot(d, n) > 0.3L) return d;
    }
}

/// A convex shape in its own space, a point of it and the outward normal there.
void ask_mapped(Dice& dice, Notebook& book, const std::string& shape, const V& point, const V& normal,
                const std::string& name) {
    const Map map = any_map(dice);
    book.objects(shape + " " + map.text() + " }\n");
    const V world = map.point(point), n = map.normal(normal);
    const Shot shot = aim(world, along(dice, -n), dice.between(1, 9), dice.between(0.2, 5));
    book.root(shot, name + ", sheared: t counts in lengths of the ray's direction in the world");
    book.ask(nearest_query(shot), name + ", sheared: the normal is at right angles to the surface in the world",
             hits_with_normal(shot, n, false));
    book.miss(aim(world, along(dice, -n), -30), name + ", sheared: behind the origin");
}

}  // namespace

std::vector<Question> transforms(std::uint64_t seed) {
    Dice dice(seed);
    Notebook book("1.12");
    for (int i = 0; i < 4; ++i) {
        const V n = dice.unit();
        ask_mapped(dice, book, "sphere { <0, 0, 0>, 1", n, n, "a sphere");
        const L s = dice.between(0.1, 0.9), angle = dice.between(0, 6.28);
        const V out(std::cos(angle), 0, std::sin(angle));
        ask_mapped(dice, book, "cylinder { <0, 0, 0>, <0, 1, 0>, 1", out + V(0, s, 0), out, "a cylinder");
        ask_mapped(dice, book, "box { <-1, -1, -1>, <1, 1, 1>", V(dice.between(-0.9, 0.9), 1, dice.between(-0.9, 0.9)),
                   V(0, 1, 0), "a box");
    }
    // An ellipsoid by plain words: scaled, then shifted.
    for (int i = 0; i < 2; ++i) {
        const V scale(dice.round_between(0.5, 1), dice.round_between(1, 2), dice.round_between(2, 3)),
            shift = dice.position(2);
        const Map map{M(V(scale.x, 0, 0), V(0, scale.y, 0), V(0, 0, scale.z)), shift};
        const V n = dice.unit(), world_normal = map.normal(n);
        book.objects(fmt::format("sphere {{ <0, 0, 0>, 1 scale {} translate {} }}\n", vector(scale), vector(shift)));
        const Shot shot = aim(map.point(n), along(dice, -world_normal), 5, dice.between(0.2, 5));
        book.ask(nearest_query(shot), "a sphere scaled to an ellipsoid: its normal",
                 hits_with_normal(shot, world_normal, false));
        book.root(shot, "a sphere scaled to an ellipsoid: its root");
    }
    return book.take();
}

std::vector<Question> bounds(std::uint64_t seed) {
    Dice dice(seed);
    Notebook book("1.13");
    book.objects("sphere { <0, 0, 0>, 1 }\n");  // the questions bring their own balls
    const auto ask = [&](const V& center, L radius, const Shot& ray, L t_min, L t_max, bool truth, const char* about) {
        book.ask(fmt::format("misses {} {} {} {} {}", numbers(center), number(radius), ray.text(), number(t_min),
                             number(t_max)),
                 about, says(truth));
    };
    for (int i = 0; i < 4; ++i) {
        const V c = dice.position(4), d = dice.unit();
        V x, y;
        frame(d, x, y);
        const L r = dice.round_between(0.2, 2), speed = dice.between(0.2, 5), reach = dice.between(3, 9);
        const Shot at_middle = aim(c + 0.3L * r * x, d, reach, speed);
        ask(c, r, at_middle, 0, kFar, false, "straight at the ball");
        ask(c, r, aim(c + 0.98L * r * y, d, reach, speed), 0, kFar, false, "close to its edge, but through it");
        ask(c, r, aim(c + 1.02L * r * y, d, reach, speed), 0, kFar, true, "past its edge");
        ask(c, r, aim(c + 0.3L * r * x, d, -reach, speed), 0, kFar, true, "the ball lies behind the origin");
        ask(c, r, aim(c + 0.5L * r * x, d, 0.3L * r, speed), 0, kFar, false,
            "the origin lies in the ball, before its middle");
        ask(c, r, aim(c + 0.5L * r * x, d, -0.3L * r, speed), 0, kFar, false,
            "the origin lies in the ball, behind its middle");
        ask(c, r, at_middle, 0, (reach - 1.1L * r) / speed, true, "the range ends before the ball");
        ask(c, r, at_middle, 0, reach / speed, false, "the range ends in the ball");
        ask(c, r, at_middle, (reach + 1.1L * r) / speed, kFar, true, "the range begins behind the ball");
        ask(c, -1, aim(c + 9.0L * x, d, reach, speed), 0, kFar, false, "a negative radius bounds nothing");
    }
    return book.take();
}

namespace {

void ask_order(Dice& dice, Notebook& book) {
    const V d = dice.unit(), c = dice.position(2);
    const L near_radius = dice.round_between(0.3, 0.8), far_radius = dice.round_between(0.9, 1.5);
    const V near_center = rounded(c), far_center = rounded(c + dice.between(3, 5) * d);
    const auto ball = [](const V& center, L r) {
        return fmt::format("sphere {{ {}, {} }}\n", vector(center), number(r));
    };
    const Shot shot = aim(near_center - near_radius * d, d, 4, dice.between(0.3, 3));
    for (const bool near_first : {true, false}) {
        const std::string scene = near_first ? ball(near_center, near_radius) + ball(far_center, far_radius)
                                             : ball(far_center, far_radius) + ball(near_center, near_radius);
        book.objects(scene);
        book.ask(
            nearest_query(shot),
            near_first ? "two spheres, the near one first in the file" : "two spheres, the near one last in the file",
            hits_with_normal(shot, -d, false, near_first ? 0 : 1));
        Shot behind = shot;
        behind.t = shot.t + glm::dot(far_center - far_radius * d - near_center + near_radius * d, d) / shot.speed();
        book.ask(nearest_query(shot, shot.t + 2.2L * near_radius / shot.speed()),
                 "the range begins behind the near sphere", hits_with_normal(behind, -d, false, near_first ? 1 : 0));
        book.ask(nearest_query(shot, 0, shot.t * 0.99L), "the range ends before all", misses_it());
    }
}

/// A ball cut by a plane through its middle: what lies above is gone, and one looks into a bowl.
void ask_clips(Dice& dice, Notebook& book) {
    const V c = dice.position(2), axis = dice.unit();
    const L r = dice.round_between(0.8, 2);
    const V plane_normal = rounded(axis);
    const V unit = glm::normalize(plane_normal);
    const L offset = rounded(glm::dot(unit, c));
    V x, y;
    frame(unit, x, y);
    const L h = dice.between(0.1, 0.6) * r;
    const Shot down = aim(c + h * x - std::sqrt(r * r - h * h) * unit, -unit, 3 * r);
    const std::string ball = fmt::format("sphere {{ {}, {} clipped_by {{ ", vector(c), number(r));
    book.objects(ball + fmt::format("plane {{ {}, {} }} }} }}\n", vector(plane_normal), number(offset)));
    book.root(down, "clipped by a plane: the first root is cut away, the second is seen");
    const V bottom = glm::normalize(down.at(down.t) - c);
    book.ask(nearest_query(down), "clipped by a plane: the normal inside the bowl is that of the sphere",
             hits_with_normal(down, bottom, false));
    const Shot up = aim(down.at(down.t), unit, 3);
    book.root(up, "clipped by a plane: from below the bowl is closed");
    book.miss(aim(c + 0.5L * r * unit, x, 9), "clipped by a plane: above nothing is left");
    book.objects(ball + fmt::format("plane {{ {}, {} inverse }} }} }}\n", vector(plane_normal), number(offset)));
    const Shot top = aim(c + h * x + std::sqrt(r * r - h * h) * unit, -unit, 3);
    book.root(top, "clipped by an inverse plane: the upper half is left");
    book.objects(ball + fmt::format("sphere {{ {}, {} }} }} }}\n", vector(down.at(down.t)), number(r / 2)));
    book.miss(aim(top.at(top.t), unit, -3), "clipped by a sphere: nothing is left of the top");
    book.root(down, "clipped by a sphere: a round piece of the bottom is left");
}

void ask_insides(Dice& dice, Notebook& book) {
    const V c = dice.position(2), d = dice.unit();
    const L r = dice.round_between(0.5, 2);
    const auto ask = [&](const std::string& objects, const V& p, bool truth, const char* about) {
        book.objects(objects);
        book.ask("inside 0 " + numbers(rounded(p)), about, says(truth));
    };
    const std::string ball = fmt::format("sphere {{ {}, {}", vector(c), number(r));
    ask(ball + " }\n", c + 0.95L * r * d, true, "a point in a sphere");
    ask(ball + " }\n", c + 1.05L * r * d, false, "a point outside of a sphere");
    ask(ball + " inverse }\n", c + 0.95L * r * d, false, "inverse: what was inside is outside");
    ask(ball + " inverse }\n", c + 1.05L * r * d, true, "inverse: what was outside is inside");
    const std::string plane = fmt::format("plane {{ {}, {}", vector(rounded(d)), number(rounded(r)));
    ask(plane + " }\n", (r - 0.1L) * d, true, "a plane's inside is where its normal does not point");
    ask(plane + " }\n", (r + 0.1L) * d, false, "a plane's outside is where its normal points");
    const std::string box = "box { <-1, -2, -3>, <1, 2, 3>";
    ask(box + " }\n", V(0.9L, -1.9L, 2.9L), true, "a point in a box");
    ask(box + " }\n", V(0.9L, -2.1L, 2.9L), false, "a point outside of a box by one coordinate");
    ask("polygon { 4, <0, 0, 0>, <1, 0, 0>, <0, 1, 0>, <0, 0, 0> }\n", V(0.2L, 0.2L, 0), false,
        "a flat thing has no inside");
    const Map map = any_map(dice);
    ask("sphere { <0, 0, 0>, 1 " + map.text() + " }\n", map.point(0.9L * d), true,
        "a sheared sphere: the point in its space");
    ask("sphere { <0, 0, 0>, 1 " + map.text() + " }\n", map.point(1.1L * d), false,
        "a sheared sphere: a point outside");
}

}  // namespace

std::vector<Question> nearest_hits(std::uint64_t seed) {
    Dice dice(seed);
    Notebook book("1.15");
    for (int i = 0; i < 3; ++i) ask_order(dice, book);
    for (int i = 0; i < 2; ++i) ask_clips(dice, book);
    ask_insides(dice, book);
    return book.take();
}

}  // namespace rays::grader::step_1
