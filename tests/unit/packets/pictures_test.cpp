// A picture has the same bytes with packets and without: the scenes of all steps, and scenes made to be hard on lanes.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include <fmt/format.h>

#include "renderer/needs.h"
#include "renderer/packets.h"
#include "renderer/render.h"
#include "scene_reader/scene_reader.h"
#include "scene_writer.h"

namespace rays::packets::tests {
namespace {

namespace fs = std::filesystem;

struct Picture {
    Film film;
    Residual residual;
};

Picture picture_of(const Scene& scene, RenderOptions options, bool packets) {
    Residual residual;
    options.packets = packets;
    Film film = render(scene, options, &residual);
    return {std::move(film), residual};
}

/// The same bits in every channel.
void expect_same_film(const Film& got, const Film& expected) {
    const auto [width, height] = expected.raster();
    int differences = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c) {
                const float a = got.at(x, y)[c], b = expected.at(x, y)[c];
                if (std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b) || differences++ > 0) continue;
                ADD_FAILURE() << fmt::format("first difference: pixel {}, {}, channel {}: {:.9g} instead of {:.9g}", x,
                                             y, c, a, b);
            }
    EXPECT_EQ(differences, 0);
}

/// Packets and single rays: the same bits, and the same residual.
void expect_same_picture(const Scene& scene, const RenderOptions& options) {
    const Picture together = picture_of(scene, options, true), alone = picture_of(scene, options, false);
    SCOPED_TRACE(fmt::format("{} x {}, {} samples, {} threads", options.raster.width, options.raster.height,
                             options.samples, options.threads));
    expect_same_film(together.film, alone.film);
    EXPECT_EQ(together.residual.mean, alone.residual.mean);
    EXPECT_EQ(together.residual.max, alone.residual.max);
    EXPECT_EQ(together.residual.x, alone.residual.x);
    EXPECT_EQ(together.residual.y, alone.residual.y);
}

/// As the render program does it.
Scene staged(Scene scene) {
    require_built(scene);
    drop_what_is_not_needed(scene);
    prepare(scene);
    return scene;
}
Scene staged(const std::string& text) { return staged(read_scene_text(text, "test")); }

// ---- The scenes of the steps ----------------------------------------------------------------------------------------

std::vector<std::string> scenes_of_the_steps() {
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(SCENES_DIR)) {
        const std::string name = fs::relative(entry.path(), SCENES_DIR).string();
        if (entry.path().extension() == ".pov" && name[0] >= '1' && name[0] <= '9') names.push_back(name);
    }
    std::sort(names.begin(), names.end());
    return names;
}

class SamePicture : public testing::TestWithParam<std::string> {};

