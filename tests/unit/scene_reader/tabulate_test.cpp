// Tables of Time and Wavelength against the scene read at the very value.
#include <map>

#include "read.h"

namespace rays {
namespace {

Real look_up(const Varying& table, double value) {
    const double at =
        (value - double(table.first)) / double(table.last - table.first) * double(table.samples.size() - 1);
    const std::size_t i = std::min(static_cast<std::size_t>(at), table.samples.size() - 2);
    const double rest = at - double(i);
    return static_cast<Real>(double(table.samples[i]) * (1 - rest) + double(table.samples[i + 1]) * rest);
}

const Varying* find(const Scene& scene, const std::string& what) {
    for (const Varying& varying : scene.varying) {
        if (varying.what == what) return &varying;
    }
    return nullptr;
}

const char kMoving[] =
    "sphere { <Time, 2, 3*Time*Time>, 1 + 0.5*Time }\n"
    "box { -1, 1 rotate 90*Time*y }\n"
    "sphere { 0, 1 scale <1 + Time, 1, 1> }\n"
    "light_source { <cos(3*Time), sin(3*Time), 0>, rgb <1, 1 - Time, 0> }";

TEST(Tabulate, TablesAreWithinTheirStatedError) {
    const Scene scene = scene_of(kMoving);
    ASSERT_FALSE(scene.varying.empty());
    for (double time : {0.0, 0.013, 0.27, 0.5, 0.731, 0.999, 1.0}) {
        ReadOptions options;
        options.declared = {{"Time", time}};
        const Scene exact = scene_of(kMoving, options);
        EXPECT_TRUE(exact.varying.empty());
        const std::map<std::string, double> truth = {
            {"spheres[0].center.x", exact.spheres[0].center.x},   {"spheres[0].center.z", exact.spheres[0].center.z},
            {"spheres[0].radius", exact.spheres[0].radius},       {"lights[0].location.x", exact.lights[0].location.x},
            {"lights[0].location.y", exact.lights[0].location.y}, {"lights[0].color.green", exact.lights[0].color[1]},
        };
        for (const auto& [what, value] : truth) {
            const Varying* table = find(scene, what);
            ASSERT_NE(table, nullptr) << what;
            EXPECT_EQ(table->variable, Varying::Variable::time);
            EXPECT_LE(std::abs(look_up(*table, time) - value), double(table->error)) << what << " at " << time;
            EXPECT_LE(table->error, 1e-4) << what;
        }
    }
}

TEST(Tabulate, StraightMotionNeedsTwoSamples) {
    const Scene scene = scene_of(kMoving);
    EXPECT_EQ(find(scene, "spheres[0].center.x")->samples.size(), 2u);
    EXPECT_GT(find(scene, "spheres[0].center.z")->samples.size(), 2u);
    EXPECT_EQ(find(scene, "spheres[0].center.y"), nullptr);
}

TEST(Tabulate, RoundingWhereTermsCancelIsNoMotion) {
    // The plane of focus stays on the thing: its coordinates are 0 but for rounding, another one at every time.
    const Scene scene =
        scene_of("camera { location <0.2*Time,2,-4> look_at <0,0.4,0> aperture 0.2 focal_point <0,0.4,0> }");
    const Varying* table = find(scene, "camera.focal_point.x");
    if (table) {
        EXPECT_LT(std::abs(look_up(*table, 0.3)), 1e-12);
    }
    EXPECT_NE(find(scene, "camera.direction.x"), nullptr);
}

TEST(Tabulate, WhatCannotAlwaysBeFoldedIsNeverFolded) {
    // At Time 0 this sphere is round and this box straight; later they are not.
    const Scene scene = scene_of(kMoving);
    EXPECT_NE(scene.objects[1].transform, kNone);
    EXPECT_NE(scene.objects[2].transform, kNone);
    EXPECT_EQ(scene.objects[0].transform, kNone);
}

TEST(Tabulate, EveryNumberOfAFinishMayChange) {
    const Scene scene = scene_of("sphere { 0, 1 finish { brilliance 1 + Time glossy 0.5*Time } }");
    EXPECT_NE(find(scene, "materials[0].finish.brilliance"), nullptr);
    EXPECT_NE(find(scene, "materials[0].finish.glossy"), nullptr);
}

TEST(Tabulate, Wavelength) {
    const Scene scene = scene_of("sphere { 0, 1 interior { ior 1.5046 + 4200/(Wavelength*Wavelength) } }");
    const Varying* table = find(scene, "interiors[0].ior");
    ASSERT_NE(table, nullptr);
    EXPECT_EQ(table->variable, Varying::Variable::wavelength_nm);
    EXPECT_EQ(table->first, 380);
    EXPECT_EQ(table->last, 780);
    for (double nm : {380.0, 441.7, 587.6, 656.3, 780.0}) {
        EXPECT_NEAR(look_up(*table, nm), 1.5046 + 4200 / (nm * nm), table->error);
    }
}

TEST(Tabulate, ADefaultForPovRayIsLeftAlone) {
    const Scene scene = scene_of("#ifndef (Time) #declare Time = clock; #end sphere { Time*x, 1 }");
    EXPECT_EQ(scene.varying.size(), 1u);
}

TEST(Tabulate, UnusedVariablesCostNothing) { EXPECT_TRUE(scene_of("sphere { 0, 1 }").varying.empty()); }

// A scene that varies is read some twenty times. POV-Ray's transforms.inc has a macro with a parameter Time.
TEST(Tabulate, OthersWithTheNameAreNotTheVariable) {
    const std::string mesh =
        "mesh { triangle { 0, x, y } translate Far*x }";  // worked into the corners unless something varies
    for (const char* text :
         {"#declare Far = 1; #macro Move(Time, Wavelength) Time + Wavelength #end ",
          "#declare Time = 2; #declare Far = Time; ", "#declare Far = 1; #local Wavelength = Far; "}) {
        EXPECT_EQ(scene_of(text + mesh).objects[0].transform, kNone) << text;
    }
    EXPECT_NE(scene_of("#declare Time = 2*Time; #declare Far = Time; " + mesh).objects[0].transform, kNone);
}

TEST(Tabulate, SwitchedOffTheFirstValueStays) {
    ReadOptions options;
    options.tabulate = false;
    const Scene scene = scene_of("sphere { <5 + Time, Wavelength, 0>, 1 }", options);
    EXPECT_TRUE(scene.varying.empty());
    EXPECT_TRUE(near(scene.spheres[0].center, {5, 380, 0}));
}

TEST(Tabulate, WhatNoTableCanHoldIsAnError) {
    EXPECT_TRUE(contains(error_of("#if (Time > 0.3) sphere { 0, 1 } #end"), "other parts at Time"));
    EXPECT_TRUE(contains(error_of("sphere { <(Time > 0.3), 0, 0>, 1 }"), "too abruptly"));
    EXPECT_TRUE(contains(error_of("sphere { <Time*Wavelength, 0, 0>, 1 }"),
                         "spheres[0].center.x depends on Time and on Wavelength"));
    EXPECT_TRUE(contains(error_of("sphere { Time*x, 1 + Time*(Wavelength > 500) }"), "depends on"));
}

TEST(Tabulate, AWaveThatVanishesOnTheGridIsSeen) {
    const Scene scene = scene_of("sphere { <sin(16*pi*Time), 0, 0>, 1 }");
    const Varying* table = find(scene, "spheres[0].center.x");
    ASSERT_NE(table, nullptr);
    EXPECT_NEAR(look_up(*table, 1.0 / 32), 1, 1e-3);
}

}  // namespace
}  // namespace rays
