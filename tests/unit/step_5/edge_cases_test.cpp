// Where distributing over something meets its limits: no size, no time, one sample, a light on the floor, a focus at
// infinity.
#include <fmt/format.h>

#include "pictures.h"
#include "renderer/distribute.h"

namespace rays::tests {
namespace {

constexpr Pattern kPatterns[] = {Pattern::regular, Pattern::random, Pattern::jittered, Pattern::multi_jittered,
                                 Pattern::sobol};

const std::string kEye = "camera { location <0,2,-4> look_at <0,0.4,0> right x up y }\n";
const std::string kStage =
    "plane { y, 0 pigment { checker rgb 1 rgb 0.3 } finish { ambient 0.1 diffuse 0.7 } }\n"
    "sphere { <0,0.7,0>, 0.7 pigment { rgb <0.8,0.5,0.3> } finish { ambient 0.1 diffuse 0.7 specular 0.3 } }\n"
    "sphere { <1,0.4,-1>, 0.4 pigment { rgbt <1,1,1,0.9> } finish { ambient 0 diffuse 0.1 reflection 0.1 } interior { "
    "ior 1.5 } }\n"
    "mesh { triangle { <-1,0,-1>, <-1.5,0,0>, <-1,1,0> } pigment { rgb 0.6 } }\n";
const std::string kLamp = "light_source { <3,5,-4>, rgb 1 }\n";
/// All at once, in a picture.
const std::string kEverything =
    "camera { location <0.2*Time,2,-4> look_at <0,0.4,0> right x up y aperture 0.2 focal_point <0,0.4,0> }\nbackground "
    "{ rgb <0.2,0.3,0.4> }\n"
    "light_source { <3,5,-4>, rgb 0.7 area_light x*2, z*2, 5, 5 }\n"
    "light_source { <-3,4,-2>, rgb 0.3 area_light x, z, 5, 5 circular orient fade_distance 3 fade_power 2 }\n" +
    kStage +
    "sphere { <-0.5+Time,0.3,-1.5>, 0.3 pigment { rgb 0 } finish { ambient 0 diffuse 0.1 reflection 0.7 glossy 0.1 } "
    "}\n";

// ---- Nothing to distribute over ----

// One regular sample is the pixel's centre, on either way to a picture.
TEST(Limits, ALightWithoutSizeIsAPointToTheByte) {
    const RenderOptions options{.raster = {40, 30}, .pattern = Pattern::regular, .threads = 1};
    const Film point = render(staged(kEye + kStage + kLamp), {.raster = {40, 30}, .threads = 1});
    for (const char* more : {"", "circular", "circular orient"}) {
        const Scene scene = staged(
            kEye + kStage + fmt::format("light_source {{ <3,5,-4>, rgb 1 area_light 0*x, 0*y, 3, 3 {} }}\n", more));
        EXPECT_TRUE(needs_distribution(scene));
        EXPECT_TRUE(same_bytes(render(scene, options), point)) << more;
    }
}

TEST(Limits, AnApertureOfZeroIsAPinholeToTheByte) {
    const Scene closed =
        staged("camera { location <0,2,-4> look_at <0,0.4,0> right x up y aperture 0 focal_point <0,0.4,0> }\n" +
               kStage + kLamp);
    EXPECT_FALSE(needs_distribution(closed));
    const Scene pinhole = staged(kEye + kStage + kLamp);
    for (const int samples : {1, 4, 9})
        EXPECT_TRUE(same_bytes(render(closed, {.raster = {40, 30}, .samples = samples, .threads = 1}),
                               render(pinhole, {.raster = {40, 30}, .samples = samples, .threads = 1})));
    // And one that is all but closed shows the same but for rounding, and for the few samples that meet an edge.
    const Scene tiny =
        staged("camera { location <0,2,-4> look_at <0,0.4,0> right x up y aperture 1e-9 focal_point <0,0.4,0> }\n" +
               kStage + kLamp);
    EXPECT_LE(different(render(tiny, {.raster = {40, 30}, .pattern = Pattern::regular, .threads = 1}),
                        render(pinhole, {.raster = {40, 30}, .threads = 1}), 1e-4f),
              2);
}

TEST(Limits, ARegularPatternIsTheRegularGridButForRounding) {
    const Scene scene = staged(kEye + kStage + kLamp);
    for (const int samples : {1, 4, 16}) {
        const Film grid = render(scene, {.raster = {40, 30}, .samples = samples, .threads = 1});
        const Film pattern =
            render(scene, {.raster = {40, 30}, .samples = samples, .pattern = Pattern::regular, .threads = 1});
        EXPECT_EQ(different(grid, pattern, 2e-6f), 0) << samples;  // another order of summation
    }
}

TEST(Limits, NothingMovesInAShutterThatIsOpenForNoTime) {
    Scene scene = staged(kEverything);
    scene.camera.shutter_open = scene.camera.shutter_close = Real(0.5);
    const Film film = render(scene, {.raster = {16, 12}, .samples = 4, .threads = 1});
    Scene still = staged_at(kEverything, 0.5);
    EXPECT_LE(
        different(film, render(still, {.raster = {16, 12}, .samples = 4, .pattern = Pattern::sobol, .threads = 1}),
                  2e-3f),
        4);
}

// ---- Numbers of samples ----

TEST(Samples, AnyNumberOfAnyPatternThroughAnyFilterIsFinite) {
    const Scene scene = staged(kEverything);
    for (const Pattern pattern : kPatterns)
        for (const Filter filter : {Filter::box, Filter::tent, Filter::mitchell})
            for (const int samples : {1, 2, 3, 5, 7, 13, 31})
                EXPECT_TRUE(all_finite(render(
                    scene, {.raster = {8, 6}, .samples = samples, .pattern = pattern, .filter = filter, .threads = 1})))
                    << int(pattern) << ' ' << int(filter) << ' ' << samples;
}

// The mean of a picture does not depend on how many samples it took: all are unbiased. Values lie in [0, 1.2]: by
// Hoeffding's inequality the mean of n random ones is off by more than 1.2 sqrt(ln(2e10) / (2 n)) once in 10^10,
// patterns are better.
TEST(Samples, TheMeanIsTheSameForAnyNumber) {
    const Scene scene = staged(kEverything);
    const double truth = mean_of(render(scene, {.raster = {8, 6}, .samples = 4096, .seed = 77, .threads = 1}));
    for (const Pattern pattern : {Pattern::random, Pattern::jittered, Pattern::multi_jittered, Pattern::sobol})
        for (const int samples : {1, 2, 3, 7, 16, 31}) {
            double mean = 0;
            const int seeds = 256 / samples;
            for (int seed = 0; seed < seeds; ++seed)
                mean += mean_of(render(scene, {.raster = {8, 6},
                                               .samples = samples,
                                               .pattern = pattern,
                                               .seed = std::uint64_t(seed),
                                               .threads = 1})) /
                        seeds;
            const double n = 48.0 * samples * seeds;
            EXPECT_NEAR(mean, truth,
                        1.2 * std::sqrt(std::log(2e10) / (2 * n)) + 1.2 * std::sqrt(std::log(2e10) / (2 * 48 * 4096.0)))
                << int(pattern) << ' ' << samples;
        }
}

TEST(Samples, TwiceAsManyOfSobolBeginWithTheSameOnes) {
    const Scene scene = staged(kEverything);
    const RenderOptions options{.raster = {8, 6}, .pattern = Pattern::sobol};
    const Distribution distribution(scene, options);
    SampleTracer tracer(distribution), other(distribution);
    for (std::uint32_t s = 0; s < 64; ++s) {
        const Radiance few = tracer.sample(3, 4, distribution.draw(3, 4, s, 64)),
                       many = other.sample(3, 4, distribution.draw(3, 4, s, 128));
        for (int lane = 0; lane < 3; ++lane) EXPECT_EQ(few[lane], many[lane]) << s;
    }
}

TEST(Samples, EveryTracerAndEveryOrderBringsTheSame) {
    // Nothing of a sample is left when the next one begins.
    const Scene scene = staged(kEverything);
    const RenderOptions options{.raster = {8, 6}, .pattern = Pattern::multi_jittered};
    const Distribution distribution(scene, options);
    SampleTracer forwards(distribution), backwards(distribution);
    std::vector<Radiance> first;
    for (std::uint32_t s = 0; s < 96; ++s)
        first.push_back(
            forwards.sample(int(s % 8), int(s / 8 % 6), distribution.draw(int(s % 8), int(s / 8 % 6), s % 16, 16)));
    for (std::uint32_t s = 96; s-- > 0;) {
        const Radiance again =
            backwards.sample(int(s % 8), int(s / 8 % 6), distribution.draw(int(s % 8), int(s / 8 % 6), s % 16, 16));
        for (int lane = 0; lane < 3; ++lane) EXPECT_EQ(first[s][lane], again[lane]) << s;
    }
}

TEST(Samples, EverythingIsTheSameBytesByAnyNumberOfThreads) {
    const Scene scene = staged(kEverything);
    for (const float error : {0.0f, 0.03f}) {
        RenderOptions options{.raster = {20, 17}, .samples = error > 0 ? 128 : 12, .error = error, .threads = 1};
        const Film one = render(scene, options);
        for (const int threads : {2, 3, 50}) {
            options.threads = threads;
            EXPECT_TRUE(same_bytes(one, render(scene, options))) << threads << " threads";
        }
    }
}

TEST(Samples, OtherSeedsAndOtherPixelsAreOtherSamples) {
    const Scene scene = staged(
        "camera { orthographic location <0,0,-5> direction z right x*16 up y*16 }\n"
        "mesh { #declare I = 0; #while (I < 16) triangle { <I-8,-9,0>, <I-7.5,-9,0>, <I-8,999999,0> } #declare I = "
        "I+1; #end\n"
        "pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 1 } }\n");
    const Film a =
        render(scene, {.raster = {16, 16}, .samples = 8, .pattern = Pattern::random, .seed = 1, .threads = 1});
    const Film b =
        render(scene, {.raster = {16, 16}, .samples = 8, .pattern = Pattern::random, .seed = 2, .threads = 1});
    // Every pixel is half covered: 0 to 8 of 8 by a fair coin. Two pixels agree with probability 0.196.
    int seeds_agree = 0, neighbours_agree = 0;
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) {
            seeds_agree += a.at(x, y)[0] == b.at(x, y)[0];
            neighbours_agree += a.at(x, y)[0] == a.at((x + 1) % 16, y)[0];
        }
    // 256 tries: 50 expected, 6.3 standard deviation. 6.5 of these, once in 10^10.
    EXPECT_NEAR(seeds_agree, 50, 41);
    EXPECT_NEAR(neighbours_agree, 50, 41);
}

// ---- Lights in bad places ----

TEST(LightOnItsReceiver, IsFiniteAndNeverBrighterThanItMayBe) {
    const std::string floor =
        "camera { location <0,3,-4> look_at 0 right x up y }\nplane { y, 0 pigment { rgb 1 } finish { ambient 0 "
        "diffuse 1 } }\n";
    for (const char* light :
         {"<0,0,0>, rgb 1 area_light x*2, z*2, 3, 3", "<0,0,0>, rgb 1 area_light x*2, y*2, 3, 3",
          "<0,1,0>, rgb 1 area_light x*2, y*2, 3, 3 circular",
          "<0,0,0>, rgb 1 area_light x*2, z*2, 3, 3 circular orient", "<0,1e-9,0>, rgb 1 area_light x*2, z*2, 3, 3",
          "<0,0.5,0>, rgb 1 area_light x*2, z*2, 3, 3 circular orient"})
        for (const char* fading : {"", "fade_distance 0.3 fade_power 2"}) {
            const Scene scene = staged(floor + fmt::format("light_source {{ {} {} }}\n", light, fading));
            for (const Pattern pattern : kPatterns) {
                // One sample a pixel: no mean hides what one of them brings.
                const Film film = render(scene, {.raster = {60, 60}, .samples = 1, .pattern = pattern, .threads = 1});
                EXPECT_TRUE(all_finite(film)) << light;
                for (int i = 0; i < 3600; ++i) {
                    EXPECT_GE(film.at(i % 60, i / 60)[0], 0) << light;
                    EXPECT_LE(film.at(i % 60, i / 60)[0], *fading ? 2 : 1)
                        << light;  // POV-Ray's fading is 2 at no distance
                }
            }
        }
}

TEST(LightOnItsReceiver, EdgeOnItLightsByItsUpperHalf) {
    // A square that stands on the floor's plane, half below: from far away, half of its points light.
    const Scene scene = staged(
        "camera { location <0,1,0> direction -y right x*1e-3 up z*1e-3 }\nplane { y, 0 pigment { rgb 1 } finish { "
        "ambient 0 diffuse 1 } }\n"
        "light_source { <100,0,0>, rgb 1 area_light y*100, z, 3, 3 }\n");
    // The cosine of a point at height h is h / sqrt(h^2 + 100^2): the mean over 0 to 50, halved, is (sqrt(12500) - 100)
    // / 100.
    const double truth = (std::sqrt(12500.0) - 100) / 100;
    EXPECT_NEAR(mean_of(render(scene, {.raster = {8, 8}, .samples = 1024, .threads = 1})), truth, 1e-4);
}

// ---- Lenses in bad places ----

std::string lens(const std::string& focal_point, const std::string& more = "") {
    return "camera { location 0 direction z right x up y aperture 0.4 focal_point " + focal_point + " " + more + " }\n";
}
const std::string kEdge =
    "box { <-1e6,-1e6,DEPTH>, <0,1e6,DEPTH*1.0001> pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 1 } }\n";
std::string edge_at(double depth) { return fmt::format("#declare DEPTH = {};\n", depth) + kEdge; }

TEST(Focus, AtInfinityEverythingBlursByTheLens) {
    for (const double depth : {1.0, 4.0}) {
        const Scene scene = staged(edge_at(depth) + lens("z*1e7"));
        for (const Pattern pattern : kPatterns) {
            const Film film = render(scene, {.raster = {40, 8}, .samples = 16, .pattern = pattern, .threads = 1});
            EXPECT_TRUE(all_finite(film));
            for (int y = 0; y < 8; ++y)
                for (int x = 0; x < 40; ++x) {
                    const double at = ((x + 0.5) / 40 - 0.5) * depth, half = 0.5 / 40 * depth;  // at the edge's depth
                    if (at + half < -0.1) {
                        EXPECT_EQ(film.at(x, y)[0], 1) << at;
                    }
                    if (at - half > 0.1) {
                        EXPECT_EQ(film.at(x, y)[0], 0) << at;
                    }
                    EXPECT_GE(film.at(x, y)[0], 0);
                    EXPECT_LE(film.at(x, y)[0], 1);
                }
            // The middle of the blur is half lit.
            double middle = 0;
            for (int y = 0; y < 8; ++y) middle += (film.at(19, y)[0] + film.at(20, y)[0]) / 16.0;
            EXPECT_NEAR(middle, 0.5, 3.45 / std::sqrt(2 * 16 * 8)) << "by Hoeffding, once in 10^10";
        }
    }
    // What is at infinity itself is as sharp as through a pinhole.
    const Film far = render(staged(edge_at(1e6) + lens("z*1e6")), {.raster = {40, 8}, .samples = 16, .threads = 1});
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 40; ++x) EXPECT_EQ(far.at(x, y)[0], x < 20 ? 1 : 0) << x;
}

