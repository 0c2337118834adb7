// The student beside the solution in charts of speed; each program is a shell script that answers as such a program
// would, and says itself how long it took: nothing here depends on how long anything takes.
#include "grader/student_speed.h"

#include <gtest/gtest.h>

#include <sstream>

#include "grader/step_data.h"
#include "references/averaged.h"
#include "tools.h"

namespace rays::grader {
namespace {

namespace fs = std::filesystem;

constexpr int kWidth = 16, kHeight = 12;

/// A line of a script: so many seconds more of processor time.
std::string takes(int seconds) { return "echo takes " + std::to_string(seconds) + " >&2\n"; }

/// Runs scripts for real, under limits; their time is what they say, and a second for all the rest.
class ToldTime : public Sandbox {
public:
    std::string tier() const override { return real_->tier(); }
    JobResult run(const Job& job) const override {
        JobResult result = real_->run(job);
        result.ended.cpu_s = 1;
        std::istringstream words(result.ended.err);
        double seconds = 0;
        for (std::string word; words >> word;)
            if (word == "takes" && words >> seconds) result.ended.cpu_s += seconds;
        return result;
    }

private:
    std::unique_ptr<Sandbox> real_ = make_sandbox();
};

class StudentSpeedTest : public testing::Test {
protected:
    Project project = find_project();
    TemporaryFolder solution_folder, student_folder;
    std::unique_ptr<Sandbox> sandbox = std::make_unique<ToldTime>();
    Step step;

    static RgbImage grey(float value) {
        return {{kWidth, kHeight}, std::vector<Rgb>(static_cast<std::size_t>(kWidth * kHeight), {value, value, value})};
    }

    /// Writes this picture wherever it is asked for one.
    static std::string painting(const TemporaryFolder& folder, float value) {
        write_atomically(folder.path() / "picture", exr_bytes(grey(value)));
        return "cp " + (folder.path() / "picture").string() + " picture.exr\n";
    }

    /// Many rays take these seconds, one takes nothing; says what it is told about agreement.
    static std::string answering(const std::string& agreement, int seconds = 3) {
        return "question=$(tail -n 1)\ncase \"$question\" in\n*100000*) " + takes(seconds) +
               "echo 1 1 ;;\nagreement*) " + agreement + " ;;\n*) echo 1 1 ;;\nesac\n";
    }

    std::vector<SpeedPoint> timed(const std::string& solution, const std::string& student) {
        Limits limits;
        limits.cpu_s = 2, limits.wall_s = 20;
        return time_student({project,
                             *sandbox,
                             step,
                             script(solution_folder, solution),
                             student.empty() ? solution_folder.path() / "program" : script(student_folder, student),
                             {},
                             1,
                             limits});
    }

    SpeedPoint pictures(const std::string& student) {
        step.speed = {{"3.tree.time",
                       "depth",
                       "x",
                       "1_ray_casting/one_sphere.pov",
                       kWidth,
                       kHeight,
                       {{"depth 3", "max_trace_level 3", 0}},
                       "max_trace_level 20",
                       {},
                       {}}};
        const auto points = timed(painting(solution_folder, 0.5f), student);
        EXPECT_EQ(points.size(), 1u);
        return points.at(0);
    }

