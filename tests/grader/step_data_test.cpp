// What a step.json may say of noisy scenes.
#include "grader/step_data.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "tools.h"

namespace rays::grader {
namespace {

SceneTask scene_with(const std::string& fields) {
    const TemporaryFolder folder;
    write_atomically(
        folder.path() / "5_x" / "step.json",
        R"({"number":5,"id":"5_x","title":"X","tasks":[],"scenes":[{"scene":"5_x/a.pov","points":2)" + fields + "}]}");
    return read_steps(folder.path()).at(0).scenes.at(0);
}

std::string problem_of(const std::string& fields) {
    try {
        scene_with(fields);
        return "none";
    } catch (const InputError& e) {
        return e.what();
    }
}

TEST(StepData, ASceneWithSamplesAndSeedsIsStatistical) {
    EXPECT_FALSE(scene_with("").statistical());
    const SceneTask scene = scene_with(R"(,"samples":16,"seeds":8)");
    EXPECT_TRUE(scene.statistical());
    EXPECT_EQ(scene.samples, 16);
    EXPECT_EQ(scene.seeds, 8);
    EXPECT_EQ(scene.noise_full, 1.75);
    EXPECT_EQ(scene_with(R"(,"samples":16,"seeds":8,"noise":[2,4])").noise_none, 4);
}

TEST(StepData, SaysWhatIsWrongWithANoisyScene) {
    EXPECT_TRUE(has(problem_of(R"(,"samples":16)"), "5_x/step.json: scene 5_x/a.pov: a noisy scene needs both"));
    EXPECT_TRUE(has(problem_of(R"(,"seeds":8)"), "needs both"));
    EXPECT_TRUE(has(problem_of(R"(,"samples":0,"seeds":8)"), "\"samples\" is 0: need 1 to 4096"));
    EXPECT_TRUE(has(problem_of(R"(,"samples":16,"seeds":7)"), "\"seeds\" is 7: need 8 to 64"));
    EXPECT_TRUE(has(problem_of(R"(,"samples":1.5,"seeds":8)"), "whole numbers"));
    EXPECT_TRUE(has(problem_of(R"(,"samples":16,"seeds":8,"noise":2)"), "two numbers"));
    EXPECT_TRUE(has(problem_of(R"(,"samples":16,"seeds":8,"noise":[3,2])"), "need 1 <= first < second"));
}

}  // namespace
}  // namespace rays::grader
