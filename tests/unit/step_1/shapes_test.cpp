// Known roots and normals of single shapes.
#include <gtest/gtest.h>

#include "1_ray_casting/ray_casting.h"

namespace rays {
namespace {

constexpr Interval kAhead{0, kInfinity};
/// A few roundings of numbers of the size of ten.
constexpr Real kClose = 64 * std::numeric_limits<Real>::epsilon();

template <class Shape>
void expect_hit(const Shape& shape, const Ray& ray, Real t, const Vec3& unit_normal, Interval range = kAhead) {
    const auto root = intersect(shape, ray, range);
    ASSERT_TRUE(root) << "missed, but t = " << t << " was expected";
    EXPECT_NEAR(root->t, t, kClose * (1 + std::abs(t)));
    const Vec3 n = glm::normalize(normal(shape, ray.at(root->t), *root));
    EXPECT_NEAR(glm::distance(n, unit_normal), 0, kClose) << n.x << ' ' << n.y << ' ' << n.z;
}

template <class Shape>
void expect_miss(const Shape& shape, const Ray& ray, Interval range = kAhead) {
    const auto root = intersect(shape, ray, range);
    EXPECT_FALSE(root) << "hit at t = " << root->t;
}

const Vec3 X(1, 0, 0), Y(0, 1, 0), Z(0, 0, 1);

TEST(Camera, PixelsLieWherePovRayPutsThem) {
    Camera camera;
    camera.location = Vec3(1, 2, 3);
    camera.direction = Real(2) * Z;
    camera.right = Real(4) * X;
    camera.up = Real(3) * Y;
    const Ray corner = camera_ray(camera, {4, 3}, 0, 0);
    EXPECT_EQ(corner.origin, camera.location);
    EXPECT_NEAR(glm::distance(corner.direction, Vec3(-1.5, 1, 2)), 0, kClose)
        << "left and up, half a pixel from the edge";
    EXPECT_NEAR(glm::distance(camera_ray(camera, {4, 3}, 3, 2, {0.5, 0.5}).direction, Vec3(2, -1.5, 2)), 0, kClose);
    camera.kind = Camera::Kind::orthographic;
    const Ray parallel = camera_ray(camera, {4, 3}, 0, 0);
    EXPECT_EQ(parallel.direction, camera.direction);
    EXPECT_NEAR(glm::distance(parallel.origin, Vec3(-0.5, 3, 3)), 0, kClose);
}

TEST(Sphere, RootsFromOutsideInsideAndBehind) {
    const Sphere s{Vec3(0, 0, 5), 2};
    expect_hit(s, {Vec3(0), Z}, 3, -Z);
    expect_hit(s, {Vec3(0), Real(2) * Z}, 1.5, -Z);
    expect_hit(s, {Vec3(0, 0, 5), Z}, 2, Z);
    expect_hit(s, {Vec3(0), Z}, 7, Z, {4, kInfinity});
    expect_miss(s, {Vec3(0), -Z});
    expect_miss(s, {Vec3(0), Z}, {0, 3});
    expect_miss(s, {Vec3(0, Real(2.0001), 0), Z});
    expect_miss(s, {Vec3(0), Vec3(0)});
}

TEST(Plane, BothSidesAndParallel) {
    const Plane p{Y, 2};
    expect_hit(p, {Vec3(0), Y}, 2, Y);
    expect_hit(p, {Vec3(0, 5, 0), -Y}, 3, Y);
    expect_miss(p, {Vec3(0), -Y});
    expect_miss(p, {Vec3(0), X});
    expect_miss(p, {Vec3(0, 2, 0), X});
}

TEST(Triangle, WeightsAndNormals) {
    const Triangle t{Vec3(0), Vec3(4, 0, 0), Vec3(0, 4, 0)};
    expect_hit(t, {Vec3(1, 2, -3), Z}, 3, Z);
    expect_hit(t, {Vec3(1, 2, 3), -Z}, 3, Z);
    const auto root = intersect(t, {Vec3(1, 2, -3), Z}, kAhead);
    EXPECT_NEAR(root->uv.x, 0.25, kClose);
    EXPECT_NEAR(root->uv.y, 0.5, kClose);
    expect_miss(t, {Vec3(Real(2.01), 2, -3), Z});
    expect_miss(t, {Vec3(1, 0, -3), Y});
    const SmoothTriangle s{t, Z, X, Y};
    const auto on_smooth = intersect(s, {Vec3(1, 2, -3), Z}, kAhead);
    ASSERT_TRUE(on_smooth);
    EXPECT_NEAR(glm::distance(shading_normal(s, *on_smooth), Vec3(0.25, 0.5, 0.25)), 0, kClose);
}

TEST(Polygon, HolesNotchesAndRepeatedPoints) {
    Polygon p;
    p.points = {Vec3(2, 0, 0),         Vec3(2, 2, 0),         Vec3(2, 4, 0),        Vec3(2, 4, 4),
                Vec3(2, 4, 4),         Vec3(2, 2, 1),         Vec3(2, 0, 4),        Vec3(2, 1, Real(0.2)),
                Vec3(2, 2, Real(0.2)), Vec3(2, 2, Real(0.8)), Vec3(2, 1, Real(0.8))};
    p.contour_ends = {7, 11};
    prepare(p);
    EXPECT_EQ(std::abs(p.plane.normal.x), 1);
    const auto at = [&](double y, double z) {
        return intersect(p, Ray{Vec3(0, Real(y), Real(z)), X}, kAhead).has_value();
    };
    EXPECT_TRUE(at(0.5, 0.5));
    EXPECT_TRUE(at(3.9, 3));
    EXPECT_FALSE(at(2, 2)) << "in the notch";
    EXPECT_FALSE(at(1.5, 0.5)) << "in the hole";
    EXPECT_TRUE(at(2.5, 0.5)) << "beside the hole, whose corners lie on a level with it";
    EXPECT_FALSE(at(-0.1, 0.5));
}

TEST(Box, FacesEdgesAndZeros) {
    const Box b{Vec3(-1, -2, -3), Vec3(1, 2, 3)};
    expect_hit(b, {Vec3(-5, 0, 0), X}, 4, -X);
    expect_hit(b, {Vec3(0), X}, 1, X);
    expect_hit(b, {Vec3(0, 9, 1), -Y}, 7, Y);
    expect_miss(b, {Vec3(-5, 2.5, 0), X});
    expect_miss(b, {Vec3(-5, 0, 0), -X});
    EXPECT_EQ(intersect(b, {Vec3(0, 0, -9), Z}, kAhead)->part, 4u);
}

TEST(Disc, RimAndHole) {
    const Disc d{Vec3(0, 1, 0), Y, 2, 1};
    expect_hit(d, {Vec3(Real(1.5), 4, 0), -Y}, 3, Y);
    expect_miss(d, {Vec3(Real(0.5), 4, 0), -Y});
    expect_miss(d, {Vec3(Real(2.5), 4, 0), -Y});
    expect_miss(d, {Vec3(-5, 1, 0), X});
}

TEST(Cone, MantleEndsAndOpenings) {
    const Cone cylinder{Vec3(0), 1, Vec3(0, 4, 0), 1, false};
    expect_hit(cylinder, {Vec3(-3, 1, 0), X}, 2, -X);
    expect_hit(cylinder, {Vec3(0, -2, 0), Y}, 2, -Y);
    expect_hit(cylinder, {Vec3(0, 1, 0), Y}, 3, Y);
    Cone pipe = cylinder;
    pipe.open = true;
    expect_miss(pipe, {Vec3(0, -2, 0), Y});
    expect_hit(pipe, {Vec3(0, -1, 0), Vec3(1, 2, 0)}, 1, X);
    const Cone tip{Vec3(0), 1, Vec3(0, 1, 0), 0, false};
    expect_hit(tip, {Vec3(-2, Real(0.5), 0), X}, 1.5, glm::normalize(Vec3(-1, 1, 0)));
    expect_miss(tip, {Vec3(-2, Real(1.5), 0), X});  // the other sheet of the double cone
    expect_hit(tip, {Vec3(0, 3, 0), -Y}, 2, Y);     // the apex
}

TEST(Quadric, ParaboloidAlongItsAxisAndConeAtItsApex) {
    Quadric p;  // x^2 + y^2 = z
    p.q[0][0] = p.q[1][1] = 1;
    p.q[2][3] = p.q[3][2] = Real(-0.5);
    expect_hit(p, {Vec3(1, 0, 5), -Z}, 4, glm::normalize(Vec3(2, 0, -1)));
    expect_miss(p, {Vec3(1, 0, 5), Z});
    Quadric none;  // x^2 + 1 = 0
    none.q[0][0] = none.q[3][3] = 1;
    expect_miss(none, {Vec3(-5, 0, 0), X});
    Quadric cone;
    cone.q[0][0] = cone.q[2][2] = 1;
    cone.q[1][1] = -1;
    EXPECT_EQ(normal(cone, Vec3(0), {}), X) << "the apex has no normal; POV-Ray takes x";
}

TEST(Torus, FourRootsInOrder) {
    const Torus t{3, 1};
    const Ray ray{Vec3(-10, 0, 0), X};
    expect_hit(t, ray, 6, -X);
    expect_hit(t, ray, 8, X, {7, kInfinity});
    expect_hit(t, ray, 12, -X, {9, kInfinity});
    expect_hit(t, ray, 14, X, {13, kInfinity});
    expect_miss(t, ray, {15, kInfinity});
    expect_miss(t, {Vec3(0, -5, 0), Y});
    expect_hit(t, {Vec3(3, 0, 0), Y}, 1, Y);
}

TEST(BicubicPatch, FlatPatchGivesUAndV) {
    BicubicPatch p;
    for (int k = 0; k < 16; ++k) p.control[std::size_t(k)] = Vec3(k / 4, k % 4, 0);
    prepare(p);
    const auto root = intersect(p, {Vec3(Real(0.75), Real(2.25), -2), Z}, kAhead);
    ASSERT_TRUE(root);
    EXPECT_NEAR(root->t, 2, kClose);
    EXPECT_NEAR(root->uv.x, 0.25, kClose);
    EXPECT_NEAR(root->uv.y, 0.75, kClose);
    expect_miss(p, {Vec3(Real(-0.01), 1, -2), Z});
    expect_miss(p, {Vec3(1, Real(3.01), -2), Z});
}

TEST(BicubicPatch, PoleHasANormal) {
    BicubicPatch p;  // the edge u = 0 is one point
    for (int k = 0; k < 16; ++k) p.control[std::size_t(k)] = Vec3((k / 4) * (k % 4 - Real(1.5)), k / 4, 0);
    const Vec3 n = normal(p, Vec3(0), Root{0, Vec2(0, Real(0.5)), 0});
    EXPECT_GT(std::abs(glm::normalize(n).z), 1 - kClose);
}

}  // namespace
}  // namespace rays
