#include "bodies.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <random>

#include "1_ray_casting/ray_casting.h"

namespace rays::bench {
namespace {

double unit(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

/// Uniform on the sphere.
Vec3 direction(std::mt19937_64& random) {
    const double z = 2 * unit(random) - 1, angle = 2 * kPi * unit(random), r = std::sqrt(1 - z * z);
    return Vec3(glm::dvec3(r * std::cos(angle), r * std::sin(angle), z));
}

Vec3 in_cube(std::mt19937_64& random) {
    const double x = unit(random), y = unit(random);
    return Vec3(glm::dvec3(x - 0.5, y - 0.5, unit(random) - 0.5));
}

Bodies in_a_cube(const char* kind, std::size_t count) {
    Bodies bodies;
    bodies.name = fmt::format("{}/{}", kind, count);
    bodies.count = count;
    bodies.eye = Vec3(Real(0.9), Real(0.8), Real(-2));
    bodies.angle_deg = 36;
    bodies.scene.materials.emplace_back();
    return bodies;
}

void add_as_one_object(Scene& scene, Mesh mesh) {
    prepare(mesh);
    scene.meshes.push_back(std::move(mesh));
    Object object;
    object.kind = ShapeKind::mesh;
    scene.objects.push_back(object);
}

void add_triangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    Mesh::Face face;
    face.position = {a, b, c};
    mesh.faces.push_back(face);
}

/// A ball of 28 meridians and 19 parallels, its poles included: 2 * 28 * 18 triangles.
void add_ball(Mesh& mesh, const Vec3& center, Real radius) {
    constexpr std::uint32_t kMeridians = 28, kParallels = 19;
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (std::uint32_t i = 0; i < kMeridians; ++i) {
        for (std::uint32_t j = 0; j <= kParallels; ++j) {
            const Real around = 2 * kPi * Real(i) / kMeridians, down = kPi * Real(j) / kParallels;
            const Vec3 out(std::sin(down) * std::cos(around), std::cos(down), std::sin(down) * std::sin(around));
            mesh.positions.push_back(in_float(center + radius * out));
        }
    }
    const auto at = [&](std::uint32_t i, std::uint32_t j) { return first + i % kMeridians * (kParallels + 1) + j; };
    for (std::uint32_t i = 0; i < kMeridians; ++i) {
        for (std::uint32_t j = 0; j < kParallels; ++j) {
            if (j + 1 < kParallels) add_triangle(mesh, at(i, j), at(i, j + 1), at(i + 1, j + 1));
            if (j > 0) add_triangle(mesh, at(i, j), at(i + 1, j + 1), at(i + 1, j));
        }
    }
}

/// Nine smaller flakes on a sphere: six around its equator, three above. `axes` are those of its own space.
void add_flake(Mesh& mesh, const Vec3& center, const Mat3& axes, Real radius, int generation) {
    add_ball(mesh, center, radius);
    if (generation == 0) return;
    for (int k = 0; k < 9; ++k) {
        const Real around = glm::radians(Real(k < 6 ? 60 * k : 120 * (k - 6) + 30));
        const Real down = glm::radians(Real(k < 6 ? 90 : 35));
        const Vec3 out = std::sin(down) * std::sin(around) * axes[0] + std::cos(down) * axes[1] +
                         std::sin(down) * std::cos(around) * axes[2];
        const Vec3 side = std::cos(around) * axes[0] - std::sin(around) * axes[2];
        add_flake(mesh, center + Real(4) / 3 * radius * out, Mat3(side, out, glm::cross(side, out)), radius / 3,
                  generation - 1);
    }
}

}  // namespace

Bodies random_spheres(std::size_t count) {
    Bodies bodies = in_a_cube("spheres", count);
    std::mt19937_64 random(count);
    // count * pi r^2 = 1
    const auto radius = static_cast<float>(std::sqrt(1 / (kPi * static_cast<Real>(count))));
    for (std::uint32_t i = 0; i < count; ++i) {
        bodies.scene.spheres.push_back({in_float(in_cube(random)), Real(radius)});
        Object object;
        object.shape = i;
        bodies.scene.objects.push_back(object);
    }
    return bodies;
}

Bodies random_triangles(std::size_t count) {
    Bodies bodies = in_a_cube("triangles", count);
    std::mt19937_64 random(count);
    // With a circle of radius r around it a triangle is 3 sqrt(3)/4 r^2 large, and seen half as large on average.
    const Real radius = std::sqrt(8 / (3 * std::sqrt(Real(3)) * static_cast<Real>(count)));
    Mesh mesh;
    for (std::uint32_t i = 0; i < count; ++i) {
        const Vec3 center = in_cube(random), x = direction(random);
        const Vec3 y = glm::normalize(glm::cross(x, direction(random)));
        for (const Real angle : {Real(0), 2 * kPi / 3, 4 * kPi / 3})
            mesh.positions.push_back(in_float(center + radius * (std::cos(angle) * x + std::sin(angle) * y)));
        add_triangle(mesh, 3 * i, 3 * i + 1, 3 * i + 2);
    }
    add_as_one_object(bodies.scene, std::move(mesh));
    return bodies;
}

Bodies tessellated_flake() {
    Bodies bodies;
    bodies.name = "flake";
    bodies.eye = Vec3(Real(2.2), Real(1.8), Real(-4.6));
    bodies.look_at = Vec3(0, Real(0.05), 0);
    bodies.angle_deg = 36;
    bodies.scene.materials.emplace_back();
    Mesh mesh;
    add_flake(mesh, Vec3(0), Mat3(1), 1, 3);
    bodies.count = mesh.faces.size();
    add_as_one_object(bodies.scene, std::move(mesh));
    return bodies;
}

}  // namespace rays::bench