TEST(Focus, OnAThingShowsItAsAPinholeDoes) {
    // The same draws of the pixel: the same points of the thing. Only where rounding takes one across the edge it
    // differs.
    const std::string pinhole = "camera { location 0 direction z right x up y }\n";
    const std::string thing =
        "disc { <0.1,0.2,4>, z, 1.3 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 1 } }\n";
    const RenderOptions options{.raster = {40, 40}, .samples = 16, .pattern = Pattern::sobol, .threads = 1};
    const Film sharp = render(staged(thing + pinhole), options);
    for (const char* more : {"", "aperture_blades 5"})
        EXPECT_LE(different(render(staged(thing + lens("z*4", more)), options), sharp, 0), 2) << more;
}

TEST(Focus, AlmostOnTheLensSeesTheLensUpsideDown) {
    // All rays go through nearly one point of the plane of focus; at twice its distance they are where they started, on
    // the other side: half of a lens of radius 0.1 sees the left, give or take what the film's points differ by.
    for (const double focus : {1e-3, 1e-6}) {
        const Film film = render(staged(edge_at(2 * focus) + lens(fmt::format("z*{}", focus))),
                                 {.raster = {12, 12}, .samples = 256, .threads = 1});
        for (int i = 0; i < 144; ++i)
            EXPECT_NEAR(film.at(i % 12, i / 12)[0], 0.5, 0.03) << focus;  // 1/256 by chance, 0.01 by the film
    }
}

TEST(Focus, OfAnOrthographicCameraBlursByDepthAlone) {
    // Its rays meet at the plane of focus as well; an edge at twice the distance blurs over the lens' whole width,
    // anywhere.
    const Scene scene = staged(
        edge_at(8) + "camera { orthographic location 0 direction z right x*2 up y*2 aperture 1 focal_point z*4 }\n");
    const Film film = render(scene, {.raster = {40, 8}, .samples = 64, .threads = 1});
    EXPECT_TRUE(all_finite(film));
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 40; ++x) {
            const double at = (x + 0.5) / 20 - 1;
            if (at + 0.025 < -0.25) {
                EXPECT_EQ(film.at(x, y)[0], 1) << at;
            }
            if (at - 0.025 > 0.25) {
                EXPECT_EQ(film.at(x, y)[0], 0) << at;
            }
            if (std::abs(at) < 0.17) {
                EXPECT_GT(film.at(x, y)[0], 0) << at;
                EXPECT_LT(film.at(x, y)[0], 1) << at;
            }
        }
}

}  // namespace
}  // namespace rays::tests
