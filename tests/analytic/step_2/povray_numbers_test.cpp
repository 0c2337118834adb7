// What POV-Ray 3.7.0.10 answered: one pixel of a plane seen straight on, by the light conventions that its manual
// leaves open. Measured with `povray +W1 +H1 +FP16 File_Gamma=1.0 -A` (16 bits a channel) and the scene text below.
#include <gtest/gtest.h>

#include "renderer/radiance.h"
#include "stage.h"

namespace rays::tests {
namespace {

struct Measured {
    const char* finish;
    const char* scene;
    double red;  ///< as POV-Ray rendered it; the pigment's red is 0.8
};

const Measured kMeasured[] = {
    // A light at 60 degrees, colour 0.5: no 1 / pi.
    {"diffuse 0.6", "light_source { <sqrt(3), 0, -1> rgb 0.5 }", 0.11999694819562066},
    // Brilliance is a power of the cosine; with albedo the reflected energy stays as stated.
    {"diffuse 0.6 brilliance 3", "light_source { <sqrt(3), 0, -1> rgb 0.5 }", 0.029999237048905166},
    {"diffuse albedo 0.6 brilliance 3", "light_source { <sqrt(3), 0, -1> rgb 0.5 }", 0.05999847409781033},
    {"diffuse 0.6 brilliance 0.5", "light_source { <sqrt(3), 0, -1> rgb 0.5 }", 0.1697108415350576},
    {"diffuse 0.6 brilliance 0", "light_source { <sqrt(3), 0, -1> rgb 0.5 }", 0.23999389639124133},
    // Parallel rays, in front of and behind the light's plane: behind, lit all the same, and through any occluder.
    {"diffuse 1", "light_source { <sqrt(3), 0, -1> rgb 0.5 parallel point_at <0, 0, -0.5> }", 0.11093308918898298},
    {"diffuse 1", "light_source { <0, 0, 1> rgb 0.5 parallel point_at <0, 0, 2> }", 0.4},
    {"diffuse 1",
     "light_source { <0, 0, 1> rgb 0.5 parallel point_at <0, 0, 2> } sphere { <0, 0, -7>, 0.3 pigment { rgb 1 } }",
     0.4},
    // A spotlight made parallel has no rim; behind it there is nothing.
    {"diffuse 1", "light_source { <2, 0, -2> rgb 0.5 spotlight parallel radius 5 falloff 10 point_at <2, 0, 0> }", 0.4},
    {"diffuse 1", "light_source { <2, 0, 2> rgb 0.5 spotlight parallel radius 5 falloff 10 point_at <2, 0, 3> }", 0.0},
    // 45 degrees off a spotlight's axis, times 0.8 * 0.5 / sqrt(2).
    {"diffuse 1", "light_source { <2, 0, -2> rgb 0.5 spotlight radius 20 falloff 60 point_at <2, 0, 0> }",
     0.45656860373706815 * 0.4 * 0.70710678118654752},
    {"diffuse 1", "light_source { <2, 0, -2> rgb 0.5 spotlight radius 60 falloff 20 point_at <2, 0, 0> }",
     0.4 * 0.70710678118654752},
    {"diffuse 1", "light_source { <2, 0, -2> rgb 0.5 spotlight radius 20 falloff 60 tightness 3 point_at <2, 0, 0> }",
     0.1614147775471237 * 0.4 * 0.70710678118654752},
    {"diffuse 1", "light_source { <2, 0, -2> rgb 0.5 spotlight radius 95 falloff 100 point_at <2, 0, 0> }",
     0.4 * 0.70710678118654752},
    // 2 off a cylinder's axis.
    {"diffuse 1", "light_source { <2, 0, -2> rgb 0.5 cylinder radius 1 falloff 4 point_at <2, 0, 0> }",
     0.7407492179751277 * 0.4},
    {"diffuse 1", "light_source { <2, 0, -2> rgb 0.5 cylinder radius 1 falloff 4 tightness 3 point_at <2, 0, 0> }",
     0.09258411535820553 * 0.4},
    {"diffuse 1", "light_source { <2, 0, -2> rgb 0.5 cylinder radius 0 falloff 4 point_at <2, 0, 0> }", 0.4},
    // A shadowless light makes no highlight.
    {"diffuse 0 phong 1", "light_source { <0, 0, -2> rgb 0.5 shadowless }", 0.0},
    {"diffuse 0 phong 1", "light_source { <0, 0, -2> rgb 0.5 }", 0.5000076295109483},
    {"diffuse 0 specular 1", "light_source { <0, 0, -2> rgb 0.5 shadowless }", 0.0},
    // Exponents: 100 at acos(0.998752), as phong and as specular; 0.
    {"diffuse 0 phong 0.7 phong_size 100", "light_source { <0.1, 0, -2> rgb 0.5 }", 0.30891889829861907},
    {"diffuse 0 specular 0.7 roughness 0.01", "light_source { <0.1, 0, -2> rgb 0.5 }", 0.33925383382925156},
    {"diffuse 0 phong 0.7 phong_size 0", "light_source { <1, 0, -2> rgb 0.5 }", 0.3499961852445258},
    // Metal under light at 71.6 degrees, whole and half.
    {"diffuse 0 phong 0.7 phong_size 1 metallic 1", "light_source { <3, 0, -1> rgb 0.5 }", 0.09134050507362478},
    {"diffuse 0 specular 0.7 roughness 1 metallic 0.5", "light_source { <3, 0, -1> rgb 0.5 }", 0.25912870984969866},
    // Fading.
    {"diffuse 1", "light_source { <0, 0, -6> rgb 0.5 fade_distance 2 fade_power 3 }", 0.0285648889906157},
    {"diffuse 1", "light_source { <0, 0, -6> rgb 0.5 fade_distance 2 }", 0.4},
    {"diffuse 1", "light_source { <0, 0, -3> rgb 0.5 parallel point_at <0, 0, 2> fade_distance 2 fade_power 1.5 }",
     0.2819714656290532},
    // A light in the surface.
    {"diffuse 1", "light_source { <0, 0, 0> rgb 0.5 }", 0.0},
};

class OnePixel : public testing::TestWithParam<Measured> {};

TEST_P(OnePixel, IsWhatPovrayRendered) {
    const Measured& m = GetParam();
    const Scene scene = staged("plane { z, 0 pigment { rgb <0.8, 0.4, 0.2> } finish { ambient 0 " +
                               std::string(m.finish) + " } }\n" + m.scene);
    const BruteForce intersector(scene);
    World world = make_world(scene, intersector);
    const double red = radiance(world, {{0, 0, -5}, {0, 0, 1}}, {})[0];
    // The grid of 16 bits, and POV-Ray's own rounding on the way to it: its 0.12 is written as 0.119997.
    EXPECT_NEAR(red, m.red, 2.0 / 65535) << m.finish << "; " << m.scene;
}

INSTANTIATE_TEST_SUITE_P(Measured, OnePixel, testing::ValuesIn(kMeasured));

}  // namespace
}  // namespace rays::tests
