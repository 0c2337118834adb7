// The thin lens: circles of confusion with their size and profile, and what photographers' formulas say about them.
#include <fmt/format.h>

#include "5_distributed/distributed.h"
#include "replicas.h"

namespace rays::tests {
namespace {

const std::string kGlows = " pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 1 } ";

constexpr double kFocus = 4, kRadius = 0.5;  ///< of the lens: an aperture of 2

/// The radius of a point's blur, on the plane in focus.
double blur_of(double depth) { return kRadius * std::abs(kFocus - depth) / depth; }

/// From -`half` to `half` of the plane in focus.
std::string camera(double half, const std::string& more = "") {
    return fmt::format(
        "camera {{ location 0 direction z*{0} right x*{1} up y*{1} aperture {2} focal_point <0,0,{0}> {3} }}\n", kFocus,
        2 * half, 4 * kRadius, more);
}

TEST(Lens, AnEdgeOutOfFocusIsTheDiscsPartBesideALine) {
    for (const double depth : {1.5, 3.0, 6.0, 30.0}) {
        const double blur = blur_of(depth);
        for (const bool level : {false, true}) {
            const Scene scene = staged(
                camera(2 * blur) + (level ? "box { <-999,-999,0>, <999,0,1e-4>" : "box { <-999,-999,0>, <0,999,1e-4>") +
                fmt::format(" translate {}*z {} }}\n", depth, kGlows));
            const Raster raster = level ? Raster{64, 16} : Raster{16, 64};
            for (const Pattern pattern :
                 {Pattern::random, Pattern::jittered, Pattern::multi_jittered, Pattern::sobol}) {
                const Film film = render(scene, {.raster = raster, .samples = 64, .pattern = pattern, .threads = 1});
                for (int i = 0; i < 16; ++i) {
                    Replicas line;
                    for (int j = 0; j < 64; ++j)
                        line.values.push_back(level ? film.at(j, 15 - i)[0] : film.at(i, j)[0]);
                    const double at = (i + 0.5) / 4 - 2;
                    expect_mean(line, mean_over([](double x) { return part_of_disc(-x); }, at, 0.25), 64 * 64, 0,
                                fmt::format("depth {}, {} radii", depth, at));
                }
            }
        }
    }
}

/// A glowing disc so small that the lens sees all of it or nothing, but for a rim. It is seen from the part
/// (own F / (F - z))^2 pi of the lens' area, wherever in its blur.
struct SmallDisc {
    double depth, own;
    double seen_from() const { return own * kFocus / std::abs(kFocus - depth); }  ///< radius, on the lens
    double rim() const { return own * kFocus / depth; }                           ///< radius, in the plane in focus
    Film picture(double half, int side, const std::string& more = "") const {
        return render(staged(camera(half, more) + fmt::format("disc {{ <0,0,{}>, z, {} {} }}\n", depth, own, kGlows)),
                      {.raster = {side, side}, .samples = 64, .threads = 1});
    }
};

TEST(Lens, ACircleOfConfusionIsUniformRoundAndAsWideAsItShouldBe) {
    for (const SmallDisc disc : {SmallDisc{2, 0.06}, SmallDisc{12, 0.12}}) {
        constexpr int kSide = 96;
        const double blur = blur_of(disc.depth), half = 1.2 * blur, pixel = 2 * half / kSide;
        const Film film = disc.picture(half, kSide);
        const double level = std::pow(disc.seen_from() / kRadius, 2);
        constexpr int kRings = 4, kSectors = 8;
        Replicas groups[kRings][kSectors];
        double flux = 0;
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x) {
                const double px = (x + 0.5) * pixel - half, py = half - (y + 0.5) * pixel;
                const double from_axis = std::hypot(px, py), unsure = disc.rim() + pixel * std::sqrt(0.5);
                const double value = film.at(x, y)[0];
                flux += value * pixel * pixel;
                if (from_axis > blur + unsure) {
                    EXPECT_EQ(value, 0) << from_axis;
                }
                if (from_axis > blur - unsure) continue;
                const auto ring = std::min(kRings - 1, int(kRings * std::pow(from_axis / (blur - unsure), 2)));
                const auto sector = std::min(kSectors - 1, int(kSectors * (std::atan2(py, px) / (2 * kPiD) + 0.5)));
                groups[ring][sector].values.push_back(value);
            }
        for (const auto& ring : groups)
            for (const Replicas& group : ring) expect_mean(group, level, double(group.values.size()) * 64, 0, "level");
        // All of the light: the level times the blur's area. By chance as far off as any group, relatively, at most.
        EXPECT_NEAR(flux / (level * kPiD * blur * blur), 1, 0.03);
    }
}

TEST(Lens, ATriangularApertureShowsItsCornersUpsideDownInFrontOfTheFocus) {
    for (const SmallDisc disc : {SmallDisc{2, 0.04}, SmallDisc{12, 0.08}}) {
        constexpr int kSide = 96;
        const double blur = blur_of(disc.depth), half = 1.2 * blur, pixel = 2 * half / kSide;
        const Film film = disc.picture(half, kSide, "aperture_blades 3");
        const double level = kPiD * std::pow(disc.seen_from() / kRadius, 2) / (0.75 * std::sqrt(3));
        const double up = disc.depth > kFocus ? 1 : -1;
        Replicas inside;
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x) {
                const double px = (x + 0.5) * pixel - half, py = up * (half - (y + 0.5) * pixel);
                // How far inside of the three sides, which are half a radius from the middle.
                const double depth = blur / 2 + std::min(py, -py / 2 - std::abs(px) * std::sqrt(0.75));
                const double unsure = disc.rim() + pixel * std::sqrt(0.5);
                if (depth > unsure) inside.values.push_back(film.at(x, y)[0]);
                if (depth < -unsure) {
                    EXPECT_EQ(film.at(x, y)[0], 0) << px << ' ' << py;
                }
            }
        expect_mean(inside, level, double(inside.values.size()) * 64);
    }
}

