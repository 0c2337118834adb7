// Everything that can move: every structure answers as asking every object does, and every time shows what the scene is
// then.
#include <fmt/format.h>

#include "pictures.h"
#include "renderer/agreement.h"
#include "renderer/brute_force.h"
#include "renderer/moving_intersector.h"

namespace rays::tests {
namespace {

struct Moving {
    const char* name;
    std::string objects;
    friend void PrintTo(const Moving& m, std::ostream* out) { *out << m.name; }
};

const std::string kPaint = " pigment { rgb <0.8,0.5,0.3> } finish { ambient 0.1 diffuse 0.7 phong 0.4 } ";

/// A dented sheet of 5 x 5 x 2 triangles; `height` is SDL of X, Z and Time.
std::string sheet(const std::string& height, const std::string& more) {
    return "#macro Y(X,Z) (" + height +
           ") #end mesh {\n"
           "#declare I = 0; #while (I < 5) #declare J = 0; #while (J < 5)\n"
           "#declare X = I*0.4-1; #declare Z = J*0.4-1; #declare U = X+0.4; #declare W = Z+0.4;\n"
           "triangle { <X,Y(X,Z),Z>, <U,Y(U,Z),Z>, <U,Y(U,W),W> } triangle { <X,Y(X,Z),Z>, <U,Y(U,W),W>, <X,Y(X,W),W> "
           "}\n"
           "#declare J = J+1; #end #declare I = I+1; #end\n" +
           kPaint + more + "}\n";
}

const std::vector<Moving>& movings() {
    static const std::vector<Moving> all = {
        {"Sphere", "sphere { <2*Time-1,0.5,0>, 0.3+0.4*Time" + kPaint + "}"},
        {"Ellipsoid", "sphere { 0, 0.5 scale <1,0.5+Time,1> rotate 90*Time*z translate <Time,0.5,0>" + kPaint + "}"},
        {"Cone", "cone { <0,0,Time>, 0.5, <Time,1,0>, 0.2*Time" + kPaint + "}"},
        {"OpenCylinder", "cylinder { <0,0,0>, <Time,1,0>, 0.4 open rotate 50*Time*x" + kPaint + "}"},
        {"Torus", "torus { 0.6+0.3*Time, 0.2 rotate <90*Time,20,0> translate <0,0.5,Time>" + kPaint + "}"},
        {"Box", "box { -0.4, 0.4 rotate <70*Time,360*Time,0> translate <Time,0.7,0>" + kPaint + "}"},
        {"Disc", "disc { <0,Time,0>, <Time-0.3,1,0>, 0.9, 0.3*Time" + kPaint + "}"},
        {"Plane", "plane { <0.5*Time,1,0>, -Time" + kPaint + "}"},
        {"Triangle", "triangle { <-1,0,Time>, <1,Time,0>, <Time,1,1>" + kPaint + "}"},
        {"SmoothTriangles", "mesh { smooth_triangle { <-1,0,0>, y, <1,0,0>, <1,1,0>, <0,1,1>, <0,1,-1> }" + kPaint +
                                " rotate 200*Time*y scale 1+Time }"},
        {"Polygon",
         "polygon { 8, <-1,-1>,<1,-1>,<0,1>,<-1,-1>, <-0.3,-0.5>,<0.3,-0.5>,<0,0.3>,<-0.3,-0.5> rotate <30,99*Time,0> "
         "translate Time*y" +
             kPaint + "}"},
        {"PolygonWhosePointsMove", "polygon { 4, <-1,-1-Time,0>,<1,-1,0>,<Time,1,0>,<-1,-1-Time,0>" + kPaint + "}"},
        {"Quadric", "quadric { <1,1+Time,1>, <0,Time,0>, <0,0,0>, -0.6-Time translate Time*x" + kPaint + "}"},
        {"Patch",
         "bicubic_patch { type 1 flatness 0 u_steps 2 v_steps 2 "
         "<-1,0,-1>,<-.3,0,-1>,<.3,0,-1>,<1,0,-1>,<-1,0,-.3>,<-.3,2*Time,-.3>,<.3,1,-.3>,<1,0,-.3>,"
         "<-1,0,.3>,<-.3,1,.3>,<.3,1,.3>,<1,0,.3>,<-1,0,1>,<-.3,0,1>,<.3,0,1>,<1,Time,1> rotate 60*Time*y" +
             kPaint + "}"},
        {"RigidMesh", sheet("0.3*sin(5*X)*cos(4*Z)", "rotate <40*Time,360*Time,0> translate Time*y")},
        {"ScaledMesh", sheet("0.3*sin(5*X)*cos(4*Z)", "scale <1,1+3*Time,0.5> translate <Time,0,0>")},
        {"DeformingMesh", sheet("0.3*sin(5*X+6*Time)", "")},
        {"DeformingAndTurningMesh", sheet("0.3*sin(5*X+6*Time)", "rotate 90*Time*z")},
        {"ClippedMesh", sheet("0.3*sin(5*X)", "rotate 90*Time*y clipped_by { sphere { 0, 0.8 } }")},
        {"MeshWhoseClipMoves", sheet("0.3*sin(5*X)", "clipped_by { box { -2, <2*Time-1,2,2> } }")},
        {"SphereWhoseClipMoves", "sphere { <0,0.5,0>, 0.7 clipped_by { plane { x, Time-0.5 } }" + kPaint + "}"},
        // A shear that grows while the ball falls: from x = 0 to 0 by way of 2.5. The product of two linear functions
        // is none.
        {"ProductOfTwoMotions", "sphere { <0,1-Time,0>, 0.1 matrix <1,0,0, 10*Time,1,0, 0,0,1, 0,0,0>" + kPaint +
                                    "}"
                                    "sphere { <0,2,0>, 0.3" +
                                    kPaint + "} box { <-2,-0.2,-1>, <2,-0.1,1>" + kPaint + "}"},
        {"TwoMeshes", sheet("0.2*X", "rotate 90*Time*y") + sheet("0.2*Z+0.3", "translate Time*y no_shadow")},
        {"Mixed", "sphere { <2*Time-1,0.5,0>, 0.3" + kPaint + "} sphere { <0,1,1>, 0.4" + kPaint +
                      "} box { <-1.5,0,0>, <-1,1,0.5>" + kPaint + "}" +
                      sheet("0.2*X", "rotate 90*Time*y translate -0.3*y")},
    };
    return all;
}

class Moves : public testing::TestWithParam<Moving> {
protected:
    std::string text() const {
        return "camera { location <0,2,-4> look_at <0,0.4,0> right x up y }\nbackground { rgb <0.1,0.2,0.3> }\n"
               "light_source { <3,5,-4>, rgb 1 }\n" +
               GetParam().objects + "\n";
    }
};

/// Asks for the same hits, and whether normals are the same but for rounding: a mesh that moves as a whole is met in
/// its own space, where its normals get unit length once more.
int different_hits(const Scene& scene, const Intersector& one, const Intersector& other, std::uint64_t seed,
                   int& hits) {
    constexpr Real kRounding = sizeof(Real) == 8 ? Real(1e-14) : Real(1e-6);
    HardRays rays(scene, seed);
    int differences = 0;
    for (int i = 0; i < 300; ++i) {
        const auto query = rays.next();
        const auto a = one.nearest(query.ray, query.range), b = other.nearest(query.ray, query.range);
        hits += b.has_value();
        const bool same = a && b ? a->t == b->t && a->object == b->object && a->material == b->material &&
                                       a->point == b->point && glm::length(a->normal - b->normal) <= kRounding &&
                                       glm::length(a->shading_normal - b->shading_normal) <= kRounding
                                 : !a && !b;
        differences += !same;
        differences += one.occluded(query.ray, query.range) != other.occluded(query.ray, query.range);
    }
    return differences;
}

TEST_P(Moves, RaysMeetWhatTheyMeetWhenEveryObjectIsAsked) {
    const Scene read = staged(text());
    Scene first_scene = read;
    ASSERT_FALSE(first_scene.varying.empty());
    Motion first_motion(first_scene);
    const auto first = make_moving_intersector(first_scene, first_motion, Partition::none);
    for (const Partition partition :
         {Partition::none, Partition::grid, Partition::octree, Partition::bvh, Partition::automatic}) {
        Scene scene = read;
        Motion motion(scene);
        const auto structure = make_moving_intersector(scene, motion, partition);
        int hits = 0;
        // Not only forwards: a structure must not remember the time before.
        for (const double time : {0.0, 1.0, 0.371, 0.372}) {
            motion.set_time(Real(time));
            first_motion.set_time(Real(time));
            const auto seed = std::uint64_t(1000 * time);
            const BruteForce slow(scene);
            EXPECT_EQ(different_hits(scene, *structure, slow, seed, hits), 0)
                << "partition " << int(partition) << " at " << time;
            // Among themselves they agree in every bit.
            const Agreement agreement = compare(scene, *structure, *first, 300, seed);
            EXPECT_EQ(agreement.differences, 0u)
                << "partition " << int(partition) << " at " << time << ": " << agreement.first;
        }
        EXPECT_GT(hits, 5);
    }
}

TEST_P(Moves, PicturesAreTheSameBytesThroughEveryStructureAndByAnyNumberOfThreads) {
    const Scene scene = staged(text());
    RenderOptions options{.raster = {24, 20}, .samples = 4, .seed = 3, .threads = 1, .partition = Partition::none};
    const Film slow = render(scene, options);
    EXPECT_TRUE(all_finite(slow));
    for (const Partition partition : {Partition::automatic, Partition::grid, Partition::octree, Partition::bvh}) {
        options.partition = partition;
        EXPECT_TRUE(same_bytes(slow, render(scene, options))) << "partition " << int(partition);
    }
    for (const int threads : {2, 3}) {
        options.threads = threads;
        EXPECT_TRUE(same_bytes(slow, render(scene, options))) << threads << " threads";
    }
}

// What a shutter of no length shows is the still picture of that time: the same samples, of a scene that is read at it.
// Tables are off by 1e-4 of a thing's size at most, so that edges may move by a thousandth of a pixel: a few samples of
// 4 x 480.
TEST_P(Moves, AShutterOfNoLengthShowsTheStillScene) {
    Scene moving = staged(text());
    for (const double time : {0.0, 0.37, 1.0}) {
        moving.camera.shutter_open = moving.camera.shutter_close = Real(time);
        const Scene still = staged_at(text(), time);
        ASSERT_TRUE(still.varying.empty());
        const RenderOptions options{.raster = {24, 20}, .samples = 4, .pattern = Pattern::sobol, .threads = 1};
        EXPECT_LE(different(render(moving, options), render(still, options), 2e-3f), 4) << time;
    }
}

INSTANTIATE_TEST_SUITE_P(Things, Moves, testing::ValuesIn(movings()),
                         [](const auto& of) { return std::string(of.param.name); });

// ---- What moves but is not met: lights, colours, the camera ----

const std::string kStage =
    "plane { y, 0 pigment { checker rgb 1 rgb 0.3 } finish { ambient 0.1 diffuse 0.7 } }\n"
    "sphere { <0,0.7,0>, 0.7 pigment { rgb <0.8,0.5,0.3> } finish { ambient 0.1 diffuse 0.7 specular 0.3 } }\n";
const std::string kEye = "camera { location <0,2,-4> look_at <0,0.4,0> right x up y }\n";
const std::string kLamp = "light_source { <3,5,-4>, rgb 1 }\n";

class Changes : public testing::TestWithParam<Moving> {};

TEST_P(Changes, AShutterOfNoLengthShowsTheStillScene) {
    Scene moving = staged(GetParam().objects);
    ASSERT_FALSE(moving.varying.empty());
    for (const double time : {0.0, 0.37, 1.0}) {
        moving.camera.shutter_open = moving.camera.shutter_close = Real(time);
        const RenderOptions options{.raster = {24, 20}, .samples = 4, .pattern = Pattern::sobol, .threads = 1};
        EXPECT_LE(different(render(moving, options), render(staged_at(GetParam().objects, time), options), 2e-3f), 6)
            << time;
    }
}

TEST_P(Changes, ThePictureIsTheMeanOverItsTimes) {
    // 64 stills against a picture of 256 samples: of each pixel of 12 x 10 by twelve standard errors, 1/2 over 16 at
    // most.
    Film mean({12, 10});
    for (int i = 0; i < 64; ++i) {
        const Film still = render(
            staged_at(GetParam().objects, (i + 0.5) / 64),
            {.raster = {12, 10}, .samples = 16, .pattern = Pattern::sobol, .seed = std::uint64_t(i), .threads = 1});
        for (int p = 0; p < 120; ++p) mean.at(p % 12, p / 12) += (1.0f / 64) * still.at(p % 12, p / 12);
    }
    const Film moving = render(staged(GetParam().objects), {.raster = {12, 10}, .samples = 1024, .threads = 1});
    // Errors of both are below 0.5 / sqrt(1024), were they random: 6.5 of these, once in 10^10 a pixel.
    EXPECT_EQ(different(mean, moving, 6.5f * 1.5f * 0.5f / 32), 0);
    // And the pictures as wholes are far closer: 120 pixels.
    EXPECT_NEAR(mean_of(mean), mean_of(moving), 6.5 * 1.5 * 0.5 / 32 / std::sqrt(120.0));
}

INSTANTIATE_TEST_SUITE_P(
    Things, Changes,
    testing::Values(
        Moving{"LightAndItsColour", kEye + kStage + "light_source { <3-6*Time,5,-4>, rgb <1,Time,1-Time> }\n"},
        Moving{"Spotlight",
               kEye + kStage +
                   "light_source { <3,5,-4>, rgb 2 spotlight point_at <2*Time-1,0,0> radius 8+4*Time falloff 20 }\n"},
        Moving{"AreaLight", kEye + kStage + "light_source { <3,5,-4>, rgb 1 area_light x*2*Time, y, 3, 3 }\n"},
        Moving{"Camera", "camera { location <2*Time-1,2,-4> look_at <0,0.4,0> right x up y }\n" + kLamp + kStage},
        Moving{"CameraThatTurns",
               "camera { location <0,2,-4> look_at <Time,0.4,0> angle 40+20*Time right x up y }\n" + kLamp + kStage},
        Moving{
            "Lens",
            "camera { location <0,2,-4> look_at <0,0.4,0> right x up y aperture 0.3 focal_point <0,0.4,3*Time-1> }\n" +
                kLamp + kStage},
        Moving{
            "Colour",
            kEye + kLamp + "plane { y, 0 pigment { rgb <Time,1-Time,0.5> } finish { ambient Time diffuse 1-Time } }\n"},
        Moving{"CheckersThatTurn", kEye + kLamp +
                                       "plane { y, 0 pigment { checker rgb 1 rgb 0.3 rotate 30*Time*y translate Time*x "
                                       "} finish { ambient 0.1 diffuse 0.7 } }\n"},
        Moving{"Background", kEye + "background { rgb <Time,1-Time,Time*Time> }\n" + kLamp + kStage},
        Moving{"Mirror",
               kEye + kLamp + kStage +
                   "sphere { <1,0.5,-0.5>, 0.5 pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection Time } }\n"},
        Moving{"GlassThatClears", kEye + kLamp + kStage +
                                      "sphere { <1,0.5,-0.5>, 0.5 pigment { rgbt <1,1,1,Time> } finish { ambient 0.2 "
                                      "diffuse 0.5 } interior { ior 1+0.5*Time } }\n"}),
    [](const auto& of) { return std::string(of.param.name); });

/// A mesh that moves as a whole has a structure of its own, also where there is so little that things are asked one by
/// one.
TEST(Motion, AMeshAloneIsNotAskedFaceByFace) {
    Scene scene = staged(sheet("0.2*X", "rotate 90*Time*y"));
    Motion motion(scene);
    const auto structure = make_moving_intersector(scene, motion, Partition::automatic);
    motion.set_time(Real(0.5));
    const Ray down{{Real(0.1), 9, Real(0.13)}, {0, -1, 0}};
    const auto before = structure->nearest(down, {0, 100});
    ASSERT_TRUE(before);
    EXPECT_EQ(before->object, 0u);
    // Its structure keeps corners of its own: who asks the scene's faces as well meets them where they never were.
    for (Vec3& corner : scene.meshes[0].positions) corner.y += 2;
    prepare(scene.meshes[0]);
    const auto after = structure->nearest(down, {0, 100});
    ASSERT_TRUE(after);
    EXPECT_EQ(after->t, before->t);
}

TEST(Motion, SamplesThatMoveAreTheSameBytesByAnyNumberOfThreadsAdaptivelyToo) {
    const Scene scene = staged(kEye + kLamp + kStage + "sphere { <2*Time-1,0.5,-1>, 0.3 }\n");
    RenderOptions options{.raster = {30, 25}, .samples = 256, .error = 0.02f, .threads = 1};
    Residual one, three;
    const Film alone = render(scene, options, &one);
    options.threads = 3;
    EXPECT_TRUE(same_bytes(alone, render(scene, options, &three)));
    EXPECT_EQ(one.samples, three.samples);
}

TEST(Motion, AThingThatCrossesTheWholePicture) {
    // It is 600 pictures wide, and covers the eye's axis for 1/20 of the time.
    const Scene scene = staged(
        "camera { orthographic location <0,0,-5> direction z right x up y }\n"
        "box { <-300,-9,0>, <-290,9,1> translate 200*(Time-0.5)*x+295*x pigment { rgb 1 } finish { ambient 0 diffuse 0 "
        "emission 1 } }\n");
    const Film film = render(scene, {.raster = {16, 16}, .samples = 256, .threads = 1});
    EXPECT_TRUE(all_finite(film));
    // Sobol's times are one in each 256th: a pixel is off by one of them at each end, and by its own width, 1/200/16.
    for (int i = 0; i < 256; ++i) EXPECT_NEAR(film.at(i % 16, i / 16)[0], 10.0 / 200, 2.5 / 256);
}

}  // namespace
}  // namespace rays::tests
