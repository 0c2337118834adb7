// Known numbers of one smooth surface: reflectances, critical and Brewster angles, hemispherical means, reciprocity.
#include <gtest/gtest.h>

#include <cmath>

#include "3_recursion/recursion.h"
#include "core/vec.h"

namespace rays::tests {
namespace {

constexpr bool kDouble = sizeof(Real) == 8;

Real radians(double degrees) { return Real(degrees * 3.14159265358979323846 / 180); }

struct Glass {
    double ior, straight_on, critical_deg, brewster_deg, outside, inside;
};
/// Reflectance straight on, critical angle, Brewster's angle, mean over the hemisphere from outside and inside.
const Glass kGlasses[] = {{1.5, 0.0400, 41.8103, 56.3099, 0.09178, 0.59635},
                          {1.5168, 0.042165, 41.2452, 56.6038, 0.09424, 0.60631},
                          {1.333, 0.020373, 48.6066, 53.1232, 0.06641, 0.47459}};

class OfGlass : public testing::TestWithParam<Glass> {};

TEST_P(OfGlass, StraightOn) {
    const Glass& g = GetParam();
    EXPECT_NEAR(fresnel(1, Real(g.ior)), g.straight_on, 5e-7);  // the table's last digit
    EXPECT_NEAR(schlick(1, Real(g.ior)), g.straight_on, 5e-7);
    EXPECT_NEAR(fresnel(1, Real(1 / g.ior)), g.straight_on, 5e-7);
}

TEST_P(OfGlass, CriticalAngleByBisection) {
    const Glass& g = GetParam();
    double low = 0, high = 90;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        const Vec3 in(std::sin(radians(middle)), 0, std::cos(radians(middle)));
        (refract(in, {0, 0, -1}, Real(1 / g.ior)) ? low : high) = middle;
    }
    EXPECT_NEAR(low, g.critical_deg, 5.1e-5);
    EXPECT_NEAR(low, std::asin(1 / g.ior) * 180 / 3.14159265358979323846, kDouble ? 1e-10 : 1e-3);
}

TEST_P(OfGlass, BrewstersAngleReflectsOnePolarisation) {
    const Glass& g = GetParam();
    const double brewster = std::atan(g.ior);
    EXPECT_NEAR(brewster * 180 / 3.14159265358979323846, g.brewster_deg, 5.1e-5);
    // r_p vanishes, r_s is cos(2 angle): half of its square is left.
    const double truth = 0.5 * std::pow(std::cos(2 * brewster), 2);
    EXPECT_NEAR(fresnel(Real(std::cos(brewster)), Real(g.ior)), truth, kDouble ? 1e-14 : 1e-6);
}

/// Twice the integral of F(c) c over the cosine: by Simpson's rule, in sqrt(1 - c) to tame the critical angle.
double hemispherical(double ior, double from, double to) {
    const int steps = 4000;
    double sum = 0;
    for (int i = 0; i <= steps; ++i) {
        const double c = from + (to - from) * i / steps;
        sum += (i == 0 || i == steps ? 1 : i % 2 ? 4 : 2) * 2 * c * double(fresnel(Real(c), Real(ior)));
    }
    return sum * (to - from) / steps / 3;
}

TEST_P(OfGlass, MeanOverTheHemisphere) {
    const Glass& g = GetParam();
    const double outside = hemispherical(g.ior, 0, 1);
    EXPECT_NEAR(outside, g.outside, 1e-5);
    // From inside: total reflection up to the critical cosine, whose part of the integral is its square.
    const double critical = std::sqrt(1 - 1 / (g.ior * g.ior));
    const double inside = critical * critical + hemispherical(1 / g.ior, critical, 1);
    EXPECT_NEAR(inside, g.inside, 3e-5);  // Simpson's rule meets a root at the critical angle
    EXPECT_NEAR(inside, 1 - (1 - outside) / (g.ior * g.ior), 3e-5) << "the same light both ways";
}

TEST_P(OfGlass, TheSameBothWays) {
    const Glass& g = GetParam();
    for (const double degrees : {0.0, 10.0, 45.0, 70.0, 85.0, 89.9}) {
        const Vec3 in(std::sin(radians(degrees)), 0, std::cos(radians(degrees)));
        const auto inner = refract(in, {0, 0, -1}, Real(g.ior));
        ASSERT_TRUE(inner);
        const auto out = refract(-*inner, {0, 0, 1}, Real(1 / g.ior));
        ASSERT_TRUE(out);
        EXPECT_LT(glm::length(*out + in), kDouble ? 1e-13 : 1e-3) << degrees;
        EXPECT_NEAR(fresnel(in.z, Real(g.ior)), fresnel(inner->z, Real(1 / g.ior)), kDouble ? 1e-12 : 1e-3) << degrees;
    }
}

INSTANTIATE_TEST_SUITE_P(Table, OfGlass, testing::ValuesIn(kGlasses));

TEST(Surfaces, AnIndexOfExactlyOneIsNoSurface) {
    for (const double degrees : {0.0, 30.0, 60.0, 89.0, 89.999999}) {
        const Vec3 in(std::sin(radians(degrees)), 0, std::cos(radians(degrees)));
        const auto through = refract(in, {0, 0, -1}, 1);
        ASSERT_TRUE(through) << degrees;
        EXPECT_LT(glm::length(*through - in), kDouble ? 2e-15 : 1e-6) << degrees;
        EXPECT_NEAR(fresnel(in.z, 1), 0, 1e-15) << degrees;
    }
}

TEST(Surfaces, SchlicksErrorForGlass) {
    // +0.036 at a cosine of 0.088, -0.020 at 0.464; from inside with the incident cosine it would be 0.96.
    EXPECT_NEAR(schlick(Real(0.088), Real(1.5)) - fresnel(Real(0.088), Real(1.5)), 0.036, 5e-4);
    EXPECT_NEAR(schlick(Real(0.464), Real(1.5)) - fresnel(Real(0.464), Real(1.5)), -0.020, 5e-4);
    for (int i = 0; i <= 1000; ++i) {
        const Real c = Real(i) / 1000;
        EXPECT_LT(std::abs(schlick(c, Real(1.5)) - fresnel(c, Real(1.5))), 0.0361) << c;
        EXPECT_LT(std::abs(schlick(c, Real(1 / 1.5)) - fresnel(c, Real(1 / 1.5))), 0.0361) << c;
    }
}

TEST(Surfaces, ACornerOfMirrorsSendsBack) {
    const Vec3 in = glm::normalize(Vec3(-0.3, 0.7, -0.5));
    Vec3 d = in;
    for (Vec3 n : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) d = reflect(d, glm::dot(d, n) > 0 ? -n : n);
    EXPECT_LT(glm::length(d + in), kDouble ? 1e-15 : 1e-6);
}

TEST(Surfaces, AThousandBouncesKeepTheLength) {
    Vec3 d = glm::normalize(Vec3(0.2, -0.9, 0.4));
    for (int i = 0; i < 1000; ++i) {
        const Vec3 n = glm::normalize(Vec3(std::sin(Real(i)), std::cos(Real(3 * i)), Real(0.5)));
        d = reflect(d, glm::dot(d, n) > 0 ? -n : n);
        ASSERT_NEAR(glm::length(d), 1, kDouble ? 5e-16 : 3e-7) << i;
    }
}

TEST(Surfaces, AbsorptionIsMultiplicativeAndScales) {
    Interior glass;
    glass.fade_distance = 2;
    glass.fade_power = 1001;
    glass.fade_color = {0.2f, 0.5f, 1.0f};
    for (const double d : {0.1, 1.0, 7.0}) {
        const Radiance once = absorption(glass, Real(d)), twice = absorption(glass, Real(2 * d));
        EXPECT_NEAR(once[0], std::exp(-0.8 * d / 2), 1e-6);
        EXPECT_NEAR(twice[0], once[0] * once[0], 1e-6);
        EXPECT_EQ(twice[2], 1) << "white takes nothing";
        Interior larger = glass;
        larger.fade_distance *= 8;
        EXPECT_EQ(absorption(larger, Real(8 * d))[1], once[1]) << "a scene of another size, the same glass";
    }
    EXPECT_EQ(absorption(glass, Real(1e30))[0], 0);
    EXPECT_EQ(absorption(glass, 0)[0], 1);
}

}  // namespace
}  // namespace rays::tests
