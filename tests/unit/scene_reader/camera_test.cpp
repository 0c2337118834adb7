// Camera vectors. The formulas are POV-Ray 3.7's (parse order: angle, look_at, transforms), worked out by hand here.
#include "read.h"

namespace rays {
namespace {

TEST(CameraReader, DefaultsArePovRays) {
    const Camera camera = scene_of("").camera;
    EXPECT_TRUE(near(camera.location, {0, 0, 0}));
    EXPECT_TRUE(near(camera.direction, {0, 0, 1}));
    EXPECT_TRUE(near(camera.right, {Real(1.33), 0, 0}));
    EXPECT_TRUE(near(camera.up, {0, 1, 0}));
}

TEST(CameraReader, AngleSetsTheDirectionsLength) {
    const Camera camera = scene_of("camera { angle 60 right x*1.5 direction 7*z }").camera;
    EXPECT_TRUE(near(camera.direction, {0, 0, Real(1.5 / 2 / std::tan(30 * std::acos(-1.0) / 180))}));
}

TEST(CameraReader, LookAtTurnsAndKeepsLengths) {
    const Camera camera = scene_of("camera { location <0,0,-5> look_at <5,0,0> right x*2 up y*3 }").camera;
    const Real h = std::sqrt(Real(0.5));
    EXPECT_TRUE(near(camera.direction, {h, 0, h}));
    EXPECT_TRUE(near(camera.right, {2 * h, 0, -2 * h}));
    EXPECT_TRUE(near(camera.up, {0, 3, 0}));
}

TEST(CameraReader, TheOrderOfItemsDoesNotMatter) {
    const Camera a = scene_of("camera { location <1,2,-3> sky <1,1,0> angle 50 right x*1.6 look_at <0,1,2> }").camera;
    const Camera b = scene_of("camera { look_at <0,1,2> right x*1.6 angle 50 sky <1,1,0> location <1,2,-3> }").camera;
    EXPECT_EQ(a.direction, b.direction);
    EXPECT_EQ(a.right, b.right);
    EXPECT_EQ(a.up, b.up);
}

// parse.cpp of POV-Ray 3.7.0.10, "old style syntax".
TEST(CameraReader, BeforeVersion35TheOrderMatters) {
    const auto camera_of = [](const std::string& items) {
        return scene_of("#version 3.1; camera { " + items + " }").camera;
    };
    EXPECT_TRUE(near(camera_of("location -5*z look_at <3,0,-1> direction 2*z").direction, {0, 0, 2}));
    EXPECT_TRUE(near(camera_of("location -5*z direction 2*z look_at <3,0,-1>").direction, {Real(1.2), 0, Real(1.6)}));
    EXPECT_TRUE(near(camera_of("angle 90 right x*2").direction, {0, 0, Real(1.33 / 2)}));
    EXPECT_TRUE(near(camera_of("right x*2 angle 90").direction, {0, 0, 1}));
    EXPECT_TRUE(near(camera_of("translate x location y").location, {0, 1, 0}));
    EXPECT_TRUE(near(camera_of("location y translate x").location, {1, 1, 0}));
    EXPECT_TRUE(near(camera_of("location -5*z look_at 0 orthographic").up, {0, 5, 0}));
    EXPECT_TRUE(near(camera_of("orthographic location -5*z look_at 0").up, {0, 1, 0}));
    const Camera named = scene_of("#version 3.1; #declare C = camera { location y } camera { C right x*2 }").camera;
    EXPECT_TRUE(near(named.right, {2, 0, 0}));
    EXPECT_TRUE(near(named.location, {0, 1, 0}));
}

TEST(CameraReader, ALeftRightVectorStaysLeft) {
    // right -x makes a right-handed scene; look_at must not turn it round.
    const Camera camera = scene_of("camera { location <0,0,-5> right -x*2 look_at 0 }").camera;
    EXPECT_TRUE(near(camera.right, {-2, 0, 0}));
    EXPECT_TRUE(near(camera.up, {0, 1, 0}));
}

TEST(CameraReader, LookingAlongTheSkyKeepsTheRightVector) {
    const Camera camera = scene_of("camera { location <0,5,0> look_at 0 right x*2 }").camera;
    EXPECT_TRUE(near(camera.right, {2, 0, 0}));
    EXPECT_TRUE(near(camera.up, glm::cross(Vec3(0, -1, 0), Vec3(1, 0, 0))));
}

TEST(CameraReader, TransformsComeLast) {
    const Camera camera =
        scene_of("camera { rotate 90*y translate <1,2,3> location <0,0,-5> look_at 0 right x }").camera;
    EXPECT_TRUE(near(camera.location, {-5 + 1, 2, 3}));
    EXPECT_TRUE(near(camera.direction, {1, 0, 0}));
    EXPECT_TRUE(near(camera.right, {0, 0, -1}));
}

TEST(CameraReader, OrthographicShowsWhatPerspectiveShowsAtLookAt) {
    const Camera camera =
        scene_of("camera { orthographic location <0,0,-5> look_at <0,0,5> angle 90 right x*2 up y }").camera;
    EXPECT_EQ(camera.kind, Camera::Kind::orthographic);
    // angle 90: direction has length 1, the distance is 10.
    EXPECT_TRUE(near(camera.right, {20, 0, 0}));
    EXPECT_TRUE(near(camera.up, {0, 10, 0}));
    const Camera plain = scene_of("camera { orthographic location <0,0,-5> look_at <0,0,5> right x*8 up y*6 }").camera;
    EXPECT_TRUE(near(plain.right, {8, 0, 0}));
}

TEST(CameraReader, ShearedFrustumIsKept) {
    const Camera camera = scene_of("camera { location 1 direction <0.2,0.1,1> right x up <0.1,1,0> }").camera;
    EXPECT_TRUE(near(camera.direction, {Real(0.2), Real(0.1), 1}));
    EXPECT_TRUE(near(camera.up, {Real(0.1), 1, 0}));
}

TEST(CameraReader, ThinLens) {
    const Camera camera =
        scene_of("camera { location <0,0,-5> look_at 0 aperture 0.4 focal_point <0,3,-1> blur_samples 10, 20 }").camera;
    EXPECT_EQ(camera.aperture, Real(0.4));
    EXPECT_EQ(camera.blur_samples, 20);
    // POV-Ray keeps the distance to the focal point, 5 here, and focuses across the axis there.
    EXPECT_TRUE(near(camera.focal_point, {0, 0, 0}));
}

TEST(CameraReader, ADeclaredCameraTakesTransforms) {
    const Camera camera =
        scene_of("#declare C = camera { location <0,0,-5> look_at 0 } camera { C translate y }").camera;
    EXPECT_TRUE(near(camera.location, {0, 1, -5}));
}

TEST(CameraReader, DegenerateCamerasAreErrors) {
    EXPECT_TRUE(contains(error_of("camera { direction 0 }"), "direction vector has length 0"));
    EXPECT_TRUE(contains(error_of("camera { up 0 }"), "up vector has length 0"));
    EXPECT_TRUE(contains(error_of("camera { location 1 look_at 1 }"), "same point"));
    EXPECT_TRUE(contains(error_of("camera { right x up x }"), "in one plane"));
    EXPECT_TRUE(contains(error_of("camera { angle 180 }"), "between 0 and 180"));
}

// Words of our own count where they may stand, and are names everywhere else.
TEST(CameraReader, ApertureBladesAndShutterAreOurOwnWords) {
    const Camera camera = scene_of("camera { aperture 0.4 aperture_blades 6 shutter 0.25, 0.75 location y }").camera;
    EXPECT_EQ(camera.aperture_blades, 6);
    EXPECT_EQ(camera.shutter_open, Real(0.25));
    EXPECT_EQ(camera.shutter_close, Real(0.75));
    EXPECT_TRUE(near(camera.location, {0, 1, 0}));
    const Camera usual =
        scene_of("#declare shutter = 3; #declare aperture_blades = y; camera { location shutter*aperture_blades }")
            .camera;
    EXPECT_TRUE(near(usual.location, {0, 3, 0}));
    EXPECT_EQ(usual.aperture_blades, 0);
    EXPECT_EQ(usual.shutter_close, 1);
    for (const char* wrong : {"shutter 0.5, 0.4", "shutter -0.1, 1", "shutter 0, 1.5"})
        EXPECT_NE(error_of(std::string("camera { ") + wrong + " }").find("shutter opens and closes"), std::string::npos)
            << wrong;
    for (const char* wrong : {"aperture_blades 2", "aperture_blades 65"})
        EXPECT_NE(error_of(std::string("camera { ") + wrong + " }").find("aperture_blades"), std::string::npos)
            << wrong;
}

}  // namespace
}  // namespace rays
