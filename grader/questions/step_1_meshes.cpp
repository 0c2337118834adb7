// Questions of task 1.14: back faces and meshes.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "questions/step_1.h"

namespace rays::grader::step_1 {

namespace {

/// A convex solid of triangles, corners counter-clockwise seen from outside.
struct Solid {
    std::vector<V> corners;
    std::vector<std::array<int, 3>> faces;

    V corner(std::size_t face, std::size_t i) const { return corners[static_cast<std::size_t>(faces[face][i])]; }
    V normal(std::size_t f) const {
        return glm::normalize(glm::cross(corner(f, 1) - corner(f, 0), corner(f, 2) - corner(f, 0)));
    }
    V point(std::size_t f, V2 w) const {
        return (1 - w.x - w.y) * corner(f, 0) + w.x * corner(f, 1) + w.y * corner(f, 2);
    }

    /// `turned` exchanges two corners of every face; `left_out` leaves one face out.
    std::string text(bool turned = false, int left_out = -1, const std::string& modifiers = "") const {
        std::string c, f;
        for (const V& p : corners) c += ", " + vector(p);
        int count = 0;
        for (std::size_t i = 0; i < faces.size(); ++i) {
            if (static_cast<int>(i) == left_out) continue;
            const auto [x, y, z] = faces[i];
            f += turned ? fmt::format(", <{}, {}, {}>", x, z, y) : fmt::format(", <{}, {}, {}>", x, y, z);
            ++count;
        }
        return fmt::format("mesh2 {{ vertex_vectors {{ {}{} }} face_indices {{ {}{} }} {} }}\n", corners.size(), c,
                           count, f, modifiers);
    }
};

/// An octahedron, stretched, turned and moved; the order of its corners may come out either way and is then repaired.
Solid any_solid(Dice& dice) {
    const V z = dice.unit(), center = dice.position(2);
    V x, y;
    frame(z, x, y);
    const L a = dice.between(0.7, 2), b = dice.between(0.7, 2), c = dice.between(0.7, 2);
    Solid solid;
    for (const V& axis : {a * x, b * y, c * z}) {
        solid.corners.push_back(rounded(center + axis));
        solid.corners.push_back(rounded(center - axis));
    }
    for (int sx = 0; sx < 2; ++sx) {
        for (int sy = 0; sy < 2; ++sy) {
            for (int sz = 0; sz < 2; ++sz) {
                std::array<int, 3> face{sx, 2 + sy, 4 + sz};
                solid.faces.push_back(face);
                const std::size_t f = solid.faces.size() - 1;
                if (glm::dot(solid.normal(f), solid.corner(f, 0) - center) < 0)
                    std::swap(solid.faces[f][1], solid.faces[f][2]);
            }
        }
    }
    return solid;
}

V along(Dice& dice, const V& n) {
    for (;;) {
        const V d = dice.unit();
        if (glm::dot(d, n) > 0.2L) return d;
    }
}

V2 inner_weights(Dice& dice) {
    const L s = std::sqrt(dice.between(0, 1)), t = dice.between(0, 1);
    return V2(s * (1 - t), s * t) * 0.94L + 0.02L;
}

}  // namespace

std::vector<Question> meshes(std::uint64_t seed) {
    Dice dice(seed);
    Notebook book("1.14");
    const auto ask_facing = [&](const V& n, const V& d, bool truth, const char* about) {
        book.ask("back_facing " + numbers(rounded(n)) + " " + numbers(rounded(d)), about, says(truth));
    };
    book.objects("sphere { <0, 0, 0>, 1 }\n");
    for (int i = 0; i < 3; ++i) {
        const V d = dice.unit();
        const L length = dice.between(0.3, 3);
        ask_facing(along(dice, d), length * d, true, "the outward normal goes along with the ray: its back is seen");
        ask_facing(along(dice, -d), length * d, false, "the outward normal comes towards the ray: its front is seen");
    }
    for (int i = 0; i < 3; ++i) {
        const Solid solid = any_solid(dice);
        const auto face = static_cast<std::size_t>(dice.whole(0, 7));
        const V n = solid.normal(face), point = solid.point(face, inner_weights(dice));
        const Shot outside = aim(point, along(dice, -n), dice.between(1, 6), dice.between(0.2, 5));
        const Shot inside = aim(point, along(dice, n), 0.02L);
        for (const bool turned : {false, true}) {
            book.objects(solid.text(turned));
            book.root(outside, turned ? "a closed mesh, faces turned inwards" : "a closed mesh from outside");
            book.ask(nearest_query(outside), "the normal of its face", hits_with_normal(outside, n, true));
            book.root(inside, "from within a closed mesh: back faces are seen");
        }
        book.miss(aim(point, outside.direction / outside.speed(), -9), "the mesh lies behind the origin");
        V x, y;
        frame(n, x, y);
        book.miss(aim(point + 0.02L * n, x, 9), "past a face");

        // Through the gap where a face was, on to the others from behind: an open mesh has no back faces.
        book.objects(solid.text(false, static_cast<int>(face)));
        const std::size_t opposite = 7 - face;
        const V far_point = solid.point(opposite, inner_weights(dice));
        const V through = glm::normalize(far_point - point);
        book.root(aim(far_point, through, glm::length(far_point - point) + 2),
                  "an open mesh: through the gap, the other side from behind");

        // The front half cut away: the far faces are seen from behind, although the mesh itself is closed.
        const V cut = rounded(through);
        const L offset = rounded(glm::dot(glm::normalize(cut), (far_point + point) / 2.0L));
        book.objects(solid.text(
            false, -1, fmt::format("clipped_by {{ plane {{ {}, {} inverse }} }}", vector(cut), number(offset))));
        book.root(aim(far_point, through, glm::length(far_point - point) + 2),
                  "a closed mesh, its front clipped away: the far side from behind");
    }
    return book.take();
}

}  // namespace rays::grader::step_1
