// How much of a pixel lies on one side of a straight edge: known exactly, for every pixel.
#include <fmt/format.h>

#include "replicas.h"

namespace rays::tests {
namespace {

/// The area of the unit square around (cx, cy) where nx x + ny y < d: the square's corners, cut, by the shoelace
/// formula.
double covered(double cx, double cy, double nx, double ny, double d) {
    const double square[4][2] = {
        {cx - 0.5, cy - 0.5}, {cx + 0.5, cy - 0.5}, {cx + 0.5, cy + 0.5}, {cx - 0.5, cy + 0.5}};
    std::vector<std::pair<double, double>> cut;
    for (int i = 0; i < 4; ++i) {
        const auto &a = square[i], &b = square[(i + 1) % 4];
        const double over_a = nx * a[0] + ny * a[1] - d, over_b = nx * b[0] + ny * b[1] - d;
        if (over_a < 0) cut.emplace_back(a[0], a[1]);
        if ((over_a < 0) != (over_b < 0)) {
            const double t = over_a / (over_a - over_b);
            cut.emplace_back(a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]));
        }
    }
    double area = 0;
    for (std::size_t i = 0; i < cut.size(); ++i) {
        const auto &p = cut[i], &q = cut[(i + 1) % cut.size()];
        area += (p.first * q.second - q.first * p.second) / 2;
    }
    return std::abs(area);
}

constexpr int kSide = 6;  // pixels; each is 1 x 1, the picture's centre is at (0, 0)

struct Edge {
    const char* name;
    double angle, offset;
};

class Coverage : public testing::TestWithParam<std::tuple<Edge, Pattern, int>> {};

/// White to the left of a line that is turned by the angle.
Scene half_box(double angle, double offset) {
    return staged(
        fmt::format("camera {{ orthographic location <0,0,-5> direction z right x*{0} up y*{0} }}\n"
                    "box {{ <-99,-99,0>, <{2},99,1> rotate {1}*z pigment {{ rgb 1 }} finish {{ ambient 0 diffuse 0 "
                    "emission 1 }} }}\n",
                    kSide, angle, offset));
}

TEST_P(Coverage, OfEveryPixelByAHalfPlane) {
    const auto& [edge, pattern, samples] = GetParam();
    const Scene scene = half_box(edge.angle, edge.offset);
    std::vector<Replicas> pixels(kSide * kSide);
    for (std::uint64_t seed = 0; seed < 96; ++seed) {
        const Film film = render(
            scene, {.raster = {kSide, kSide}, .samples = samples, .pattern = pattern, .seed = seed, .threads = 1});
        for (int i = 0; i < kSide * kSide; ++i)
            pixels[std::size_t(i)].values.push_back(film.at(i % kSide, i / kSide)[0]);
    }
    const double nx = std::cos(edge.angle * kPiD / 180), ny = std::sin(edge.angle * kPiD / 180);
    for (int i = 0; i < kSide * kSide; ++i) {
        const double x = i % kSide + 0.5 - kSide / 2.0, y = kSide / 2.0 - 0.5 - i / kSide;
        expect_mean(pixels[std::size_t(i)], covered(x, y, nx, ny, edge.offset), 96.0 * samples, 0,
                    fmt::format("pixel {},{}", i % kSide, i / kSide));
    }
}

std::string name_of(const testing::TestParamInfo<std::tuple<Edge, Pattern, int>>& of) {
    constexpr const char* kNames[] = {"regular", "random", "jittered", "multi_jittered", "sobol"};
    return fmt::format("{}_{}_{}", std::get<0>(of.param).name, kNames[int(std::get<1>(of.param))],
                       std::get<2>(of.param));
}

INSTANTIATE_TEST_SUITE_P(
    Edges, Coverage,
    testing::Combine(testing::Values(Edge{"along_the_rows", 90, 0.3}, Edge{"along_the_columns", 0, -1.4},
                                     Edge{"generic", 33, 0.17}),
                     testing::Values(Pattern::random, Pattern::jittered, Pattern::multi_jittered, Pattern::sobol),
                     testing::Values(64)),
    name_of);

// An edge along the rows or columns cuts all pixels along it alike: together they show a bias of a hundredth, as cells
// have that no sample ever visits.
TEST(Coverage, NumbersOfSamplesThatFillNoGridAreNotBiased) {
    for (const auto& [angle, offset] :
         {std::pair(90.0, 0.3), std::pair(0.0, 0.3), std::pair(90.0, 0.8), std::pair(0.0, 0.8)}) {
        const Scene scene = half_box(angle, offset);
        for (const Pattern pattern : {Pattern::random, Pattern::jittered, Pattern::multi_jittered, Pattern::sobol})
            for (const int samples : {3, 7, 13}) {
                Replicas cut;
                for (std::uint64_t seed = 0; seed < 400; ++seed) {
                    const Film film = render(
                        scene,
                        {.raster = {kSide, kSide}, .samples = samples, .pattern = pattern, .seed = seed, .threads = 1});
                    for (int i = 0; i < kSide; ++i)  // rows count downwards
                        cut.values.push_back(angle == 0 ? film.at(3, i)[0] : film.at(i, 2)[0]);
                }
                expect_mean(cut, offset, kAlways, 0,
                            fmt::format("pattern {}, {} samples, angle {}", int(pattern), samples, angle));
            }
    }
}

// A regular grid is no estimate: its error is bounded. A row of k points counts an interval to 1/(2k), and as the edge
// leaves every row (or column) of the grid once, the mean over rows is as good.
TEST(RegularGrid, IsOffByHalfAStepAtMost) {
    for (const double angle : {0.0, 90.0, 33.0, 71.0}) {
        const Film film = render(half_box(angle, 0.17),
                                 {.raster = {kSide, kSide}, .samples = 64, .pattern = Pattern::regular, .threads = 1});
        const double nx = std::cos(angle * kPiD / 180), ny = std::sin(angle * kPiD / 180);
        for (int i = 0; i < kSide * kSide; ++i) {
            const double x = i % kSide + 0.5 - kSide / 2.0, y = kSide / 2.0 - 0.5 - i / kSide;
            EXPECT_NEAR(double(film.at(i % kSide, i / kSide)[0]), covered(x, y, nx, ny, 0.17), 0.5 / 8 + 1e-6) << angle;
        }
    }
}

}  // namespace
}  // namespace rays::tests
