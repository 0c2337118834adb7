// A picture has the same bytes with packets and without: the scenes of all steps, and scenes made to be hard on lanes.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <vector>

#include <fmt/format.h>

#include "renderer/needs.h"
#include "renderer/packets.h"
#include "renderer/render.h"
#include "scene_reader/scene_reader.h"

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
                ADD_FAILURE() << fmt::format("first difference: pixel {}, {}, channel {}: {:.9g} instead of {:.9g}", x, y, c, a, b);
            }
    EXPECT_EQ(differences, 0);
}

/// Packets and single rays: the same bits, and the same residual.
void expect_same_picture(const Scene& scene, const RenderOptions& options) {
    const Picture together = picture_of(scene, options, true), alone = picture_of(scene, options, false);
    SCOPED_TRACE(fmt::format("{} x {}, {} samples, {} threads", options.raster.width, options.raster.height, options.samples, options.threads));
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
    std::replace_if(name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
    return name;
});

TEST(PacketPictures, ComeFromPackets) {
    // Else all of these would compare single rays with single rays.
    EXPECT_TRUE(make_packets(staged(std::string("sphere { 0, 1 }"))));
    EXPECT_GE(scenes_of_the_steps().size(), 50u);
}

// ---- Scenes by chance -----------------------------------------------------------------------------------------------

/// Writes scenes in which everything that shading and recursion know occurs, in all combinations sooner or later.
class SceneWriter {
public:
    explicit SceneWriter(std::uint64_t seed) : bits_(seed) {}

    std::string scene() {
        std::string text = fmt::format("#version 3.7; global_settings {{ assumed_gamma 1.0 max_trace_level {} adc_bailout {} ambient_light rgb {} }}\n",
                                       pick({"1", "2", "5", "12"}), pick({"0", "1/255", "0.05", "0.4"}), number(0.5, 1.5));
        text += camera() + fmt::format("background {{ rgb {} }}\n", vector(0, 1));
        for (int i = 1 + below(3); i-- > 0;) text += light();
        text += "#declare M1 = interior { ior 1.5 } #declare M2 = interior { ior 1.2 fade_distance 0.7 fade_power 1000 fade_color rgb <0.2, 0.7, 0.4> }\n";
        text += "#declare T = texture { " + pigment() + " }\n";
        if (chance(3)) text += fmt::format("plane {{ y, -2 {} }}\n", texture());
        for (int i = 3 + below(12); i-- > 0;) text += object();
        return text;
    }

private:
    double unit() { return double(bits_() >> 11) * 0x1p-53; }
    int below(int n) { return int(bits_() % std::uint64_t(n)); }
    bool chance(int one_in) { return below(one_in) == 0; }
    std::string pick(std::initializer_list<const char*> words) { return words.begin()[below(int(words.size()))]; }
    std::string number(double low, double high) { return fmt::format("{:.4f}", low + (high - low) * unit()); }
    std::string vector(double low, double high) {
        const std::string x = number(low, high), y = number(low, high);
        return "<" + x + ", " + y + ", " + number(low, high) + ">";
    }
    std::string maybe(int one_in, const std::string& text) { return chance(one_in) ? " " + text : ""; }

