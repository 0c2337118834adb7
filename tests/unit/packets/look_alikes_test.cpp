// Which materials are lit in the same go.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "packets/shading.h"
#include "scene_reader/scene_reader.h"

namespace rays::packets {
namespace {

using Numbers = std::vector<std::uint32_t>;

Numbers look_alikes_of(const std::vector<std::string>& textures) {
    std::string text;
    for (const std::string& texture : textures) text += "sphere { 0, 1 texture { " + texture + " } }\n";
    const Scene scene = read_scene_text(text, "looks");
    EXPECT_EQ(scene.materials.size(), textures.size());
    return look_alikes(scene);
}

TEST(LookAlikes, OpaqueColoursOfTheSameFinish) {
    const std::string finish = " finish { diffuse 0.5 reflection { 0.2 metallic } }";
    EXPECT_EQ(look_alikes_of({"pigment { rgb 1 }" + finish, "pigment { rgb 0.5 }", "pigment { rgb <1, 0, 0> }" + finish,
                              "pigment { rgb <1, 0, 1> }"}),
              (Numbers{0, 1, 0, 1}));
}

TEST(LookAlikes, NotOfFinishesThatDifferAnywhere) {
    for (const char* other :
         {"finish { diffuse 0.51 }", "finish { ambient rgb <0.1, 0.1, 0.11> }", "finish { emission 0.1 }",
          "finish { phong 1 }", "finish { phong_size 41 }", "finish { specular 1 }", "finish { roughness 0.06 }",
          "finish { metallic }", "finish { brilliance 2 }", "finish { reflection 0.1 }",
          "finish { reflection { 0, 0 fresnel } }", "finish { reflection { 0 metallic } }",
          "finish { reflection { 0 exponent 2 } }", "finish { reflection { 0 falloff 2 } }",
          "finish { conserve_energy }"})
        EXPECT_EQ(look_alikes_of({"pigment { rgb 1 }", std::string("pigment { rgb 1 } ") + other}), (Numbers{0, 1}))
            << other;
}

TEST(LookAlikes, ClearOnesAndCheckersOnlyIfTheyAreTheSame) {
    EXPECT_EQ(
        look_alikes_of({"pigment { rgbt <1, 1, 1, 0.5> }", "pigment { rgbt <1, 1, 0, 0.5> }",
                        "pigment { rgbt <1, 1, 1, 0.5> }", "pigment { rgbf <1, 1, 1, 0.5> }", "pigment { rgb 1 }"}),
        (Numbers{0, 1, 0, 3, 4}));
    EXPECT_EQ(look_alikes_of({"pigment { checker rgb 1 rgb 0 }", "pigment { checker rgb 1 rgb 0.5 }",
                              "pigment { checker rgb 1 rgb 0 }", "pigment { checker rgb 1 rgb 0 scale 2 }",
                              "pigment { rgb 1 }"}),
              (Numbers{0, 1, 0, 3, 4}));
}

TEST(LookAlikes, OfManyLooksTheFirstAreKnown) {
    std::vector<std::string> textures;
    for (int n = 0; n < 60; ++n)
        textures.push_back(fmt::format("pigment {{ rgb 0.{} }} finish {{ diffuse 0.{} }}", n, 10 + n / 2));
    const Numbers alike = look_alikes_of(textures);
    for (std::uint32_t n = 0; n < 60; ++n) EXPECT_EQ(alike[n], n < 32 ? n / 2 * 2 : n);
}

}  // namespace
}  // namespace rays::packets
