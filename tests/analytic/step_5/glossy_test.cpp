// Rough surfaces: where the mirrored rays go in the mean, and that none of them is lost.
#include <fmt/format.h>

#include "5_distributed/distributed.h"
#include "replicas.h"

namespace rays::tests {
namespace {

// The normal's tilt a has cos a = (1 - u)^(1 / (m + 2)), so p(c) = (m + 2) c^(m + 1) on [0, 1]. A ray that comes along
// the true normal leaves at 2 a, whose cosine is 2 c^2 - 1: its mean is 2 (m + 2) / (m + 4) - 1 = m / (m + 4). Below c
// = 1 / sqrt 2 the ray would go below the surface, and is mirrored up: to the mean comes twice the integral of 1 - 2
// c^2 there, 2^(1 - m/2) / (m + 4).
double mean_cosine(double m) { return m / (m + 4) + std::pow(2, 1 - m / 2) / (m + 4); }

TEST(Glossy, MeanCosineOfAMirroredRay) {
    for (const double m : {1.0, 2.0, 10.0, 100.0, 1000.0}) {
        Finish finish;
        finish.glossy = static_cast<float>(1 / m);
        Surface surface;
        surface.normal = surface.geometric_normal = surface.to_viewer = glm::normalize(Vec3(1, 2, -3));
        surface.finish = &finish;
        Replicas cosines, around_x, around_y;
        const Vec3 a = glm::normalize(glm::cross(surface.normal, Vec3(0, 0, 1))), b = glm::cross(a, surface.normal);
        for (std::uint32_t pixel = 0; pixel < 64; ++pixel) {
            double sum = 0, x = 0, y = 0;
            for (std::uint32_t s = 0; s < 1024; ++s) {
                const Vec3 normal = tilted_normal(surface, point_of(Pattern::sobol, {1, pixel, 0, s, 1024}));
                EXPECT_NEAR(double(glm::length(normal)), 1, 1e-6);
                const Vec3 mirrored = reflect(-surface.to_viewer, normal);
                sum += double(glm::dot(mirrored, surface.normal)) / 1024;
                x += double(glm::dot(mirrored, a)) / 1024;
                y += double(glm::dot(mirrored, b)) / 1024;
            }
            cosines.values.push_back(sum), around_x.values.push_back(x), around_y.values.push_back(y);
        }
        expect_mean(cosines, mean_cosine(m), kAlways, 0, fmt::format("m = {}", m));
        expect_mean(around_x, 0, kAlways), expect_mean(around_y, 0, kAlways);
    }
}

TEST(Glossy, TheHighlightIsBlinns) {
    // The part of normals within a: 1 - cos^(m + 2) a, the integral of Blinn's c^m times the cosine, normed.
    for (const double m : {5.0, 50.0}) {
        Finish finish;
        finish.glossy = static_cast<float>(1 / m);
        Surface surface;
        surface.normal = surface.geometric_normal = surface.to_viewer = Vec3(0, 1, 0);
        surface.finish = &finish;
        // At most 45 degrees: farther ones are bent back.
        for (const double within : {5.0, 15.0, 30.0, 44.0}) {
            const double cosine = std::cos(within * kPiD / 180);
            Replicas parts;
            for (std::uint32_t pixel = 0; pixel < 64; ++pixel) {
                int inside = 0;
                for (std::uint32_t s = 0; s < 256; ++s)
                    inside +=
                        double(tilted_normal(surface, point_of(Pattern::random, {2, pixel, 0, s, 256})).y) > cosine;
                parts.values.push_back(inside / 256.0);
            }
            // Mirrored back from beyond 45 degrees: a normal at 90 - a takes the place of one at a.
            const double other = std::sin(within * kPiD / 180);
            expect_mean(parts, 1 - std::pow(cosine, m + 2) + std::pow(other, m + 2), 64 * 256, 0,
                        fmt::format("m = {}, {} degrees", m, within));
        }
    }
}

TEST(Glossy, AMirrorUnderASkyThatIsItsCosine) {
    // A huge ball, white inside, lit from below by a parallel light without shadows: its brightness is the cosine from
    // the top. A rough mirror in its middle that looks up shows the mean cosine.
    for (const double m : {2.0, 20.0, 200.0}) {
        const Scene scene = staged(fmt::format(
            "camera {{ location <0,1,0> direction -y right x*1e-3 up z*1e-3 }}\n"
            "light_source {{ <0,-1,0>, rgb 1 parallel point_at 0 shadowless }}\n"
            "sphere {{ 0, 1e5 pigment {{ rgb 1 }} finish {{ ambient 0 diffuse 1 }} }}\n"
            "disc {{ 0, y, 0.01 pigment {{ rgb 0 }} finish {{ ambient 0 diffuse 0 reflection 1 glossy {} }} }}\n",
            1 / m));
        const Film film = render(scene, {.raster = {8, 8}, .samples = 256, .threads = 1});
        Replicas all;
        for (int i = 0; i < 64; ++i) all.values.push_back(film.at(i % 8, i / 8)[0]);
        expect_mean(all, mean_cosine(m), kAlways, 2e-5, fmt::format("m = {}", m));
    }
}

// ---- The furnace: all around is 1 ----

const std::string kFurnace =
    "global_settings { max_trace_level 20 adc_bailout 0 }\n"
    "camera { location <0,1,-6> direction z*2 right x up y rotate 9*x }\n"
    "background { rgb 1 }\n";

/// Every pixel is 1 but for what was not traced, whose weights are known: in the mean, all that is missing is that.
void expect_all_1(const std::string& text) {
    const Scene scene = staged(kFurnace + text);
    for (const Pattern pattern : {Pattern::random, Pattern::sobol}) {
        Residual residual;
        const Film film =
            render(scene, {.raster = {24, 24}, .samples = 16, .pattern = pattern, .threads = 1}, &residual);
        double missing = 0;
        for (int y = 0; y < 24; ++y)
            for (int x = 0; x < 24; ++x) {
                EXPECT_LE(film.at(x, y)[0], 1 + 2e-5) << text << x << ' ' << y;
                EXPECT_GE(film.at(x, y)[0], 1 - residual.max - 2e-5) << text << x << ' ' << y;
                missing += (1 - double(film.at(x, y)[0])) / (24 * 24);
            }
        EXPECT_NEAR(missing, residual.mean, 2e-6) << text;
        EXPECT_LT(residual.mean, 0.05) << text;
    }
}

TEST(Furnace, ARoughMirrorLosesNothing) {
    for (const char* rough : {"1", "0.3", "0.01"}) {
        const std::string mirror =
            fmt::format(" pigment {{ rgb 0 }} finish {{ ambient 0 diffuse 0 reflection 1 glossy {} }} }}\n", rough);
        expect_all_1("sphere { 0, 1.5" + mirror);
        expect_all_1("plane { y, -1" + mirror);
        expect_all_1("torus { 1, 0.4 rotate 40*x" + mirror);
        expect_all_1("mesh { smooth_triangle { <-2,-1,0>, <-1,0,-1>, <2,-1,0>, <1,0,-1>, <0,2,0>, <0,1,-1> }" + mirror);
    }
}

TEST(Furnace, RoughGlassLosesNothing) {
    for (const char* rough : {"0.3", "0.01"}) {
        const std::string glass = fmt::format(
            " pigment {{ rgbt <0,0,0,1> }} finish {{ ambient 0 diffuse 0 reflection {{ 0, 1 fresnel on }} "
            "conserve_energy glossy {} }} interior {{ ior 1.5 }} }}\n",
            rough);
        // Rays that run along inside of a ball leave it after dozens of total reflections: those are pruned.
        expect_all_1("sphere { 0, 1.5" + glass);
        expect_all_1("box { -1, 1 rotate <20,35,0>" + glass);
    }
}

}  // namespace
}  // namespace rays::tests
