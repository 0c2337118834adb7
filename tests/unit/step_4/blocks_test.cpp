// The blocks in leaves of the hierarchy never hide a root.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <random>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "../step_1/rays_at.h"
#include "4_partitioning/beyond/leaf_blocks.h"
#include "4_partitioning/structures.h"
#include "chance.h"

namespace rays::tests {
namespace {

using test::RaysAt;
using test::Special;

// ---- What grazes a shape: rays in a tangent plane, moved in or out by very little
// ---------------------------------------

struct Tangent {
    Vec3 point, direction, outwards;
};

Tangent tangent(const Sphere& s, Chance& chance) {
    const Vec3 n = chance.direction();
    return {s.center + s.radius * n, chance.across(n), n};
}
Tangent tangent(const Cone& c, Chance& chance) {
    const Vec3 axis = c.cap - c.base, n = chance.across(axis);
    const Real height = chance.unit() < Real(0.3) ? Real(chance.unit() < Real(0.5)) : chance.unit();
    const Vec3 generator = axis + (c.cap_radius - c.base_radius) * n, around = glm::normalize(glm::cross(axis, n));
    const Vec3 point = c.base + c.base_radius * n + height * generator;
    const Vec3 along = glm::normalize(generator);
    const Vec3 d = chance.unit() < Real(0.3) ? along : chance.between(-1, 1) * along + chance.between(-1, 1) * around;
    return {point, d, n};
}
Tangent tangent(const Triangle& t, Chance& chance) {
    const Vec3 corners[] = {t.a, t.b, t.c};
    const auto i = std::size_t(chance.bits() % 3);
    const Vec3 &from = corners[i], &to = corners[(i + 1) % 3], &opposite = corners[(i + 2) % 3];
    const Vec3 point = from + chance.unit() * (to - from);
    const Vec3 in = opposite - point;
    return {point,
            chance.unit() < Real(0.5) ? chance.direction() : glm::cross(to - from, in) + chance.between(-1, 1) * in,
            -in};
}

Ray grazing(const Tangent& at, Real size, Chance& chance) {
    const Vec3 d = glm::normalize(at.direction);
    const Real off = (chance.unit() < Real(0.8) ? -1 : 1) * size * chance.order(Real(1e-16), Real(1e-2));
    const Vec3 point = at.point + off * at.outwards;
    return {point - size * chance.order(Real(1e-2), Real(1e8)) * d, d * chance.order(Real(1e-3), Real(1e3))};
}

// ---- Special points, as the packets' tests have them ----------------------------------------------------------------

Special special_of(const Sphere& s) {
    return {
        {s.center, s.center + Vec3(s.radius, 0, 0), s.center - Vec3(0, 0, s.radius)}, {{1, 0, 0}, {0, 1, 0}}, s.radius};
}
Special special_of(const Cone& c) {
    const Vec3 axis = c.cap - c.base, u = glm::normalize(glm::cross(axis, Vec3(Real(0.1), Real(0.2), 1)));
    return {{c.base + Real(0.5) * axis, c.base, c.cap, c.base + c.base_radius * u, c.cap - c.cap_radius * u},
            {axis, u, axis + (c.cap_radius - c.base_radius) * u, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
            glm::length(axis) + std::max(c.base_radius, c.cap_radius)};
}
Special special_of(const Triangle& t) {
    return {{(t.a + t.b + t.c) / Real(3), t.a, t.b, t.c, Real(0.5) * (t.a + t.b)},
            {t.b - t.a, t.c - t.b, {1, 0, 0}, {0, 1, 0}},
            glm::length(t.b - t.a) + glm::length(t.c - t.a)};
}

/// Eight shapes in a block, and rays at each of them in turn. `BlockRay` is how the block sees a ray.
template <class BlockRay, class Block, class Shape>
class FilledBlock {
public:
    void put(const Shape& shape) {
        std::visit([&](const auto& s) { wide::put(block_, s, 0); }, shape);
        shapes_.push_back(shape);
    }

    void expect_nothing_hidden(const std::string& name, Chance& chance, int rays) {
        for (int n = 0; n < rays; ++n) {
            const Shape& aimed_at = shapes_[std::size_t(n) % shapes_.size()];
            Ray ray;
            Interval range{0, kInfinity};
            std::visit(
                [&](const auto& shape) {
                    const Special special = special_of(shape);
                    if (n % 3 == 0) {
                        ray = grazing(tangent(shape, chance), special.size, chance);
                    } else {
                        const auto question = RaysAt(special, chance.bits()).next();
                        ray = question.ray;
                        range = question.range;
                    }
                },
                aimed_at);
            if (!is_ray(ray)) continue;
            ASSERT_NO_FATAL_FAILURE(ask(name, ray, range));
        }
    }

    int roots = 0, misses = 0, spared = 0;

private:
    void ask(const std::string& name, const Ray& ray, Interval range) {
        const BlockRay block_ray(ray, range);
        const float end = range.max < wide::kMaxFloat ? wide::above(range.max) : wide::kMaxFloat;
        const unsigned met = block_ray.may_meet(block_, end);
        for (std::size_t i = 0; i < shapes_.size(); ++i) {
            const auto root = std::visit([&](const auto& shape) { return intersect(shape, ray, range); }, shapes_[i]);
            if (!root) {
                ++misses;
                spared += !(met >> i & 1);
                continue;
            }
            ++roots;
            // As the walk asks, too: no farther than a root that is already found at the same place.
            const unsigned up_to_it = block_ray.may_meet(block_, wide::above(root->t));
            ASSERT_TRUE(met >> i & 1) << name << ", lane " << i << text(ray, range, root->t);
            ASSERT_TRUE(up_to_it >> i & 1) << name << ", up to the root, lane " << i << text(ray, range, root->t);
        }
        if constexpr (requires { block_ray.roots(block_, end); }) {
            ASSERT_NO_FATAL_FAILURE(expect_bounds(name, ray, range, block_ray.roots(block_, end)));
        }
    }
    /// What a block says about the roots that it is certain of, and of those that it is not.
    void expect_bounds(const std::string& name, const Ray& ray, Interval range, const wide::TriangleRoots& bounds) {
        for (std::size_t i = 0; i < shapes_.size(); ++i) {
            const auto root = std::visit([&](const auto& shape) { return intersect(shape, ray, range); }, shapes_[i]);
            if ((bounds.must >> i & 1) && bounds.latest[i] < range.max) {
                ASSERT_TRUE(root) << name << ", lane " << i << " has no root, " << test::text(ray, range);
                ASSERT_LE(root->t, bounds.latest[i]) << name << ", lane " << i << ", " << test::text(ray, range);
            }
            if (root) {
                ASSERT_GE(root->t, bounds.earliest[i]) << name << ", lane " << i << ", " << test::text(ray, range);
            }
        }
    }
    static std::string text(const Ray& ray, Interval range, Real t) {
        return fmt::format(", {}: a root at {:.17g} is hidden", test::text(ray, range), t);
    }

    Block block_;
    std::vector<Shape> shapes_;
};

/// `blocks` blocks of shapes that make(chance) makes.
template <class BlockRay, class Block, class Shape, class Make>
void expect_nothing_hidden(const std::string& name, Make make, double spares, int blocks = 60) {
    Chance chance(1);
    int roots = 0, misses = 0, spared = 0;
    for (int b = 0; b < blocks; ++b) {
        FilledBlock<BlockRay, Block, Shape> block;
        for (int i = 0; i < wide::kWidth - b % 3; ++i) block.put(make(chance));
        ASSERT_NO_FATAL_FAILURE(block.expect_nothing_hidden(name, chance, 600));
        roots += block.roots;
        misses += block.misses;
        spared += block.spared;
    }
    EXPECT_GT(roots, blocks * 60) << name << ": the rays look past it";
    EXPECT_GT(spared, spares * misses) << name << ": who asks everybody needs no block";
}

using AnyTriangle = std::variant<Triangle>;
using AnySphere = std::variant<Sphere>;
using Round = std::variant<Cone, Sphere>;

template <class Make>
void expect_cones(const std::string& name, Make make, double spares) {
    expect_nothing_hidden<wide::SphereRay, wide::ConeBlock, Round>(name, make, spares);
}

/// In double: the margins allow for what float does to a block and its ray, not for what it does to the root itself. In
/// float the roots of rays from afar are off by as much.
class BlocksHideNoRoot : public testing::Test {
protected:
    void SetUp() override {
        if (sizeof(Real) < sizeof(double)) GTEST_SKIP() << "geometry is in float";
    }
};

TEST_F(BlocksHideNoRoot, OfTriangles) {
    const auto at = [](Vec3 middle, Real spread, Real size) {
        return [=](Chance& c) -> AnyTriangle {
            const Vec3 p = middle + c.in_cube(spread);
            const Real s = c.order(size / 100, size);
            return Triangle{p, p + s * c.direction(), p + s * c.direction()};
        };
    };
    using wide::TriangleBlock, wide::TriangleRay;
    expect_nothing_hidden<TriangleRay, TriangleBlock, AnyTriangle>("small triangles", at(Vec3(0), 3, 1), 0.5);
    expect_nothing_hidden<TriangleRay, TriangleBlock, AnyTriangle>("far triangles", at(Vec3(1e6, -1e6, 1e6), 3, 1),
                                                                   0.1);
    // From 1e18 away even step 1's test finds what is none, one time in a million.
    expect_nothing_hidden<TriangleRay, TriangleBlock, AnyTriangle>("large ones among small ones", at(Vec3(0), 3, 1e4),
                                                                   0.3, 2000);
}

TEST_F(BlocksHideNoRoot, OfSpheres) {
    const auto at = [](Vec3 middle, Real smallest, Real largest) {
        return [=](Chance& c) -> AnySphere { return Sphere{middle + c.in_cube(3), c.order(smallest, largest)}; };
    };
    using wide::SphereBlock, wide::SphereRay;
    expect_nothing_hidden<SphereRay, SphereBlock, AnySphere>("spheres", at(Vec3(0), Real(0.1), 1), 0.4);
    expect_nothing_hidden<SphereRay, SphereBlock, AnySphere>("tiny spheres", at(Vec3(0), Real(1e-6), Real(1e-3)), 0.4);
    expect_nothing_hidden<SphereRay, SphereBlock, AnySphere>("far spheres", at(Vec3(1e6, 1e6, -1e6), Real(0.1), 1),
                                                             0.1);
    expect_nothing_hidden<SphereRay, SphereBlock, AnySphere>("spheres of all sizes", at(Vec3(0), Real(1e-3), 1e5), 0.1);
}

TEST_F(BlocksHideNoRoot, OfCones) {
    expect_cones(
        "cones", [](Chance& c) -> Round { return cone(c, c.in_cube(3), c.between(Real(0.3), 2), c.unit(), c.unit()); },
        0.4);
    expect_cones(
        "cylinders",
        [](Chance& c) -> Round {
            const Real radius = c.order(Real(0.01), 1);
            return cone(c, c.in_cube(3), c.between(Real(0.3), 2), radius, radius);
        },
        0.4);
    expect_cones(
        "cones with an apex",
        [](Chance& c) -> Round {
            const bool at_base = c.unit() < Real(0.5);
            return cone(c, c.in_cube(3), c.between(Real(0.3), 2), at_base ? 0 : c.unit(), at_base ? c.unit() : 0);
        },
        0.4);
    expect_cones(
        "thin long cones",
        [](Chance& c) -> Round {
            return cone(c, c.in_cube(10), c.order(10, 1000), c.order(Real(1e-5), Real(1e-2)),
                        c.order(Real(1e-5), Real(1e-2)));
        },
        0.4);
    expect_cones(
        "flat cones",
        [](Chance& c) -> Round { return cone(c, c.in_cube(3), c.order(Real(1e-6), Real(0.1)), c.unit(), c.unit()); },
        0.3);
    expect_cones(
        "cones a million away",
        [](Chance& c) -> Round {
            return cone(c, Vec3(1e6, -1e6, 1e6) + c.in_cube(3), c.between(Real(0.3), 2), c.unit(), c.unit());
        },
        0.05);
    expect_cones(
        "cones of all sizes",
        [](Chance& c) -> Round {
            return cone(c, c.in_cube(3), c.order(Real(1e-3), 1e4), c.order(Real(1e-4), 1e3), c.order(Real(1e-4), 1e3));
        },
        0.1);
    expect_cones(
        "cones along an axis",
        [](Chance& c) -> Round {
            Vec3 axis(0);
            axis[int(c.bits() % 3)] = c.between(-2, 2);
            const Vec3 base = c.in_cube(3);
            return Cone{base, c.unit(), base + axis, c.unit(), false};
        },
        0.4);
}

TEST_F(BlocksHideNoRoot, OfSpheresAmongCones) {
    expect_cones(
        "spheres and cones",
        [](Chance& c) -> Round {
            if (c.unit() < Real(0.5)) return Sphere{c.in_cube(3), c.order(Real(0.01), 1)};
            return cone(c, c.in_cube(3), c.between(Real(0.3), 2), c.unit(), c.unit());
        },
        0.4);
    expect_cones(
        "nothing but spheres",
        [](Chance& c) -> Round {
            return Sphere{c.in_cube(3), c.order(Real(0.01), 1)};
        },
        0.4);
}

TEST(Blocks, KindsThatShareALeaf) {
    using wide::LeafKind;
    EXPECT_EQ(wide::together(LeafKind::spheres, LeafKind::cones), LeafKind::cones);
    EXPECT_EQ(wide::together(LeafKind::cones, LeafKind::spheres), LeafKind::cones);
    for (const LeafKind same : {LeafKind::list, LeafKind::triangles, LeafKind::spheres, LeafKind::cones})
        EXPECT_EQ(wide::together(same, same), same);
    for (const LeafKind round : {LeafKind::spheres, LeafKind::cones})
        for (const LeafKind other : {LeafKind::list, LeafKind::triangles})
            EXPECT_EQ(wide::together(round, other), std::nullopt);
}

}  // namespace
}  // namespace rays::tests
