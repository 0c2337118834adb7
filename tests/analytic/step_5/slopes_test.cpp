// How fast the error falls with the number of samples N, pattern by pattern. What theory says of patterns with one
// sample in each of N equal cells of d dimensions: where the integrand is smooth, each cell contributes its size
// N^(-1/d) / N of error, at random: N^(-1/2 - 1/d) in all. Where it jumps, only the N^(1 - 1/d) cells on the jump
// count, 1/N each: N^(-1/2 - 1/(2d)). Points without a pattern: N^(-1/2), whatever d. Centres of cells: N^(-2/d) where
// it is smooth. Scrambled nets (Owen, 1997): N^(-3/2) but for a root of log N where it is smooth, and as jitter where
// it jumps.
#include <fmt/format.h>

#include <array>
#include <numeric>

#include "5_distributed/distributed.h"
#include "replicas.h"

namespace rays::tests {
namespace {

constexpr std::array kPatterns{Pattern::regular, Pattern::random, Pattern::jittered, Pattern::multi_jittered,
                               Pattern::sobol};
constexpr std::array kNames{"regular", "random", "jittered", "multi_jittered", "sobol"};
const std::vector<std::uint32_t> kCounts{4, 16, 64, 256, 1024};

/// Of log error over log N, by least squares.
double slope_of(const std::vector<std::uint32_t>& counts, const std::vector<double>& errors) {
    const auto n = double(counts.size());
    double x = 0, y = 0, xx = 0, xy = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const double lx = std::log(counts[i]), ly = std::log(errors[i]);
        x += lx / n, y += ly / n, xx += lx * lx / n, xy += lx * ly / n;
    }
    return (xy - x * y) / (xx - x * x);
}

/// Slopes of all patterns; one that is NaN is only printed.
using Slopes = std::array<double, 5>;
constexpr double kAnything = std::numeric_limits<double>::quiet_NaN();

/// The error of one estimate: of a pattern's N points for replica number r.
using Estimator = std::function<double(Pattern, std::uint32_t n, std::uint32_t r)>;

/// The root of the mean square of so many replicas is known to 1 / sqrt(2 replicas) of itself, 1.6 % for 2048: the
/// fitted slope to 0.005 at most with five counts, 0.009 with the last three, of which 0.1 is more than ten. `from` is
/// the first N that is fitted.
void expect_slopes(const char* what, const Estimator& error, const Slopes& theory, std::uint32_t from = 4) {
    constexpr std::uint32_t replicas = 2048;
    for (std::size_t p = 0; p < kPatterns.size(); ++p) {
        std::vector<std::uint32_t> counts;
        std::vector<double> errors;
        std::string all;
        for (const std::uint32_t n : kCounts) {
            double squares = 0;
            for (std::uint32_t r = 0; r < replicas; ++r) squares += std::pow(error(kPatterns[p], n, r), 2);
            const double rmse = std::sqrt(squares / replicas);
            all += fmt::format(" {:.2e}", rmse);
            if (n >= from) counts.push_back(n), errors.push_back(rmse);
        }
        const double slope = slope_of(counts, errors);
        fmt::print("{:<28} {:<14} slope {:6.3f}  theory {:6.3f}  errors{}\n", what, kNames[p], slope, theory[p], all);
        testing::Test::RecordProperty(fmt::format("slope_{}", kNames[p]), fmt::format("{:.3f}", slope));
        if (!std::isnan(theory[p])) {
            EXPECT_NEAR(slope, theory[p], 0.1) << what << ", " << kNames[p];
        }
    }
}

/// The mean of f over a pattern's points, less the truth.
template <class F>
double error_of(Pattern pattern, std::uint32_t n, std::uint32_t replica, F f, double truth) {
    double sum = 0;
    for (std::uint32_t s = 0; s < n; ++s) sum += f(point_of(pattern, {7, replica, 0, s, n}));
    return sum / n - truth;
}

/// A line across the unit square, another one for each replica.
struct Line {
    double nx, ny, d;
    explicit Line(std::uint32_t r) {
        const Vec2 chance = random_point({99, r, 0, 0, 1});
        const double angle = 2 * kPiD * double(chance.x);
        nx = std::cos(angle), ny = std::sin(angle);
        d = (double(chance.y) - 0.5) * 0.6;  // of the square's centre; the nearest side is 0.5 away
    }
    bool below(double x, double y) const { return nx * x + ny * y < d; }
    /// Of the square [-1/2, 1/2]^2: the mean over x of the covered height, exactly: a clamped linear function's
    /// integral.
    double of_square() const {
        const double a = std::abs(nx), b = std::abs(ny);
        const auto cut = [](double t) { return t > 0 ? t * t / 2 : 0; };
        // The box of widths a and b, folded: the cumulative trapezoid.
        return (cut(d + (a + b) / 2) - cut(d + (a - b) / 2) - cut(d - (a - b) / 2) + cut(d - (a + b) / 2)) /
               std::max(a * b, 1e-12);
    }
    double of_disc() const { return part_of_disc(d); }
};

TEST(Slopes, EdgeInAPixel) {
    expect_slopes("edge, 2-D",
                  [](Pattern pattern, std::uint32_t n, std::uint32_t r) {
                      const Line line(r);
                      return error_of(
                          pattern, n, r,
                          [&](Vec2 u) {
                              const FilterPoint at = filter_point(Filter::box, u);
                              return line.below(double(at.offset.x), double(at.offset.y)) ? 1.0 : 0.0;
                          },
                          line.of_square());
                  },
                  {kAnything, -0.5, -0.75, -0.75, -0.75});
}

TEST(Slopes, SmoothInAPixel) {
    const double truth = (std::exp(1) - 1) * 2 * (std::exp(0.5) - 1);
    expect_slopes(
        "smooth, 2-D",
        [=](Pattern pattern, std::uint32_t n, std::uint32_t r) {
            return error_of(
                pattern, n, r, [](Vec2 u) { return std::exp(double(u.x + u.y / 2)); }, truth);
        },
        {-1, -0.5, -1, -1, -1.5}, 64);
}

// Not only how fast but how far. Random points: the root of var f / N. One in each cell: of mean |grad f|^2 / 12 / N^2.
// Centres: mean (f_uu + f_vv) / 24 / N. Of exp(u + v/2): the mean of f is (e - 1) 2 (sqrt e - 1), that of f^2 (e^2 -
// 1)/2 (e - 1).
TEST(Slopes, ErrorsOfASmoothIntegrandAreThoseOfTheory) {
    const double mean = (std::exp(1) - 1) * 2 * (std::exp(0.5) - 1),
                 of_squares = (std::exp(2) - 1) / 2 * (std::exp(1) - 1);
    constexpr std::uint32_t kN = 256, kReplicas = 2048;
    const auto rmse = [&](Pattern pattern) {
        double squares = 0;
        for (std::uint32_t r = 0; r < kReplicas; ++r)
            squares += std::pow(error_of(
                                    pattern, kN, r, [](Vec2 u) { return std::exp(double(u.x + u.y / 2)); }, mean),
                                2);
        return std::sqrt(squares / kReplicas);
    };
    // The root of a mean of 2048 squares: 1.6 %, 6.5 of which are 0.1. Once in 10^10.
    EXPECT_NEAR(rmse(Pattern::random) / std::sqrt((of_squares - mean * mean) / kN), 1, 0.1);
    EXPECT_NEAR(rmse(Pattern::jittered) / (std::sqrt(1.25 * of_squares / 12) / kN), 1, 0.1);
    EXPECT_NEAR(rmse(Pattern::regular) / (1.25 * mean / 24 / kN), 1, 0.01);
}

TEST(Slopes, SumOfSmoothFunctionsOfOneCoordinate) {
    // What one in each of N columns and rows is good for. Where the coordinates act together, as above, strips within a
    // cell are dealt by chance to cells whose slopes differ: multi-jitter is then jitter but for a factor, five here.
    const double truth = std::exp(1) - 1 + 2 * (std::exp(0.5) - 1);
    expect_slopes(
        "sum of smooth, 1-D each",
        [=](Pattern pattern, std::uint32_t n, std::uint32_t r) {
            return error_of(
                pattern, n, r, [](Vec2 u) { return std::exp(double(u.x)) + std::exp(double(u.y / 2)); }, truth);
        },
        {-1, -0.5, -1, -1.5, -1.5}, 16);
}

/// The edge of something that hides the light beyond a line, seen from one point: the share of the light that is left.
void expect_penumbra_slopes(const char* name, const Light& light, double (Line::*truth)() const) {
    expect_slopes(name,
                  [&](Pattern pattern, std::uint32_t n, std::uint32_t r) {
                      const Line line(r);
                      const auto is_seen = [&](Vec2 u) {
                          const Vec3 at = light_at(light, u, 0).location;
                          return line.below(double(at.x), double(at.z)) ? 1.0 : 0.0;
                      };
                      return error_of(pattern, n, r, is_seen, (line.*truth)());
                  },
                  {kAnything, -0.5, -0.75, -0.75, -0.75});
}

TEST(Slopes, PenumbraOfASquareLight) {
    Light light;
    light.area = true;
    light.axis_u = {1, 0, 0}, light.axis_v = {0, 0, 1};
    expect_penumbra_slopes("penumbra, square light", light, &Line::of_square);
}

TEST(Slopes, PenumbraOfADisc) {
    Light light;
    light.area = light.circular = true;
    light.axis_u = {2, 0, 0}, light.axis_v = {0, 0, 2};
    expect_penumbra_slopes("penumbra, disc", light, &Line::of_disc);
}

TEST(Slopes, IrradianceOfADisc) {
    // Smooth on the light, but the map from the square has a crease along its diagonals: a kink. The cells on it, N^(1
    // - 1/d), are each wrong by N^(-1 - 1/d): for a net that is otherwise better N^(-1/2 - 1/d - 1/(2d)), 5/4 in two
    // dimensions.
    Light light;
    light.area = light.circular = true;
    light.axis_u = {2, 0, 0}, light.axis_v = {0, 0, 2};
    light.location = {Real(0.3), Real(1.2), 0};
    long double truth = 0;
    constexpr int kSteps = 1500;
    for (int i = 0; i < kSteps; ++i)
        for (int j = 0; j < kSteps; ++j) {
            const long double r = std::sqrt((i + 0.5L) / kSteps),
                              angle = 2 * 3.14159265358979323846L * (j + 0.5L) / kSteps;
            const long double x = 0.3L + r * std::cos(angle), z = r * std::sin(angle);
            truth += 1.2L / std::sqrt(1.44L + x * x + z * z) / kSteps / kSteps;
        }
    expect_slopes(
        "irradiance of a disc",
        [&](Pattern pattern, std::uint32_t n, std::uint32_t r) {
            return error_of(
                pattern, n, r,
                [&](Vec2 u) {
                    const Vec3 at = light_at(light, u, 0).location;
                    return double(at.y / glm::length(at));
                },
                double(truth));
        },
        {-1, -0.5, -1, -1, -1.25}, 16);
}

TEST(Slopes, EdgeThroughALens) {
    Camera camera;
    camera.direction = {0, 0, 4}, camera.right = {4, 0, 0}, camera.up = {0, 4, 0};
    camera.aperture = 4;  // a radius of 1
    camera.focal_point = {0, 0, 4};
    expect_slopes("edge through a lens",
                  [&](Pattern pattern, std::uint32_t n, std::uint32_t r) {
                      const Line line(r);
                      return error_of(
                          pattern, n, r,
                          [&](Vec2 u) {
                              // The middle of the film: at half the focus' distance rays are half as far apart as on
                              // the lens.
                              const Ray ray = lens_ray(camera, {2, 2}, 1, 1, Vec2(-0.5), u);
                              const Vec3 at = ray.at(2 / ray.direction.z);
                              return line.below(2 * double(at.x), 2 * double(at.y)) ? 1.0 : 0.0;
                          },
                          line.of_disc());
                  },
                  {kAnything, -0.5, -0.75, -0.75, -0.75});
}

// One dimension: time. An edge -1/2 - 1/2, smooth -1/2 - 1, cells' centres -2 where it is smooth.
double time_of(const Camera& camera, Pattern pattern, std::uint32_t n, std::uint32_t r, std::uint32_t s) {
    return double(shutter_time(camera, number_of(pattern, {7, r, dimension_of(Purpose::time, 0, {}), s, n})));
}

TEST(Slopes, EdgeInTime) {
    expect_slopes("edge, time",
                  [](Pattern pattern, std::uint32_t n, std::uint32_t r) {
                      const double passes = 0.2 + 0.6 * double(random_point({99, r, 0, 0, 1}).x);
                      double sum = 0;
                      for (std::uint32_t s = 0; s < n; ++s) sum += time_of({}, pattern, n, r, s) < passes;
                      return sum / n - passes;
                  },
                  {-1, -0.5, -1, -1, -1});
}

TEST(Slopes, SmoothInTime) {
    expect_slopes(
        "smooth, time",
        [](Pattern pattern, std::uint32_t n, std::uint32_t r) {
            double sum = 0;
            for (std::uint32_t s = 0; s < n; ++s) sum += std::exp(time_of({}, pattern, n, r, s));
            return sum / n - (std::exp(1) - 1);
        },
        {-2, -0.5, -1.5, -1.5, -1.5}, 16);
}

// ---- The same by the renderer: that it keeps what patterns promise, it must give every purpose its own dimension, every
// sample its number, and every pixel its key ----

/// Errors of all pixels of pictures with these seeds.
void expect_rendered_slopes(const char* what, const Scene& scene, Raster raster, int seeds,
                            const std::function<double(int, int)>& truth, const Slopes& theory) {
    const std::vector<std::uint32_t> counts{4, 16, 64, 256};
    for (std::size_t p = 0; p < kPatterns.size(); ++p) {
        if (std::isnan(theory[p])) continue;
        std::vector<double> errors;
        for (const std::uint32_t n : counts) {
            double squares = 0;
            for (int seed = 0; seed < seeds; ++seed) {
                const Film film = render(scene, {.raster = raster,
                                                 .samples = int(n),
                                                 .pattern = kPatterns[p],
                                                 .seed = std::uint64_t(seed),
                                                 .threads = 1});
                for (int y = 0; y < raster.height; ++y)
                    for (int x = 0; x < raster.width; ++x) squares += std::pow(film.at(x, y)[0] - truth(x, y), 2);
            }
            errors.push_back(std::sqrt(squares / (double(seeds) * raster.width * raster.height)));
        }
        const double slope = slope_of(counts, errors);
        fmt::print("{:<28} {:<14} slope {:6.3f}  theory {:6.3f}\n", what, kNames[p], slope, theory[p]);
        EXPECT_NEAR(slope, theory[p], 0.1) << what << ", " << kNames[p];
    }
}

TEST(RenderedSlopes, Penumbra) {
    // A pixel so narrow that only the light's points matter; rows and seeds are replicas, columns are places in the
    // penumbra.
    const Scene scene = staged(
        "camera { orthographic location <0,5,0> direction -y right x*0.1 up z*0.1 }\n"
        "light_source { <0,1000,0>, rgb 1 area_light <20,0,9>, <-9,0,20>, 9, 9 }\n"
        "plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }\n"
        "box { <-999,9.999,-999>, <0,10,999> }\n");
    // The light's points project on x with a trapezoid's density, of the widths 20 and 9.
    const auto truth = [](int x, int) {
        return mean_over(
            [](double at) {
                const double d = at * 99;  // on the light
                const auto cut = [](double t) { return t > 0 ? t * t / 2 : 0; };
                return (cut(d + 14.5) - cut(d + 5.5) - cut(d - 5.5) + cut(d - 14.5)) / 180;
            },
            (x + 0.5) / 160 - 0.05, 1.0 / 160);
    };
    // Over 16 columns a pixel is 1/16 of the picture: its own width blurs little, in a second pattern.
    expect_rendered_slopes("rendered penumbra", scene, {16, 32}, 1, truth, {kAnything, -0.5, -0.75, -0.75, -0.75});
}

TEST(RenderedSlopes, Edge) {
    const Scene scene = staged(
        "camera { orthographic location <0,0,-5> direction z right x*12 up y*12 }\n"
        "box { <-99,-99,0>, <0.17,99,1> rotate 33*z pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 1 } }\n");
    const double nx = std::cos(33 * kPiD / 180), ny = std::sin(33 * kPiD / 180);
    expect_rendered_slopes("rendered edge", scene, {12, 12}, 24,
                           [&](int x, int y) {
                               Line line(0);
                               line.nx = nx, line.ny = ny;
                               line.d = 0.17 - nx * (x - 5.5) - ny * (5.5 - y);
                               return line.of_square();
                           },
                           {kAnything, -0.5, -0.75, -0.75, -0.75});
}

}  // namespace
}  // namespace rays::tests
