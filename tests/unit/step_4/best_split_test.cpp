// Which plane parts things best, held against trying all of them one by one in double.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "4_partitioning/beyond/best_split.h"
#include "chance.h"

namespace rays::tests {
namespace {

using namespace wide;

struct Thing {
    FloatBox box;
    LeafKind kind;
    Item item() const { return {box, 7, kind}; }
    double center(int a) const { return double(box.lo[a]) + double(box.hi[a]); }
};

float cost_of(LeafKind kind) { return kind == LeafKind::cones ? 0.5f : 0.3f; }

double area(const std::vector<Thing>& things) {
    double lo[3] = {1e300, 1e300, 1e300}, hi[3] = {-1e300, -1e300, -1e300};
    for (const Thing& t : things)
        for (int a = 0; a < 3; ++a)
            lo[a] = std::min(lo[a], double(t.box.lo[a])), hi[a] = std::max(hi[a], double(t.box.hi[a]));
    const double x = hi[0] - lo[0], y = hi[1] - lo[1], z = hi[2] - lo[2];
    return x * y + y * z + z * x;
}
double cost(const std::vector<Thing>& side) {
    double sum = 0;
    for (const Thing& t : side) sum += cost_of(t.kind);
    return sum * area(side);
}
/// Of parting them where `is_before` says; nothing on one side is no split.
template <class IsBefore>
double cost(const std::vector<Thing>& things, const IsBefore& is_before) {
    std::vector<Thing> before, behind;
    for (const Thing& t : things) (is_before(t) ? before : behind).push_back(t);
    return before.empty() || behind.empty() ? INFINITY : cost(before) + cost(behind);
}

Corners centers_of(const std::vector<Thing>& things) {
    Corners centers;
    for (const Thing& t : things) centers.add(t.item().center());
    return centers;
}
std::vector<Item> items_of(const std::vector<Thing>& things) {
    std::vector<Item> items;
    for (const Thing& t : things) items.push_back(t.item());
    return items;
}

std::vector<Thing> some(Chance& chance, int count, const Vec3& extent, Real size) {
    std::vector<Thing> things;
    for (int i = 0; i < count; ++i) {
        Thing t{{}, chance.unit() < Real(0.5) ? LeafKind::cones : LeafKind::spheres};
        for (int a = 0; a < 3; ++a) {
            const Real at = extent[a] * (chance.unit() - Real(0.5)), half = size * chance.unit();
            t.box.lo[a] = static_cast<float>(at - half);
            t.box.hi[a] = static_cast<float>(at + half);
        }
        things.push_back(t);
    }
    return things;
}

TEST(BestSplit, IsTheBestOfAllPlanesBetweenBins) {
    Chance chance(31);
    for (int round = 0; round < 300; ++round) {
        const int count = round % 3 == 0 ? 600 : 2 + round % 40, bins = count < 512 ? 16 : 32;
        const Vec3 extent(1, chance.order(Real(1e-3), 10), round % 5 == 0 ? 0 : 1);
        const auto things = some(chance, count, extent, Real(0.05));
        const Bins sorted(centers_of(things), static_cast<std::uint32_t>(count));
        const Split best = sorted.best_split(items_of(things), cost_of);
        ASSERT_GE(best.axis, 0) << "round " << round;
        const double reached = cost(things, [&](const Thing& t) { return sorted.is_before(best, t.item()); });
        EXPECT_NEAR(best.cost, reached, 1e-5 * reached) << "round " << round;
        for (int a = 0; a < 3; ++a) {
            double lo = INFINITY, hi = -INFINITY;
            for (const Thing& t : things) lo = std::min(lo, t.center(a)), hi = std::max(hi, t.center(a));
            for (int plane = 1; plane < bins; ++plane) {
                const double at = lo + (hi - lo) * plane / bins;
                const double other = cost(things, [&](const Thing& t) { return t.center(a) < at; });
                // What lies on a plane may be on either side of it, for rounding.
                const bool on_a_plane = std::any_of(things.begin(), things.end(), [&](const Thing& t) {
                    return std::abs(t.center(a) - at) < 1e-6 * (hi - lo);
                });
                if (on_a_plane) continue;
                ASSERT_LE(reached, other * (1 + 1e-5)) << "round " << round << ", axis " << a;
            }
        }
    }
}

TEST(BestSplit, IsNoneWhereAllCentresCoincideOrLieBeyondFloat) {
    Chance chance(32);
    const auto split_of = [](const std::vector<Thing>& things) {
        return Bins(centers_of(things), static_cast<std::uint32_t>(things.size()))
            .best_split(items_of(things), cost_of);
    };
    std::vector<Thing> same = some(chance, 1, Vec3(0), Real(0.5));
    same.resize(20, same[0]);
    EXPECT_EQ(split_of(same).axis, -1);
    std::vector<Thing> far = same;
    for (int i = 0; i < 20; ++i) far[static_cast<std::size_t>(i)].box.hi = {i % 2 ? 3e38f : 1, i % 2 ? 1 : -3e38f, 1};
    far[3].box.lo = {3e38f, 3e38f, 0};
    const Split split = split_of(far);
    EXPECT_TRUE(split.axis == -1 || std::isfinite(split.cost)) << split.axis << " " << split.cost;
}

TEST(BestSplit, ThingsKeepTheirNumberAndKind) {
    for (const LeafKind kind : {LeafKind::list, LeafKind::triangles, LeafKind::spheres, LeafKind::cones})
        for (const std::uint32_t number : {0u, 1u, 0x7f800001u, 0xffffffffu}) {  // NaNs and denormals among them
            Item a({}, number, kind), b({}, 5, LeafKind::list);
            std::swap(a, b);
            EXPECT_EQ(b.primitive(), number);
            EXPECT_EQ(b.kind(), kind);
        }
}

}  // namespace
}  // namespace rays::tests
