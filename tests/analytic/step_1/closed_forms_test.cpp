// Known answers: silhouettes, chords, parity of crossings.
#include <gtest/gtest.h>

#include "1_ray_casting/ray_casting.h"
#include "aim.h"
#include "tessellation.h"

namespace rays {
namespace {

constexpr Real kEpsilon = std::numeric_limits<Real>::epsilon();

/// Number of sign changes (hit or miss) along a row of film points, located by bisection.
TEST(ClosedForms, SilhouetteOfASphereOnTheAxisIsACircle) {
    // Its radius on a film at distance f is f r / sqrt(d^2 - r^2), and not f r / d.
    const Real f = Real(1.7), d = 5, r = 2;
    const Sphere sphere{Vec3(0, 0, d), r};
    const Real expected = f * r / std::sqrt(d * d - r * r);
    for (int k = 0; k < 16; ++k) {
        const Vec3 across(std::cos(k * kPi / 8), std::sin(k * kPi / 8), 0);
        Real hit = 0, miss = 2 * expected;
        for (int i = 0; i < 60; ++i) {
            const Real middle = (hit + miss) / 2;
            (intersect(sphere, Ray{Vec3(0), Vec3(0, 0, f) + middle * across}, {0, kInfinity}) ? hit : miss) = middle;
        }
        EXPECT_NEAR(hit, expected, 16 * kEpsilon) << "direction " << k << " of 16; f r / d would be " << f * r / d;
    }
}

TEST(ClosedForms, ChordsOfASphereDoNotDependOnTheSideTheyAreSeenFrom) {
    test::Aim aim(1);
    for (int i = 0; i < 10'000; ++i) {
        const Sphere sphere{aim.in_cube(3), aim.uniform(0.1, 2)};
        const Vec3 d = aim.direction();
        const Real h = sphere.radius * aim.uniform(0, 0.999);
        const Vec3 side = glm::normalize(glm::cross(d, std::abs(d.x) < Real(0.5) ? Vec3(1, 0, 0) : Vec3(0, 1, 0)));
        const Vec3 middle = sphere.center + h * side;
        const Real chord = 2 * std::sqrt((sphere.radius - h) * (sphere.radius + h));
        const auto length = [&](const Vec3& direction) {
            const Ray ray{middle - Real(4) * direction, direction};
            const auto in = intersect(sphere, ray, {0, kInfinity});
            const auto out = in ? intersect(sphere, ray, {in->t + chord / 2, kInfinity}) : in;
            return out ? out->t - in->t : Real(-1);
        };
        // The middle of the chord is off by a few eps * 4; its length by that times h / half chord <= 22.
        EXPECT_NEAR(length(d), chord, 1000 * kEpsilon);
        EXPECT_NEAR(length(-d), chord, 1000 * kEpsilon);
    }
}

constexpr Real kPastARoot = Real(1e4) * kEpsilon;

/// How many roots a ray from outside has.
template <class Shape>
int crossings(const Shape& shape, const Ray& ray) {
    int count = 0;
    Interval rest{0, kInfinity};
    while (const auto root = intersect(shape, ray, rest)) {
        ++count;
        rest.min = root->t * (1 + kPastARoot);
        if (count > 100) break;
    }
    return count;
}

/// Does the ray meet the torus at less than 1e-2 from a tangent? The place of a root is uncertain by a few eps * 20 /
/// 1e-2, and `crossings` steps over 1e4 eps; the two roots of a chord lie at least 1e-2 apart.
bool grazes(const Torus& torus, const Ray& ray) {
    Interval rest{0, kInfinity};
    while (const auto root = intersect(torus, ray, rest)) {
        const Vec3 n = glm::normalize(normal(torus, ray.at(root->t), *root));
        if (std::abs(glm::dot(n, glm::normalize(ray.direction))) < Real(1e-2)) return true;
        rest.min = root->t * (1 + kPastARoot);
    }
    return false;
}

TEST(ClosedForms, RaysLeaveClosedSolidsAsOftenAsTheyEnter) {
    if (sizeof(Real) == sizeof(float))
        GTEST_SKIP() << "stepping over the rounding of a root steps over thin chords as well";
    test::Aim aim(2);
    const Torus torus{2, Real(0.5)};
    const Cone frustum{Vec3(0, -1, 0), Real(1.5), Vec3(0, 1, 0), Real(0.5), false},
        tip{Vec3(0), 1, Vec3(0, 2, 0), 0, false};
    const Box box{Vec3(-1, -2, -1), Vec3(2, 1, 1)};
    std::array<int, 5> of_torus{};
    for (int i = 0; i < 50'000; ++i) {
        const Ray ray = aim.through(aim.in_cube(2.4), 20);
        EXPECT_EQ(crossings(box, ray) % 2, 0) << "box, ray " << i;
        EXPECT_EQ(crossings(frustum, ray) % 2, 0) << "frustum, ray " << i;
        EXPECT_EQ(crossings(tip, ray) % 2, 0) << "cone, ray " << i;
        if (grazes(torus, ray))
            continue;  // two roots as close as their rounding: one may be found again, or both missed
        const int on_torus = crossings(torus, ray);
        ASSERT_LE(on_torus, 4);
        ++of_torus[std::size_t(on_torus)];
    }
    EXPECT_EQ(of_torus[1] + of_torus[3], 0);
    EXPECT_GT(of_torus[2], 5000);
    EXPECT_GT(of_torus[4], 1000);
}

TEST(ClosedForms, TorusRootsAreOnTheTorusAndNoneIsMissed) {
    if (sizeof(Real) == sizeof(float)) GTEST_SKIP() << "the walk's steps are below the rounding of float";
    // A dense walk along the ray with the distance to the surface (a Lipschitz bound) finds every crossing of its own.
    test::Aim aim(3);
    for (const Torus torus : {Torus{2, Real(0.5)}, Torus{1, Real(0.01)}, Torus{1, Real(0.99)}}) {
        const auto distance = [&](const Vec3& p) {
            return std::hypot(std::hypot(p.x, p.z) - torus.major, p.y) - torus.minor;
        };
        for (int i = 0; i < 3000; ++i) {
            const Real angle = aim.uniform(0, 2 * double(kPi));
            const Vec3 on_circle = torus.major * Vec3(std::cos(angle), 0, std::sin(angle));
            const Vec3 d = aim.direction();
            const Ray ray{on_circle + Real(1.2) * torus.minor * aim.direction() - Real(6) * d, d};
            std::vector<Real> expected;
            bool graze = false;
            Real t = 0, before = distance(ray.origin);
            while (t < 14) {
                const Real step = std::max(std::abs(before), Real(1e-5) * torus.minor);
                const Real after = distance(ray.at(t + step));
                if ((after < 0) != (before < 0)) expected.push_back(t + step);
                graze |= std::abs(after) < Real(1e-4) * torus.minor && std::abs(before) < Real(1e-4) * torus.minor &&
                         step > 2 * std::abs(after - before);
                t += step, before = after;
            }
            if (graze) continue;
            Interval rest{0, kInfinity};
            for (const Real walked : expected) {
                const auto root = intersect(torus, ray, rest);
                ASSERT_TRUE(root) << "ray " << i << " of R = " << torus.major << ", r = " << torus.minor;
                EXPECT_NEAR(root->t, walked, Real(0.5) * torus.minor);
                EXPECT_NEAR(distance(ray.at(root->t)), 0, 32 * kEpsilon * 6);
                rest.min = root->t + Real(1e-6) * torus.minor;
            }
            EXPECT_FALSE(intersect(torus, ray, rest)) << "a root too many, ray " << i;
        }
    }
}

TEST(ClosedForms, MeshParityAndCullingAgreeWithAllFaces) {
    Mesh mesh = test::ball_of_triangles(1, 1, Vec3(0));
    prepare(mesh);
    ASSERT_EQ(mesh.outward_winding, 1);
    Mesh plain = mesh;
    plain.outward_winding = 0;
    test::Aim aim(4);
    int inside_starts = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Ray ray = aim.through(aim.in_cube(1), aim.uniform(0, 3));
        const auto culled = intersect(mesh, ray, {0, kInfinity}), all = intersect(plain, ray, {0, kInfinity});
        ASSERT_EQ(culled.has_value(), all.has_value()) << "ray " << i;
        if (all) {
            EXPECT_EQ(culled->t, all->t);
        }
        const bool starts_inside = glm::length(ray.origin) < Real(0.7);
        inside_starts += starts_inside;
        if (starts_inside) {
            EXPECT_TRUE(all) << "inside of a closed mesh every ray hits";
        }
        if (glm::length(ray.origin) > 1 && sizeof(Real) == sizeof(double)) {  // in float, steps past a root pass chords
            EXPECT_EQ(crossings(plain, ray) % 2, 0);
        }
        // Past the first root the far side must still be there: a clip may have cut the near one away.
        if (all && !starts_inside) {
            const Interval rest{all->t, kInfinity};
            EXPECT_EQ(intersect(mesh, ray, rest).has_value(), intersect(plain, ray, rest).has_value());
        }
    }
    EXPECT_GT(inside_starts, 1000);
}

}  // namespace
}  // namespace rays
