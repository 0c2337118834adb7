// Are the fresh scenes fair? The reader takes every one of them, each shows something, and the solution's picture is
// the same bytes with every structure: so the solution against itself passes, whichever structure the grader renders
// with.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "grader/fresh_scenes.h"
#include "renderer/needs.h"
#include "renderer/render.h"
#include "scene_reader/scene_reader.h"
#include "seeds.h"

namespace rays::tests {
namespace {

constexpr Raster kRaster{grader::kFreshWidth, grader::kFreshHeight};

/// As the render program does it.
Scene staged(const std::string& sdl) {
    ReadOptions options;
    options.raster = kRaster;
    Scene scene = read_scene_text(sdl, "fresh.pov", options);
    require_built(scene);
    drop_what_is_not_needed(scene);
    prepare(scene);
    return scene;
}

using Colour = std::array<float, 3>;

std::vector<Colour> picture(const Scene& scene, Partition partition) {
    RenderOptions options;
    options.raster = kRaster;
    options.threads = 1;
    options.partition = partition;
    const Film film = render(scene, options);
    std::vector<Colour> pixels;
    for (int y = 0; y < kRaster.height; ++y)
        for (int x = 0; x < kRaster.width; ++x)
            pixels.push_back({film.at(x, y)[0], film.at(x, y)[1], film.at(x, y)[2]});
    return pixels;
}

bool finite(const std::vector<Colour>& pixels) {
    for (const Colour& c : pixels)
        if (!(std::isfinite(c[0]) && std::isfinite(c[1]) && std::isfinite(c[2]))) return false;
    return true;
}

bool same_bytes(const std::vector<Colour>& a, const std::vector<Colour>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Colour)) == 0;
}

bool of_one_colour(const std::vector<Colour>& pixels) {
    return std::set<Colour>(pixels.begin(), pixels.end()).size() <= 1;
}

void expect_fair(const std::string& sdl) {
    const Scene scene = staged(sdl);
    const auto truth = picture(scene, Partition::automatic);
    EXPECT_TRUE(finite(truth)) << sdl;
    for (const Partition p : {Partition::none, Partition::grid, Partition::octree, Partition::bvh})
        EXPECT_TRUE(same_bytes(picture(scene, p), truth)) << "with structure " << int(p) << "\n" << sdl;
}

struct Fresh {
    int step, scenes;  ///< how many of the step's tasks have fresh scenes
};

/// The scene that the grader would take.
std::optional<grader::FreshScene> taken(const std::string& task, std::uint64_t seed) {
    std::optional<grader::FreshScene> fresh;
    for (int attempt = 0; attempt < grader::kFreshAttempts; ++attempt) {
        fresh = grader::fresh_scene(task, grader::seed_of_fresh_scene(seed, 0, attempt));
        if (!fresh || !of_one_colour(picture(staged(fresh->sdl), Partition::automatic))) return fresh;
    }
    ADD_FAILURE() << "pictures of nothing, the last one of\n" << fresh->sdl;
    return fresh;
}

class FreshScenesOfStep : public testing::TestWithParam<Fresh> {};

TEST_P(FreshScenesOfStep, AreReadShowSomethingAndAreTheSameWithEveryStructure) {
    // Boxes are not a rounding of float wider than what is in them: a torus may lose the rim of its shadow.
    if (sizeof(Real) < sizeof(double)) GTEST_SKIP() << "the same bytes are promised for geometry in double";
    constexpr int kMostTasks = 20;
    std::set<int> tasks;
    for (const std::uint64_t seed : fair_seeds()) {
        for (int task = 1; task <= kMostTasks; ++task) {
            const std::string id = std::to_string(GetParam().step) + "." + std::to_string(task);
            SCOPED_TRACE("task " + id + ", seed " + std::to_string(seed));
            std::optional<grader::FreshScene> fresh;
            ASSERT_NO_THROW(fresh = taken(id, seed));
            if (!fresh) continue;
            tasks.insert(task);
            ASSERT_NO_THROW(expect_fair(fresh->sdl));
        }
    }
    EXPECT_EQ(static_cast<int>(tasks.size()), GetParam().scenes);
}

INSTANTIATE_TEST_SUITE_P(Questions, FreshScenesOfStep,
                         testing::Values(Fresh{1, 14}, Fresh{2, 10}, Fresh{3, 11}, Fresh{4, 2}, Fresh{5, 4}),
                         [](const auto& of) { return "step_" + std::to_string(of.param.step); });

}  // namespace
}  // namespace rays::tests
