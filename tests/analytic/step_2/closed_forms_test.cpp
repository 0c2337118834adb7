// Known answers of whole pictures and shapes: Lambert's phase law, the widths of highlights, the umbra of a sphere, the
// inverse square, superposition.
#include <gtest/gtest.h>

#include <limits>

#include "stage.h"

namespace rays::tests {
namespace {

Illumination white_from(const Vec3& l) { return {l, 1, Radiance(1.0f)}; }

// A white Lambert sphere far away, lit at phase angle a: its disc has the mean (2/3) kd (sin a + (pi - a) cos a) / pi.
TEST(ClosedForms, LambertsPhaseLaw) {
    const Scene scene = staged(ball("ambient 0 diffuse 0.7"));
    const int rows = 400;
    for (const double phase : {0.0, 0.5, 1.0, 1.5707963267948966, 2.4, 3.0}) {
        const Vec3 l(std::sin(phase), 0, -std::cos(phase));
        double sum = 0;
        for (int i = 0; i < rows; ++i)
            for (int j = 0; j < rows; ++j) {
                const Real x = (i + Real(0.5)) * 2 / rows - 1, y = (j + Real(0.5)) * 2 / rows - 1;
                if (x * x + y * y >= 1) continue;
                Surface surface = surface_of(scene, Vec3(0), {x, y, -std::sqrt(1 - x * x - y * y)}, {0, 0, -1});
                surface.color = Radiance(1.0f);
                sum += diffuse(surface, white_from(l))[0];
            }
        const double pi = 3.14159265358979324;
        const double mean = sum * 4 / (rows * rows) / pi;
        const double truth = 2.0 / 3 * 0.7 * (std::sin(phase) + (pi - phase) * std::cos(phase)) / pi;
        // 160000 midpoints: the grid's own error is below 2e-4 (halving the rows multiplies it by three).
        EXPECT_NEAR(mean, truth, 2e-4) << phase;
    }
}

/// Where the highlight falls to half, as an angle of `tilt(angle)`: by bisection.
template <class Highlight>
double half_width(Highlight highlight) {
    double low = 0, high = 1.2;
    for (int i = 0; i < 60; ++i) ((highlight((low + high) / 2) > 0.5) ? low : high) = (low + high) / 2;
    return low;
}

TEST(ClosedForms, WidthsOfHighlights) {
    for (const int exponent : {5, 20, 80, 320, 2000}) {
        const Scene scene = staged(ball("ambient 0 diffuse 0 phong 1 phong_size " + std::to_string(exponent) +
                                        " specular 1 roughness 1/" + std::to_string(exponent)));
        const Vec3 up(0, 1, 0);
        const Surface surface = surface_of(scene, up, up, up);
        // Seen along the normal, light at an angle has the mirror direction as far, and the half vector half as far
        // away.
        const auto light_at = [](double angle) {
            return white_from({Real(std::sin(angle)), Real(std::cos(angle)), 0});
        };
        const double width = std::acos(std::exp2(-1.0 / exponent));
        const double phong_width = half_width([&](double a) { return phong(surface, light_at(a))[0]; });
        const double blinn_width = half_width([&](double a) { return blinn(surface, light_at(a))[0]; });
        // Radiance is float: the half is found to 6e-8, which is 6e-8 / (m tan(width)) radians of it; the cosine is
        // rounded a few times on its way, and 1 / sin(width) turns that into an angle.
        const double rounding = 8 * double(std::numeric_limits<Real>::epsilon()) / std::sin(width);
        const double tolerance = 3e-7 / (exponent * std::tan(width)) + rounding + 1e-9;
        EXPECT_NEAR(phong_width, width, tolerance) << exponent;
        EXPECT_NEAR(blinn_width, 2 * width, 2 * tolerance) << exponent;
    }
}

TEST(ClosedForms, UmbraOfASphere) {
    const double r = 0.8, h = 1.7, top = 5.3;
    const Scene scene = staged(
        "plane { y, 0 pigment { rgb 1 } }\n"
        "sphere { <0, 1.7, 0>, 0.8 pigment { rgb 1 } }\n"
        "light_source { <0, 5.3, 0>, rgb 1 }\n");
    const BruteForce intersector(scene);
    const auto dark = [&](double x) {
        Surface surface;
        surface.point = {Real(x), 0, 0};
        surface.normal = {0, 1, 0};
        return in_shadow(intersector, surface, illuminate(scene.lights[0], surface.point));
    };
    ASSERT_TRUE(dark(0));
    ASSERT_FALSE(dark(4));
    double low = 0, high = 4;
    for (int i = 0; i < 50; ++i) (dark((low + high) / 2) ? low : high) = (low + high) / 2;
    const double truth = top * std::tan(std::asin(r / (top - h)));
    // A tangent ray sees a double root, found to the square root of the rounding of its discriminant.
    EXPECT_NEAR(low, truth, sizeof(Real) == 8 ? 1e-12 * truth + 1e-9 : 1e-4);
    EXPECT_GT(std::abs(truth - r * top / (top - h)), 0.01) << "the tempting r H / (H - h) is another number";
}

TEST(ClosedForms, InverseSquareFarBeyondFadeDistance) {
    const Scene scene = staged("light_source { 0, rgb 5e5 fade_distance 0.001 fade_power 2 }\n");
    const float one = illuminate(scene.lights[0], {1, 0, 0}).radiance[0];
    EXPECT_NEAR(one, 1, 2e-6);  // 5e5 * 2e-6 / (1 + 1e-6)
    for (const int d : {2, 4, 8, 16}) {
        const float there = illuminate(scene.lights[0], {0, Real(d), 0}).radiance[0];
        EXPECT_NEAR(there * d * d, one, 2e-6) << d;
    }
}

TEST(ClosedForms, LightAddsUp) {
    const std::string finish = ball("ambient 0.2 emission 0.1 diffuse 0.5 phong 0.4 phong_size 9 specular 0.3");
    const std::string first = "light_source { <4, 7, -2>, rgb <0.9, 0.5, 0.1> }\n";
    const std::string second = "light_source { <-3, 5, -6>, rgb <0.2, 0.4, 0.8> fade_distance 4 fade_power 2 }\n";
    const Vec3 n = glm::normalize(Vec3(0.1, 1, -0.3)), v = glm::normalize(Vec3(0.5, 0.8, -0.4));
    const auto seen = [&](const std::string& lights) {
        const Scene scene = staged(finish + lights);
        const BruteForce intersector(scene);
        return direct_light(scene, scene.lights, OpaqueShadows(intersector), surface_of(scene, n, n, v));
    };
    const Radiance none = seen("");
    expect_near(seen(first + second), seen(first) + seen(second) - none, 3e-7);
    EXPECT_GT(seen(first)[0], none[0]);
    EXPECT_GT(seen(second)[2], none[2]);
}

TEST(ClosedForms, AmbientLightIsFlatAndKnowsNoShadow) {
    const Scene scene = staged(ball("ambient 0.3 diffuse 0.5") +
                               "sphere { <0, 3, 0>, 1 pigment { rgb 1 } }\n"
                               "light_source { <0, 9, 0>, rgb 1 }\n");
    const BruteForce intersector(scene);
    const Radiance truth = 0.3f * Radiance(0.8f, 0.4f, 0.2f);
    for (const Vec3& n : {Vec3(0, 1, 0), Vec3(0, -1, 0), glm::normalize(Vec3(1, -2, 3))})
        expect_near(direct_light(scene, scene.lights, OpaqueShadows(intersector), surface_of(scene, n, n, n)), truth,
                    1e-7);
}

}  // namespace
}  // namespace rays::tests
