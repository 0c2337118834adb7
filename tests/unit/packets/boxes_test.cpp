// What boxes see of eight rays: whoever meets a box is never left out, and hardly anybody else is asked.
#include <random>

#include "eight.h"
#include "packets/beam.h"
#include "packets/spray.h"

namespace rays::packets::tests {
namespace {

const Span kAhead{Reals(1e-3), Reals(1e7)};

/// Boxes of many sizes, some of them thin, and rays that are aimed at them from near and far.
class Range {
public:
    double number(double from, double to) { return std::uniform_real_distribution(from, to)(random_); }
    bool coin() { return number(0, 1) < 0.5; }

    /// The last two places are empty.
    wide::Node node() {
        wide::Node node;
        const double size = std::pow(10, number(-2, 4));
        for (std::size_t i = 0; i < wide::kWidth; ++i) {
            wide::FloatBox box;
            for (std::size_t a = 0; a < 3 && i < kBoxes; ++a) {
                box.lo[a] = static_cast<float>(number(-size, size));
                box.hi[a] = box.lo[a] + static_cast<float>(number(0, coin() ? size : 1e-3 * size));
            }
            node.set(i, box);
        }
        return node;
    }
    unsigned box() { return static_cast<unsigned>(number(0, kBoxes)); }

    /// On a side of the box, an edge or a corner.
    Vec3 point_of(const wide::Node& node, unsigned box) {
        Vec3 point;
        const int side = static_cast<int>(number(0, 3));
        for (int a = 0; a < 3; ++a) {
            const double lo = node.lo(a)[box], hi = node.hi(a)[box];
            point[a] = a == side || coin() ? (coin() ? lo : hi) : number(lo, hi);
        }
        return point;
    }
    /// Now and then in a coordinate plane, or along an axis.
    Vec3 direction() {
        Vec3 d(number(-1, 1), number(-1, 1), number(-1, 1));
        for (int a = 0; a < 2; ++a)
            if (number(0, 1) < 0.2) d[a] = coin() ? 0.0 : -0.0;
        return glm::normalize(d);
    }

private:
    static constexpr unsigned kBoxes = 6;
    std::mt19937_64 random_{29};
};

/// Eight rays for a beam have one direction, those for a spray eight.
template <class Front>
constexpr bool kOneWay = std::is_same_v<Front, Beam>;

template <class Front>
Front front_of(const Rays& rays) {
    auto front = [&] {
        if constexpr (kOneWay<Front>)
            return Beam(rays, Mask::of(kAllLanes), Directions(rays.direction).way(0), kAhead);
        else
            return Spray(rays, Mask::of(kAllLanes), kAhead);
    }();
    front.leave_out(Mask::of(0));  // sprays look anew only when something has changed
    return front;
}

template <class Front>
class BoxesSee : public testing::Test {};
using Fronts = testing::Types<Beam, Spray>;
TYPED_TEST_SUITE(BoxesSee, Fronts);

TYPED_TEST(BoxesSee, EverybodyWhoMeetsThem) {
    Range range;
    for (int n = 0; n < 20'000; ++n) {
        const wide::Node node = range.node();
        const unsigned box = range.box();
        const double way = std::pow(10, range.number(-1, 5));
        Vec3 direction = range.direction();
        Lanes<Ray> rays;
        for (Ray& ray : rays) {
            if (!kOneWay<TypeParam>) direction = range.direction();
            ray = {range.point_of(node, box) - way * direction, direction};
        }
        const TypeParam front = front_of<TypeParam>(together(rays));
        ASSERT_EQ(front.rays_that_meet(node, box), kAllLanes) << n;
        alignas(32) float enters[wide::kWidth];
        ASSERT_TRUE(front.meets(node, enters) >> box & 1) << n;
        ASSERT_LE(enters[box], way * (1 + 1e-6)) << n;
        ASSERT_EQ(front.meets(node, enters) >> 6, 0u) << "an empty place is met by nobody";
    }
}

/// By a margin of a thousandth of what rounding may depend on.
bool misses(const Ray& ray, const wide::Node& node, unsigned box) {
    double enter = 1e-3, leave = 1e7;
    for (int a = 0; a < 3; ++a) {
        const double margin = 1e-3 * (std::abs(ray.origin[a]) + std::abs(node.lo(a)[box]) + std::abs(node.hi(a)[box]));
        const double lo = (node.lo(a)[box] - margin - ray.origin[a]) / ray.direction[a];
        const double hi = (node.hi(a)[box] + margin - ray.origin[a]) / ray.direction[a];
        if (std::isnan(lo) || std::isnan(hi)) continue;
        enter = std::max(enter, std::min(lo, hi));
        leave = std::min(leave, std::max(lo, hi));
    }
    return enter > leave;
}

TYPED_TEST(BoxesSee, NobodyElse) {
    Range range;
    int missing = 0;
    for (int n = 0; n < 20'000; ++n) {
        const wide::Node node = range.node();
        const unsigned aimed_at = range.box(), box = range.box();
        Vec3 direction = range.direction();
        Lanes<Ray> rays;
        for (Ray& ray : rays) {
            if (!kOneWay<TypeParam>) direction = range.direction();
            ray = {range.point_of(node, aimed_at) - range.number(1, 100) * direction, direction};
        }
        const TypeParam front = front_of<TypeParam>(together(rays));
        const unsigned met = front.rays_that_meet(node, box);
        alignas(32) float enters[wide::kWidth];
        if (met != 0) {
            ASSERT_TRUE(front.meets(node, enters) >> box & 1) << n;
            ASSERT_FALSE(enters[box] > front.far_end()) << n << ": the walk would pass over it";
        } else if (!kOneWay<TypeParam>) {
            ASSERT_FALSE(front.meets(node, enters) >> box & 1) << n << ": a spray knows without being asked again";
        }
        for (unsigned i = 0; i < kLanes; ++i) {
            if (!misses(rays[i], node, box)) continue;
            ++missing;
            ASSERT_FALSE(met >> i & 1) << n << ", lane " << i;
        }
    }
    EXPECT_GT(missing, 20'000);
}

}  // namespace
}  // namespace rays::packets::tests
