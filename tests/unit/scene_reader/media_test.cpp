// Media and densities.
#include <filesystem>
#include <fstream>

#include "read.h"

namespace rays {
namespace {

TEST(MediaReader, Coefficients) {
    const Scene scene = scene_of(
        "media { absorption 0.1 emission rgb <1,0,0> scattering { 5, rgb 0.5 eccentricity 0.7 extinction 0.25 } method "
        "2 intervals 3 samples 4, 9 }");
    ASSERT_EQ(scene.atmosphere.size(), 1u);
    const Media& media = scene.atmosphere[0];
    EXPECT_EQ(media.absorption[0], 0.1f);
    EXPECT_EQ(media.emission[0], 1);
    ASSERT_TRUE(media.scattering.has_value());
    EXPECT_EQ(media.scattering->type, 5);
    EXPECT_EQ(media.scattering->eccentricity, 0.7f);
    EXPECT_EQ(media.scattering->extinction, 0.25f);
    EXPECT_EQ(media.method, 2);
    EXPECT_EQ(media.intervals, 3);
    EXPECT_EQ(media.samples_min, 4);
    EXPECT_EQ(media.samples_max, 9);
}

TEST(MediaReader, DensitiesMoveWithTheObject) {
    const Scene scene = scene_of(
        "sphere { 0, 1 hollow interior { media { absorption 1 density { spherical scale 2 color_map { [0 rgb 0] [1 rgb "
        "0.5] } } density { rgb 3 } } } translate x }");
    const Media& media = scene.interiors[scene.objects[0].interior].media[0];
    ASSERT_EQ(media.densities.size(), 2u);
    EXPECT_TRUE(std::holds_alternative<Media::SphericalDensity>(media.densities[0].form));
    EXPECT_EQ(media.densities[0].color[0], 0.5f);
    ASSERT_NE(media.densities[0].transform, kNone);
    EXPECT_TRUE(near(scene.transforms[media.densities[0].transform].point_to_world({1, 0, 0}), {3, 0, 0}));
    EXPECT_EQ(media.densities[1].color[0], 3);
}

TEST(MediaReader, DensityFiles) {
    const auto folder = std::filesystem::path(::testing::TempDir()) / "raysteps_media_test";
    std::filesystem::create_directories(folder);
    const char bytes[] = {0, 2, 0, 1, 0, 2, 0, char(255), 51, 102};  // 2 x 1 x 2, one byte each
    std::ofstream(folder / "small.df3", std::ios::binary).write(bytes, sizeof bytes);
    std::ofstream(folder / "broken.df3", std::ios::binary).write(bytes, sizeof bytes - 1);
    const auto read = [&folder](const std::string& file) {
        return read_scene_text("media { density { density_file df3 \"" + file + "\" interpolate 1 } }",
                               (folder / "s.pov").string());
    };
    const Scene scene = read("small.df3");
    const auto& grid = std::get<Media::GridDensity>(scene.atmosphere[0].densities[0].form);
    EXPECT_EQ(grid.size[0], 2u);
    EXPECT_EQ(grid.size[2], 2u);
    EXPECT_EQ(grid.interpolation, 1);
    EXPECT_EQ(grid.values, (std::vector<float>{0, 1, 0.2f, 0.4f}));
    EXPECT_THROW(read("broken.df3"), InputError);
    EXPECT_THROW(read("missing.df3"), InputError);
    EXPECT_THROW(read("../small.df3"), InputError);
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace rays
