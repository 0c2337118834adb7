// A range lets roots through or not; it does not move them. Structures and lists of objects ask with other ranges, and
// must see the same bits.
#include <gtest/gtest.h>

#include "1_ray_casting/ray_casting.h"
#include "aim.h"

namespace rays {
namespace {

using test::Aim;

template <class Shape>
void expect_same_bits(const Shape& shape, const char* name) {
    Aim aim(7);
    int hits = 0;
    for (int i = 0; i < 20000; ++i) {
        const Ray ray = aim.through(aim.in_cube(1), i % 2 ? 0.5 : 20);
        const auto root = intersect(shape, ray, {0, kInfinity});
        if (!root) continue;
        ++hits;
        const Interval shorter{0, root->t * Real(1.001)};
        const auto again = intersect(shape, ray, shorter);
        ASSERT_TRUE(again) << name << ", ray " << i << ": missed in 0 to " << shorter.max;
        ASSERT_EQ(again->t, root->t) << name << ", ray " << i << ", range 0 to " << shorter.max;
        ASSERT_FALSE(intersect(shape, ray, {0, root->t}))
            << name << ", ray " << i << ": a root at the end of the range";
    }
    EXPECT_GT(hits, 1000) << name;
}

BicubicPatch waves() {
    BicubicPatch patch;
    for (int i = 0; i < 16; ++i)
        patch.control[std::size_t(i)] =
            Vec3(Real(i / 4) - Real(1.5), Real((i * 7) % 5) / 2 - 1, Real(i % 4) - Real(1.5));
    prepare(patch);
    return patch;
}

TEST(Range, ItsEndDoesNotMoveRoots) {
    expect_same_bits(Sphere{Vec3(0), 1}, "sphere");
    expect_same_bits(Torus{Real(0.8), Real(0.3)}, "torus");
    expect_same_bits(Torus{Real(0.5), Real(0.7)}, "torus that crosses itself");
    expect_same_bits(waves(), "patch");
}

}  // namespace
}  // namespace rays
