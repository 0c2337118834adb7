// Samples that are chosen eight at a time are those of step 5, and their pictures have the bytes of single rays.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "5_distributed/distributed.h"
#include "packets/camera_samples.h"
#include "renderer/needs.h"
#include "renderer/render.h"
#include "scene_reader/scene_reader.h"

namespace rays::packets::tests {
namespace {

TEST(CameraSamples, PointsAreSobolPointsBitForBit) {
    for (const std::uint32_t first : {0u, 8u, 16u, 1000u, 0x7ffffff0u})
        for (const std::uint32_t pixel : {0u, 1u, 77777u}) {
            Draw draw{.seed = 5 + first, .pixel = pixel, .samples = 64};
            draw.sample = first;
            SobolPoints sobol(draw);
            for (const std::uint32_t dimension : {0u, 1u, 2u, 3u, 5u, 0u, 4u}) {
                const Vec2s points = sobol.of(dimension);
                const Spread x(points.x), y(points.y);
                draw.dimension = dimension;
                for (draw.sample = first; draw.sample < first + kLanes; ++draw.sample) {
                    const auto i = static_cast<int>(draw.sample - first);
                    const Vec2 point = sobol_point(draw);
                    EXPECT_EQ(std::bit_cast<std::uint64_t>(x[i]), std::bit_cast<std::uint64_t>(point.x));
                    EXPECT_EQ(std::bit_cast<std::uint64_t>(y[i]), std::bit_cast<std::uint64_t>(point.y));
                }
            }
        }
}

constexpr const char* kThings =
    "plane { y, 0 pigment { checker rgb 1 rgb 0.4 } finish { ambient 0.1 diffuse 0.6 reflection 0.3 } }\n"
    "sphere { <0,1,0>, 1 pigment { rgb <1,0.5,0.2> } finish { diffuse 0.6 phong 0.5 } }\n"
    "sphere { <1.8,0.7,-1>, 0.7 pigment { rgbf 0.9 } finish { diffuse 0.1 reflection { 0, 1 fresnel on } "
    "conserve_energy } interior { ior 1.5 } }\n"
    "box { <-2.5,0,-1>, <-1.3,1.2,0.5> pigment { rgb <0.3,0.7,0.4> } finish { diffuse 0.6 } }\n";

/// What the camera and the light may be, and whether the floor is rough.
struct Variant {
    const char *name, *camera, *light, *more;
};

class Pictures : public testing::TestWithParam<Variant> {};

TEST_P(Pictures, AreThoseOfSingleRays) {
    const Variant& v = GetParam();
    Scene scene = read_scene_text(
        std::string("#version 3.7; global_settings { assumed_gamma 1.0 max_trace_level 4 }\ncamera { ") + v.camera +
            " }\nlight_source { <3,6,-4> rgb 1 " + v.light + " }\nlight_source { <-5,3,-2> rgb <0.2,0.2,0.3> }\n" +
            kThings + v.more,
        v.name);
    drop_what_is_not_needed(scene);
    prepare(scene);
    for (const int samples : {1, 3, 8, 21, 100})
        for (const Pattern pattern : {Pattern::sobol, Pattern::jittered})
            for (const float error : {0.0f, 0.02f}) {
                if (error > 0 && pattern != Pattern::sobol) continue;
                RenderOptions options{.raster = {23, 17},
                                      .samples = samples,
                                      .pattern = pattern,
                                      .error = error,
                                      .seed = 3,
                                      .threads = 2};
                Residual one, other;
                const Film together = render(scene, options, &one);
                options.packets = false;
                const Film alone = render(scene, options, &other);
                int differences = 0;
                for (int y = 0; y < 17; ++y)
                    for (int x = 0; x < 23; ++x)
                        for (int c = 0; c < 3; ++c)
                            differences += std::bit_cast<std::uint32_t>(together.at(x, y)[c]) !=
                                           std::bit_cast<std::uint32_t>(alone.at(x, y)[c]);
                EXPECT_EQ(differences, 0) << v.name << ", " << samples << " samples";
                EXPECT_EQ(one.mean, other.mean);
                EXPECT_EQ(one.samples, other.samples);
            }
}

constexpr const char *kEye = "location <0,2.2,-6> direction z*1.4 right x*4/3 up y",
                     *kSquare = "area_light x*1.5, z*1.5, 4, 4";
INSTANTIATE_TEST_SUITE_P(
    Distributed, Pictures,
    testing::Values(
        Variant{"area", kEye, kSquare, ""}, Variant{"disc", kEye, "area_light x*1.5, z*2.5, 4, 4 circular", ""},
        Variant{"ball", kEye, "area_light x*1.5, z*1.5, 4, 4 circular orient", ""},
        Variant{"lens", "location <0,2.2,-6> direction z*1.4 right x*4/3 up y aperture 0.6 focal_point <0,2.2,-1>", "",
                ""},
        Variant{"both",
                "location <0,2.2,-6> direction <0.1,-0.2,1.4> right x*4/3 up y aperture 0.6 focal_point <0,2,0>",
                kSquare, ""},
        Variant{
            "blades",
            "location <0,2.2,-6> direction z*1.4 right x*4/3 up y aperture 0.6 focal_point <0,2.2,0> aperture_blades 5",
            kSquare, ""},
        Variant{"orthographic",
                "orthographic location <0,2.2,-6> direction z right x*6 up y*4.5 aperture 0.8 focal_point <0,2,0>", "",
                ""},
        Variant{"rough", kEye, kSquare,
                "sphere { <0,0.4,-2>, 0.4 pigment { rgbf 0.9 } finish { reflection 0.3 glossy 0.02 } interior { ior "
                "1.4 } }\n"},
        Variant{"spotlight", kEye, "spotlight point_at 0 radius 15 falloff 25 area_light x, z, 4, 4", ""},
        Variant{"parallel", kEye, "parallel point_at 0 area_light x, z, 4, 4", ""},
        Variant{"smooth", kEye, kSquare,
                "smooth_triangle { <-2,0.1,-2>, <-1,1,-1>, <-1,0.1,-2>, <0,1,0>, <-1.5,1,-2>, <1,0,-1> pigment { rgb 1 "
                "} finish { reflection 0.5 glossy 0.05 } }\n"}),
    [](const auto& of) { return std::string(of.param.name); });

}  // namespace
}  // namespace rays::packets::tests
