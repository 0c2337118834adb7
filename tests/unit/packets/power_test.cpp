// Powers of eight numbers at once.
#include <limits>
#include <random>

#include "eight.h"
#include "packets/shading.h"

namespace rays::packets::tests {
namespace {

/// In units of the last place of `b`.
double ulps_between(double a, double b) { return std::abs(a - b) / (std::nextafter(std::abs(b), std::numeric_limits<double>::infinity()) - std::abs(b)); }

TEST(Power, IsThatOfSingleNumbersToFiveUnitsInTheLastPlace) {
    // libmvec promises 4 units, the scalar function less than 1.
    std::mt19937_64 bits(1);
    const auto unit = [&] { return double(bits() >> 11) * 0x1p-53; };
    int asked = 0, floats_differ = 0;
    for (int n = 0; n < 20'000; ++n) {
        const double exponent = n % 3 == 0   ? std::exp(16 * unit() - 8)
                                : n % 3 == 1 ? double(bits() % 200)
                                             : 1 / (0.001 + unit());
        Lanes<double> base;
        for (double& x : base)
            x = n % 2 ? unit() + 1e-300 : 1 - 0.01 * unit();  // cosines near 1 are what highlights ask
        const unsigned lanes = n % 4 ? kAllLanes : unsigned(bits()) & kAllLanes;
        const Spread got(power(Mask::of(lanes), together(base), exponent));
        for (std::size_t i = 0; i < kLanes; ++i) {
            if (!(lanes >> i & 1)) {
                EXPECT_EQ(got[int(i)], 1) << "a lane that is not asked";
                continue;
            }
            const double truth = std::pow(base[i], exponent);
            if (truth < 1e-290) {  // units in the last place lose their meaning
                EXPECT_NEAR(got[int(i)], truth, 1e-290);
                continue;
            }
            ASSERT_LE(ulps_between(got[int(i)], truth), 5) << base[i] << " to the " << exponent;
            ++asked;
            floats_differ += float(got[int(i)]) != float(truth);
        }
    }
    EXPECT_GT(asked, 50'000);
    EXPECT_LE(floats_differ, 1) << "of " << asked << ": as floats, the last bits of doubles are hardly ever seen";
}

}  // namespace
}  // namespace rays::packets::tests
