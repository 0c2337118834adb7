// What POV-Ray 3.7.0.10 answered: one pixel by the conventions of mirrors, glass and their shadows that its manual
// leaves open. Measured with `povray +W1 +H1 +FP16 File_Gamma=1.0 -A` (16 bits a channel) and the scene text below.
#include <gtest/gtest.h>

#include <ostream>

#include "renderer/radiance.h"
#include "stage.h"

namespace rays::tests {
namespace {

struct Measured {
    const char* what;
    const char* scene;
    bool walls;        ///< with a red wall behind the camera and a green one beyond
    double colour[3];  ///< as POV-Ray rendered it
};

void PrintTo(const Measured& m, std::ostream* out) { *out << m.what; }

const char* const kWalls =
    "plane { -z, -20 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission rgb <0, 0.8, 0> } }\n"
    "plane { z, -20 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission rgb <0.8, 0, 0> } }\n";

const Measured kMeasured[] = {
    {"a mirror by Fresnel, straight on",
     "plane { z, 0 pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection { 0, 1 fresnel on } "
     "conserve_energy } interior { ior 1.5 } }",
     true,
     {0.031998, 0.000000, 0.000000}},
    {"the same at 45 degrees",
     "plane { <1, 0, -1>, 0 pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection { 0, 1 "
     "fresnel on } conserve_energy } interior { ior 1.5 } } background { rgb 0.8 }",
     false,
     {0.040192, 0.040192, 0.040192}},
    {"falloff at 45 degrees",
     "plane { <1, 0, -1>, 0 pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection { 0.1, 0.9 "
     "falloff 2 } } } background { rgb 0.8 }",
     false,
     {0.134905, 0.134905, 0.134905}},
    {"metal at 45 degrees",
     "plane { <1, 0, -1>, 0 pigment { rgb <0.9, 0.5, 0.2> } finish { ambient 0 diffuse 0 "
     "reflection { 0.8 metallic } } } background { rgb 0.8 }",
     false,
     {0.577676, 0.328405, 0.141451}},
    {"half metal at 75 degrees",
     "plane { <0.965926, 0, -0.258819>, 0 pigment { rgb <0.9, 0.5, 0.2> } finish { ambient 0 "
     "diffuse 0 reflection { 0.8 metallic 0.5 } } } background { rgb 0.8 }",
     false,
     {0.613306, 0.506508, 0.426413}},
    {"an exponent",
     "plane { z, 0 pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection { 0.7 } "
     "reflection_exponent 2 } }",
     true,
     {0.626093, 0.000000, 0.000000}},
    {"a lossless slab",
     "box { <-900, -900, 0>, <900, 900, 1> pigment { rgbt 1 } finish { ambient 0 diffuse 0 "
     "reflection { 0, 1 fresnel on } conserve_energy } interior { ior 1.5 } }",
     true,
     {0.061494, 0.737285, 0.000000}},
    {"a slab that does not conserve energy",
     "box { <-900, -900, 0>, <900, 900, 1> pigment { rgbt 1 } finish { ambient 0 diffuse 0 "
     "reflection { 0, 1 fresnel on } } interior { ior 1.5 } }",
     true,
     {0.063996, 0.800000, 0.000000}},
    {"a slab that absorbs by Beer",
     "box { <-900, -900, 0>, <900, 900, 1> pigment { rgbt 1 } finish { ambient 0 diffuse 0 "
     "reflection { 0, 1 fresnel on } conserve_energy } interior { ior 1.5 fade_distance 1 "
     "fade_power 1001 fade_color rgb 0.3 } }",
     true,
     {0.046647, 0.366125, 0.000000}},
    {"a slab that absorbs by the other law",
     "box { <-900, -900, 0>, <900, 900, 1> pigment { rgbf <0.9, 0.8, 0.7, 0.9> } finish { ambient "
     "0 diffuse 0 } interior { ior 1.5 fade_distance 0.7 fade_power 2 fade_color rgb <0.5, 0.3, "
     "0.1> } }",
     true,
     {0.000000, 0.219883, 0.000000}},
    {"a fade_power of 0 in a slab",
     "box { <-900, -900, 0>, <900, 900, 1> pigment { rgbt 1 } finish { ambient 0 diffuse 0 } "
     "interior { ior 1.5 fade_distance 0.7 fade_color rgb <0.5, 0.3, 0.1> } }",
     true,
     {0.000000, 0.519997, 0.000000}},
    {"filter and transmit",
     "box { <-900, -900, 0>, <900, 900, 1> pigment { rgbft <0.9, 0.6, 0.3, 0.5, 0.25> } finish { "
     "ambient 0 diffuse 0 emission 0.2 } }",
     true,
     {0.076493, 0.288502, 0.020996}},
    {"a mirror that lets light through",
     "box { <-900, -900, 0>, <900, 900, 1> pigment { rgbft <0.9, 0.6, 0.3, 0.5, 0.25> } finish { "
     "ambient 0 diffuse 0 reflection 0.3 } }",
     true,
     {0.368185, 0.263783, 0.000000}},
    {"the same with energy conserved",
     "box { <-900, -900, 0>, <900, 900, 1> pigment { rgbft <0.9, 0.6, 0.3, 0.5, 0.25> } finish { "
     "ambient 0 diffuse 0 reflection 0.3 conserve_energy } }",
     true,
     {0.302815, 0.129259, 0.000000}},
    {"mirrors in a row, five levels",
     "plane { -z, -5 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 0.1 reflection 0.8 } "
     "} plane { z, -12 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 0.1 reflection 0.8 "
     "} }",
     false,
     {0.336156, 0.336156, 0.336156}},
    {"mirrors in a row, pruned by weight",
     "global_settings { max_trace_level 50 adc_bailout 0.3 } plane { -z, -5 pigment { rgb 1 } "
     "finish { ambient 0 diffuse 0 emission 0.1 reflection 0.8 } } plane { z, -12 pigment { rgb 1 "
     "} finish { ambient 0 diffuse 0 emission 0.1 reflection 0.8 } }",
     false,
     {0.368933, 0.368933, 0.368933}},
    {"mirrors by angle in a row, pruned by the weight of max",
     "global_settings { max_trace_level 50 adc_bailout 0.3 } plane { -z, -5 pigment { rgb 1 } "
     "finish { ambient 0 diffuse 0 emission 0.1 reflection { 0.2, 0.8 falloff 2 } } } plane { z, "
     "-12 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 0.1 reflection { 0.2, 0.8 "
     "falloff 2 } } }",
     false,
     {0.124987, 0.124987, 0.124987}},
    {"blue glass below adc_bailout by its grey",
     "global_settings { adc_bailout 0.2 } disc { 0, z, 3 pigment { rgbf <0, 0.05, 0.9, 1> } finish "
     "{ ambient 0 diffuse 0 } }",
     true,
     {0.000000, 0.000000, 0.000000}},
    {"glass of weight below adc_bailout",
     "global_settings { adc_bailout 0.5 } disc { 0, z, 3 pigment { rgbf <0.7, 0.7, 0.7, 0.6> } "
     "finish { ambient 0 diffuse 0 } }",
     true,
     {0.000000, 0.000000, 0.000000}},
    {"nine sheets are one level",
     "global_settings { max_trace_level 2 } #declare I = 0; #while (I < 9) disc { I*z, z, 3 "
     "pigment { rgbt 0.9 } finish { ambient 0 diffuse 0 } } #declare I = I + 1; #end",
     true,
     {0.000000, 0.309941, 0.000000}},
    {"glass in glass: leaving the inner one reflects nothing",
     "box { <-900, -900, 0>, <900, 900, 1> pigment { rgbt 1 } finish { ambient 0 diffuse 0 "
     "reflection { 0, 1 fresnel on } conserve_energy } interior { ior 1.3 } } box { <-9, -9, 0.3>, "
     "<9, 9, 0.7> pigment { rgbt 1 } finish { ambient 0 diffuse 0 reflection { 0, 1 fresnel on } "
     "conserve_energy } interior { ior 2 } }",
     true,
     {0.048386, 0.738231, 0.000000}},
    {"an overlap",
     "box { <-900, -900, 0>, <900, 900, 1> pigment { rgbt 1 } finish { ambient 0 diffuse 0 "
     "reflection { 0, 1 fresnel on } conserve_energy } interior { ior 1.3 } } box { <-9, -9, 0.3>, "
     "<9, 9, 1.7> pigment { rgbt 1 } finish { ambient 0 diffuse 0 reflection { 0, 1 fresnel on } "
     "conserve_energy } interior { ior 2 } }",
     true,
     {0.048386, 0.637522, 0.000000}},
    {"from within glass, beyond the critical angle",
     "plane { <0.866025, 0, -0.5>, 0 inverse pigment { rgbf <0.5, 0.6, 0.7, 0.8> } finish { "
     "ambient 0 diffuse 0 reflection 0.2 } interior { ior 1.5 fade_distance 8 fade_power 1001 "
     "fade_color rgb <0.9, 0.5, 0.3> } } background { rgb <0.8, 0.7, 0.6> }",
     false,
     {0.706004, 0.374685, 0.250111}},
    {"the shadow of a sheet",
     "light_source { <0, 0, -20>, rgb 0.9 } disc { <0, 0, -15>, z, 3 pigment { rgbft <0.9, 0.6, "
     "0.3, 0.5, 0.25> } } plane { z, 0 pigment { rgb 1 } finish { ambient 0 diffuse 0.8 } }",
     false,
     {0.504005, 0.396002, 0.287999}},
    {"the shadow of a ball that fades",
     "light_source { <0, 0, -20>, rgb 0.9 } sphere { <0, 0, -15>, 2 pigment { rgbf <0.9, 0.8, 0.7, "
     "0.9> } interior { ior 1.5 fade_distance 3 fade_power 1001 fade_color rgb <0.5, 0.3, 0.1> } } "
     "plane { z, 0 pigment { rgb 1 } finish { ambient 0 diffuse 0.8 } }",
     false,
     {0.242527, 0.146777, 0.086076}},
    {"the shadow of a ball with a bubble",
     "light_source { <0, 0, -20>, rgb 0.9 } sphere { <0, 0, -15>, 2 pigment { rgbt 1 } interior { "
     "ior 1.5 fade_distance 3 fade_power 1001 fade_color rgb <0.5, 0.3, 0.1> } } sphere { <0, 0, "
     "-15>, 1 pigment { rgbt 1 } interior { ior 1 } } plane { z, 0 pigment { rgb 1 } finish { "
     "ambient 0 diffuse 0.8 } }",
     false,
     {0.609461, 0.570153, 0.533394}},
    {"opaque behind clear",
     "light_source { <0, 0, -20>, rgb 0.9 } disc { <0, 0, -15>, z, 3 pigment { rgbt 0.5 } } disc { "
     "<0, 0, -16>, z, 3 pigment { rgb 1 } } plane { z, 0 pigment { rgb 1 } finish { ambient 0 "
     "diffuse 0.8 } }",
     false,
     {0.000000, 0.000000, 0.000000}},
    {"an inverse ball far away is not around the camera: its box is asked first",
     "sphere { <30, 0, 0>, 1 inverse pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { ior 1.5 } } "
     "sphere { 0, 2 pigment { rgbt 1 } finish { ambient 0 diffuse 0 reflection { 0, 1 fresnel on } conserve_energy } "
     "interior { ior 1.5 } }",
     true,
     {0.061494, 0.737285, 0.000000}},
    {"in the box of an inverse ball and outside of the ball it is",
     "sphere { <6, 6, -4>, 7 inverse pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { ior 1.5 } } "
     "sphere { 0, 2 pigment { rgbt 1 } finish { ambient 0 diffuse 0 reflection { 0, 1 fresnel on } conserve_energy } "
     "interior { ior 1.5 } }",
     true,
     {0.000000, 0.800000, 0.000000}},
};

class OnePixel : public testing::TestWithParam<Measured> {};

TEST_P(OnePixel, IsWhatPovrayRendered) {
    const Measured& m = GetParam();
    const Scene scene = staged(std::string(m.scene) + "\n" + (m.walls ? kWalls : ""));
    const BruteForce intersector(scene);
    World world = make_world(scene, intersector);
    const Vec3 camera(0, 0, -10);
    const Radiance found = radiance(world, {camera, {0, 0, 1}}, media_around(scene, camera));
    for (int c = 0; c < 3; ++c) {
        // The grid of 16 bits, POV-Ray's rounding on the way to it, and six digits in the table.
        EXPECT_NEAR(found[c], m.colour[c], 2.0 / 65535) << "lane " << c << " of " << m.what;
    }
}

INSTANTIATE_TEST_SUITE_P(Measured, OnePixel, testing::ValuesIn(kMeasured));

}  // namespace
}  // namespace rays::tests