    SpeedPoint structures(const std::string& student) {
        step.speed = {{"4.growth.spheres", "", "y", "", 0, 0, {}, "", {"grid"}, {100}}};
        const auto points = timed(answering("echo 20 10 0"), student);
        EXPECT_EQ(points.size(), 1u);
        return points.at(0);
    }
};

TEST_F(StudentSpeedTest, APictureHasARatioAndAnErrorToTheSolutionsBest) {
    const SpeedPoint point = pictures(takes(2) + painting(student_folder, 0.75f));
    EXPECT_EQ(point.verdict, Verdict::pass) << point.message;
    EXPECT_EQ(point.chart + "/" + point.series + "/" + point.label + "/" + point.time, "3.tree.time/depth/depth 3/x");
    EXPECT_EQ(point.rounds, kSpeedRounds);
    EXPECT_EQ(point.low, 3);
    EXPECT_EQ(point.median, 3);
    EXPECT_EQ(point.high, 3);
    ASSERT_TRUE(point.error);
    EXPECT_DOUBLE_EQ(*point.error, 0.5) << "0.25 of 0.5";
    EXPECT_EQ(point.against, "max_trace_level 20");
}

TEST_F(StudentSpeedTest, SettingsStandAtTheEndOfTheScene) {
    // Both sides render the scene with the setting; who asks for the truth is the solution alone.
    const std::string look = "tail -n 1 one_sphere.pov | grep -q 'global_settings { max_trace_level 3 }' || exit 1\n";
    EXPECT_EQ(pictures(look + painting(student_folder, 0.5f)).error, 0.0);
}

TEST_F(StudentSpeedTest, AMeanIsHeldAgainstAveragedFramesNotTheSolution) {
    const AveragedReference truth = load_averaged_reference(project.references() / "5_distributed/edges.exr");
    const auto [width, height] = truth.raster();
    const auto painting_of = [](const TemporaryFolder& folder, RgbImage picture, float times) {
        for (Rgb& pixel : picture.pixels)
            for (float& lane : pixel) lane *= times;
        write_atomically(folder.path() / "picture", exr_bytes(picture));
        return "case \"$*\" in *'--pattern sobol --samples 4'*) ;; *) exit 1 ;; esac\ncp " +
               (folder.path() / "picture").string() + " picture.exr\n";
    };
    step.speed = {{"5.edges.time",
                   "Sobol",
                   "x",
                   "5_distributed/edges.pov",
                   width,
                   height,
                   {{"4 samples", "", 4}},
                   SpeedTask::kReference,
                   {},
                   {}}};
    // The solution's picture is black: nobody looks at it.
    const auto error = [&](float times) {
        const auto points =
            timed(painting_of(solution_folder, truth.mean, 0), painting_of(student_folder, truth.mean, times));
        EXPECT_EQ(points.at(0).verdict, Verdict::pass) << points.at(0).message;
        EXPECT_EQ(points.at(0).against, "");
        return points.at(0).error.value_or(-1);
    };
    EXPECT_NEAR(error(1.25f), 0.25, 1e-4);
    EXPECT_LT(error(1), 0.002) << "the reference's own error";
}

TEST_F(StudentSpeedTest, AStructureHasTheTimeOfItsRaysAlone) {
    // Twelve seconds before any question, then twice as long for its rays as the solution.
    const SpeedPoint point = structures(takes(12) + answering("echo 20 10 0", 6));
    EXPECT_EQ(point.verdict, Verdict::pass) << point.message;
    EXPECT_EQ(point.series, "grid");
    EXPECT_EQ(point.at, 100);
    EXPECT_EQ(point.time, "y");
    EXPECT_EQ(point.low, 2);
    EXPECT_EQ(point.median, 2);
    EXPECT_FALSE(point.error);
    EXPECT_EQ(point.message, "");
}

TEST_F(StudentSpeedTest, ATimeThatNoiseAteIsNoTime) {
    const SpeedPoint point = structures(answering("echo 20 10 0", 0));
    EXPECT_EQ(point.verdict, Verdict::fail);
    EXPECT_EQ(point.message, "too quick to be timed");
}

TEST_F(StudentSpeedTest, AWrongStructureSaysSo) {
    EXPECT_EQ(structures(answering("echo 20 10 3")).message, "3 of 20 rays are answered otherwise than by asking all");
    EXPECT_EQ(structures(answering("echo '\x1b[31m'")).message, "it does not say whether its answers are right");
}

TEST_F(StudentSpeedTest, WhatIsNotWrittenHasNoPoint) {
    const SpeedPoint picture = pictures(painting(student_folder, 1) + "echo 'unfinished 3.2 x.cpp:1' >&2");
    EXPECT_EQ(picture.verdict, Verdict::not_started);
    EXPECT_EQ(picture.message, "waits for task 3.2");
    EXPECT_EQ(structures("echo unfinished 4.4").message, "waits for task 4.4");
}

TEST_F(StudentSpeedTest, CrashesEndlessLoopsAndBrokenPicturesHaveNoPoint) {
    EXPECT_EQ(pictures("kill -SEGV $$").verdict, Verdict::crash);
    EXPECT_EQ(structures("while :; do :; done").verdict, Verdict::time_out);
    EXPECT_EQ(pictures("true").message, "the picture was not written");
    EXPECT_EQ(pictures("echo EXR > picture.exr").message, "the picture is not an OpenEXR file");
    EXPECT_EQ(pictures(painting(student_folder, std::numeric_limits<float>::quiet_NaN())).message,
              "the picture is no number somewhere");
}

TEST_F(StudentSpeedTest, TheSolutionIsNotComparedWithItself) {
    step.speed = {{"4.growth.spheres", "", "y", "", 0, 0, {}, "", {"grid"}, {100}}};
    const fs::path program = script(solution_folder, "true");
    EXPECT_TRUE(time_student({project, *sandbox, step, program, program, {}, 1, {}}).empty());
}

TEST(CubeOfSpheres, CoversAViewOfItOnce) {
    const std::string scene = cube_of_spheres(100);
    EXPECT_EQ(std::count(scene.begin(), scene.end(), '\n'), 100);
    EXPECT_NE(scene.find(", 0.05641896 }"), std::string::npos) << "100 pi r^2 = 1";
}

/// Charts and points name each other across files.
TEST(SpeedTasks, AreWhatTheChartsHave) {
    std::size_t tasks = 0;
    for (const Step& step : read_steps(find_project().steps()))
        for (const SpeedTask& task : step.speed) {
            ++tasks;
            EXPECT_EQ(task.chart.front() - '0', step.number) << task.chart;
            EXPECT_TRUE(task.time == "x" || task.time == "y" || task.time == "1/x") << task.time;
            EXPECT_EQ(task.structures.empty(), !task.settings.empty()) << task.chart;
            if (!task.scene.empty()) {
                EXPECT_TRUE(fs::exists(find_project().scenes() / task.scene)) << task.scene;
            }
            for (const auto& setting : task.settings)
                EXPECT_EQ(setting.samples > 0, task.truth == SpeedTask::kReference)
                    << task.chart << ": means are held against averaged frames";
        }
    EXPECT_GE(tasks, 11u) << "every step of 1 to 5 has some";
}

}  // namespace
}  // namespace rays::grader
