// Closed meshes for the tests.
#pragma once

#include <map>
#include <utility>

#include "1_ray_casting/ray_casting.h"

namespace rays::test {

/// An icosahedron, every face split in four `levels` times, corners moved to the unit sphere, then scaled and shifted.
/// Counter-clockwise seen from outside.
inline Mesh ball_of_triangles(int levels, Real radius, const Vec3& center) {
    const Real g = Real(std::numbers::phi);
    Mesh mesh;
    mesh.positions = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                      {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    using Corners = std::array<std::uint32_t, 3>;
    std::vector<Corners> faces = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                                  {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                                  {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    for (int level = 0; level < levels; ++level) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [at, is_new] = middles.try_emplace(std::minmax(a, b), mesh.positions.size());
            if (is_new) mesh.positions.push_back(glm::normalize(mesh.positions[a]) + glm::normalize(mesh.positions[b]));
            return at->second;
        };
        std::vector<Corners> finer;
        for (const auto [a, b, c] : faces) {
            const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
        }
        faces = std::move(finer);
    }
    for (Vec3& p : mesh.positions) p = center + radius * glm::normalize(p);
    for (const Corners& f : faces) mesh.faces.push_back({f, {0, 0, 0}, Mesh::kObjectMaterial, false});
    return mesh;
}

}  // namespace rays::test