TEST_P(SamePicture, WithPacketsAndWithout) {
    for (const RenderOptions& options : {RenderOptions{.raster = {96, 72}, .samples = 1, .threads = 1},
                                         RenderOptions{.raster = {37, 21}, .samples = 9, .threads = 2},
                                         RenderOptions{.raster = {37, 21}, .samples = 1, .threads = 2},
                                         RenderOptions{.raster = {1, 1}, .samples = 1, .threads = 1},
                                         RenderOptions{.raster = {1, 1}, .samples = 9, .threads = 2}}) {
        ReadOptions reading;
        reading.raster = options.raster;
        const Scene scene = staged(read_scene(fs::path(SCENES_DIR) / GetParam(), reading));
        expect_same_picture(scene, options);
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, SamePicture, testing::ValuesIn(scenes_of_the_steps()), [](const auto& of) {
    std::string name = of.param;
    std::replace_if(
        name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
    return name;
});

TEST(PacketPictures, ComeFromPackets) {
    // Else all of these would compare single rays with single rays.
    EXPECT_TRUE(make_packets(staged(std::string("sphere { 0, 1 }"))));
    EXPECT_GE(scenes_of_the_steps().size(), 50u);
}

// ---- Scenes by chance -----------------------------------------------------------------------------------------------

/// RAYSTEPS_CHANCE_SCENES=1000 looks at more than the tests have time for.
int scenes_a_test() {
    const char* wanted = std::getenv("RAYSTEPS_CHANCE_SCENES");
    return wanted ? std::atoi(wanted) : 40;
}

class ScenesByChance : public testing::TestWithParam<int> {};

TEST_P(ScenesByChance, RenderTheSamePicture) {
    for (int n = 0; n < scenes_a_test(); ++n) {
        const auto seed = std::uint64_t(GetParam() * scenes_a_test() + n);
        const std::string text = SceneWriter(seed).scene();
        SCOPED_TRACE(fmt::format("seed {}:\n{}", seed, text));
        expect_same_picture(staged(text), {.raster = {31, 22}, .samples = n % 4 ? 1 : 4, .threads = 1});
        if (testing::Test::HasFailure()) return;
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, ScenesByChance, testing::Range(0, 8));

// ---- What has a way of its own --------------------------------------------------------------------------------------

const std::string kHead =
    "#version 3.7; global_settings { assumed_gamma 1.0 }\ncamera { location <0, 1, -5> direction z right x * 4/3 up y "
    "}\n";

TEST(PacketPictures, AreTheSameOfNothingAndOfOneThing) {
    for (const char* text : {"", "background { rgb <0.1, 0.2, 0.3> }", "sphere { 0, 1 }",
                             "light_source { 3, rgb 1 } sphere { 0, 1 }", "light_source { 0, rgb 1 } plane { y, 0 }",
                             "light_source { <0, 0, -1>, rgb 1 } torus { 1, 0.3 rotate 60 * x }"})
        for (const Raster raster : {Raster{33, 18}, Raster{3, 3}, Raster{1, 7}, Raster{9, 1}})
            expect_same_picture(staged(kHead + text), {.raster = raster, .threads = 1});
}

TEST(PacketPictures, AreTheSameWhereTheLightStandsOnTheSurface) {
    expect_same_picture(
        staged(kHead +
               "light_source { <0, 0, -1>, rgb 1 } sphere { 0, 1 finish { phong 1 specular 1 } } plane { y, -1 }"),
        {.raster = {40, 30}, .threads = 1});
}

TEST(PacketPictures, EndBelowAThousandBranches) {
    const Scene sheets = staged(
        "#version 3.7; global_settings { assumed_gamma 1.0 adc_bailout 0 }\n"
        "camera { location <0, 0, -5> direction z right x up y }\n"
        "#for (I, 1, 10000) disc { <0, 0, I / 100>, z, 50000 pigment { rgbt <1, 1, 1, 0.9999> } } #end\n");
    const RenderOptions options{.raster = {8, 4}, .threads = 1};
    expect_same_picture(sheets, options);
    // What a thousand sheets let through of what is behind; the others are left out, and counted. Weights are floats: a
    // thousand roundings of 2^-25 each.
    EXPECT_NEAR(picture_of(sheets, options, true).residual.max, std::pow(double(0.9999f), kMostAbove), 1000 * 0x1p-25);
}

// The film of a parallel camera that nothing cuts lies in the same media everywhere; one that something cuts does not.
TEST(PacketPictures, AreTheSameFromFilmsApartAndInside) {
    for (const char* film : {"<0, 0, -10>", "<0, 0, -1>", "<0.5, 0, 0>", "<0, 0, 3>"})
        expect_same_picture(
            staged(fmt::format("#version 3.7; global_settings {{ assumed_gamma 1.0 }}\n"
                               "camera {{ orthographic location {} right 4 * x up 3 * y direction z }}\n",
                               film) +
                   "background { rgb 0.3 } light_source { <4, 5, -9>, rgb 1 }\n"
                   "sphere { 0, 1.2 pigment { rgbt <1, 0.9, 0.8, 0.8> } interior { ior 1.4 } }\n"
                   "plane { -z, -2.5 pigment { rgbt <0.5, 1, 0.5, 0.5> } interior { ior 1.1 } }\n"),
            {.raster = {40, 30}, .threads = 1});
}

TEST(PacketPictures, AreTheSameFromWhereFloatsEnd) {
    for (const char* from : {"1e12", "1e30", "1e39", "1e60"})
        for (const char* camera : {"camera { location <0, 0, -D> direction z right x up y }\n",
                                   "camera { location <D, -D, D> right x up y look_at 0 }\n"})
            expect_same_picture(
                staged(fmt::format("#version 3.7; global_settings {{ assumed_gamma 1.0 }} background {{ rgb 0.5 "
                                   "}}\n#declare D = {};\n",
                                   from) +
                       camera + "light_source { 5, rgb 1 } sphere { 0, 1 } sphere { <1, 2, 3>, 0.5 } plane { y, -1 }"),
                {.raster = {9, 6}, .threads = 1});
}

TEST(PacketPictures, AreTheSameWhereThingsStandTooNearToCastAShadow) {
    // 0.0005 from the light, and as near to what they would shade: shadow rays leave out 0.001 at both ends.
    const Scene scene = staged(kHead +
                               "light_source { <2, 3, -2>, rgb 1 } sphere { <2, 3, -2>, 0.0005 } plane { y, 0 }\n"
                               "disc { <0, 0.0005, 0>, y, 0.5 pigment { rgb <1, 0, 0> } } sphere { <0, 1, 1>, 0.7 }");
    const RenderOptions options{.raster = {40, 30}, .threads = 1};
    expect_same_picture(scene, options);
    const Film film = render(scene, options);
    EXPECT_GT(film.at(20, 20)[0], 0.3f) << "the floor is lit";
}

TEST(PacketPictures, LeaveOddSettingsToSingleRays) {
    Scene scene = staged(kHead + "light_source { 5, rgb 1 } sphere { 0, 1 finish { reflection 0.5 } }");
    scene.settings.adc_bailout = -1;
    EXPECT_FALSE(make_packets(scene)) << "what weighs nothing is traced, too";
    scene.settings.adc_bailout = 0;
    scene.settings.max_trace_level = 0;
    EXPECT_FALSE(make_packets(scene));
    expect_same_picture(scene, {.raster = {12, 9}, .threads = 1});
}

TEST(PacketPictures, AreTheSameForAnyNumberOfThreads) {
    const Scene scene = staged(SceneWriter(3).scene());
    const RenderOptions one{.raster = {41, 33}, .threads = 1};
    const Film alone = render(scene, one);
    for (const int threads : {2, 5, 40}) {
        RenderOptions many = one;
        many.threads = threads;
        SCOPED_TRACE(fmt::format("{} threads", threads));
        expect_same_film(render(scene, many), alone);
    }
}

TEST(PacketPictures, ProgressEndsAtOne) {
    for (const int height : {1, 8, 9}) {
        double last = 0;
        RenderOptions options{.raster = {4, height}, .threads = 1};
        options.progress = [&](double done) {
            EXPECT_GE(done, last);
            last = done;
        };
        render(staged(kHead + "sphere { 0, 1 }"), options);
        EXPECT_EQ(last, 1) << height << " rows";
    }
}

}  // namespace
}  // namespace rays::packets::tests
