// The truths, and the judge: measured errors are worth what these are.
#include <gtest/gtest.h>

#include <cmath>

#include "1_ray_casting/ray_casting.h"
#include "measure/naive.h"
#include "measure/subject.h"
#include "measure/truth.h"

namespace rays::bench {
namespace {

const ExactRay kAlongZ(Ray{Vec3(0, 0, -5), Vec3(0, 0, 1)});

TEST(Truth, KnownRoots) {
    EXPECT_NEAR(static_cast<double>(*truth_of(Sphere{Vec3(0), 1})(kAlongZ)), 4, 1e-18);
    EXPECT_NEAR(static_cast<double>(*truth_of(Torus{1, Real(0.25)})(kAlongZ)), 3.75, 1e-17);
    Quadric sphere;
    sphere.q = Mat4(1);
    sphere.q[3][3] = -4;
    EXPECT_NEAR(static_cast<double>(*truth_of(sphere)(kAlongZ)), 3, 1e-18);
    EXPECT_FALSE(truth_of(Sphere{Vec3(0, 3, 0), 1})(kAlongZ));

    BicubicPatch flat;  // the square [0, 3]^2 in the plane z = 1
    for (std::size_t i = 0; i < 16; ++i) flat.control[i] = Vec3(Real(i / 4), Real(i % 4), 1);
    const ExactRay onto(Ray{Vec3(Real(0.7), Real(1.9), -5), Vec3(0, 0, 1)});
    EXPECT_NEAR(static_cast<double>(*truth_of(flat)(onto)), 6, 1e-17);
    EXPECT_FALSE(truth_of(flat)(ExactRay(Ray{Vec3(Real(-0.1), 1, -5), Vec3(0, 0, 1)})));
}

Target torus_target(const Torus& torus) {
    const auto truth = truth_of(torus);
    return {1, rays_around(1, 10, 200, truth), {}, truth};
}

TEST(Judge, CountsWrongAnswersAsOne) {
    const Torus torus{Real(0.75), Real(0.25)};
    const Target target = torus_target(torus);
    Answers right, none(target.rays.size());
    std::size_t hits = 0;
    for (const Ray& ray : target.rays) {
        right.push_back(intersect(torus, ray, {}));
        hits += right.back().has_value();
    }
    EXPECT_GT(hits, 50u);
    EXPECT_LT(hits, 150u) << "about half of the rays hit";

    const Accuracy good = judge(target, right), blind = judge(target, none);
    // Ten sizes away t itself is rounded by 10 eps; a few roundings more on the way.
    EXPECT_LE(good.largest, 200 * std::numeric_limits<Real>::epsilon());
    EXPECT_EQ(good.wrong, 0);
    EXPECT_EQ(blind.mean, 1);
    EXPECT_DOUBLE_EQ(blind.wrong, static_cast<double>(hits) / static_cast<double>(target.rays.size()));

    for (auto& root : right)
        if (root) root->t += Real(0.5);  // the far side, say
    EXPECT_EQ(judge(target, right).mean, 1);
    for (auto& root : right)
        if (root) root->t = std::numeric_limits<Real>::quiet_NaN();
    EXPECT_EQ(judge(target, right).mean, 1);
    EXPECT_EQ(judge(target, right).largest, 1);
}

// Each naive method is right where it must be, so that what its chart shows is its nature and no slip in its code.
TEST(Naive, RightWhereItIsEasy) {
    const Ray ray{Vec3(Real(0.1), Real(0.2), -3), Vec3(0, 0, 1)};
    const Sphere sphere{Vec3(0), 1};
    EXPECT_NEAR(textbook_sphere(sphere, ray, {})->t, intersect(sphere, ray, {})->t, 1e-5);
    Quadric quadric;
    quadric.q = Mat4(1);
    quadric.q[3][3] = -1;
    EXPECT_NEAR(textbook_quadric(quadric, ray, {})->t, intersect(quadric, ray, {})->t, 1e-5);
    const Torus torus{Real(0.75), Real(0.25)};
    EXPECT_NEAR(stepped_torus(torus, ray, {}, 256)->t, intersect(torus, ray, {})->t, 1e-5);
    EXPECT_FALSE(textbook_sphere(sphere, {Vec3(0, 2, -3), Vec3(0, 0, 1)}, {}));

    const BicubicPatch patch = wavy_patch();
    const Ray down{Vec3(Real(0.1), 5, Real(0.2)), Vec3(0, -1, 0)};
    const auto root = intersect(patch, down, {});
    ASSERT_TRUE(root);
    EXPECT_NEAR(newton_patch(patch, down, {}, 6)->t, root->t, 1e-4);
    EXPECT_NEAR(intersect(tessellated(patch, 64), down, {})->t, root->t, 1e-2);
}

}  // namespace
}  // namespace rays::bench
