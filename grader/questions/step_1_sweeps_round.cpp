// Sweeps over spheres, cones and quadrics: where discriminants cancel and quadratic terms vanish.
#include <fmt/format.h>

#include <cmath>

#include "questions/step_1_sweeps.h"

namespace rays::grader::step_1 {

namespace {

std::string ball(const V& center, L radius) {
    return fmt::format("sphere {{ {}, {} }}\n", vector(center), number(radius));
}

/// How far off the surface of a ball, in radii.
std::function<L(const V&)> off_ball(const V& center, L radius) {
    return [=](const V& p) { return (glm::length(p - center) - radius) / radius; };
}

/// b^2 - c cancels when the distance is large beside the radius.
void far_spheres(Notebook& book, Dice& dice, L distance) {
    for (int i = 0; i < 8; ++i) {
        const V center = dice.position(1), d = dice.unit();
        const L radius = dice.round_between(0.5, 2), h = dice.between(0.1, 0.9) * radius;
        V x, y;
        frame(d, x, y);
        book.objects(ball(center, radius));
        Shot shot = aim(center + h * x, d, std::max(1.1L, distance) * radius);
        shot.t -= std::sqrt(radius * radius - h * h);
        book.ask(root_query(shot), "aimed inside of the silhouette", lands_on(shot, off_ball(center, radius), 1e-6L));
    }
}

/// On either side of the silhouette: h = r (1 -+ x).
void grazing_spheres(Notebook& book, Dice& dice, L x) {
    for (int i = 0; i < 6; ++i) {
        const V center = dice.position(1), d = dice.unit();
        const L radius = dice.round_between(0.5, 2);
        V side, other;
        frame(d, side, other);
        book.objects(ball(center, radius));
        Shot inside = aim(center + radius * (1 - x) * side, d, 5);
        inside.t -= radius * std::sqrt(x * (2 - x));
        book.ask(root_query(inside), "inside of the silhouette", lands_on(inside, off_ball(center, radius), 1e-6L));
        book.miss(aim(center + radius * (1 + x) * side, d, 5), "outside of the silhouette");
    }
}

/// The origin x radii below the surface, the ray going straight out or nearly so: the near root is behind.
void origin_near_surface(Notebook& book, Dice& dice, L x) {
    for (int i = 0; i < 6; ++i) {
        const V center = dice.position(1), n = dice.unit();
        const L radius = dice.round_between(0.5, 2);
        book.objects(ball(center, radius));
        V d = dice.unit();
        while (glm::dot(d, n) < 0.5L) d = dice.unit();
        const Shot out{rounded(center + radius * (1 - x) * n), rounded(d), 0};
        // The truth for the origin as it was rounded: c / q, in long double.
        const V o = out.origin - center;
        const L a = glm::dot(out.direction, out.direction), b = glm::dot(o, out.direction);
        const L c = glm::dot(o, o) - radius * radius;
        Shot shot = out;
        shot.t = -c / (b + std::sqrt(b * b - a * c));
        book.ask(root_query(shot), "from just below the surface outwards", [=](const Answer& answer) {
            Judgement j = hits_at(shot.t, 1, 1e-3L * shot.t)(answer);
            j.error /= static_cast<double>(shot.t);
            return j;
        });
    }
}

/// Inside a cone, x from parallel to a generator: the quadratic term is about x and the ray meets the mantle once.
void cones_along_generators(Notebook& book, Dice& dice, L x) {
    book.objects("cone { <0, 0, 0>, 1, <0, 2, 0>, 0 }\n");
    for (int i = 0; i < 8; ++i) {
        const L angle = dice.between(0, 6.28), s = dice.between(0.2, 0.6);
        const V out(std::cos(angle), 0, std::sin(angle));
        const V generator = glm::normalize(V(0, 2, 0) - out);
        const L other_angle = angle + kPi + dice.between(-0.7, 0.7);
        const V goal = (1 - s) * V(std::cos(other_angle), 0, std::sin(other_angle)) + V(0, 2 * s, 0);
        const V d = glm::normalize(generator + x * dice.unit());
        const Shot shot = aim(goal, d, 0.1L);  // inside: the solid is convex and d leaves it at the goal
        book.ask(root_query(shot), "nearly parallel to a generator", hits_at(shot.t, 1, 1e-6L));
    }
}

/// z = x^2 + y^2 from below, `tilt` off its axis: one root near, the other at about 1 / tilt^2.
void paraboloid_along_axis(Notebook& book, Dice& dice, L tilt) {
    book.objects("quadric { <1, 1, 0>, <0, 0, 0>, <0, 0, -1>, 0 }\n");
    for (int i = 0; i < 8; ++i) {
        const V at(dice.between(-1, 1), dice.between(-1, 1), 0);
        const V goal(at.x, at.y, at.x * at.x + at.y * at.y);
        const L angle = dice.between(0, 6.28);
        const V d = glm::normalize(V(0.1L * tilt * std::cos(angle), 0.1L * tilt * std::sin(angle), 1));
        const Shot shot = aim(goal, d, 4);
        book.ask(root_query(shot), "nearly along the axis", hits_at(shot.t, 1, 1e-6L));
    }
}

/// x^2 + y^2 - z^2 = eps^2: a hyperboloid whose neck closes to a cone. The roots lie eps apart, four lengths away.
void closing_necks(Notebook& book, Dice& dice, L eps) {
    const L constant = rounded(eps * eps), neck = std::sqrt(constant);
    book.objects(fmt::format("quadric {{ <1, 1, -1>, <0, 0, 0>, <0, 0, 0>, {} }}\n", number(-constant)));
    for (int i = 0; i < 8; ++i) {
        const L angle = dice.between(0, 6.28), slant = dice.between(-0.5, 0.5);
        const V out(std::cos(angle), std::sin(angle), 0);
        const V d = glm::normalize(-out + slant * V(-out.y, out.x, 0));
        const Shot shot = aim(neck * out, d, 4);
        book.ask(root_query(shot), "through the neck", [=](const Answer& answer) {
            Judgement j = hits_at(shot.t, 1, 1e-2L * neck)(answer);
            j.error /= static_cast<double>(neck);
            return j;
        });
    }
}

}  // namespace

std::vector<Plan> sweeps_of_round_shapes() {
    return {
        {"1.3.distance",
         "1.3",
         "Spheres farther and farther away",
         "distance / radius",
         "distance of the hit from the surface, in radii",
         {0, 8, 0.5},
         1,
         1e8,
         far_spheres},
        {"1.3.grazing",
         "1.3",
         "Rays closer and closer to the silhouette",
         "1 - impact parameter / radius",
         "distance of the hit from the surface, in radii",
         {-1, -14, 1},
         1e-9,
         0.1,
         grazing_spheres},
        {"1.3.origin",
         "1.3",
         "Origins closer and closer to the surface",
         "depth of the origin, in radii",
         "relative error of t",
         {-1, -14, 1},
         1e-10,
         0.1,
         origin_near_surface},
        {"1.8.generator",
         "1.8",
         "Rays closer and closer to a generator of a cone",
         "angle from the generator",
         "error of the hit, in lengths",
         {-1, -16, 1},
         1e-16,
         0.1,
         cones_along_generators},
        {"1.9.axis",
         "1.9",
         "Rays closer and closer to the axis of a paraboloid",
         "ten times the tangent of the angle from the axis",
         "error of the hit, in lengths",
         {0, -16, 1},
         1e-16,
         1,
         paraboloid_along_axis},
        {"1.9.neck",
         "1.9",
         "A hyperboloid that closes to a cone",
         "radius of the neck",
         "error of the hit, in radii of the neck",
         {-1, -10, 1},
         1e-7,
         0.1,
         closing_necks},
    };
}

}  // namespace rays::grader::step_1
