// Triangles, alone and in meshes.
#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "1_ray_casting/ray_casting.h"
#include "core/unfinished.h"

namespace rays {

using glm::cross;
using glm::dot;

std::optional<Root> intersect(const Triangle& triangle, const Ray& ray, Interval range) {
    // Task 1.5: Where the ray meets the plane, and the weights of b and c there. Inside: no weight is negative.
    // Edges belong to the triangle: a ray through an edge of two triangles must hit at least one of them.
    unfinished("1.5");
    return {};
}

Vec3 normal(const Triangle& triangle, const Vec3&, const Root&) {
    // Task 1.5: (b - a) x (c - a).
    unfinished("1.5");
    return {};
}

std::optional<Root> intersect(const SmoothTriangle& triangle, const Ray& ray, Interval range) {
    // Task 1.5: Smoothness is only in the normal.
    unfinished("1.5");
    return {};
}

Vec3 normal(const SmoothTriangle& triangle, const Vec3& point, const Root& root) {
    // Task 1.5: The true normal: that of the flat triangle.
    unfinished("1.5");
    return {};
}

Vec3 shading_normal(const SmoothTriangle& triangle, const Root& root) {
    // Task 1.5: Interpolate the normals of the corners with the weights of the root.
    unfinished("1.5");
    return {};
}

bool back_facing(const Vec3& outward_normal, const Vec3& direction) {
    // Task 1.14: Does the outward normal point the same way as the ray?
    unfinished("1.14");
    return {};
}

void prepare(Mesh& mesh) {
    // Task 1.14: The bounding sphere, and outward_winding. A mesh is closed when every edge occurs once in each
    // direction; then the sign of its volume, the sum of a . (b x c) / 6, tells whether it winds outwards.
    // Zero is always right, only slower.
    unfinished("1.14");
}

std::optional<Root> intersect(const Mesh& mesh, const Ray& ray, Interval range) {
    // Task 1.14: The nearest of all faces. Skip back faces of a closed mesh when the range begins outside of its bound:
    // a ray that comes from outside enters before it leaves. Not so for a range that begins inside.
    unfinished("1.14");
    return {};
}

std::optional<Root> intersect(const Mesh& mesh, std::uint32_t face, const Ray& ray, Interval range) {
    // Task 1.14: The face as a triangle of its own; Root::part is its number. Culled as in the mesh: structures of step 4
    // ask face by face and must find the same.
    unfinished("1.14");
    return {};
}

Vec3 normal(const Mesh& mesh, const Vec3&, const Root& root) {
    // Task 1.14: That of the face.
    unfinished("1.14");
    return {};
}

Vec3 shading_normal(const Mesh& mesh, const Root& root) {
    // Task 1.14: As for a smooth triangle when the face is smooth, else the normal of the face.
    unfinished("1.14");
    return {};
}

}  // namespace rays
