// A noisy scene judged, with shell scripts for programs: they hand out pictures by their seed.
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "grader/checks.h"
#include "schema_check.h"
#include "support/sha256.h"
#include "tools.h"

namespace rays::grader {
namespace {

namespace fs = std::filesystem;

constexpr Raster kSize{24, 16};
constexpr int kPictures = 64;  ///< seeds of one batch are apart from each other modulo 64

/// What one program's pictures are like.
struct Look {
    float factor = 1, noise = 0.05f;
    std::string before{};  ///< shell commands before a picture is handed out
};

float random_sign(std::uint64_t& state) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return float(state >> 40) / float(1 << 23) - 1;
}

class StatisticalCheckTest : public testing::Test {
protected:
    StatisticalCheckTest() {
        project.root = folder.path() / "project";
        const std::string sdl = "sphere { 0, 1 }\n";
        write_atomically(project.scenes() / "9_x" / "soft.pov", sdl);
        write_atomically(project.references() / "9_x" / "soft.exr", "");
        write_reference(project.references() / "9_x" / "soft.exr");
        const nlohmann::json entry{{"scene", "9_x/soft.pov"},      {"reference", "9_x/soft.exr"},
                                   {"width", kSize.width},         {"height", kSize.height},
                                   {"method", "mean of 8 frames"}, {"frames", 8},
                                   {"standard_error", 0.001},      {"command", "x"},
                                   {"sha256", sha256(sdl)},        {"includes", nlohmann::json::object()},
                                   {"sha256_reference", "x"}};
        write_atomically(
            project.references() / "manifest.json",
            nlohmann::json{{"version", 1}, {"povray", "3.7"}, {"entries", nlohmann::json::array({entry})}}.dump());
        step.number = 9;
        scene.scene = "9_x/soft.pov";
        scene.points = 10;
        scene.samples = 16;
        scene.seeds = 8;
    }

    static void write_reference(const fs::path& file) {
        const RgbImage mean = test_picture(kSize.width, kSize.height);
        std::vector<float> values;
        for (const Rgb& p : mean.pixels) values.insert(values.end(), {p[0], p[1], p[2], 1e-4f, 1e-4f, 1e-4f});
        OIIO::ImageSpec spec(kSize.width, kSize.height, 6, OIIO::TypeDesc::FLOAT);
        spec.channelnames = {"R", "G", "B", "error.R", "error.G", "error.B"};
        const auto out = OIIO::ImageOutput::create(file.string());
        ASSERT_TRUE(out && out->open(file.string(), spec) && out->write_image(OIIO::TypeDesc::FLOAT, values.data()) &&
                    out->close());
    }

    fs::path program(const TemporaryFolder& where, const Look& look, std::uint64_t random) const {
        for (int i = 0; i < kPictures; ++i) {
            RgbImage picture = test_picture(kSize.width, kSize.height);
            for (Rgb& p : picture.pixels)
                for (float& v : p) v *= look.factor * (1 + look.noise * random_sign(random));
            write_atomically(where.path() / fmt::format("{}.exr", i), exr_bytes(picture));
        }
        return script(
            where,
            fmt::format(
                "while [ $# -gt 0 ]; do case $1 in --seed) seed=$2;; --samples) samples=$2;; esac; shift; done\n"
                "[ \"$samples\" = 16 ] || exit 2\necho $seed >> {0}/seeds\n{1}\ncp {0}/$((seed % 64)).exr picture.exr",
                where.path().string(), look.before));
    }

    Check check(const Look& student, const Look& solution = {}) {
        const fs::path own = program(student_folder, student, 1), right = program(solution_folder, solution, 2);
        const Bench bench{project, *sandbox, step, right, own, out.path(), 7, {}, true};
        return statistical_check(bench, scene);
    }
    static int lines(const fs::path& file) {
        std::ifstream in(file);
        return static_cast<int>(std::count(std::istreambuf_iterator<char>(in), {}, '\n'));
    }
    int runs_of_student() const { return lines(student_folder.path() / "seeds"); }
    int runs_of_solution() const { return lines(solution_folder.path() / "seeds"); }

