// Whatever the numbers: a root is finite and in its range, normals are finite, and nothing hangs.
#include <gtest/gtest.h>

#include <functional>

#include "1_ray_casting/ray_casting.h"
#include "aim.h"

namespace rays {
namespace {

const std::vector<Real>& awkward_numbers() {
    using Limits = std::numeric_limits<Real>;
    static const std::vector<Real> numbers{0,
                                           -Real(0),
                                           1,
                                           -1,
                                           Real(0.5),
                                           Limits::denorm_min(),
                                           Limits::min(),
                                           Limits::epsilon(),
                                           Limits::max(),
                                           -Limits::max(),
                                           kInfinity,
                                           -kInfinity,
                                           Limits::quiet_NaN(),
                                           Real(1e6),
                                           Real(-1e18)};
    return numbers;
}

Vec3 awkward_vector(test::Aim& aim) {
    const auto one = [&] { return awkward_numbers()[std::size_t(aim.uniform(0, double(awkward_numbers().size())))]; };
    const Real x = one(), y = one();
    return {x, y, one()};
}

Ray awkward_ray(test::Aim& aim) {
    const Vec3 origin = aim.uniform(0, 1) < 0.5 ? awkward_vector(aim) : aim.in_cube(3);
    const Vec3 direction = aim.uniform(0, 1) < 0.5 ? awkward_vector(aim) : aim.direction();
    return {origin, direction};
}

template <class Shape>
void expect_sane(const Shape& shape, const char* name, std::uint64_t seed) {
    test::Aim aim(seed);
    for (int i = 0; i < 20'000; ++i) {
        const Ray ray = awkward_ray(aim);
        const Interval range{0, i % 2 ? kInfinity : Real(1e7)};
        const auto root = intersect(shape, ray, range);
        if (!root) continue;
        ASSERT_TRUE(std::isfinite(root->t)) << name << ", ray " << i << " of seed " << seed;
        ASSERT_TRUE(range.contains(root->t)) << name << ", ray " << i << " of seed " << seed;
        const Vec3 point = ray.at(root->t);
        if (!is_finite(point)) continue;
        ASSERT_TRUE(is_finite(normal(shape, point, *root))) << name << ", ray " << i << " of seed " << seed;
    }
}

Polygon polygon_of(std::vector<Vec3> points) {
    Polygon p;
    p.contour_ends = {std::uint32_t(points.size())};
    p.points = std::move(points);
    prepare(p);
    return p;
}

BicubicPatch patch_of(const std::function<Vec3(int, int)>& at) {
    BicubicPatch patch;
    for (int k = 0; k < 16; ++k) patch.control[std::size_t(k)] = at(k / 4, k % 4);
    prepare(patch);
    return patch;
}

TEST(Degenerate, AwkwardRaysOnOrdinaryShapes) {
    expect_sane(Sphere{Vec3(1, 0, 0), 1}, "sphere", 1);
    expect_sane(Plane{Vec3(0, 1, 0), 1}, "plane", 2);
    expect_sane(Triangle{Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 1)}, "triangle", 3);
    expect_sane(polygon_of({Vec3(0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(Real(0.2), Real(0.2), 0)}), "polygon", 4);
    expect_sane(Box{Vec3(-1), Vec3(1)}, "box", 5);
    expect_sane(Disc{Vec3(0), Vec3(0, 1, 0), 1, Real(0.5)}, "disc", 6);
    expect_sane(Cone{Vec3(0), 1, Vec3(0, 1, 0), Real(0.5), false}, "cone", 7);
    expect_sane(Cone{Vec3(0), 1, Vec3(0, 1, 0), 1, true}, "open cylinder", 8);
    Quadric saddle;
    saddle.q[0][1] = saddle.q[1][0] = 1;
    saddle.q[2][3] = saddle.q[3][2] = -1;
    expect_sane(saddle, "quadric", 9);
    expect_sane(Torus{1, Real(0.25)}, "torus", 10);
    expect_sane(patch_of([](int i, int j) { return Vec3(i, j, (i - 1) * (j - 2)); }), "patch", 11);
}

TEST(Degenerate, ShapesThatAreHardlyThere) {
    expect_sane(Triangle{Vec3(0), Vec3(1, 0, 0), Vec3(2, 0, 0)}, "triangle without area", 1);
    expect_sane(Triangle{Vec3(1), Vec3(1), Vec3(1)}, "triangle of one point", 2);
    expect_sane(polygon_of({}), "polygon without points", 3);
    expect_sane(polygon_of({Vec3(0), Vec3(1, 1, 0)}), "polygon of two points", 4);
    expect_sane(polygon_of({Vec3(0), Vec3(1, 0, 0), Vec3(2, 0, 0)}), "polygon without area", 5);
    expect_sane(Disc{Vec3(0), Vec3(0, 1, 0), 0, 0}, "disc without radius", 6);
    expect_sane(Cone{Vec3(0), 1, Vec3(0), 1, false}, "cylinder without height", 7);
    expect_sane(Cone{Vec3(0), 0, Vec3(0, 1, 0), 0, false}, "cylinder without radius", 8);
    expect_sane(Quadric{}, "quadric of zeros", 9);
    Quadric line;  // x^2 + y^2 = 0
    line.q[0][0] = line.q[1][1] = 1;
    expect_sane(line, "quadric that is a line", 10);
    expect_sane(Torus{0, 1}, "torus that is a sphere", 11);
    expect_sane(Torus{Real(0.5), 1}, "torus that crosses itself", 12);
    expect_sane(Torus{1, 1}, "torus whose hole is a point", 13);
    expect_sane(patch_of([](int, int) { return Vec3(1); }), "patch that is a point", 14);
    expect_sane(patch_of([](int i, int) { return Vec3(i, 0, 0); }), "patch that is a line", 15);
    expect_sane(patch_of([](int i, int j) { return Vec3(i * (j - Real(1.5)), i, 0); }), "flat patch with a pole", 16);
    expect_sane(patch_of([](int i, int j) { return Vec3(i == 2 ? -3 : i, j, 0); }), "flat patch folded over", 17);
}

/// Rays in a patch's own plane, through its pole and along its folds have infinitely many roots; they cost a bounded
/// number of pieces (the longest of these tests takes milliseconds).
TEST(Degenerate, RaysThatLieInAPatch) {
    const auto flat = patch_of([](int i, int j) { return Vec3(i, j, 0); });
    const auto fan = patch_of([](int i, int j) { return Vec3(i * (j - Real(1.5)), i, Real(0.1) * i * j); });
    test::Aim aim(1);
    for (int i = 0; i < 200; ++i) {
        const Real x = aim.uniform(0, 3), y = aim.uniform(0, 3);
        const auto in_plane = intersect(flat, Ray{Vec3(x, -1, 0), Vec3(y - x, 4, 0)}, {0, kInfinity});
        if (in_plane) {
            EXPECT_TRUE(std::isfinite(in_plane->t));
        }
        const auto at_pole = intersect(fan, Ray{Vec3(0, -1, -1), Vec3(0, 1, 1)}, {0, kInfinity});
        if (at_pole) {
            EXPECT_NEAR(at_pole->t, 1, 1e-3);
        }
    }
}

TEST(Degenerate, CamerasOfOnePixelAndOfNoAngle) {
    Camera camera;
    const Ray ray = camera_ray(camera, {1, 1}, 0, 0);
    EXPECT_EQ(ray.direction, camera.direction) << "the only pixel's centre is the film's middle";
    camera.right = camera.up = Vec3(0);
    EXPECT_TRUE(is_finite(camera_ray(camera, {7, 5}, 3, 4).direction));
}

}  // namespace
}  // namespace rays
