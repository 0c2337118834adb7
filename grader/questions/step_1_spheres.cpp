// Questions of task 1.3.
#include <cmath>

#include "questions/step_1.h"

namespace rays::grader::step_1 {

namespace {

struct Ball {
    V center;
    L radius;
    std::string text() const { return "sphere { " + vector(center) + ", " + number(radius) + " }\n"; }
};

Ball any_ball(Dice& dice) { return {dice.position(3), dice.round_between(0.3, 2)}; }

/// A unit vector with at least 0.2 of it along n.
V along(Dice& dice, const V& n) {
    for (;;) {
        const V d = dice.unit();
        if (glm::dot(d, n) > 0.2L) return d;
    }
}

}  // namespace

std::vector<Question> spheres(std::uint64_t seed) {
    Dice dice(seed);
    Notebook book("1.3");
    for (int i = 0; i < 4; ++i) {
        const Ball ball = any_ball(dice);
        book.objects(ball.text());
        const V n = dice.unit(), point = ball.center + ball.radius * n;
        const V inwards = along(dice, -n);
        const L speed = dice.between(0.2, 5);
        const L chord = -2 * ball.radius * glm::dot(inwards, n);

        const Shot outside = aim(point, inwards, dice.between(1, 9), speed);
        book.root(outside, "from outside: the near root, t in lengths of the direction");
        book.ask(nearest_query(outside), "the normal points outwards", hits_with_normal(outside, n, false));

        const V leaving = along(dice, n);
        const Shot inside = aim(point, leaving, ball.radius * glm::dot(leaving, n) * dice.between(0.1, 1.9), speed);
        book.root(inside, "origin inside the sphere: the far root");
        book.ask(nearest_query(inside), "seen from inside, the normal still points outwards",
                 hits_with_normal(inside, n, false));

        book.miss(aim(point, inwards, -(chord + dice.between(0.5, 5))), "the sphere lies behind the origin");

        Shot second = outside;
        second.t += chord / speed;
        book.ask(root_query(outside, outside.t + 0.3L * chord / speed),
                 "the range begins between the roots: the second counts", hits(second));
        book.ask(root_query(outside, 0, outside.t * 0.9L), "the range ends before the sphere", misses_it());

        V x, y;
        frame(leaving, x, y);
        const L angle = dice.between(0, 6.28);
        const V side = std::cos(angle) * x + std::sin(angle) * y;
        book.miss(aim(ball.center + 1.01L * ball.radius * side, leaving, 6), "passes by at 1.01 radii");
        const L half_chord = ball.radius * std::sqrt(1 - 0.99L * 0.99L);
        Shot edge = aim(ball.center + 0.99L * ball.radius * side, leaving, 6);
        edge.t -= half_chord;
        book.root(edge, "close to the silhouette, at 0.99 radii");

        // h = r / 2 at a few thousand radii: b^2 - c of float numbers is rounding noise there.
        const L far = dice.between(1000, 4000) * ball.radius;
        Shot distant = aim(ball.center + 0.5L * ball.radius * side, leaving, far);
        distant.t -= ball.radius * std::sqrt(0.75L);
        book.ask(root_query(distant), "a far small sphere, hit half way to its edge",
                 hits_at(distant.t, 1, 1e-4L * ball.radius));
    }
    return book.take();
}

}  // namespace rays::grader::step_1
