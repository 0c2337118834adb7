// Lanes do what single numbers do, for numbers of every kind.
#include <algorithm>
#include <limits>

#include "eight.h"
#include "packets/lanes.h"

namespace rays::packets::tests {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr Lanes<double> kAwkward{0.0, -0.0, 1.5, -2.5, kInf, -kInf, kNan, 5e-324};

/// Every awkward number with every other: what(a, b) for eight pairs at a time.
template <class What>
void each_pairing(What what) {
    for (std::size_t shift = 0; shift < kLanes; ++shift) {
        Lanes<double> other;
        for (std::size_t i = 0; i < kLanes; ++i) other[i] = kAwkward[(i + shift) % kLanes];
        what(kAwkward, other);
    }
}

template <class Expected>
void expect_lanes(const char* what, Reals got, Expected expected) {
    const Spread lanes(got);
    for (std::size_t i = 0; i < kLanes; ++i)
        EXPECT_TRUE(same(lanes[int(i)], expected(i)))
            << what << ", lane " << i << ": " << lanes[int(i)] << " instead of " << expected(i);
}

template <class Expected>
void expect_mask(const char* what, Mask got, Expected expected) {
    for (std::size_t i = 0; i < kLanes; ++i)
        EXPECT_EQ(got.bits() >> i & 1, unsigned{expected(i)}) << what << ", lane " << i;
}

TEST(Masks, AreTheirBits) {
    for (unsigned bits = 0; bits <= kAllLanes; ++bits) {
        EXPECT_EQ(Mask::of(bits).bits(), bits);
        EXPECT_EQ(Mask::of(bits).any(), bits != 0);
        EXPECT_EQ(widen(narrow(Mask::of(bits))).bits(), bits) << "through floats and back";
        const unsigned other = bits * 37 & kAllLanes;
        EXPECT_EQ((Mask::of(bits) & Mask::of(other)).bits(), bits & other);
        EXPECT_EQ((Mask::of(bits) | Mask::of(other)).bits(), bits | other);
        EXPECT_EQ((Mask::of(bits) - Mask::of(other)).bits(), bits & ~other);
    }
}

TEST(Masks, SelectLaneByLane) {
    const Reals yes = together({1, 2, 3, 4, 5, 6, 7, 8}), no = together({-1, -2, -3, -4, -5, -6, -7, -8});
    const Floats yes_in_float(yes), no_in_float(no);
    for (unsigned bits = 0; bits <= kAllLanes; ++bits) {
        const auto expected = [&](std::size_t i) { return (bits >> i & 1 ? 1.0 : -1.0) * double(i + 1); };
        expect_lanes("doubles", select(Mask::of(bits), yes, no), expected);
        alignas(32) float floats[kLanes];
        select(Mask::of(bits), yes_in_float, no_in_float).store(floats);
        for (std::size_t i = 0; i < kLanes; ++i) EXPECT_EQ(floats[i], float(expected(i))) << bits;
    }
}

TEST(Lanes, CompareAsSingleNumbersNanIncluded) {
    each_pairing([](const Lanes<double>& a, const Lanes<double>& b) {
        const Reals x = together(a), y = together(b);
        expect_mask("<", x < y, [&](std::size_t i) { return a[i] < b[i]; });
        expect_mask(">", x > y, [&](std::size_t i) { return a[i] > b[i]; });
        expect_mask("<=", x <= y, [&](std::size_t i) { return a[i] <= b[i]; });
        expect_mask(">=", x >= y, [&](std::size_t i) { return a[i] >= b[i]; });
        expect_mask("==", x == y, [&](std::size_t i) { return a[i] == b[i]; });
    });
}

TEST(Lanes, CalculateAsSingleNumbers) {
    each_pairing([](const Lanes<double>& a, const Lanes<double>& b) {
        const Reals x = together(a), y = together(b);
        expect_lanes("+", x + y, [&](std::size_t i) { return a[i] + b[i]; });
        expect_lanes("-", x - y, [&](std::size_t i) { return a[i] - b[i]; });
        expect_lanes("*", x * y, [&](std::size_t i) { return a[i] * b[i]; });
        expect_lanes("/", x / y, [&](std::size_t i) { return a[i] / b[i]; });
        expect_lanes("negative", -x, [&](std::size_t i) { return -a[i]; });
        expect_lanes("abs", abs(x), [&](std::size_t i) { return std::abs(a[i]); });
        expect_lanes("floor", floor(x * Reals(0.7)), [&](std::size_t i) { return std::floor(a[i] * 0.7); });
        expect_lanes("sqrt", sqrt(x), [&](std::size_t i) { return std::sqrt(a[i]); });
        expect_lanes("copysign", copysign(x, y), [&](std::size_t i) { return std::copysign(a[i], b[i]); });
        expect_lanes("fma", fma(x, y, x), [&](std::size_t i) { return std::fma(a[i], b[i], a[i]); });
    });
}

TEST(Lanes, MultiplyAndAddWithOneRounding) {
    // (1 + e)(1 - e) - 1 = -e^2: rounded twice it is 0.
    const double e = 0x1p-30;
    expect_lanes("fma", fma(1 + e, 1 - e, -1), [&](std::size_t) { return -e * e; });
    expect_lanes("two roundings", Reals(1 + e) * Reals(1 - e) + Reals(-1), [](std::size_t) { return 0.0; });
}

TEST(Lanes, AreFilledFromAnywhereAndEmptiedIntoIt) {
    const auto expected = [](std::size_t i) { return double(i) + 1; };
    double room[kLanes + 1] = {-1, 1, 2, 3, 4, 5, 6, 7, 8}, copy[kLanes + 1] = {};
    const Reals loaded = Reals::load_anywhere(room + 1);
    expect_lanes("loaded", loaded, expected);
    loaded.store_anywhere(copy + 1);
    for (std::size_t i = 0; i < kLanes; ++i) EXPECT_EQ(copy[i + 1], expected(i));
    EXPECT_EQ(copy[0], 0);
    expect_lanes("named", Reals(1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0), expected);
    expect_lanes("whole", Reals(_mm256_setr_epi32(1, 2, 3, 4, 5, 6, 7, 8)), expected);
    expect_lanes("halves", Reals(loaded.first_four(), loaded.last_four()), expected);
}

TEST(Lanes, TakeTheFirstOfEqualsAsTheStandardLibraryDoes) {
    each_pairing([](const Lanes<double>& a, const Lanes<double>& b) {
        expect_lanes("max", max(together(a), together(b)), [&](std::size_t i) { return std::max(a[i], b[i]); });
        expect_lanes("min", min(together(a), together(b)), [&](std::size_t i) { return std::min(a[i], b[i]); });
    });
}

TEST(Lanes, FloatsAreRoundedAsCastsAreAndStayInTheirLanes) {
    const Lanes<double> values{0.1, -0.1, 1e-50, 1e50, 16777217, 1 + 0x1p-24, 1 + 0x1.8p-24, -7};
    alignas(32) float floats[kLanes];
    Floats(together(values)).store(floats);
    for (std::size_t i = 0; i < kLanes; ++i) EXPECT_EQ(floats[i], static_cast<float>(values[i])) << "lane " << i;
}

TEST(Lanes, ColoursAreBlackWhereAllThreeAreNothing) {
    const Floats some(together({0, 1, 0, 0, -0.0, kNan, 0, -1})), none(0.0f);
    const unsigned seen = 1u << 1 | 1u << 5 | 1u << 7;  // a NaN is not black, as in Radiance::is_black
    EXPECT_EQ(is_not_black({some, none, none}).bits(), seen);
    EXPECT_EQ(is_not_black({none, some, none}).bits(), seen);
    EXPECT_EQ(is_not_black({none, none, some}).bits(), seen);
}

}  // namespace
}  // namespace rays::packets::tests
