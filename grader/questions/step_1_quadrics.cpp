// Questions of task 1.9. The constant term is chosen last, so that the surface goes through a chosen point.
#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "questions/step_1.h"

namespace rays::grader::step_1 {

namespace {

/// As in the scene: A x^2 + E y^2 + H z^2 + B xy + C xz + F yz + D x + G y + I z + J.
struct Form {
    V square, mixed, linear;
    L constant = 0;

    L operator()(const V& p) const {
        return square.x * p.x * p.x + square.y * p.y * p.y + square.z * p.z * p.z + mixed.x * p.x * p.y +
               mixed.y * p.x * p.z + mixed.z * p.y * p.z + glm::dot(linear, p) + constant;
    }
    V gradient(const V& p) const {
        return {2 * square.x * p.x + mixed.x * p.y + mixed.y * p.z + linear.x,
                2 * square.y * p.y + mixed.x * p.x + mixed.z * p.z + linear.y,
                2 * square.z * p.z + mixed.y * p.x + mixed.z * p.y + linear.z};
    }
    /// The form at o + t d is f(o) + t slope + t^2 bend; the bend is that of d without linear terms.
    L bend(const V& d) const { return Form{square, mixed, V(0), 0}(d); }
    std::string text() const {
        return fmt::format("quadric {{ {}, {}, {}, {} }}\n", vector(square), vector(mixed), vector(linear),
                           number(constant));
    }
};

/// The other root beside shot.t, by Vieta's formulas; nothing when the equation is linear.
std::optional<L> other_root(const Form& f, const Shot& shot) {
    const L a = f.bend(shot.direction), slope = glm::dot(f.gradient(shot.at(shot.t)), shot.direction);
    return a == 0 ? std::nullopt : std::optional(shot.t - slope / a);
}

/// A ray through a point of the surface: both roots asked for.
void ask_through(Dice& dice, Notebook& book, const Form& f, const V& point, const std::string& name) {
    for (int tries = 0; tries < 1000; ++tries) {
        const V d = dice.unit(), n = glm::normalize(f.gradient(point));
        if (std::abs(glm::dot(d, n)) < 0.2L) continue;
        Shot shot = aim(point, d, dice.between(1, 6), dice.between(0.3, 3));
        auto other = other_root(f, shot);
        if (other && (std::abs(*other - shot.t) * shot.speed() < 0.05L || std::abs(*other) * shot.speed() < 0.05L))
            continue;
        const bool first = !other || *other < 0 || *other > shot.t;
        if (!first) std::swap(shot.t, *other);
        const bool second_ahead = other && *other > shot.t;
        book.root(shot, name + ": the nearer root ahead");
        const V normal = glm::normalize(f.gradient(shot.at(shot.t)));
        book.ask(nearest_query(shot), name + ": the normal is along the gradient",
                 hits_with_normal(shot, normal, true));
        if (second_ahead) {
            Shot second = shot;
            second.t = *other;
            book.ask(root_query(shot, (shot.t + *other) / 2), name + ": the range begins between the roots",
                     hits(second));
        } else {
            book.ask(root_query(shot, shot.t + 0.01L), name + ": no root but one ahead", misses_it());
        }
        return;
    }
}

}  // namespace

std::vector<Question> quadrics(std::uint64_t seed) {
    Dice dice(seed);
    Notebook book("1.9");
    const struct {
        const char* name;
        V square, mixed, linear;
    } kinds[] = {
        {"ellipsoid", {1, 2, 0.5L}, {0, 0, 0}, {0, 0, 0}},
        {"ellipsoid off the axes", {2, 1, 1.5L}, {0.5L, -0.75L, 0.25L}, {1, -2, 0.5L}},
        {"hyperboloid", {1, -1, 1}, {0, 0, 0}, {0, 0, 0}},
        {"paraboloid", {1, 0, 1}, {0, 0, 0}, {0, -1, 0}},
        {"saddle z = x y", {0, 0, 0}, {1, 0, 0}, {0, 0, -1}},
        {"elliptic cylinder", {1, 0, 3}, {0, 0, 0}, {0, 0, 0}},
        {"parabolic cylinder", {1, 0, 0}, {0, 0, 0}, {0, 1, 0}},
        {"a plane, in disguise", {0, 0, 0}, {0, 0, 0}, {1, 2, -1}},
    };
    for (const auto& kind : kinds) {
        const V point = dice.position(1.5) + V(0.25L);
        Form f{kind.square, kind.mixed, kind.linear, 0};
        f.constant = rounded(-f(point));
        book.objects(f.text());
        ask_through(dice, book, f, point, kind.name);
    }

    Form unit{V(1), V(0), V(0), -4};
    book.objects(unit.text());
    const V n = dice.unit();
    V x, y;
    frame(n, x, y);
    book.root(aim(2.0L * n, -n, 5), "a ball of radius 2: its size");
    book.miss(aim(2.02L * x, n, 5), "a ball of radius 2: a miss at 1.01 radii");
    book.root(aim(2.0L * n, n, 1.5L), "a ball of radius 2: from inside");
    book.miss(aim(2.0L * n, n, -0.5L), "a ball of radius 2: behind the origin");

    // z = x^2 + y^2 along its axis, where the quadratic term vanishes.
    const V at(dice.round_between(-1, 1), dice.round_between(-1, 1), 0);
    const V on(at.x, at.y, at.x * at.x + at.y * at.y);
    book.objects(Form{V(1, 1, 0), V(0), V(0, 0, -1), 0}.text());
    book.root(aim(on, V(0, 0, 1), 4), "a paraboloid along its axis: one root, the equation is linear");
    book.root(aim(on, V(0, 0, -1), 4), "a paraboloid along its axis, from within");

    // Two planes x^2 = 1, and what is empty.
    book.objects(Form{V(1, 0, 0), V(0), V(0), -1}.text());
    book.root(aim(V(-1, 0.5L, 2), glm::normalize(V(1, 0.2L, 0.3L)), 4), "a pair of planes: the nearer one");
    book.miss(aim(V(0, 3, 1), V(0, 0, 1), 4), "between a pair of planes, parallel to them");
    book.objects(Form{V(1, 2, 3), V(0), V(0), 1}.text());
    book.miss(aim(V(0, 0, 0), n, 4), "x^2 + 2 y^2 + 3 z^2 + 1 = 0 has no points");
    return book.take();
}

}  // namespace rays::grader::step_1
