// Eight boxes held against a ray in float: none that the ray meets is ever missed, and few others are met.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "4_partitioning/beyond/box_ray.h"
#include "chance.h"
#include "core/ray.h"

namespace rays::tests {
namespace {

using wide::BoxRay, wide::Boxes, wide::kWidth;

Boxes all(const Bounds& bounds) {
    Boxes boxes;
    for (std::size_t lane = 0; lane < kWidth; ++lane) boxes.set(lane, wide::rounded_outwards(bounds));
    return boxes;
}
std::string text(const Ray& ray, const Bounds& box) {
    return fmt::format(
        "from {:.17g} {:.17g} {:.17g} along {:.17g} {:.17g} {:.17g}, box {:.17g} {:.17g} {:.17g} to "
        "{:.17g} {:.17g} {:.17g}",
        ray.origin.x, ray.origin.y, ray.origin.z, ray.direction.x, ray.direction.y, ray.direction.z, box.min.x,
        box.min.y, box.min.z, box.max.x, box.max.y, box.max.z);
}

/// A direction of any length that may run along one axis or two, exactly or nearly.
Vec3 any_direction(Chance& chance, Real shortest, Real longest) {
    Vec3 d = chance.direction();
    for (int a = 0; a < 3; ++a)
        if (chance.unit() < Real(0.3)) d[a] *= chance.unit() < Real(0.5) ? 0 : chance.order(Real(1e-30), 1);
    if (d == Vec3(0)) d.z = -1;
    d /= std::max(std::abs(d.x), std::max(std::abs(d.y), std::abs(d.z)));  // so that its square is a number in float
    return glm::normalize(d) * chance.order(shortest, longest);
}
Bounds box_at(Chance& chance, const Vec3& middle, Real size) {
    Vec3 half;
    for (int a = 0; a < 3; ++a) half[a] = chance.unit() < Real(0.2) ? 0 : size * chance.unit();  // flat ones, too
    return {middle - half, middle + half};
}
Vec3 point_in(const Bounds& box, Chance& chance) {
    Vec3 p;
    for (int a = 0; a < 3; ++a) p[a] = box.min[a] + chance.unit() * (box.max[a] - box.min[a]);
    return p;
}

/// Rays from anywhere to a point in a box. In double: the ray's own rounding is far below what boxes are widened by.
void expect_none_missed(const std::string& name, Real offset, Real shortest, Real longest, Real farthest) {
    Chance chance(7);
    for (int n = 0; n < 100000; ++n) {
        const Bounds box = box_at(chance, offset * chance.direction() + chance.in_cube(3), chance.order(Real(1e-3), 3));
        const Vec3 d = any_direction(chance, shortest, longest);
        const Real length = glm::length(d), t = chance.order(Real(1e-3), farthest) / length;
        const Vec3 point = point_in(box, chance);
        const Ray ray{point - t * d, d};
        if (!(glm::length(ray.origin + t * d - point) <= Real(1e-8) * (1 + offset))) continue;  // rounded away
        const BoxRay box_ray(ray, {0, kInfinity});
        alignas(32) float enters[kWidth];
        ASSERT_EQ(box_ray.meets(all(box), enters), 0xffu) << name << ": " << text(ray, box);
        for (const float at : enters)
            ASSERT_LE(at, wide::above(t * (1 + Real(1e-6)))) << name << ": " << text(ray, box);
        // And up to there, as a walk asks that has found something in the box.
        BoxRay shorter(ray, {0, kInfinity});
        shorter.shorten(t * (1 + Real(1e-6)));
        ASSERT_EQ(shorter.meets(all(box)), 0xffu) << name << ", up to it: " << text(ray, box);
    }
}

TEST(BoxRay, MissesNoBoxThatTheRayMeets) {
    if (sizeof(Real) < sizeof(double)) GTEST_SKIP() << "the rays themselves are rounded";
    expect_none_missed("near", 0, 1, 1, 100);
    expect_none_missed("from afar", 0, 1, 1, 1e6);
    expect_none_missed("a million away", 1e6, 1, 1, 100);
    expect_none_missed("long and short directions", 0, Real(1e-6), 1e6, 100);
    expect_none_missed("beyond float", 0, Real(1e-48), Real(1e-36), 10);
    expect_none_missed("and at its end", 0, Real(1e-36), Real(1e-30), 10);
}

/// From where nothing is rounded but the direction and its inverse, to a corner: all planes there are at the same t.
TEST(BoxRay, MeetsCorners) {
    if (sizeof(Real) < sizeof(double)) GTEST_SKIP() << "the rays themselves are rounded";
    Chance chance(10);
    for (int n = 0; n < 100000; ++n) {
        // Corners that are floats, and boxes exactly as large.
        wide::FloatBox box;
        Vec3 corner;
        for (std::size_t a = 0; a < 3; ++a) {
            const auto one = static_cast<float>(chance.between(-4, 4)),
                       other = static_cast<float>(chance.between(-4, 4));
            box.lo[a] = std::min(one, other);
            box.hi[a] = std::max(one, other);
            corner[int(a)] = one;
        }
        Boxes boxes;
        for (std::size_t lane = 0; lane < kWidth; ++lane) boxes.set(lane, box);
        ASSERT_EQ(BoxRay({Vec3(0), glm::normalize(corner)}, {0, kInfinity}).meets(boxes), 0xffu) << n;
    }
}

/// A box beside the ray, by a thousandth of what coordinates are, is not met: not even by rays along an axis, whose
/// inverse is no number.
TEST(BoxRay, MeetsNoBoxBeside) {
    Chance chance(8);
    for (const Real offset : {Real(0), Real(1e4), Real(1e7)}) {
        int met = 0;
        for (int n = 0; n < 10000; ++n) {
            Vec3 d = chance.direction();
            const int across = int(chance.bits() % 3), other = (across + 1) % 3;
            if (n % 2 == 0) d[across] = 0;
            if (n % 4 == 0) d[other] = 0;
            if (d == Vec3(0)) continue;
            d = glm::normalize(d);
            // The box is moved out of the ray's way across it.
            const Vec3 aside = glm::normalize(glm::cross(d, chance.direction()));
            const Vec3 middle = offset * Vec3(1, -1, 1) + chance.in_cube(1);
            const Real size = Real(1e-3) * (1 + offset);
            const Bounds box{middle - Vec3(size / 4), middle + Vec3(size / 4)};
            met += BoxRay(Ray{middle + size * aside - chance.unit() * 10 * d, d}, {0, kInfinity}).meets(all(box)) != 0;
        }
        EXPECT_EQ(met, 0) << "boxes at " << offset;
    }
}

TEST(BoxRay, LooksNeitherBackNorBeyondTheEnd) {
    const Boxes box = all({Vec3(-1, -1, 4), Vec3(1, 1, 6)});
    const auto meets = [&](Real from, Vec3 d, Interval range) {
        return BoxRay({Vec3(0, 0, from), d}, range).meets(box);
    };
    EXPECT_EQ(meets(0, {0, 0, 1}, {0, kInfinity}), 0xffu);
    EXPECT_EQ(meets(0, {0, 0, -1}, {0, kInfinity}), 0u);
    EXPECT_EQ(meets(7, {0, 0, 1}, {0, kInfinity}), 0u);
    EXPECT_EQ(meets(7, {0, 0, -1}, {0, kInfinity}), 0xffu);
    EXPECT_EQ(meets(5, {0, 0, 1}, {0, kInfinity}), 0xffu) << "from inside";
    EXPECT_EQ(meets(0, {0, 0, 1}, {0, Real(3.9)}), 0u);
    EXPECT_EQ(meets(0, {0, 0, 1}, {Real(6.1), 100}), 0u);
    EXPECT_EQ(meets(0, {0, 0, 1}, {Real(5.9), 100}), 0xffu);
}

TEST(BoxRay, NobodyIsMetWhereNobodyIs) {
    Boxes nobody;
    for (std::size_t lane = 0; lane < kWidth; ++lane) nobody.set(lane, wide::FloatBox());
    Chance chance(9);
    for (int n = 0; n < 10000; ++n) {
        const Ray ray{chance.in_cube(1) * chance.order(1, Real(1e30)), any_direction(chance, Real(1e-3), 1e3)};
        ASSERT_EQ(BoxRay(ray, {0, kInfinity}).meets(nobody), 0u) << text(ray, {});
    }
}

}  // namespace
}  // namespace rays::tests
