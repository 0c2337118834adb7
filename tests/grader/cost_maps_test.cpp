// What a pixel costs, from student's programs of every kind; each is a shell script that answers as such a program
// would.
#include "grader/cost_maps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/exr_file.h"
#include "grader/picture.h"
#include "tools.h"

namespace rays::grader {
namespace {

namespace fs = std::filesystem;

constexpr Raster kRaster{160, 120};

/// A map of `tests` everywhere but for ten times as many at one pixel, and half as many nodes.
std::string map_bytes(float tests, Raster raster = kRaster,
                      const std::vector<std::string>& channels = {"tests", "nodes"},
                      std::pair<int, int> dear = {7, 5}) {
    Film film(raster);
    for (int y = 0; y < raster.height; ++y)
        for (int x = 0; x < raster.width; ++x) {
            const float here = std::pair(x, y) == dear ? 10 * tests : tests;
            film.at(x, y) = Radiance(here, here / 2, 0.0f);
        }
    const TemporaryFolder folder;
    write_exr(film, (folder.path() / "x.exr").string(), channels);
    return read_file(folder.path() / "x.exr");
}

class CostMapsTest : public testing::Test {
protected:
    Project project = find_project();
    TemporaryFolder solution_folder, student_folder, out;
    std::unique_ptr<Sandbox> sandbox = make_sandbox();
    Step step = with_one_map();

    static Step with_one_map() {
        Step step;
        step.number = 4;
        step.cost_maps = {{"1_ray_casting/one_sphere.pov", {"none", "grid"}}};
        return step;
    }

    /// Answers every question: with its map (another one for no structure), its cells, and a ray.
    static std::string answering(const TemporaryFolder& folder, const std::string& cells) {
        const std::string map = (folder.path() / "map").string();
        return "case \"$*\" in\n"
               "*--visited*) echo '{\"tests\":1,\"nodes\":1,\"visited\":" +
               cells +
               "}' ;;\n"
               "*--explain*) echo '{\"queries\":[{\"origin\":[1,2,3],\"direction\":[0,0,1],\"hit\":{\"t\":4.5}}]}' ;;\n"
               "*--partition?none*) cp " +
               map +
               ".none costs.exr ;;\n"
               "*) cp " +
               map + " costs.exr ;;\nesac";
    }

    fs::path program(const TemporaryFolder& folder, const std::string& map, const std::string& text) const {
        write_atomically(folder.path() / "map", map);
        write_atomically(folder.path() / "map.none", map_bytes(1000, kRaster, {"tests", "nodes"}, {1, 1}));
        return script(folder, text);
    }

    std::vector<CostScene> maps_of(const fs::path& student) {
        const fs::path solution = program(solution_folder, map_bytes(8), answering(solution_folder, "[[0,0,0,1,1,2]]"));
        const fs::path s = student.empty() ? solution : student;
        Limits limits;
        limits.cpu_s = 1, limits.wall_s = 20;
        return map_costs({project, *sandbox, step, solution, s, out.path(), 1, limits}, 2);
    }

