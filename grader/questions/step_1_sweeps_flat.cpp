// Sweeps over planes, triangles, polygons, boxes and meshes: parallel rays, edges, corners.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "questions/squared_paper.h"
#include "questions/step_1_sweeps.h"

namespace rays::grader::step_1 {

namespace {

/// A ray that sinks by `slope` a length, one length above the plane.
void grazing_planes(Notebook& book, Dice& dice, L slope) {
    book.objects("plane { <0, 1, 0>, 0 }\n");
    for (int i = 0; i < 4; ++i) {
        const L angle = dice.between(0, 6.28);
        const Shot shot{rounded(V(dice.between(-2, 2), dice.between(0.5, 2), dice.between(-2, 2))),
                        rounded(V(std::cos(angle), -slope, std::sin(angle))), 0};
        const L t = -shot.origin.y / shot.direction.y;
        book.ask(root_query(shot), "a sinking ray meets the plane far away", [=](const Answer& answer) {
            Judgement j = hits_at(t, 1, 1e-6L * t)(answer);
            j.error /= static_cast<double>(t);
            return j;
        });
    }
}

/// x from an edge, of triangles of size about 1.
void triangle_edges(Notebook& book, Dice& dice, L x) {
    for (int i = 0; i < 4; ++i) {
        const V a = dice.position(1), d = dice.unit();
        V right, up;
        frame(dice.unit(), right, up);
        if (std::abs(glm::dot(glm::cross(right, up), d)) < 0.3L) continue;
        const V b = rounded(a + right), c = rounded(a + up);
        book.objects(fmt::format("triangle {{ {}, {}, {} }}\n", vector(a), vector(b), vector(c)));
        const L along = dice.between(0.2, 0.7);
        const V inner = a + along * (b - a) + x * (c - a), outer = a + along * (b - a) - x * (c - a);
        book.root(aim(inner, d, 3), "just inside of an edge");
        book.miss(aim(outer, d, 3), "just outside of an edge");
        const V long_edge = b + along * (c - b), inwards = a - long_edge;
        book.root(aim(long_edge + x * inwards, d, 3), "just inside of the long edge");
        book.miss(aim(long_edge - x * inwards, d, 3), "just outside of the long edge");
    }
}

/// A comb; the half line of the crossings test runs past many of its corners, x above or below.
void polygon_corners(Notebook& book, Dice& dice, L x) {
    const Paper paper = paper_across(dice.whole(0, 2));
    book.objects(polygon_text({comb()}, paper));
    const auto at = [&](L u, L v) { return paper.at({u, v}); };
    const V straight = paper.normal();
    for (const L u : {0.5L, 2.5L, 4.5L, 6.5L}) {
        book.root(aim(at(u, 1 + x), straight, 3), "in a tooth, just above the level of the corners");
        book.root(aim(at(u, 1 - x), straight, 3), "under a tooth, just below the level of the corners");
    }
    for (const L u : {1.5L, 3.5L, 5.5L}) {
        book.miss(aim(at(u, 1 + x), straight, 3), "in a gap, just above its floor");
        book.root(aim(at(u, 1 - x), straight, 3), "under a gap, just below its floor");
    }
    book.miss(aim(at(-0.5L, 1 + x), straight, 3), "beside the comb");
}

/// Rays along x whose other components are as small as numbers go.
void nearly_parallel_to_faces(Notebook& book, Dice& dice, L x) {
    book.objects("box { <-1, -2, -3>, <1, 2, 3> }\n");
    for (int i = 0; i < 4; ++i) {
        const L sign = dice.coin() ? 1 : -1;
        const Shot shot{rounded(V(-5, dice.between(-1.5, 1.5), dice.between(-2.5, 2.5))),
                        rounded(V(1, sign * x, -sign * x)), 4};
        book.root(shot, "nearly parallel to four faces, between them");
        Shot outside = shot;
        outside.origin.y = 2.5L * sign;
        book.miss(outside, "nearly parallel to four faces, outside of one");
    }
}

/// An icosahedron whose numbers are floats: POV-Ray keeps the corners of meshes so.
std::string closed_mesh(std::vector<V>& corners, std::vector<std::array<int, 3>>& faces) {
    const L g = static_cast<float>((1 + std::sqrt(5.0L)) / 2);
    corners = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
               {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    faces = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
             {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
             {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    std::string c, f;
    for (const V& p : corners) c += ", " + vector(p);
    for (const auto& [i, j, k] : faces) f += fmt::format(", <{}, {}, {}>", i, j, k);
    return fmt::format("mesh2 {{ vertex_vectors {{ 12{} }} face_indices {{ 20{} }} }}\n", c, f);
}

/// Rays at edges and corners of a closed mesh from farther and farther away: none may slip through.
void leaks(Notebook& book, Dice& dice, L distance) {
    std::vector<V> corners;
    std::vector<std::array<int, 3>> faces;
    book.objects(closed_mesh(corners, faces));
    for (int i = 0; i < 60; ++i) {
        const auto& face = faces[static_cast<std::size_t>(dice.whole(0, 19))];
        const V a = corners[static_cast<std::size_t>(face[0])], b = corners[static_cast<std::size_t>(face[1])];
        const V target = i % 4 == 0 ? a : glm::mix(a, b, dice.between(0, 1));
        // Within 30 degrees of the radius: no face around the target is seen edge-on.
        const V d = -glm::normalize(glm::normalize(target) + 0.5L * dice.unit());
        const Shot shot = aim(target, d, distance);
        book.ask(root_query(shot), "at an edge or corner of a closed mesh", hits_at(shot.t, 1, 1e-6L * distance));
    }
}

}  // namespace

std::vector<Plan> sweeps_of_flat_shapes() {
    return {
        {"1.4.grazing",
         "1.4",
         "Rays closer and closer to parallel",
         "|normal . direction|",
         "relative error of t",
         {0, -14, 1},
         1e-9,
         1,
         grazing_planes},
        {"1.5.edge",
         "1.5",
         "Rays closer and closer to an edge of a triangle",
         "distance from the edge",
         "error of the hit, in lengths",
         {-1, -15, 1},
         1e-12,
         0.1,
         triangle_edges},
        {"1.6.corner",
         "1.6",
         "A crossings test closer and closer to corners",
         "distance from their level",
         "error of the hit, in lengths",
         {-1, -15, 1},
         1e-12,
         0.1,
         polygon_corners},
        {"1.7.parallel",
         "1.7",
         "Rays closer and closer to parallel to faces of a box",
         "small components of the direction",
         "error of the hit, in lengths",
         {-1, -301, 20},
         1e-301,
         0.1,
         nearly_parallel_to_faces},
        {"1.14.leaks",
         "1.14",
         "Edges and corners of a closed mesh from farther and farther away",
         "distance",
         "error of the hit, in lengths; infinite: slipped through",
         {1, 7, 1},
         10,
         1e6,
         leaks},
    };
}

}  // namespace rays::grader::step_1
