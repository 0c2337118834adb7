// Sweeps over torus and patch, where two roots come together; over transforms and bounds.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "questions/step_1_sweeps.h"

namespace rays::grader::step_1 {

namespace {

/// Parallel to the axis, x tube radii inside or outside of the outer wall, and along the top in the same way.
void grazing_tori(Notebook& book, Dice& dice, L x) {
    const L major = 1.5L, minor = dice.round_between(0.2, 0.6);
    book.objects(fmt::format("torus {{ {}, {} }}\n", number(major), number(minor)));
    const auto off_surface = [=](const V& p) { return std::hypot(std::hypot(p.x, p.z) - major, p.y) - minor; };
    for (int i = 0; i < 4; ++i) {
        const L angle = dice.between(0, 6.28);
        const V out(std::cos(angle), 0, std::sin(angle));
        const Shot wall = aim((major + minor * (1 - x)) * out, V(0, 1, 0), 3);
        book.ask(root_query(wall), "just inside of the outer wall", lands_on(wall, off_surface, 1e-9L));
        book.miss(aim((major + minor * (1 + x)) * out, V(0, 1, 0), 3), "just outside of the outer wall");
        const Shot top = aim(major * out + V(0, minor * (1 - x), 0), out, 0.7L * major);
        book.ask(root_query(top), "just below the top", lands_on(top, off_surface, 1e-9L));
        book.miss(aim(major * out + V(0, minor * (1 + x), 0), out, 4), "just above the top");
        // Across the tube at its outer wall, in a plane through the centre: the curvature of the great circle.
        const V across(-out.z, 0, out.x);
        const Shot rim = aim((major + minor * (1 - x)) * out, across, 4);
        book.ask(root_query(rim), "just inside of the rim", lands_on(rim, off_surface, 1e-9L));
        book.miss(aim((major + minor * (1 + x)) * out, across, 4), "just outside of the rim");
    }
}

/// A vault P(u, v) = (3 u, 3 v, 12 u (1 - u)), of height 3, turned in space: rays across its ridge, 3 x below or above.
void grazing_vaults(Notebook& book, Dice& dice, L x) {
    V right, up;
    const V height = dice.unit(), corner = dice.position(1);
    frame(height, right, up);
    std::string points;
    for (int k = 0; k < 16; ++k) {
        const int i = k / 4, j = k % 4;
        const L z = i == 1 || i == 2 ? 4 : 0;  // 3 s^2 t 4 + 3 s t^2 4 = 12 s t
        points +=
            (k ? ", " : "") + vector(rounded(corner + static_cast<L>(i) * right + static_cast<L>(j) * up + z * height));
    }
    book.objects("bicubic_patch { type 1 flatness 0 u_steps 4 v_steps 4 " + points + " }\n");
    for (int i = 0; i < 6; ++i) {
        const L along = dice.between(0.3, 2.7), slant = dice.between(-0.2, 0.2);
        const V d = glm::normalize(right + slant * up);
        const L stretch = std::sqrt(1 + slant * slant);
        const V ridge = corner + 1.5L * right + along * up;
        Shot below = aim(ridge + 3 * (1 - x) * height, d, 4);
        below.t -= 1.5L * std::sqrt(x) * stretch;  // 12 u (1 - u) = 3 (1 - x) at 3 u = 1.5 (1 -+ sqrt(x))
        book.ask(root_query(below), "just below the ridge", hits_at(below.t, 1, 1e-6L + 1e-3L * std::sqrt(x)));
        book.miss(aim(ridge + 3 * (1 + x) * height, d, 4), "just above the ridge");
    }
}

/// A unit ball stretched x times along one axis.
void stretched_balls(Notebook& book, Dice& dice, L x) {
    const L factor = rounded(x);
    book.objects(fmt::format("sphere {{ <0, 0, 0>, 1 scale <1, 1, {}> }}\n", number(factor)));
    for (int i = 0; i < 8; ++i) {
        V n = dice.unit();
        const V goal(n.x, n.y, factor * n.z), normal = glm::normalize(V(n.x, n.y, n.z / factor));
        V d = dice.unit();
        while (glm::dot(d, normal) > -0.3L) d = dice.unit();
        const Shot shot = aim(goal, d, 5);
        book.ask(root_query(shot), "a stretched ball",
                 [=](const Answer& answer) { return hits_at(shot.t, 1, 1e-6L * (1 + factor * 1e-3L))(answer); });
    }
}

/// Balls farther and farther away: a ray through one is never declared a miss, one that passes at 1.5 radii is.
void far_bounds(Notebook& book, Dice& dice, L distance) {
    book.objects("sphere { <0, 0, 0>, 1 }\n");
    for (int i = 0; i < 6; ++i) {
        const V center = dice.position(2), d = dice.unit();
        const L radius = dice.round_between(0.5, 2);
        V x, y;
        frame(d, x, y);
        for (const auto& [h, truth, about] : {std::tuple(0.999L, false, "through a far ball, close to its edge"),
                                              std::tuple(1.5L, true, "past a far ball, at 1.5 radii")}) {
            const Shot shot = aim(center + h * radius * x, d, std::max(1.6L, distance) * radius);
            book.ask(fmt::format("misses {} {} {} 0 {}", numbers(center), number(radius), shot.text(), number(kFar)),
                     about, says(truth));
        }
    }
}

}  // namespace

std::vector<Plan> sweeps_of_curved_shapes() {
    return {
        {"1.10.tangent",
         "1.10",
         "Rays closer and closer to tangents of a torus",
         "depth below the surface, in tube radii",
         "distance of the hit from the surface",
         {-1, -15, 1},
         1e-10,
         0.1,
         grazing_tori},
        {"1.11.silhouette",
         "1.11",
         "Rays closer and closer to the silhouette of a patch",
         "depth below the ridge, in heights",
         "error of the hit, in lengths",
         {-1, -14, 1},
         1e-11,
         0.1,
         grazing_vaults},
        {"1.12.stretch",
         "1.12",
         "A sphere stretched more and more",
         "longest / shortest axis",
         "error of the hit, in lengths",
         {0, 6, 1},
         1,
         1e6,
         stretched_balls},
        {"1.13.distance",
         "1.13",
         "Bounding spheres farther and farther away",
         "distance / radius",
         "0: right; infinite: wrong",
         {0, 8, 1},
         1,
         1e7,
         far_bounds},
    };
}

}  // namespace rays::grader::step_1
