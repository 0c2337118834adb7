// Pixels that stop when they are good enough: are they, and what do they miss?
#include <fmt/format.h>

#include "pictures.h"

namespace rays::tests {
namespace {

/// Penumbras, an edge out of focus, and flat parts.
const std::string kSoft =
    "camera { location <0,2,-4> look_at <0,0.4,0> right x up y aperture 0.3 focal_point <0,0.4,0> }\nbackground { rgb "
    "0.2 }\n"
    "light_source { <3,5,-4>, rgb 1 area_light x*2, z*2, 5, 5 }\n"
    "plane { y, 0 pigment { rgb 0.9 } finish { ambient 0.1 diffuse 0.8 } }\n"
    "sphere { <0,0.7,0>, 0.7 pigment { rgb 0.7 } finish { ambient 0.1 diffuse 0.7 } }\n"
    "box { <-1.2,0,-1.2>, <-1,1,-1> pigment { rgb 0.2 } finish { ambient 0.1 diffuse 0.7 } }\n";

struct Errors {
    double rms = 0, beyond_4 = 0, samples = 0;
};
Errors errors_at(const Scene& scene, const Film& truth, float wanted, Pattern pattern) {
    Errors errors;
    Residual residual;
    const Film film = render(
        scene,
        {.raster = truth.raster(), .samples = 65536, .pattern = pattern, .error = wanted, .seed = 5, .threads = 1},
        &residual);
    const int pixels = truth.raster().width * truth.raster().height;
    for (int y = 0; y < truth.raster().height; ++y)
        for (int x = 0; x < truth.raster().width; ++x) {
            const double off = double(film.at(x, y)[0]) - truth.at(x, y)[0];
            errors.rms += off * off / pixels;
            errors.beyond_4 += (std::abs(off) > 4 * wanted) / double(pixels);
        }
    errors.rms = std::sqrt(errors.rms);
    errors.samples = residual.samples;
    return errors;
}

// The error asked for is a standard error: that much in the mean square over the pixels, or less. That of random points
// is estimated from four groups: a pixel stops when three degrees of freedom look good, by chance too early; groups of
// a net scatter more than the whole net, which errs on the safe side.
TEST(Adaptive, TheErrorAskedForIsReached) {
    const Scene scene = staged(kSoft);
    const Film truth = render(scene, {.raster = {32, 32}, .samples = 16384, .seed = 99});
    double before = 0;
    for (const float wanted : {0.04f, 0.02f, 0.01f}) {
        for (const Pattern pattern : {Pattern::random, Pattern::sobol}) {
            const Errors found = errors_at(scene, truth, wanted, pattern);
            fmt::print(
                "asked for {:.3f}, {:<6}: {:.4f} reached, {:.2f} % of the pixels beyond four times that, {:.1f} "
                "samples\n",
                wanted, pattern == Pattern::sobol ? "sobol" : "random", found.rms, 100 * found.beyond_4, found.samples);
            EXPECT_LE(found.rms, wanted);
            EXPECT_LE(found.beyond_4, 0.01);
            EXPECT_LT(found.samples, 4096);
            if (pattern == Pattern::random) {
                EXPECT_GT(found.samples, before);
            }
            before = found.samples;
        }
        before = 0;
    }
}

TEST(Adaptive, ItTakesSamplesWhereTheyAreNeeded) {
    // Sixteen everywhere, and no more where all is flat.
    Residual flat;
    render(staged("camera { orthographic location <0,0,-5> direction z right x up y }\nbackground { rgb 0.5 }\n"),
           {.raster = {16, 16}, .samples = 4096, .error = 0.01f, .threads = 1}, &flat);
    EXPECT_EQ(flat.samples, 16);
    // A limit below sixteen is a limit; one that is no power of two is not reached.
    for (const auto& [limit, taken] : {std::pair(1, 1), {3, 3}, {7, 7}, {16, 16}, {31, 16}, {100, 64}}) {
        Residual residual;
        const Film film =
            render(staged(kSoft), {.raster = {8, 8}, .samples = limit, .error = 1e-6f, .threads = 1}, &residual);
        EXPECT_TRUE(all_finite(film));
        EXPECT_LE(residual.samples, limit);
        EXPECT_LE(residual.samples, taken);
        EXPECT_GT(residual.samples, taken / 4.0) << limit;
    }
}

// A wire along a row of pixels, 0.05 of a pixel thick, from a fourth of its height up. Sixteen points have one in each
// sixteenth of the height: a pixel misses the wire with probability 0.2, and all three of a pixel and its neighbours in
// the row with 0.2^3. Who has a neighbour that saw it goes on, and 32 points cannot miss it.
TEST(Adaptive, WhatAPixelMissesItsNeighboursTell) {
    constexpr int kWidth = 256;
    const Scene scene =
        staged(fmt::format("camera {{ orthographic location <0,0,-5> direction z right x*{0} up y*5 }}\n"
                           "box {{ <-{0}, 0.25, 0>, <{0}, 0.3, 1> pigment {{ rgb 1 }} finish {{ ambient 0 diffuse 0 "
                           "emission 1 }} }}\n",
                           kWidth));
    const Film film = render(scene, {.raster = {kWidth, 5}, .samples = 1024, .error = 0.01f, .threads = 1});
    int lost = 0;
    for (int x = 0; x < kWidth; ++x) lost += film.at(x, 2)[0] == 0;
    fmt::print("{} of {} pixels lost the wire\n", lost, kWidth);
    // Two are expected, and 51 of pixels that look at themselves alone.
    EXPECT_LE(lost, 10);
}

// What the first samples do not see is not looked for. A dot of brightness 1 in the dark, of area a pixels, somewhere
// in a pixel of its own: sixteen points, one in each sixteenth of the pixel, all miss it with probability 1 - 16 a
// while it is small, and no neighbour tells. From a radius at which it holds a whole cell of the net it is always seen.
TEST(Adaptive, SmallFeaturesAreLostAsOftenAsTheFirstSamplesMissThem) {
    constexpr int kDots = 24;  // each way, five pixels apart
    fmt::print("radius of a dot [px]   lost   1 - 16 a   light left   without --error\n");
    for (const double radius : {0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.45}) {
        const double area = 3.14159265358979 * radius * radius;
        // Each dot anywhere in its pixel where it fits.
        const std::string text = fmt::format(
            "camera {{ orthographic location <0,0,-5> direction z right x*{0} up y*{0} }}\n#declare R = seed({1});\n"
            "#declare I = 0; #while (I < {2}) #declare J = 0; #while (J < {2})\n"
            "disc {{ <I*5-{0}/2+2.5+(rand(R)-0.5)*(1-2*{3}), J*5-{0}/2+2.5+(rand(R)-0.5)*(1-2*{3}), 0>, z, {3} pigment "
            "{{ rgb 1 }} finish {{ ambient 0 diffuse 0 emission 1 }} }}\n"
            "#declare J = J+1; #end #declare I = I+1; #end\n",
            5 * kDots, int(1000 * radius), kDots, radius);
        const Scene scene = staged(text);
        const Raster raster{5 * kDots, 5 * kDots};
        const Film adaptive = render(scene, {.raster = raster, .samples = 1024, .error = 0.01f, .threads = 1});
        const Film even = render(scene, {.raster = raster, .samples = 16, .pattern = Pattern::sobol, .threads = 1});
        int lost = 0;
        for (int j = 0; j < kDots; ++j)
            for (int i = 0; i < kDots; ++i) lost += adaptive.at(5 * i + 2, 5 * j + 2)[0] == 0;
        const double share = lost / double(kDots * kDots), expected = std::max(0.0, 1 - 16 * area);
        const double light = mean_of(adaptive) * 25 / area, all = mean_of(even) * 25 / area;
        fmt::print("{:>8} {:>18.3f} {:>10.3f} {:>10.3f} {:>12.3f}\n", radius, share, expected, light, all);
        // Hoeffding, 576 tries: once in 10^10 farther off than sqrt(ln(2e10) / 2 / 576) = 0.143.
        if (radius <= 0.1) {
            EXPECT_NEAR(share, expected, 0.143) << radius;
        }
        if (radius >= 0.3) {
            EXPECT_EQ(lost, 0) << "it holds a whole cell of 1/4 x 1/4, or of 1/16 x 1, or 1/2 x 1/8";
        }
        // Lost or not, the mean is right: who sees a dot by chance goes on, but with the samples that saw it.
        if (radius >= 0.3) {
            EXPECT_NEAR(light, 1, 0.03) << radius;
        }
    }
}

}  // namespace
}  // namespace rays::tests
