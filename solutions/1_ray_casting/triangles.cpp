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

//> hidden
namespace {

/// The space of Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013: the ray starts at the
/// origin and runs along +z, so the triangle problem is a point-in-triangle problem in the plane.
class ShearedSpace {
public:
    explicit ShearedSpace(const Ray& ray) {
        const Vec3 size = glm::abs(ray.direction);
        z_ = size.y > size.x;  // without branches: rays that bounce go any way
        z_ = size.z > std::max(size.x, size.y) ? 2 : z_;
        static constexpr int kNext[4] = {1, 2, 0, 1};
        x_ = kNext[z_];
        y_ = kNext[z_ + 1];
        origin_ = along_axes(ray.origin);
        const Vec3 direction = along_axes(ray.direction);
        scale_ = 1 / direction.z;
        shear_x_ = direction.x * scale_;
        shear_y_ = direction.y * scale_;
    }

    Vec3 from_world(const Vec3& point) const {
        const Vec3 p = along_axes(point) - origin_;
        return {p.x - shear_x_ * p.z, p.y - shear_y_ * p.z, scale_ * p.z};
    }

private:
    /// From memory: operator[] of a vector decides component by component.
    Vec3 along_axes(const Vec3& v) const {
        const Real* const components = &v.x;
        return {components[x_], components[y_], components[z_]};
    }

    int x_, y_, z_;
    Vec3 origin_;
    Real shear_x_, shear_y_, scale_;
};

/// Which side of the edge from a to b is the ray on? Exchanging a and b changes the sign and nothing else, not even the
/// rounding. So two triangles with a common edge never both deny a ray: that is what makes a mesh watertight.
Real edge_function(const Vec3& a, const Vec3& b) { return a.x * b.y - a.y * b.x; }

/// a, b, c in sheared space.
std::optional<Root> intersect_sheared(const Vec3& a, const Vec3& b, const Vec3& c, Interval range) {
    const Real wa = edge_function(b, c), wb = edge_function(c, a), wc = edge_function(a, b);
    std::optional<Root> root;  // filled in place: who copies it at once waits for its parts
    if (std::min({wa, wb, wc}) < 0 && std::max({wa, wb, wc}) > 0) return root;
    const Real inverse = 1 / (wa + wb + wc), t = (wa * a.z + wb * b.z + wc * c.z) * inverse;  // edge-on: in no interval
    if (range.contains(t)) {
        root.emplace();
        root->t = t;
        root->uv = inverse * Vec2(wb, wc);
    }
    return root;
}

std::optional<Root> intersect(const Vec3& a, const Vec3& b, const Vec3& c, const Ray& ray, Interval range) {
    const ShearedSpace space(ray);
    return intersect_sheared(space.from_world(a), space.from_world(b), space.from_world(c), range);
}

}  // namespace
//< hidden

std::optional<Root> intersect(const Triangle& triangle, const Ray& ray, Interval range) {
    //> 1.5 Where the ray meets the plane, and the weights of b and c there. Inside: no weight is negative.
    //>   Edges belong to the triangle: a ray through an edge of two triangles must hit at least one of them.
    return intersect(triangle.a, triangle.b, triangle.c, ray, range);
    //< 1.5
}

Vec3 normal(const Triangle& triangle, const Vec3&, const Root&) {
    //> 1.5 (b - a) x (c - a).
    return cross(triangle.b - triangle.a, triangle.c - triangle.a);
    //< 1.5
}

std::optional<Root> intersect(const SmoothTriangle& triangle, const Ray& ray, Interval range) {
    //> 1.5 Smoothness is only in the normal.
    return intersect(triangle.triangle, ray, range);
    //< 1.5
}

Vec3 normal(const SmoothTriangle& triangle, const Vec3& point, const Root& root) {
    //> 1.5 The true normal: that of the flat triangle.
    return normal(triangle.triangle, point, root);
    //< 1.5
}

//> hidden
namespace {

/// Linear in the weights of b and c; where opposite normals cancel, the first one.
Vec3 interpolate(const Vec3& a, const Vec3& b, const Vec3& c, const Vec2& weights) {
    const Vec3 n = (1 - weights.x - weights.y) * a + weights.x * b + weights.y * c;
    return dot(n, n) > 0 ? n : a;
}

}  // namespace
//< hidden

Vec3 shading_normal(const SmoothTriangle& triangle, const Root& root) {
    //> 1.5 Interpolate the normals of the corners with the weights of the root.
    return interpolate(triangle.normal_a, triangle.normal_b, triangle.normal_c, root.uv);
    //< 1.5
}

bool back_facing(const Vec3& outward_normal, const Vec3& direction) {
    //> 1.14 Does the outward normal point the same way as the ray?
    return dot(outward_normal, direction) > 0;
    //< 1.14
}

//> hidden
namespace {

/// Corners at the same place are one: the number of the first of them, for each.
std::vector<std::uint32_t> welded(std::span<const Vec3> positions) {
    const auto hash = [](const Vec3& p) {
        const std::hash<Real> h;
        return (h(p.x + 0) * 0x9e3779b97f4a7c15ull + h(p.y + 0)) * 0x9e3779b97f4a7c15ull + h(p.z + 0);  // -0 + 0 is +0
    };
    std::unordered_map<Vec3, std::uint32_t, decltype(hash)> first(positions.size(), hash);
    std::vector<std::uint32_t> result(positions.size());
    for (std::uint32_t i = 0; i < positions.size(); ++i) result[i] = first.try_emplace(positions[i], i).first->second;
    return result;
}

/// Every edge occurs once in each direction: the mesh is closed, and neighbours agree on what is outside.
bool is_closed(const Mesh& mesh, const std::vector<std::uint32_t>& corner) {
    std::vector<std::uint64_t> forth, back;
    for (const Mesh::Face& face : mesh.faces) {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint64_t from = corner[face.position[i]], to = corner[face.position[(i + 1) % 3]];
            if (from == to) return false;
            forth.push_back(from << 32 | to);
            back.push_back(to << 32 | from);
        }
    }
    std::sort(forth.begin(), forth.end());
    std::sort(back.begin(), back.end());
    return forth == back && std::adjacent_find(forth.begin(), forth.end()) == forth.end();
}

