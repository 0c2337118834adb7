// Lights with an area: penumbras and irradiances with closed forms. As in POV-Ray, every point of a light sends what a
// point light sends: no cosine at the light, and no distance where nothing fades.
#include <fmt/format.h>

#include "5_distributed/distributed.h"
#include "replicas.h"

namespace rays::tests {
namespace {

const std::string kWhite = " pigment { rgb 1 } finish { ambient 0 diffuse 1 } ";

// ---- Penumbras: a lamp 1000 above the floor, an edge 10 above it, seen from between the edge and the floor ----

constexpr double kLamp = 1000, kEdge = 10, kWidth = 20;
constexpr double kPenumbra = kWidth * kEdge / (kLamp - kEdge);
/// The cosine at the floor is not quite 1: half the lamp's radius over its distance squared, and the floor's own
/// extent.
constexpr double kSlant = 1e-4;

/// Columns from -1 to 1 penumbra beside the edge's shadow; rows along it. The edge and the eye may be turned below the
/// lamp.
Film penumbra(const std::string& light, Pattern pattern, double turned = 0) {
    const Scene scene =
        staged(fmt::format("camera {{ orthographic location <0,5,0> direction -y right x*{} up z*0.1 rotate {}*y }}\n"
                           "light_source {{ <0,{},0>, rgb 1 {} }}\n"
                           "plane {{ y, 0 {} }}\n"
                           "box {{ <-999,{},-999>, <0,{},999> rotate {}*y }}\n",
                           2 * kPenumbra, turned, kLamp, light, kWhite, kEdge - 1e-3, kEdge, turned));
    return render(scene, {.raster = {32, 64}, .samples = 256, .pattern = pattern, .threads = 1});
}

/// Profile as a function of the place in widths of the penumbra, from -1/2 to 1/2.
void expect_profile(const Film& film, const std::function<double(double)>& profile) {
    for (int x = 0; x < 32; ++x) {
        const double at = (x + 0.5) / 16 - 1;
        expect_mean(column_of(film, x), mean_over(profile, at, 1.0 / 16), 64 * 256, kSlant,
                    fmt::format("at {} widths", at));
    }
}

double linear(double at) { return std::clamp(0.5 + at, 0.0, 1.0); }

TEST(Penumbra, OfASquareLightIsLinear) {
    for (const Pattern pattern : {Pattern::random, Pattern::sobol, Pattern::multi_jittered})
        expect_profile(penumbra("area_light <20,0,0>, <0,0,20>, 9, 9", pattern), linear);
}

TEST(Penumbra, OfASquareLightOnItsCornerIsTwoParabolas) {
    // Its width across the edge is sqrt 2 times that of the side: as wide as the others with a side of 20 / sqrt 2.
    const auto rising = [](double at) {
        at = std::clamp(at, -0.5, 0.5);
        return at < 0 ? 2 * (at + 0.5) * (at + 0.5) : 1 - 2 * (0.5 - at) * (0.5 - at);
    };
    expect_profile(penumbra("area_light <10,0,10>, <10,0,-10>, 9, 9", Pattern::sobol), rising);
}

TEST(Penumbra, OfADiscIsTheDiscsPartBesideALine) {
    for (const Pattern pattern : {Pattern::random, Pattern::sobol, Pattern::jittered})
        expect_profile(penumbra("area_light <20,0,0>, <0,0,20>, 9, 9 circular", pattern),
                       [](double at) { return part_of_disc(2 * at); });
}

TEST(Penumbra, OfABallFromAfarIsADiscsHoweverItsAxesStand) {
    for (const char* axes : {"<20,0,0>, <0,20,0>", "<0,20,0>, <0,0,20>", "<12,16,0>, <0,0,20>"})
        for (const double turned : {0.0, 90.0, 30.0})
            expect_profile(penumbra(fmt::format("area_light {}, 9, 9 circular orient", axes), Pattern::sobol, turned),
                           [](double at) { return part_of_disc(2 * at); });
}

TEST(Penumbra, IsAsWideAsTheContractSays) {
    EXPECT_NEAR(double(widest_penumbra(Real(kWidth), Real(kLamp - kEdge), Real(kEdge))), kPenumbra, 1e-6);
    // And no wider: one sample too far outside would show.
    const Film film = penumbra("area_light <20,0,0>, <0,0,20>, 9, 9", Pattern::sobol);
    for (int y = 0; y < 64; ++y) {
        for (const int dark : {0, 7}) EXPECT_EQ(film.at(dark, y)[0], 0);
        for (const int lit : {24, 31}) EXPECT_NEAR(film.at(lit, y)[0], 1, kSlant);
    }
}

// ---- Irradiance of the origin's floor: diffuse 1, so a pixel is the mean of the cosine ----

Replicas lit(const std::string& light, Pattern pattern = Pattern::sobol, double at = 0) {
    const Scene scene =
        staged(fmt::format("camera {{ orthographic location <{},0.1,0> direction -y right x*1e-6 up z*1e-6 }}\n"
                           "light_source {{ {} }} plane {{ y, 0 {} }}\n",
                           at, light, kWhite));
    const Film film = render(scene, {.raster = {16, 8}, .samples = 256, .pattern = pattern, .threads = 1});
    Replicas all;
    for (int i = 0; i < 128; ++i) all.values.push_back(film.at(i % 16, i / 16)[0]);
    return all;
}

/// The mean of f over a disc of radius 1, in polar coordinates: the midpoint rule in both, in long double.
double mean_over_disc(const std::function<long double(long double, long double)>& f) {
    constexpr int kSteps = 400;
    long double sum = 0;
    for (int i = 0; i < kSteps; ++i)
        for (int j = 0; j < kSteps; ++j) {
            const long double r = std::sqrt((i + 0.5L) / kSteps),
                              angle = 2 * 3.14159265358979323846L * (j + 0.5L) / kSteps;
            sum += f(r * std::cos(angle), r * std::sin(angle));
        }
    return double(sum / kSteps / kSteps);
}

TEST(Irradiance, UnderADiscIsTheMeanCosine) {
    // On the axis: 1/(pi R^2) int h / sqrt(h^2 + r^2) 2 pi r dr = 2 h (sqrt(h^2 + R^2) - h) / R^2.
    for (const Pattern pattern : {Pattern::random, Pattern::jittered, Pattern::multi_jittered, Pattern::sobol}) {
        for (const double h : {0.2, 1.0, 5.0}) {
            const double R = 1.5, truth = 2 * h * (std::sqrt(h * h + R * R) - h) / (R * R);
            expect_mean(lit(fmt::format("<0,{},0>, rgb 1 area_light x*3, z*3, 9, 9 circular", h), pattern), truth,
                        kAlways, 0, "height " + std::to_string(h));
        }
    }
}

TEST(Irradiance, BesideADiscAndUnderAnEllipse) {
    for (const double at : {0.7, 1.5, 4.0}) {
        const double truth = mean_over_disc([&](long double x, long double z) {
            const long double dx = 1.5L * x - at, dz = 0.5L * z;
            return 0.8L / std::sqrt(0.64L + dx * dx + dz * dz);
        });
        expect_mean(lit("<0,0.8,0>, rgb 1 area_light x*3, z, 9, 9 circular", Pattern::sobol, at), truth, kAlways, 1e-6);
    }
}

// Fading with a tiny distance: 2 / (1 + (d/f)^2) is 2 f^2 / d^2 but for f^2 / d^2 of itself, here 1e-6 / 0.04 at most.
const char* const kInverseSquare = "rgb 500000 fade_distance 0.001 fade_power 2";

TEST(Irradiance, UnderADiscWhoseLightFadesWithTheSquare) {
    for (const double h : {0.2, 1.0, 5.0}) {
        const double R = 1.5, truth = 2 * h / (R * R) * (1 / h - 1 / std::sqrt(h * h + R * R));
        expect_mean(lit(fmt::format("<0,{},0>, {} area_light x*3, z*3, 9, 9 circular", h, kInverseSquare)), truth,
                    kAlways, 3e-5 * truth);
    }
}

TEST(Irradiance, UnderARectangleWhoseLightFadesWithTheSquareIsItsSolidAngle) {
    // cos / d^2 = h / d^3 is the solid angle's density of a surface parallel to the floor.
    for (const double h : {0.3, 1.0, 4.0}) {
        const double a = 1, b = 0.6;  // halves
        const double truth = 4 * std::atan(a * b / (h * std::sqrt(h * h + a * a + b * b))) / (4 * a * b);
        expect_mean(lit(fmt::format("<0,{},0>, {} area_light x*2, z*1.2, 9, 9", h, kInverseSquare)), truth, kAlways,
                    3e-5 * truth);
    }
}

TEST(Irradiance, OfABallFromAfarIsThatOfItsCentre) {
    // Of a ball at any distance whose light does not fade: cos over its points. Density 1 / sqrt(R^2 - r^2) around (0,
    // h, 0): its first moments vanish, the second are R^2 / 4 an axis; cos = h/d changes by 1/2 sum of second
    // derivatives times those. Of y / |p| at (0, h): d2/dx2 = d2/dz2 = -1 / h^2, d2/dy2 = 0.
    const double R = 0.5, h = 10;
    expect_mean(lit("<0,10,0>, rgb 1 area_light x, z, 9, 9 circular orient"), 1 - R * R / 4 / (h * h), kAlways,
                R * R * R * R / (h * h * h * h));
}

// ---- All of it at once: an area light is as good as very many point lights ----

TEST(AreaLight, IsTheMeanOfPointLights) {
    const std::string stage =
        "camera { location <0,3,-6> look_at 0 right x up y }\n"
        "plane { y, 0 pigment { rgb <1,0.5,0.2> } finish { ambient 0 diffuse 0.8 } }\n"
        "sphere { <0,1,0>, 1 pigment { rgb 0.7 } finish { ambient 0 diffuse 0.6 phong 0.5 phong_size 20 specular 0.3 "
        "roughness 0.05 } }\n";
    std::string points;
    for (int i = 0; i < 24; ++i)
        for (int j = 0; j < 24; ++j)
            points += fmt::format("light_source {{ <{},4,{}>, rgb 1/576 }}\n", 2 + 2 * ((i + 0.5) / 24 - 0.5),
                                  -2 + 2 * ((j + 0.5) / 24 - 0.5));
    const RenderOptions middle{.raster = {12, 12}, .samples = 1, .threads = 1};
    const Film truth = render(staged(stage + points), middle);
    // The same rays from the eye: the camera's picture of one pixel is a point of it, for both.
    const Scene scene = staged(stage + "light_source { <2,4,-2>, rgb 1 area_light x*2, z*2, 9, 9 }\n");
    Scene pinned = scene;
    std::vector<Replicas> pixels(144);
    for (int y = 0; y < 12; ++y)
        for (int x = 0; x < 12; ++x) {
            // A picture of 8 x 8 pixels in a millionth of this one's.
            pinned.camera = scene.camera;
            pinned.camera.direction += ((x + Real(0.5)) / 12 - Real(0.5)) * scene.camera.right +
                                       (Real(0.5) - (y + Real(0.5)) / 12) * scene.camera.up;
            pinned.camera.right *= Real(1e-6);
            pinned.camera.up *= Real(1e-6);
            const Film film = render(pinned, {.raster = {8, 8}, .samples = 64, .threads = 1});
            Replicas& pixel = pixels[std::size_t(y * 12 + x)];
            for (int i = 0; i < 64; ++i) pixel.values.push_back(film.at(i % 8, i / 8)[0]);
            // Where the ball's edge cuts the light the 24 x 24 points are a regular grid: wrong by half a column at
            // most.
            expect_mean(pixel, double(truth.at(x, y)[0]), 64 * 64, 0.5 / 24, fmt::format("pixel {},{}", x, y));
        }
}

}  // namespace
}  // namespace rays::tests