    TemporaryFolder folder, student_folder, solution_folder, out;
    Project project;
    Step step;
    SceneTask scene;
    std::unique_ptr<Sandbox> sandbox = make_sandbox();
};

TEST_F(StatisticalCheckTest, ARightPictureGetsAllPointsAfterOneBatch) {
    const Check c = check({});
    EXPECT_EQ(c.verdict, Verdict::pass) << c.message;
    EXPECT_EQ(c.points, 10);
    EXPECT_EQ(c.id, "9.picture.soft");
    EXPECT_EQ(c.kind, "statistical");
    EXPECT_EQ(runs_of_student(), 8);
    EXPECT_EQ(runs_of_solution(), 4);
    EXPECT_NEAR(*c.statistics->noise_ratio, 1, 0.2);
    EXPECT_EQ(c.statistics->tiles, 6);
    EXPECT_EQ(c.image->student, "images/9.picture.soft.exr");
    EXPECT_TRUE(fs::exists(out.path() / c.image->student));
    EXPECT_TRUE(fs::exists(out.path() / c.statistics->z_picture));
    EXPECT_TRUE(fs::exists(out.path() / c.image->reference));
}

TEST_F(StatisticalCheckTest, ABiasIsConfirmedByTwiceTheSeedsAndExplained) {
    const Check c = check({1.1f});
    EXPECT_EQ(c.verdict, Verdict::fail);
    EXPECT_EQ(c.points, 0);
    EXPECT_EQ(runs_of_student(), 24);
    EXPECT_EQ(runs_of_solution(), 0) << "nobody asks for the noise of a wrong picture";
    EXPECT_EQ(c.statistics->batches, 2);
    EXPECT_EQ(c.statistics->seeds, 16);
    EXPECT_TRUE(has(c.message, "too bright by 10 %")) << c.message;
    ASSERT_FALSE(c.diagnosis.empty());
    EXPECT_TRUE(has(c.diagnosis[0].text, "every value is 1.1 times the right one")) << c.diagnosis[0].text;
}

TEST_F(StatisticalCheckTest, TooMuchNoiseCostsThirtyPercent) {
    const Check c = check({1, 0.1f});
    EXPECT_EQ(c.verdict, Verdict::partial) << c.message;
    EXPECT_NEAR(c.points, 7, 1e-9);
    EXPECT_TRUE(has(c.message, "times the solution's")) << c.message;
    EXPECT_EQ(runs_of_student(), 24) << "found twice";
    scene.noise_full = 4.5;
    scene.noise_none = 6;
    EXPECT_EQ(check({1, 0.1f}).verdict, Verdict::pass) << "the scene decides how much is too much";
}

TEST_F(StatisticalCheckTest, NoiseIsNotRewarded) {
    const Check c = check({1, 4.0f});
    EXPECT_EQ(c.verdict, Verdict::fail) << c.message;
    EXPECT_EQ(c.points, 0) << "nobody can tell whether this mean is right";
    EXPECT_TRUE(has(c.message, "could not be told from a right one")) << c.message;
}

TEST_F(StatisticalCheckTest, ASeedThatDoesNothingIsNamed) {
    const Check c = check({1, 0.5f, "seed=3"});
    EXPECT_EQ(c.verdict, Verdict::fail) << "one picture's noise is no mean";
    ASSERT_FALSE(c.diagnosis.empty());
    EXPECT_TRUE(has(c.diagnosis[0].text, "--seed must decide"));
    const Check calm = check({1, 0, ""});
    EXPECT_NEAR(calm.points, 7, 1e-9) << calm.message;
    EXPECT_TRUE(has(calm.message, "pictures of different seeds are equal")) << calm.message;
}

TEST_F(StatisticalCheckTest, ACrashIsACrashAndTheFirstOneEndsIt) {
    const Check c = check({1, 0.05f, "kill -SEGV $$"});
    EXPECT_EQ(c.verdict, Verdict::crash);
    EXPECT_EQ(runs_of_student(), 1);
    EXPECT_TRUE(has(c.message, "with --seed ")) << c.message;
}

TEST_F(StatisticalCheckTest, WhatIsNotWrittenIsNotStarted) {
    const Check c = check({1, 0.05f, R"(echo '{"unfinished":[{"task":"9.1","file":"a.cpp","line":3}]}' > stats.json)"});
    EXPECT_EQ(c.verdict, Verdict::not_started);
    EXPECT_TRUE(has(c.message, "waits for task 9.1 (a.cpp:3)")) << c.message;
    EXPECT_EQ(runs_of_student(), 1);
}

TEST_F(StatisticalCheckTest, NotANumberFailsAtOnce) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const Check c = check({nan});
    EXPECT_EQ(c.verdict, Verdict::fail);
    EXPECT_TRUE(has(c.message, "3072 pixels of 8 pictures are not finite")) << c.message;
    EXPECT_EQ(runs_of_student(), 8);
}