TEST(Lens, LargestBlurIsTheCirclesDiameter) {
    const Scene scene = staged(camera(2));
    const Raster raster{400, 400};  // 100 pixels a unit of the plane in focus
    for (const double depth : {1.0, 2.0, 6.0, 50.0})
        EXPECT_NEAR(double(largest_blur_px(scene.camera, raster, Real(depth), Real(depth))), 200 * blur_of(depth),
                    1e-3);
    EXPECT_NEAR(double(largest_blur_px(scene.camera, raster, Real(kFocus), std::numeric_limits<Real>::infinity())),
                200 * kRadius, 1e-3);
    EXPECT_EQ(largest_blur_px(scene.camera, raster, Real(kFocus), Real(kFocus)), 0);
    // As far as the lens' rays really go: from its rim through one point in focus.
    for (const double depth : {1.0, 6.0}) {
        Real low = 1e9, high = -1e9;
        for (const Real u : {Real(0), Real(0.999999)}) {
            const Ray ray = lens_ray(scene.camera, raster, 200, 200, Vec2(-0.5, -0.5), {u, Real(0.5)});
            const Real x = ray.at(Real(depth) / ray.direction.z).x;
            low = std::min(low, x), high = std::max(high, x);
        }
        // At that depth a pixel is depth / focus times as wide as in focus.
        EXPECT_NEAR(double(high - low) * 100 * kFocus / depth, 200 * blur_of(depth), 1e-2);
    }
}

// ---- Depth of field: a lens of 50 mm at f/2, a film of 36 x 24 mm whose pixels are the circle of confusion allowed, 0.03 mm,
// focused at 2 m. Distances in mm from the lens; the film stands at its image distance.

constexpr double kLength = 50, kNumber = 2, kAllowed = 0.03;

Camera photographers(double focus) {
    const double image = kLength * focus / (focus - kLength);
    return staged(fmt::format(
                      "camera {{ location 0 direction z*{} right x*36 up y*24 aperture {} focal_point <0,0,{}> }}\n",
                      image, 2 * kLength / kNumber, focus))
        .camera;
}
const Raster kFilm{1200, 800};

TEST(DepthOfField, EndsExactlyWhereTheBlurReachesACircleOfConfusion) {
    const double s = 2000, hyperfocal = kLength * kLength / (kNumber * kAllowed) + kLength;
    const double nearest = s * (hyperfocal - kLength) / (hyperfocal + s - 2 * kLength),
                 farthest = s * (hyperfocal - kLength) / (hyperfocal - s);
    EXPECT_NEAR(hyperfocal, 41716.67, 0.005);
    EXPECT_NEAR(nearest, 1910.58, 0.005);
    EXPECT_NEAR(farthest, 2098.20, 0.005);
    EXPECT_NEAR(farthest - nearest, 187.61, 0.005);
    const Camera camera = photographers(s);
    constexpr double kRounding = sizeof(Real) == 8 ? 1e-9 : 1e-3;
    EXPECT_NEAR(double(largest_blur_px(camera, kFilm, Real(nearest), Real(s))), 1, kRounding);
    EXPECT_NEAR(double(largest_blur_px(camera, kFilm, Real(s), Real(farthest))), 1, kRounding);
    EXPECT_LT(double(largest_blur_px(camera, kFilm, Real(nearest + 1), Real(farthest - 1))), 1);
    EXPECT_GT(double(largest_blur_px(camera, kFilm, Real(nearest - 1), Real(s))), 1);
    EXPECT_GT(double(largest_blur_px(camera, kFilm, Real(s), Real(farthest + 1))), 1);
}

TEST(DepthOfField, OfTheLectureIsTheLimitOfASmallCircle) {
    // D = 2 N C U^2 / f^2, 192.0 mm here: it leaves out what grows with N C U / f^2 and with f / U.
    const double s = 2000, lecture = 2 * kNumber * kAllowed * s * s / (kLength * kLength);
    EXPECT_NEAR(lecture, 192.0, 0.05);
    // Half of it to each side is not the depth of field: the blur is over a pixel in front, and under it behind.
    const Camera camera = photographers(s);
    EXPECT_GT(double(largest_blur_px(camera, kFilm, Real(s - lecture / 2), Real(s))), 1.05);
    EXPECT_LT(double(largest_blur_px(camera, kFilm, Real(s), Real(s + lecture / 2))), 0.99);
}

TEST(DepthOfField, FocusedAtTheHyperfocalDistanceReachesFromItsHalfToInfinity) {
    const double hyperfocal = kLength * kLength / (kNumber * kAllowed) + kLength;
    const Camera camera = photographers(hyperfocal);
    constexpr double kRounding = sizeof(Real) == 8 ? 1e-9 : 1e-3;
    EXPECT_NEAR(double(largest_blur_px(camera, kFilm, Real(hyperfocal), std::numeric_limits<Real>::infinity())), 1,
                kRounding);
    EXPECT_NEAR(double(largest_blur_px(camera, kFilm, Real(hyperfocal / 2), Real(hyperfocal))), 1, kRounding);
}

}  // namespace
}  // namespace rays::tests
