// Every primitive of step 1, from ten sizes away, as the solution does it.
#include <cmath>

#include "1_ray_casting/ray_casting.h"
#include "subject.h"
#include "truth.h"

namespace rays::bench {
namespace {

constexpr std::size_t kRays = 512;  ///< with their answers they stay in the first caches
constexpr double kSizesAway = 10;

template <class Shape>
void add_primitive(const std::string& name, const Shape& shape, double size,
                   std::function<Exact(const ExactVec&, const Root&)> off_surface, const ExactRoot& truth = {}) {
    const auto target = std::make_shared<const Target>(
        Target{size, rays_around(size, kSizesAway, kRays, truth), std::move(off_surface), truth});
    add_subject("primitive/" + name, "solution, from 10 sizes away", target,
                [shape](const Ray& ray) { return intersect(shape, ray, {}); });
}

/// Distance to the plane through a point; the normal may have any length.
Exact off_plane(const ExactVec& p, const ExactVec& on_plane, const ExactVec& normal) {
    return std::abs(glm::dot(p - on_plane, normal)) / glm::length(normal);
}

/// A star in the plane x + y + z = 1/4 with a hole: sixty-fourths, so that float's corners lie in the plane as well.
Polygon star_with_a_hole() {
    Polygon polygon;
    const auto add = [&](double radius, double angle) {
        const auto grid = [](double x) { return std::round(64 * x) / 64; };
        const double x = grid(radius * std::cos(angle)), y = grid(radius * std::sin(angle));
        polygon.points.push_back(Vec3(glm::dvec3(x, y, 0.25 - x - y)));
    };
    for (int i = 0; i < 14; ++i) add(i % 2 == 0 ? 0.6 : 0.4, 0.3 + i * 0.4487989505);
    polygon.contour_ends.push_back(14);
    for (int i = 0; i < 6; ++i) add(0.15, i * 1.0471975512);
    polygon.contour_ends.push_back(20);
    prepare(polygon);
    return polygon;
}

Exact off_cone(const Cone& cone, const ExactVec& p, const Root& root) {
    const ExactVec base(cone.base), axis = ExactVec(cone.cap) - base;
    if (root.part == 1) return off_plane(p, base, axis);
    if (root.part == 2) return off_plane(p, ExactVec(cone.cap), axis);
    const Exact height2 = glm::dot(axis, axis), s = glm::dot(p - base, axis) / height2;
    const Exact slope = Exact(cone.cap_radius) - cone.base_radius;
    const Exact across = glm::length(p - base - s * axis) - (cone.base_radius + slope * s);
    return std::abs(across) / std::sqrt(1 + slope * slope / height2);
}

Exact off_quadric(const Quadric& quadric, const ExactVec& p) {
    const glm::vec<4, Exact> point(p, 1), qp = glm::mat<4, 4, Exact>(quadric.q) * point;
    return std::abs(glm::dot(point, qp)) / (2 * glm::length(ExactVec(qp)));
}

void add_flat_shapes() {
    const Plane plane{glm::normalize(Vec3(Real(0.3), Real(1), Real(-0.2))), Real(0.1)};
    add_primitive("plane", plane, 1, [plane](const ExactVec& p, const Root&) {
        const ExactVec n(plane.normal);
        return std::abs(glm::dot(n, p) - Exact(plane.offset)) / glm::length(n);
    });
    const Triangle triangle{
        {Real(-0.8), Real(-0.5), Real(0.1)}, {Real(0.9), Real(-0.4), Real(-0.1)}, {Real(0.1), Real(0.9), Real(0.3)}};
    add_primitive("triangle", triangle, 1, [triangle](const ExactVec& p, const Root&) {
        const ExactVec a(triangle.a);
        return off_plane(p, a, glm::cross(ExactVec(triangle.b) - a, ExactVec(triangle.c) - a));
    });
    add_primitive("polygon", star_with_a_hole(), 1, [](const ExactVec& p, const Root&) {
        return off_plane(p, ExactVec(0, 0, 0.25L), ExactVec(1, 1, 1));
    });
    const Box box{Vec3(Real(-0.6), Real(-0.5), Real(-0.4)), Vec3(Real(0.5), Real(0.6), Real(0.7))};
    add_primitive("box", box, 1, [box](const ExactVec& p, const Root& root) {
        const int axis = static_cast<int>(root.part / 2);
        return std::abs(p[axis] - Exact(root.part % 2 == 0 ? box.min[axis] : box.max[axis]));
    });
    const Disc disc{Vec3(Real(0.1), 0, Real(-0.1)), glm::normalize(Vec3(Real(0.2), Real(1), Real(0.4))), Real(0.9),
                    Real(0.3)};
    add_primitive("disc", disc, 1, [disc](const ExactVec& p, const Root&) {
        return off_plane(p, ExactVec(disc.center), ExactVec(disc.normal));
    });
}

void add_round_shapes() {
    const Sphere sphere{Vec3(Real(0.05), Real(-0.03), Real(0.02)), Real(0.95)};
    add_primitive(
        "sphere", sphere, 1,
        [sphere](const ExactVec& p, const Root&) {
            return std::abs(glm::length(p - ExactVec(sphere.center)) - Exact(sphere.radius));
        },
        truth_of(sphere));
    const Vec3 base(Real(-0.2), Real(-0.7), Real(0.1)), cap(Real(0.2), Real(0.6), Real(-0.1));
    const Cone cylinder{base, Real(0.5), cap, Real(0.5), false}, cone{base, Real(0.6), cap, Real(0.1), false};
    for (const auto& [name, shape] : {std::pair{"cylinder", cylinder}, std::pair{"cone", cone}})
        add_primitive(name, shape, 1,
                      [shape = shape](const ExactVec& p, const Root& root) { return off_cone(shape, p, root); });

    Quadric ellipsoid;  // x^2 + 2 y^2 + 3 z^2 + x y / 2 = 0.9
    ellipsoid.q[0][0] = 1, ellipsoid.q[1][1] = 2, ellipsoid.q[2][2] = 3, ellipsoid.q[3][3] = Real(-0.9);
    ellipsoid.q[0][1] = ellipsoid.q[1][0] = Real(0.25);
    add_primitive(
        "quadric", ellipsoid, 1, [ellipsoid](const ExactVec& p, const Root&) { return off_quadric(ellipsoid, p); },
        truth_of(ellipsoid));
    const Torus torus{Real(0.75), Real(0.25)};
    add_primitive(
        "torus", torus, 1,
        [torus](const ExactVec& p, const Root&) {
            return std::abs(std::hypot(std::hypot(p.x, p.z) - torus.major, p.y) - torus.minor);
        },
        truth_of(torus));
}

}  // namespace

BicubicPatch wavy_patch() {
    BicubicPatch patch;
    const double heights[16] = {0.0, 0.5, -0.6, 0.1, 0.4, -0.8, 0.9, -0.2, -0.5, 0.7, -0.7, 0.5, 0.2, -0.4, 0.3, 0.0};
    for (std::size_t i = 0; i < 16; ++i)
        patch.control[i] = Vec3(
            glm::dvec3(-0.6 + 0.4 * static_cast<double>(i / 4), heights[i], -0.6 + 0.4 * static_cast<double>(i % 4)));
    prepare(patch);
    return patch;
}

void add_primitives() {
    add_flat_shapes();
    add_round_shapes();
    const BicubicPatch patch = wavy_patch();
    add_primitive("patch", patch, 1, {}, truth_of(patch));
}

}  // namespace rays::bench