TEST_F(StatisticalCheckTest, ASolutionThatCannotRenderIsNobodysGrade) {
    const Check c = check({}, {1, 0.05f, "exit 1"});
    EXPECT_EQ(c.verdict, Verdict::infrastructure_error);
    EXPECT_EQ(c.points, 0);
}

TEST_F(StatisticalCheckTest, TheSameSeedOfTheRunAsksForTheSamePictures) {
    check({});
    const std::string first = read_file(student_folder.path() / "seeds");
    fs::remove(student_folder.path() / "seeds");
    check({});
    EXPECT_EQ(read_file(student_folder.path() / "seeds"), first);
    EXPECT_NE(read_file(solution_folder.path() / "seeds").substr(0, 8), first.substr(0, 8));
}

TEST_F(StatisticalCheckTest, WithAllStepsMineThereAreNoPointsAndNoNoise) {
    const fs::path own = program(student_folder, {}, 1), right = program(solution_folder, {}, 2);
    const Bench bench{project, *sandbox, step, right, right, out.path(), 7, {}, true};
    const Check c = statistical_all_mine_check(bench, scene, own);
    EXPECT_EQ(c.verdict, Verdict::pass);
    EXPECT_EQ(c.max, 0);
    EXPECT_EQ(c.mode, "all mine");
    EXPECT_FALSE(c.statistics->noise_ratio.has_value());
    EXPECT_EQ(runs_of_solution(), 0);
}

TEST_F(StatisticalCheckTest, ItsResultFollowsTheSchema) {
    Results results;
    results.submission_from = "student";
    results.real = "double";
    for (const Look& look :
         {Look{}, Look{1.1f}, Look{std::numeric_limits<float>::quiet_NaN()}, Look{1, 0.05f, "exit 1"}})
        results.steps.push_back({"9_x", "X", 9, Verdict::pass, 0, 10, {}, {check(look)}});
    nlohmann::json j = nlohmann::json::parse(to_json(results));
    const auto schema = nlohmann::json::parse(read_file(find_project().root / "grader" / "results.schema.json"));
    EXPECT_EQ(schema_problems(j, schema), std::vector<std::string>{});
    nlohmann::json& statistics = j["steps"][1]["checks"][0]["statistics"];
    EXPECT_EQ(statistics["whole"].size(), 3u);
    EXPECT_GT(statistics["worst"]["z"], statistics["worst"]["limit"]);
    EXPECT_FALSE(j["steps"][2]["checks"][0]["statistics"].contains("worst")) << "nothing was judged";
    EXPECT_FALSE(j["steps"][3]["checks"][0].contains("statistics")) << "there are no pictures";
    statistics["worst"]["channel"] = "A";
    statistics["noise"].erase("full");
    statistics["surprise"] = 1;
    EXPECT_EQ(schema_problems(j, schema).size(), 3u);
}

}  // namespace
}  // namespace rays::grader