/// Sets of corners that faces connect.
class Components {
public:
    explicit Components(std::size_t count) : parent_(count) {
        for (std::uint32_t i = 0; i < count; ++i) parent_[i] = i;
    }
    std::uint32_t find(std::uint32_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(std::uint32_t i, std::uint32_t j) { parent_[find(i)] = find(j); }

private:
    std::vector<std::uint32_t> parent_;
};

/// The sign of the volume, if all parts of a closed mesh agree on it; else 0, as for a cave inside of a solid.
int common_sign_of_volume(const Mesh& mesh, const std::vector<std::uint32_t>& corner) {
    Components parts(mesh.positions.size());
    for (const Mesh::Face& face : mesh.faces) {
        parts.join(corner[face.position[0]], corner[face.position[1]]);
        parts.join(corner[face.position[0]], corner[face.position[2]]);
    }
    std::unordered_map<std::uint32_t, Real> volume;
    for (const Mesh::Face& face : mesh.faces) {
        const auto [a, b, c] = face.position;
        const Vec3& o = mesh.bound.center;
        volume[parts.find(corner[a])] +=
            dot(mesh.positions[a] - o, cross(mesh.positions[b] - o, mesh.positions[c] - o));
    }
    const auto all = [&](auto test) {
        return std::all_of(volume.begin(), volume.end(), [&](const auto& part) { return test(part.second); });
    };
    return all([](Real v) { return v > 0; }) ? 1 : all([](Real v) { return v < 0; }) ? -1 : 0;
}

bool contains(const BoundingSphere& bound, const Vec3& point) {
    const Vec3 d = point - bound.center;
    return !(dot(d, d) > bound.radius * bound.radius);
}

}  // namespace
//< hidden

void prepare(Mesh& mesh) {
    //> 1.14 void The bounding sphere, and outward_winding. A mesh is closed when every edge occurs once in each
    //>   direction; then the sign of its volume, the sum of a . (b x c) / 6, tells whether it winds outwards.
    //>   Zero is always right, only slower.
    mesh.bound = bounding_sphere(mesh.positions);
    mesh.outward_winding = 0;
    if (mesh.faces.empty() || mesh.faces.size() % 2 != 0) return;  // 3 faces = 2 edges: closed meshes are even
    const auto corner = welded(mesh.positions);
    if (is_closed(mesh, corner)) mesh.outward_winding = common_sign_of_volume(mesh, corner);
    //< 1.14
}

std::optional<Root> intersect(const Mesh& mesh, const Ray& ray, Interval range) {
    //> 1.14 The nearest of all faces. Skip back faces of a closed mesh when the range begins outside of its bound:
    //>   a ray that comes from outside enters before it leaves. Not so for a range that begins inside.
    if (misses(mesh.bound, ray, range)) return std::nullopt;
    const bool cull = mesh.outward_winding != 0 && !contains(mesh.bound, ray.at(range.min));
    const Vec3 outwards_direction = Real(mesh.outward_winding) * ray.direction;
    const ShearedSpace space(ray);
    std::optional<Root> nearest;
    for (std::uint32_t i = 0; i < mesh.faces.size(); ++i) {
        const auto [ia, ib, ic] = mesh.faces[i].position;
        const Vec3 &a = mesh.positions[ia], &b = mesh.positions[ib], &c = mesh.positions[ic];
        if (cull && back_facing(cross(b - a, c - a), outwards_direction)) continue;
        if (auto root = intersect_sheared(space.from_world(a), space.from_world(b), space.from_world(c), range)) {
            root->part = i;
            range.max = root->t;
            nearest = root;
        }
    }
    return nearest;
    //< 1.14
}

std::optional<Root> intersect(const Mesh& mesh, std::uint32_t face, const Ray& ray, Interval range) {
    //> 1.14 The face as a triangle of its own; Root::part is its number. Culled as in the mesh: structures of step 4
    //>   ask face by face and must find the same.
    const auto [ia, ib, ic] = mesh.faces[face].position;
    const Vec3 &a = mesh.positions[ia], &b = mesh.positions[ib], &c = mesh.positions[ic];
    std::optional<Root> root = intersect(a, b, c, ray, range);
    if (!root) return root;
    if (mesh.outward_winding != 0 && back_facing(cross(b - a, c - a), Real(mesh.outward_winding) * ray.direction) &&
        !contains(mesh.bound, ray.at(range.min)))
        root.reset();
    else
        root->part = face;
    return root;
    //< 1.14
}

Vec3 normal(const Mesh& mesh, const Vec3&, const Root& root) {
    //> 1.14 That of the face.
    const auto [a, b, c] = mesh.faces[root.part].position;
    return cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
    //< 1.14
}

Vec3 shading_normal(const Mesh& mesh, const Root& root) {
    //> 1.14 As for a smooth triangle when the face is smooth, else the normal of the face.
    const Mesh::Face& face = mesh.faces[root.part];
    if (!face.smooth) return normal(mesh, Vec3(0), root);
    const auto [a, b, c] = face.normal;
    return interpolate(mesh.normals[a], mesh.normals[b], mesh.normals[c], root.uv);
    //< 1.14
}

}  // namespace rays
