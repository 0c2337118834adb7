// The blocks in leaves of the hierarchy are worth asking: they spare what a ray leaves, what lies behind its end, and
// most of what only their balls promise.
#include <gtest/gtest.h>

#include <bit>

#include "1_ray_casting/ray_casting.h"
#include "4_partitioning/beyond/leaf_blocks.h"
#include "chance.h"

namespace rays::tests {
namespace {

class BlocksOfOneTriangle : public testing::Test {
protected:
    void SetUp() override {
        if (sizeof(Real) < sizeof(double)) GTEST_SKIP() << "margins are wider for geometry in float";
    }

    struct Aim {
        wide::TriangleBlock block;
        Vec3 point;   ///< somewhere on the triangle
        Vec3 normal;  ///< of unit length
    };
    Aim aim() {
        const Vec3 corner = chance.in_cube(3);
        const Triangle t{corner, corner + chance.direction(), corner + chance.direction()};
        const Real b = chance.unit(), c = (1 - b) * chance.unit();
        Aim result{{}, (1 - b - c) * t.a + b * t.b + c * t.c, glm::normalize(glm::cross(t.b - t.a, t.c - t.a))};
        wide::put(result.block, t, 0);
        return result;
    }

    Chance chance{6};
    static constexpr int kRays = 2000;
};

TEST_F(BlocksOfOneTriangle, SpareItToARayThatLeavesIt) {
    // Corners lie on both sides of the ray's start: depths alone tell nothing.
    int met = 0;
    for (int n = 0; n < kRays; ++n) {
        const Aim from = aim();
        const Ray away{from.point + Real(1e-4) * from.normal, from.normal + Real(0.9) * chance.direction()};
        met += std::popcount(wide::TriangleRay(away, {Real(1e-4), kInfinity}).may_meet(from.block, wide::kMaxFloat));
    }
    EXPECT_LT(met, kRays / 20);
}

TEST_F(BlocksOfOneTriangle, SpareItToARayThatEndsBeforeIt) {
    int met = 0;
    for (int n = 0; n < kRays; ++n) {
        const Aim at = aim();
        const Vec3 way = at.normal + Real(0.9) * chance.direction();
        const wide::TriangleRay ray({at.point - way, way}, {0, 1});
        met += std::popcount(ray.may_meet(at.block, 1 - 1e-3f));
    }
    EXPECT_LT(met, kRays / 20);
}

TEST_F(BlocksOfOneTriangle, AreCertainOfWhatIsPlain) {
    int certain = 0;
    for (int n = 0; n < kRays; ++n) {
        const Aim at = aim();
        const Vec3 way = at.normal + Real(0.9) * chance.direction();
        const wide::TriangleRoots roots =
            wide::TriangleRay({at.point - way, way}, {0, kInfinity}).roots(at.block, wide::kMaxFloat);
        certain += roots.must == 1 && roots.latest[0] - roots.earliest[0] < 1e-2f;
    }
    EXPECT_GT(certain, kRays - kRays / 20);
}

TEST(Blocks, OfSpheresSpareTheOneThatARayLeaves) {
    Chance chance(7);
    int left = 0, crossed = 0;
    for (int n = 0; n < 2000; ++n) {
        const Sphere ball{chance.in_cube(3), chance.between(Real(0.1), 1)};
        wide::SphereBlock block;
        wide::put(block, ball, 0);
        const Vec3 normal = chance.direction(), way = glm::normalize(normal + Real(0.9) * chance.direction());
        const auto met = [&](const Vec3& direction) {
            const wide::SphereRay ray({ball.center + ball.radius * normal, direction}, {Real(1e-3), kInfinity});
            return std::popcount(ray.may_meet(block, wide::kMaxFloat));
        };
        left += met(way);
        crossed += met(-way);
    }
    EXPECT_LT(left, 100);
    EXPECT_EQ(crossed, 2000);
}

TEST(Blocks, OfSpheresKeepOneThatIsSmallerThanARounding) {
    if (sizeof(Real) < sizeof(double)) GTEST_SKIP() << "in float geometry it has no surface either";
    // Where it begins and ends is not known in float: the ray's near end may lie anywhere about it.
    Chance chance(8);
    int roots = 0;
    for (int n = 0; n < 20000; ++n) {
        const Sphere ball{chance.in_cube(3), chance.order(Real(1e-9), Real(1e-7))};
        wide::SphereBlock block;
        wide::put(block, ball, 0);
        const Vec3 way = chance.direction();
        const Ray ray{ball.center - way, way};
        const Interval range{1 - chance.order(Real(1e-10), Real(1e-6)), kInfinity};
        if (!intersect(ball, ray, range)) continue;
        ++roots;
        ASSERT_EQ(wide::SphereRay(ray, range).may_meet(block, wide::kMaxFloat), 1u) << "ball " << n;
    }
    EXPECT_GT(roots, 10000);
}

TEST(Blocks, OfThinConesLookAtMoreThanTheirBalls) {
    // A ball around a thin cone is mostly empty: the distance from the axis tells.
    Chance chance(5);
    wide::ConeBlock block;
    for (int i = 0; i < wide::kWidth; ++i)
        wide::put(block, cone(chance, chance.in_cube(1), 4, Real(0.01), Real(0.01)), 0);
    int balls = 0, cones = 0;
    for (int n = 0; n < 2000; ++n) {
        const Vec3 from = chance.in_cube(6);
        const wide::SphereRay ray({from, chance.in_cube(1) - from}, {0, kInfinity});
        balls += std::popcount(ray.may_meet(block.around, wide::kMaxFloat));
        cones += std::popcount(ray.may_meet(block, wide::kMaxFloat));
    }
    EXPECT_GT(balls, 5000);
    EXPECT_LT(cones, balls / 10);
}

}  // namespace
}  // namespace rays::tests