    CostMap students_grid(const std::string& map, const std::string& text) {
        const auto scenes = maps_of(program(student_folder, map, text));
        const CostMap grid = scenes.at(0).maps.at(1);
        EXPECT_EQ(grid.whose, "student");
        EXPECT_EQ(grid.structure, "grid");
        EXPECT_EQ(std::pair(scenes[0].x, scenes[0].y), std::pair(7, 5))
            << "the pixel is dear to the solution's structure";
        // Whatever a student's program does, the solution's maps are there.
        EXPECT_TRUE(fs::exists(out.path() / scenes.at(0).maps.at(3).file) && !scenes.at(0).maps.at(3).file.empty());
        return grid;
    }
};

TEST_F(CostMapsTest, TheSolutionAloneHasOneRow) {
    const auto scenes = maps_of({});
    ASSERT_EQ(scenes.size(), 1u);
    const CostScene& scene = scenes[0];
    ASSERT_EQ(scene.maps.size(), 2u);
    EXPECT_EQ(scene.scene, "1_ray_casting/one_sphere.pov");
    EXPECT_EQ(std::pair(scene.x, scene.y), std::pair(7, 5)) << "the pixel that costs most";
    EXPECT_EQ(scene.origin, (std::array<double, 3>{1, 2, 3}));
    EXPECT_EQ(scene.distance, 4.5);
    const CostMap& grid = scene.maps[1];
    EXPECT_EQ(grid.file, "images/4.costs.one_sphere.grid.solution.exr");
    EXPECT_EQ(grid.tests.max, 80);
    EXPECT_EQ(grid.nodes.max, 40);
    EXPECT_NEAR(grid.tests.mean, 8 + 72.0 / (160 * 120), 1e-9);
    EXPECT_EQ(grid.cells, (std::vector<std::array<double, 6>>{{0, 0, 0, 1, 1, 2}}));
    EXPECT_TRUE(scene.maps[0].cells.empty()) << "without a structure there are no cells";
    EXPECT_EQ(read_file(out.path() / grid.file), map_bytes(8));
}

TEST_F(CostMapsTest, AStudentsRowStandsBesideTheSolutions) {
    const CostMap grid = students_grid(map_bytes(20, kRaster, {"tests", "nodes"}, {90, 90}),
                                       answering(student_folder, "[[0,0,0,1,1,1],[0,0,1,1,1,2]]"));
    EXPECT_EQ(grid.verdict, Verdict::pass) << grid.message;
    EXPECT_EQ(grid.tests.max, 200);
    EXPECT_EQ(grid.cells.size(), 2u);
}

TEST_F(CostMapsTest, WhatIsNotWrittenIsNotStarted) {
    const CostMap grid = students_grid(map_bytes(0), answering(student_folder, "[]") +
                                                         "\necho 'unfinished 4.4 grid.cpp:3' >&2"
                                                         "\necho 'unfinished 4.3 grid.cpp:1' >&2");
    EXPECT_EQ(grid.verdict, Verdict::not_started);
    EXPECT_EQ(grid.message, "waits for task 4.3, 4.4");
    EXPECT_EQ(grid.file, "");
}

TEST_F(CostMapsTest, CrashesAndEndlessLoopsLeaveOutTheirOwnMap) {
    EXPECT_EQ(students_grid("", "kill -SEGV $$").verdict, Verdict::crash);
    EXPECT_EQ(students_grid("", "while :; do :; done").verdict, Verdict::time_out);
    EXPECT_EQ(students_grid("", "true").message, "the map was not written");
}

TEST_F(CostMapsTest, AMapIsHostileBytes) {
    const std::string cells = answering(student_folder, "[]");
    EXPECT_EQ(students_grid("EXR", cells).message, "the map is not an OpenEXR file");
    EXPECT_EQ(students_grid(map_bytes(1, {16, 12}), cells).message, "the map is 16 x 12 pixels, not 160 x 120");
    EXPECT_EQ(students_grid(map_bytes(1, kRaster, {"R", "G"}), cells).message,
              "the map is no picture of ours: its channels are not tests, nodes");
    for (const float bad : {-1.0f, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()})
        EXPECT_EQ(students_grid(map_bytes(bad), cells).message, "the map holds numbers that count nothing") << bad;
    EXPECT_EQ(students_grid(map_bytes(1).substr(0, 2000), cells).message,
              "the map is damaged: its pixels cannot be read");
}

TEST_F(CostMapsTest, NothingIsMadeWithoutAFolder) {
    const fs::path solution = program(solution_folder, map_bytes(8), answering(solution_folder, "[]"));
    EXPECT_TRUE(map_costs({project, *sandbox, step, solution, solution, {}, 1, {}}, 1).empty());
}

TEST(VisitedBoxes, AreFiniteAndNotTooMany) {
    const std::string box = "[0,0,0,1,2,3]";
    EXPECT_EQ(visited_boxes(R"({"visited":[)" + box + "]}", 5).boxes.size(), 1u);
    for (const char* bad :
         {"", "[]", "{", R"({"visited":3})", R"({"visited":[3,null,"x",[1,2,3]]})", R"({"visited":[[0,0,0,1,2,"3"]]})",
          R"({"visited":[[0,0,0,1,2,-3]]})", R"({"visited":[[0,0,0,1,2,1e999]]})"})
        EXPECT_TRUE(visited_boxes(bad, 5).boxes.empty()) << bad;
    const VisitedBoxes many = visited_boxes(R"({"visited":[)" + box + "," + box + "," + box + "]}", 2);
    EXPECT_EQ(many.boxes.size(), 2u);
    EXPECT_EQ(many.left_out, 1u);
    EXPECT_EQ(visited_boxes(R"({"visited":[[0,0,0,0.123456789,2,3]]})", 5).boxes.at(0)[3], 0.1234568);
}

}  // namespace
}  // namespace rays::grader
