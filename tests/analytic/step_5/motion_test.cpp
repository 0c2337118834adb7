// Things that move while the shutter is open: how long a pixel sees them.
#include <fmt/format.h>

#include "renderer/motion.h"
#include "replicas.h"

namespace rays::tests {
namespace {

const std::string kGlows = " pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 1 } ";
const Pattern kPatterns[] = {Pattern::random, Pattern::jittered, Pattern::multi_jittered, Pattern::sobol};

/// From -2 to 2, rows without a meaning.
std::string wide_camera(const std::string& more = "") {
    return "camera { orthographic location <0,0,-5> direction z right x*4 up y*0.1 " + more + " }\n";
}

/// The part of the time from open to close in which a bar of this width around v (t - 1/2) covers x.
double exposure(double x, double width, double v, double open = 0, double close = 1) {
    const double from = std::max(open, (x - width / 2) / v + 0.5), to = std::min(close, (x + width / 2) / v + 0.5);
    return std::max(0.0, to - from) / (close - open);
}

void expect_profile(const std::string& text, const std::function<double(double)>& truth, double known = 0,
                    int samples = 64) {
    const Scene scene = staged(text);
    for (const Pattern pattern : kPatterns) {
        const Film film = render(scene, {.raster = {24, 64}, .samples = samples, .pattern = pattern, .threads = 1});
        for (int x = 0; x < 24; ++x) {
            const double at = (x + 0.5) / 6 - 2;
            expect_mean(column_of(film, x), mean_over(truth, at, 1.0 / 6), 64.0 * samples, known,
                        fmt::format("x = {}, pattern {}", at, int(pattern)));
        }
    }
}

TEST(MovingBar, IsATrapezoidWithAPlateau) {
    for (const auto& [width, v] : {std::pair(0.5, 2.0), {1.5, 2.0}, {2.0, 0.7}}) {
        expect_profile(wide_camera() + fmt::format("box {{ <{},-9,0>, <{},9,1> translate {}*(Time-0.5)*x {} }}\n",
                                                   -width / 2, width / 2, v, kGlows),
                       [=](double x) { return exposure(x, width, v); });
    }
    EXPECT_EQ(exposure(0, 0.5, 2), 0.25);  // min(1, w / (v T)) in the middle
    EXPECT_EQ(exposure(0, 2, 0.7), 1);
}

TEST(MovingBar, SeenThroughAShutterThatIsOpenForAPart) {
    for (const auto& [open, close] : {std::pair(0.25, 0.5), {0.9, 1.0}})
        expect_profile(wide_camera(fmt::format("shutter {}, {}", open, close)) +
                           "box { <-0.25,-9,0>, <0.25,9,1> translate 3*(Time-0.5)*x " + kGlows + "}\n",
                       [=](double x) { return exposure(x, 0.5, 3, open, close); });
}

TEST(MovingBar, AsAMeshAndAsAPolygonAndForAMovingCamera) {
    const auto truth = [](double x) { return exposure(x, 0.5, 2); };
    const std::string move = " translate 2*(Time-0.5)*x ";
    expect_profile(wide_camera() +
                       "mesh { triangle { <-0.25,-9,0>, <0.25,-9,0>, <0.25,9,0> } triangle { <-0.25,-9,0>, <0.25,9,0>, "
                       "<-0.25,9,0> }" +
                       kGlows + move + "}\n",
                   truth);
    expect_profile(
        wide_camera() + "polygon { 5, <-0.25,-9>, <0.25,-9>, <0.25,9>, <-0.25,9>, <-0.25,-9>" + kGlows + move + "}\n",
        truth);
    expect_profile(
        "camera { orthographic location <2*(0.5-Time),0,-5> direction z right x*4 up y*0.1 }\nbox { <-0.25,-9,0>, "
        "<0.25,9,1>" +
            kGlows + "}\n",
        truth);
}

TEST(MovingBar, CastsAShadowThatIsATrapezoid) {
    // The eye's film is between the floor and the bar.
    expect_profile(
        "camera { orthographic location <0,1,0> direction -y right x*4 up z*0.1 }\n"
        "light_source { <0,10,0>, rgb 1 parallel point_at 0 }\n"
        "plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }\n"
        "box { <-0.25,2,-9>, <0.25,3,9> translate 2*(Time-0.5)*x }\n",
        [](double x) { return 1 - exposure(x, 0.5, 2); });
}

TEST(MovingBar, IsSeenInAMirrorAtTheSameTime) {
    // A mirror at 45 degrees shows the bar that stands above: its exposure is the same, reflected rays have the ray's
    // time.
    expect_profile(
        "camera { orthographic location <0,0,-5> direction z right x*4 up y*0.1 }\n"
        "plane { <0,1,-1>, 0 pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection 1 } }\n"
        "box { <-0.25,8,-9>, <0.25,9,9> translate 2*(Time-0.5)*x" +
            kGlows + "}\n",
        [](double x) { return exposure(x, 0.5, 2); });
}

TEST(MovingLight, ItsShadowsEdgeIsARamp) {
    // The lamp goes from -20 to 20 at a height of 1000, the edge is 100 above the floor: it shifts by 20/9 each way,
    // evenly.
    const double reach = 20.0 / 9;
    expect_profile(
        "camera { orthographic location <0,1,0> direction -y right x*4 up z*0.1 }\n"
        "light_source { <40*(Time-0.5),1000,0>, rgb 1 }\n"
        "plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }\n"
        "box { <-999,99.999,-999>, <0,100,999> }\n",
        [=](double x) { return std::clamp(0.5 + x / (2 * reach), 0.0, 1.0); }, 3e-4);
}

/// The mean over times from -1/2 to 1/2 by the midpoint rule, to 1e-3 for what rises by 1 at most.
double mean_over_time(const std::function<double(double)>& f) {
    double sum = 0;
    for (int i = 0; i < 200; ++i) sum += f((i + 0.5) / 200 - 0.5) / 200;
    return sum;
}

TEST(Motion, AndLensAreIndependent) {
    // An edge that moves and is out of focus: the mean over time of the disc's part beside a line. Were points of the
    // lens tied to times, the edge would be sharper or wider.
    const double focus = 4, depth = 2, radius = 0.5, blur = radius * (focus - depth) / depth;
    // On the plane in focus things at this depth move twice as fast.
    expect_profile(
        "camera { location 0 direction z*4 right x*4 up y*0.1 aperture 2 focal_point <0,0,4> }\n"
        "box { <-99,-99,2>, <0,99,2.0001> translate (Time-0.5)*x" +
            kGlows + "}\n",
        [=](double x) { return mean_over_time([&](double t) { return part_of_disc((2 * t - x) / blur); }); }, 1e-3, 16);
}

TEST(MovingDisc, IsExposedForItsChord) {
    // 2 sqrt(r^2 - y^2) / v, where it comes and goes while the shutter is open. Columns are all alike.
    const double r = 1, v = 10;
    for (const char* disc : {"disc { 0, z, 1", "sphere { 0, 1"}) {
        const Scene scene =
            staged(fmt::format("camera {{ orthographic location <0,0,-5> direction z right x*6 up y*2.4 }}\n {} "
                               "translate {}*(Time-0.5)*x {} }}\n",
                               disc, v, kGlows));
        for (const Pattern pattern : kPatterns) {
            const Film film = render(scene, {.raster = {96, 24}, .samples = 64, .pattern = pattern, .threads = 1});
            for (int y = 0; y < 24; ++y) {
                Replicas row;
                for (int x = 0; x < 96; ++x) row.values.push_back(film.at(x, y)[0]);
                const double at = 1.2 - (y + 0.5) / 10;
                expect_mean(row,
                            mean_over([&](double h) { return std::abs(h) < r ? 2 * std::sqrt(r * r - h * h) / v : 0; },
                                      at, 0.1),
                            96 * 64, 2e-6, fmt::format("y = {}", at));
            }
        }
    }
}

// ---- Rotation: tables are linear between their samples, chords of the circle. They say how far off they are. ----

TEST(Rotation, KeepsLengthsToTheTablesError) {
    Scene scene = staged(
        "sphere { x, 0.1 rotate 360*Time*z }\n"
        "box { <0,-0.1,-0.1>, <1,0.1,0.1> rotate 360*Time*z }\n"
        "sphere { <50,0,0>, 0.1 rotate 1800*Time*y }\n");
    Motion motion(scene);
    double shrinks = 0, far = 0;
    for (int i = 0; i <= 20000; ++i) {
        motion.set_time(Real(i) / 20000);
        const auto off = [](const Vec3& v, double length) { return std::abs(double(glm::length(v)) - length); };
        shrinks = std::max(shrinks, off(scene.spheres[0].center, 1));
        const Transform& box = scene.transforms[scene.objects[1].transform];
        for (int axis = 0; axis < 3; ++axis) shrinks = std::max(shrinks, off(box.linear[axis], 1));
        const Mat3 product = box.linear * box.inverse_linear;
        for (int axis = 0; axis < 3; ++axis) shrinks = std::max(shrinks, off(product[axis], 1));
        far = std::max(far, off(scene.spheres[1].center, 50));
    }
    EXPECT_LT(shrinks, 2e-5);
    EXPECT_LT(far, 50 * 1e-4);
    for (const Varying& table : scene.varying) {
        const double size = table.what.starts_with("spheres[1]") ? 50 : 1;
        EXPECT_LE(double(table.error), 1e-4 * size) << table.what;
        EXPECT_LE(size == 50 ? far : shrinks, double(table.error)) << table.what << " is farther off than it says";
    }
}

TEST(Rotation, ASpinningBallMakesARingThatDoesNotShrink) {
    // At radius s, the ball (centre at 1, radius b) covers the part acos((s^2 + 1 - b^2) / (2 s)) / pi of the turn.
    const double b = 0.2;
    const auto truth = [&](double s) {
        const double cosine = (s * s + 1 - b * b) / (2 * s);
        return s <= 1 - b || s >= 1 + b ? 0.0 : std::acos(cosine) / kPiD;
    };
    // A row of pixels along x that are flat: 0.5e-3 high.
    const Scene scene = staged(
        "camera { orthographic location <1,0,-5> direction z right x*0.6 up y*0.032 }\nsphere { x, 0.2 rotate "
        "360*Time*z" +
        kGlows + "}\n");
    for (const Pattern pattern : kPatterns) {
        const Film film = render(scene, {.raster = {30, 64}, .samples = 256, .pattern = pattern, .threads = 1});
        for (int x = 0; x < 30; ++x) {
            const double at = 0.7 + (x + 0.5) * 0.02;
            // The picture's rows reach to 0.016 beside the axis: radii are up to 0.016^2 / 2 larger, 1.3e-4 where at
            // = 1.
            const double slope = std::abs(truth(at + 0.01) - truth(at - 0.01)) / 0.02 + 1;
            expect_mean(column_of(film, x), mean_over(truth, at, 0.02), 64 * 256, 2e-4 * slope,
                        fmt::format("radius {}", at));
        }
    }
}

TEST(Rotation, TurnsNormals) {
    // The camera's ray hits the middle of a slab that turns from 0 to 60 degrees under a lamp above: the mean cosine.
    const double truth = std::sin(kPiD / 3) / (kPiD / 3);
    const std::string turn = " pigment { rgb 1 } finish { ambient 0 diffuse 1 } rotate 60*Time*z }\n";
    for (const std::string slab : {"box { <-9,-1e-4,-9>, <9,0,9>", "mesh { triangle { <-9,0,-9>, <9,0,-9>, <0,0,9> }",
                                   "disc { 0, y, 9", "plane { y, 0", "triangle { <-9,0,-9>, <9,0,-9>, <0,0,9>",
                                   "polygon { 4, <-9,-9>, <9,-9>, <0,9>, <-9,-9> rotate 90*x",
                                   "mesh { smooth_triangle { <-9,0,-9>, y, <9,0,-9>, y, <0,0,9>, y }",
                                   "bicubic_patch { type 1 flatness 0 u_steps 3 v_steps 3 "
                                   "<-3,0,-3>,<-1,0,-3>,<1,0,-3>,<3,0,-3>,<-3,0,-1>,<-1,0,-1>,<1,0,-1>,<3,0,-1>,"
                                   "<-3,0,1>,<-1,0,1>,<1,0,1>,<3,0,1>,<-3,0,3>,<-1,0,3>,<1,0,3>,<3,0,3>"}) {
        const Scene scene = staged(
            "camera { orthographic location <0,5,0> direction -y right x*1e-3 up z*1e-3 }\nlight_source { <0,9,0>, rgb "
            "1 parallel point_at 0 }\n" +
            slab + turn);
        const Film film = render(scene, {.raster = {8, 8}, .samples = 64, .threads = 1});
        Replicas all;
        for (int i = 0; i < 64; ++i) all.values.push_back(film.at(i % 8, i / 8)[0]);
        expect_mean(all, truth, kAlways, 2e-5, slab);
    }
}

TEST(Motion, ColoursAreAveraged) {
    // A colour that goes from 0 to 1 like the square of the time: a third in the mean.
    const Scene scene =
        staged(wide_camera() +
               "plane { z, 1 pigment { rgb <Time*Time, Time, 1> } finish { ambient 0 diffuse 0 emission 1 } }\n");
    const Film film = render(scene, {.raster = {8, 8}, .samples = 64, .threads = 1});
    for (int lane = 0; lane < 3; ++lane) {
        Replicas all;
        for (int i = 0; i < 64; ++i) all.values.push_back(film.at(i % 8, i / 8)[lane]);
        expect_mean(all, lane == 0 ? 1.0 / 3 : lane == 1 ? 0.5 : 1, kAlways, 1e-5);
    }
}

}  // namespace
}  // namespace rays::tests
