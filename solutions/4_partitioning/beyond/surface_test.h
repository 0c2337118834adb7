// Does the surface of a primitive come near a cell? Bounds say so too often.
#pragma once

#include <algorithm>

#include "4_partitioning/primitive_tester.h"

namespace rays::octree {

/// Does the surface come near the cell, as far as one can tell quickly? Bounds say too often that it does: of a sphere
/// around the cell, and of a slanted triangle.
class SurfaceTest {
public:
    SurfaceTest(const PrimitiveTester& tester, Real slack) : tester_(tester), slack_(slack) {}

    /// `thorough`: with all planes, worth its time where the cell is about as large as the primitive.
    bool reaches(std::uint32_t primitive, const Bounds& cell, bool thorough) const {
        const Scene& scene = tester_.scene();
        const Primitive p = tester_.primitive(primitive);
        const Object& object = scene.objects[p.object];
        const bool moved = object.transform != kNone;
        const Vec3 center = Real(0.5) * (cell.min + cell.max), half = Real(0.5) * (cell.max - cell.min) + slack_;
        switch (object.kind) {
            case ShapeKind::sphere: return moved || reaches(scene.spheres[object.shape], center, half);
            case ShapeKind::triangle: return moved || reaches(scene.triangles[object.shape], center, half, thorough);
            case ShapeKind::smooth_triangle:
                return moved || reaches(scene.smooth_triangles[object.shape].triangle, center, half, thorough);
            case ShapeKind::mesh:
                return moved || reaches(face(scene.meshes[object.shape], p.part), center, half, thorough);
            default: return true;
        }
    }

private:
    static Triangle face(const Mesh& mesh, std::uint32_t part) {
        const auto [a, b, c] = mesh.faces[part].position;
        return {mesh.positions[a], mesh.positions[b], mesh.positions[c]};
    }

    /// Between the nearest and the farthest point of the cell there is one at the distance of the radius.
    bool reaches(const Sphere& sphere, const Vec3& center, const Vec3& half) const {
        const Vec3 away = glm::abs(center - sphere.center);
        const Vec3 nearest = glm::max(away - half, Vec3(0)), farthest = away + half;
        return glm::length(nearest) <= sphere.radius + slack_ && glm::length(farthest) >= sphere.radius - slack_;
    }

    /// No plane parts triangle and cell: neither the triangle's own nor one along an edge of each (Akenine-Moller,
    /// "Fast 3D Triangle-Box Overlap Testing", JGT 6(1), 2001; the cell's own planes have been asked by the bounds).
    bool reaches(const Triangle& t, const Vec3& center, const Vec3& half, bool thorough) const {
        const Vec3 a = t.a - center, b = t.b - center, c = t.c - center;
        if (parted(glm::cross(b - a, c - a), a, a, a, half)) return false;
        if (!thorough) return true;
        for (const Vec3& edge : {b - a, c - b, a - c})
            if (parted({0, -edge.z, edge.y}, a, b, c, half) || parted({edge.z, 0, -edge.x}, a, b, c, half) ||
                parted({-edge.y, edge.x, 0}, a, b, c, half))
                return false;
        return true;
    }
    bool parted(const Vec3& axis, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& half) const {
        const Vec3 size = glm::abs(axis);
        const Real reach = glm::dot(size, half) + slack_ * (size.x + size.y + size.z);
        const Real u = glm::dot(axis, a), v = glm::dot(axis, b), w = glm::dot(axis, c);
        return std::min({u, v, w}) > reach || std::max({u, v, w}) < -reach;
    }

    const PrimitiveTester& tester_;
    Real slack_;
};

}  // namespace rays::octree
