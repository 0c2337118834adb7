// The same surface in two descriptions gives the same hits.
#include <gtest/gtest.h>

#include "1_ray_casting/ray_casting.h"
#include "aim.h"

namespace rays {
namespace {

constexpr Real kEpsilon = std::numeric_limits<Real>::epsilon();

/// Equal hits and misses, t alike. Where only one of the two hits, the ray must graze: `grazes` says whether it may.
template <class First, class Second, class Grazes>
void expect_same(const First& a, const Second& b, const Ray& ray, Real tolerance, Grazes grazes, int& hits) {
    const auto on_a = intersect(a, ray, {0, kInfinity}), on_b = intersect(b, ray, {0, kInfinity});
    if (on_a.has_value() != on_b.has_value()) {
        EXPECT_TRUE(grazes(ray)) << "only " << (on_a ? "the first" : "the second") << " is hit";
        return;
    }
    if (!on_a) return;
    ++hits;
    EXPECT_NEAR(on_a->t, on_b->t, tolerance * (1 + on_b->t)) << "origin " << ray.origin.x << ' ' << ray.origin.y;
    const Vec3 na = glm::normalize(normal(a, ray.at(on_a->t), *on_a));
    const Vec3 nb = glm::normalize(normal(b, ray.at(on_b->t), *on_b));
    EXPECT_GT(std::abs(glm::dot(na, nb)), 1 - tolerance) << "normals differ";
}

Quadric sphere_as_quadric(const Sphere& s) {
    Quadric q;
    q.q = Mat4(1);
    for (int i = 0; i < 3; ++i) q.q[3][i] = q.q[i][3] = -s.center[i];
    q.q[3][3] = glm::dot(s.center, s.center) - s.radius * s.radius;
    return q;
}

TEST(Identities, SphereIsAQuadric) {
    test::Aim aim(1);
    int hits = 0;
    for (int i = 0; i < 50'000; ++i) {
        const Sphere sphere{aim.in_cube(2), aim.uniform(0.2, 2)};
        const Ray ray = aim.through(sphere.center + Real(1.1) * sphere.radius * aim.direction(), aim.uniform(0, 9));
        // Near the silhouette t is off by the square root of the rounding: leave out impact parameters within 1e-3 of
        // r.
        const Vec3 oc = sphere.center - ray.origin, d = glm::normalize(ray.direction);
        const Real h = glm::length(oc - glm::dot(oc, d) * d);
        if (std::abs(h - sphere.radius) < Real(1e-3) * sphere.radius) continue;
        const Real to_surface = std::abs(glm::length(oc) - sphere.radius);
        if (to_surface < Real(1e-3)) continue;  // the root at the origin itself may fall on either side of 0
        expect_same(
            sphere, sphere_as_quadric(sphere), ray, 4096 * kEpsilon / Real(1e-2), [](auto&) { return false; }, hits);
    }
    EXPECT_GT(hits, 20'000);
}

TEST(Identities, SaddleAsQuadricAndAsPatch) {
    // z = x y over the unit square: bilinear, so its bicubic control points lie on it in a regular grid.
    BicubicPatch patch;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            patch.control[std::size_t(4 * i + j)] = Vec3(i / Real(3), j / Real(3), i * j / Real(9));
    prepare(patch);
    Quadric quadric;  // 2 (x y - z) = 0
    quadric.q[0][1] = quadric.q[1][0] = 1;
    quadric.q[2][3] = quadric.q[3][2] = -1;
    constexpr Real kStep = Real(4e5) * kEpsilon;  // four times what the roots may differ by
    test::Aim aim(2);
    int hits = 0, through_twice = 0;
    for (int i = 0; i < 50'000; ++i) {
        const Vec3 at(aim.uniform(-0.2, 1.2), aim.uniform(-0.2, 1.2), 0);
        const Ray ray = aim.through(at + Vec3(0, 0, at.x * at.y), aim.uniform(0.5, 5));
        // All roots of the quadric, those over the square: what the patch must find, in order.
        Interval rest{0, kInfinity};
        std::vector<Real> expected;
        bool near_edge = false;
        for (auto root = intersect(quadric, ray, rest); root; root = intersect(quadric, ray, rest)) {
            const Vec3 p = ray.at(root->t);
            const auto edge = [](Real x) { return std::abs(x) < Real(1e-4) || std::abs(x - 1) < Real(1e-4); };
            near_edge |= edge(p.x) || edge(p.y);
            if (p.x > 0 && p.x < 1 && p.y > 0 && p.y < 1) expected.push_back(root->t);
            rest.min = root->t * (1 + 4 * kEpsilon) + 4 * kEpsilon;
        }
        if (near_edge ||
            (expected.size() == 2 && expected[1] - expected[0] < Real(1e-3) * expected[1] + kStep * (1 + expected[1])))
            continue;
        rest = {0, kInfinity};
        for (const Real t : expected) {
            const auto root = intersect(patch, ray, rest);
            ASSERT_TRUE(root) << "ray " << i << ": a root of the quadric is missing on the patch, t = " << t;
            EXPECT_NEAR(root->t, t, 1e5 * kEpsilon * (1 + t));
            const Vec3 p = ray.at(root->t);
            EXPECT_NEAR(root->uv.x, p.x, 1e5 * kEpsilon * (1 + t));
            EXPECT_NEAR(root->uv.y, p.y, 1e5 * kEpsilon * (1 + t));
            rest.min = root->t + kStep / 4 * (1 + root->t);
            ++hits;
        }
        EXPECT_FALSE(intersect(patch, ray, rest)) << "ray " << i << ": the patch has a root more than the quadric";
        through_twice += expected.size() == 2;
    }
    EXPECT_GT(hits, 20'000);
    EXPECT_GT(through_twice, 50);
}

TEST(Identities, FlatPatchIsAPolygon) {
    const Vec3 a(0, 0, 1), u(2, 0, Real(0.5)), v(Real(0.3), 1, 0);
    BicubicPatch patch;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) patch.control[std::size_t(4 * i + j)] = a + i / Real(3) * u + j / Real(3) * v;
    Polygon polygon;
    polygon.points = {a, a + u, a + u + v, a + v};
    polygon.contour_ends = {4};
    prepare(patch);
    prepare(polygon);
    test::Aim aim(3);
    int hits = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Real s = aim.uniform(-0.2, 1.2), t = aim.uniform(-0.2, 1.2);
        const Ray ray = aim.through(a + s * u + t * v, 4);
        const Vec3 n = glm::normalize(glm::cross(u, v));
        if (std::abs(glm::dot(n, glm::normalize(ray.direction))) < Real(1e-2)) continue;
        const auto near_edge = [&](auto&) {
            return std::min({std::abs(s), std::abs(1 - s), std::abs(t), std::abs(1 - t)}) <
                   1000 * std::sqrt(kEpsilon) / 16;
        };
        expect_same(patch, polygon, ray, Real(1e6) * kEpsilon, near_edge, hits);
    }
    EXPECT_GT(hits, 8'000);
}

TEST(Identities, PolygonIsItsTriangulation) {
    // An L with a square hole, in a tilted plane, and the same from 12 triangles.
    const Vec3 o(1, 2, 3), e(Real(0.8), Real(0.6), 0), f(Real(-0.36), Real(0.48), Real(0.8));
    const auto at = [&](double x, double y) { return o + Real(x) * e + Real(y) * f; };
    Polygon polygon;
    polygon.points = {at(0, 0), at(4, 0),     at(4, 2),     at(2, 2),     at(2, 4),
                      at(0, 4), at(0.5, 0.5), at(1.5, 0.5), at(1.5, 1.5), at(0.5, 1.5)};
    polygon.contour_ends = {6, 10};
    prepare(polygon);
    std::vector<Triangle> triangles;
    const auto rectangle = [&](double x0, double y0, double x1, double y1) {
        triangles.push_back({at(x0, y0), at(x1, y0), at(x1, y1)});
        triangles.push_back({at(x0, y0), at(x1, y1), at(x0, y1)});
    };
    rectangle(0, 0, 2, 0.5), rectangle(0, 1.5, 2, 2), rectangle(0, 0.5, 0.5, 1.5), rectangle(1.5, 0.5, 2, 1.5);
    rectangle(2, 0, 4, 2), rectangle(0, 2, 2, 4);
    test::Aim aim(4);
    int hits = 0;
    for (int i = 0; i < 50'000; ++i) {
        const Ray ray = aim.through(at(aim.uniform(-0.5, 4.5), aim.uniform(-0.5, 4.5)), 5);
        const auto on_polygon = intersect(polygon, ray, {0, kInfinity});
        std::optional<Root> on_triangles;
        for (const Triangle& t : triangles)
            if (const auto root = intersect(t, ray, {0, kInfinity})) on_triangles = root;
        ASSERT_EQ(on_polygon.has_value(), on_triangles.has_value()) << "ray " << i;
        if (!on_polygon) continue;
        ++hits;
        const Real slope = std::abs(glm::dot(polygon.plane.normal, glm::normalize(ray.direction)));
        EXPECT_NEAR(on_polygon->t, on_triangles->t, 64 * kEpsilon * on_polygon->t / slope);
    }
    EXPECT_GT(hits, 15'000);
}

TEST(Identities, ThinConeIsACylinderAndBoxIsSixPolygons) {
    test::Aim aim(6);
    const Vec3 base(1, 0, 0), cap(1, 3, 1);
    const Cone cylinder{base, 1, cap, 1, false}, almost{base, 1, cap, 1 + 64 * kEpsilon, false};
    int hits = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Ray ray = aim.through(Vec3(1, Real(1.5), Real(0.5)) + aim.in_cube(1.5), 6);
        const auto a = intersect(cylinder, ray, {0, kInfinity}), b = intersect(almost, ray, {0, kInfinity});
        if (!a || !b) continue;  // silhouettes differ in the last digits
        ++hits;
        EXPECT_NEAR(a->t, b->t, std::sqrt(64 * kEpsilon) * a->t);
    }
    EXPECT_GT(hits, 5'000);

    const Box box{Vec3(-1, -2, -3), Vec3(1, Real(0.5), 2)};
    for (int i = 0; i < 20'000; ++i) {
        const Ray ray = aim.through(aim.in_cube(2.5), 9);
        const auto root = intersect(box, ray, {0, kInfinity});
        std::optional<Real> nearest;
        for (int axis = 0; axis < 3; ++axis) {
            for (const Real at : {box.min[axis], box.max[axis]}) {
                const Real t = (at - ray.origin[axis]) / ray.direction[axis];
                const Vec3 p = ray.at(t);
                const int j = (axis + 1) % 3, k = (axis + 2) % 3;
                const bool on_face =
                    p[j] >= box.min[j] && p[j] <= box.max[j] && p[k] >= box.min[k] && p[k] <= box.max[k];
                if (t > 0 && on_face && (!nearest || t < *nearest)) nearest = t;
            }
        }
        ASSERT_EQ(root.has_value(), nearest.has_value()) << "ray " << i;
        if (root) {
            EXPECT_NEAR(root->t, *nearest, 16 * kEpsilon * root->t);
        }
    }
}

}  // namespace
}  // namespace rays