    std::string camera() {
        if (chance(6)) return "camera { orthographic location <0, 1, -6> right x * 5 up y * 4 look_at 0 }\n";
        if (chance(6)) return "camera { location <0.1, 0.2, -0.3> right x * 4/3 look_at <1, 0.3, 2> angle 90 }\n";  // perhaps inside of something
        return "camera { location <0, 1, -6> right x * 4/3 look_at 0 angle 50 }\n";
    }
    std::string light() {
        const std::string kind = pick({"", "", "spotlight point_at 0 radius 10 falloff 35 tightness 3", "cylinder point_at 0 radius 2 falloff 4 tightness 2",
                                       "parallel point_at 0", "spotlight parallel point_at <0, -1, 0> radius 20 falloff 40"});
        return fmt::format("light_source {{ {}, rgb {} {}{}{} }}\n", vector(-6, 6), vector(chance(6) ? -0.6 : 0, 1.2), kind, maybe(6, "shadowless"),
                           maybe(3, fmt::format("fade_distance {} fade_power {}", number(1, 8), pick({"1", "2", "3", "1.7"}))));
    }
    std::string color() {
        if (chance(3)) return pick({"rgbf <1, 0.8, 0.6, 0.7>", "rgbt <0.2, 0.5, 1, 0.6>", "rgbft <0.9, 1, 0.9, 0.4, 0.5>", "rgbf 1", "rgbft <1, 1, 1, 0.8, 0.6>", "rgbf <0, 0, 0, 1>"});
        return "rgb " + vector(chance(8) ? -0.5 : 0, 1);
    }
    std::string pigment() {
        if (chance(4)) return fmt::format("pigment {{ checker {} {} scale {} rotate {} }}", color(), color(), number(0.2, 1), vector(0, 90));
        return "pigment { " + color() + " }";
    }
    std::string mirror() {
        const std::string range = pick({"0.4", "1", "rgb <0.9, 0.5, 0.1>", "0.1, rgb <0.8, 0.9, 1>", "0, 1", "1.2"});
        return fmt::format("reflection {{ {}{}{}{}{} }}", range, maybe(3, "fresnel on"), maybe(4, "falloff " + number(0.5, 5)),
                           maybe(5, "exponent " + pick({"0.5", "2", "1.3"})), maybe(5, "metallic"));
    }
    std::string texture() {
        return fmt::format("{} finish {{ ambient {} diffuse {}{}{}{}{}{}{} }}{}{}", pigment(), pick({"0", "0.1", "rgb <0.1, 0.2, 0.3>"}), pick({"0", "0.6", "0.9"}),
                           maybe(6, "emission rgb " + vector(0, 0.3)), maybe(3, fmt::format("phong {} phong_size {}", number(0.1, 1), number(1, 120))),
                           maybe(3, fmt::format("specular {} roughness {}", number(0.1, 1), number(0.005, 0.5))), maybe(5, "metallic"), maybe(2, mirror()),
                           maybe(4, "conserve_energy"), maybe(2, "interior { " + pick({"M1", "M2", "ior 1.33", "ior 0.8", "ior 1"}) + " }"), maybe(8, "no_shadow"));
    }
    std::string shape() {
        switch (below(11)) {
            case 0: case 1: case 2: return fmt::format("sphere {{ {}, {}", vector(-2, 2), number(0.3, 1.4));
            case 3: return fmt::format("box {{ {}, {}", vector(-2, -0.2), vector(0.2, 1));
            case 4: return fmt::format("cone {{ {}, {}, {}, {}{}", vector(-2, 0), number(0.2, 1), vector(0.2, 2), number(0, 0.5), maybe(2, "open"));
            case 5: return fmt::format("cylinder {{ {}, {}, {}", vector(-2, 0), vector(0.2, 2), number(0.1, 0.8));
            case 6: return fmt::format("torus {{ {}, {} rotate {}", number(0.7, 1.6), number(0.1, 0.4), vector(0, 360));
            case 7: return fmt::format("disc {{ {}, {}, 1.5, 0.4", vector(-1, 1), vector(0.1, 1));
            case 8: return fmt::format("smooth_triangle {{ {}, <0.2, 0.3, -1>, {}, <1, 0.3, -1>, {}, <-1, 0.2, -0.5>", vector(-2, 0), vector(0, 2), vector(-1, 2));
            case 9: return fmt::format("quadric {{ <1, 1, 0.5>, <0.2, 0, 0>, <0, 0, 0>, -1 clipped_by {{ box {{ -1.2, 1.2 }} }} translate {}", vector(-1, 1));
            default: break;
        }
        const std::string a = vector(-2, 0), b = vector(0, 2), c = vector(-1, 2), d = vector(-2, 2);
        return fmt::format("mesh {{ triangle {{ {}, {}, {} texture {{ T }} }} triangle {{ {}, {}, {} }} triangle {{ {}, {}, {} }}", a, b, c, b, c, d, a, b, d);
    }
    std::string object() {
        return shape() + maybe(4, fmt::format("scale <1, {}, 1> rotate {}", number(0.5, 2), vector(0, 90))) +
               maybe(6, fmt::format("clipped_by {{ sphere {{ {}, 1.2{} }} }}", vector(-1, 1), maybe(2, "inverse"))) + " " + texture() + " }\n";
    }

    std::mt19937_64 bits_;
};

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

const std::string kHead = "#version 3.7; global_settings { assumed_gamma 1.0 }\ncamera { location <0, 1, -5> direction z right x * 4/3 up y }\n";

TEST(PacketPictures, AreTheSameOfNothingAndOfOneThing) {
    for (const char* text : {"", "background { rgb <0.1, 0.2, 0.3> }", "sphere { 0, 1 }", "light_source { 3, rgb 1 } sphere { 0, 1 }", "light_source { 0, rgb 1 } plane { y, 0 }",
                             "light_source { <0, 0, -1>, rgb 1 } torus { 1, 0.3 rotate 60 * x }"})
        for (const Raster raster : {Raster{33, 18}, Raster{3, 3}, Raster{1, 7}, Raster{9, 1}})
            expect_same_picture(staged(kHead + text), {.raster = raster, .threads = 1});
}

TEST(PacketPictures, AreTheSameWhereTheLightStandsOnTheSurface) {
    expect_same_picture(staged(kHead + "light_source { <0, 0, -1>, rgb 1 } sphere { 0, 1 finish { phong 1 specular 1 } } plane { y, -1 }"), {.raster = {40, 30}, .threads = 1});
}

TEST(PacketPictures, AreTheSameFromWhereFloatsEnd) {
    for (const char* from : {"1e12", "1e30", "1e39", "1e60"})
        for (const char* camera : {"camera { location <0, 0, -D> direction z right x up y }\n", "camera { location <D, -D, D> right x up y look_at 0 }\n"})
            expect_same_picture(staged(fmt::format("#version 3.7; global_settings {{ assumed_gamma 1.0 }} background {{ rgb 0.5 }}\n#declare D = {};\n", from) + camera +
                                       "light_source { 5, rgb 1 } sphere { 0, 1 } sphere { <1, 2, 3>, 0.5 } plane { y, -1 }"),
                                {.raster = {9, 6}, .threads = 1});
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
