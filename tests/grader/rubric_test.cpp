#include <gtest/gtest.h>

#include <algorithm>

#include "grader/checks.h"
#include "grader/grade.h"
#include "grader/grade_step.h"
#include "grader/verdicts.h"

namespace rays::grader {
namespace {

Step step_one() {
    Step s;
    s.number = 1;
    s.id = "1_ray_casting";
    s.tasks = {{"1.3", "Sphere", 8, "spheres", "", {}},
               {"1.6", "Polygon", 4, "polygons", "", {}},
               {"1.10", "Torus", 2, "extra", "", {}}};
    s.scenes = {{"1/one.pov", {"1.3"}, 2, "", {}}};
    return s;
}

StepResult result(double sphere, double polygon, double picture) {
    StepResult r;
    r.id = "1_ray_casting";
    r.tasks = {{"1.3", "", Verdict::pass, sphere, 8, "", "", 0},
               {"1.6", "", Verdict::pass, polygon, 4, "", "", 0},
               {"1.10", "", Verdict::pass, 2, 2, "", "", 0}};
    Check c;
    c.kind = "image";
    c.task = "1.3";
    c.points = picture;
    c.max = 2;
    r.checks = {c};
    return r;
}

Rubric rubric() {
    return {{{"spheres", "Spheres", 20, false, {"spheres"}, ""},
             {"polygons", "Polygons", 20, false, {"polygons"}, ""},
             {"reflection", "Reflection", 20, false, {"reflection"}, "needs step 3"},
             {"extra", "Extra", 5, true, {"extra"}, ""}},
            30};
}

TEST(Rubric, SharesARowAmongItsTasksAndPictures) {
    Results r;
    r.rubric = rubric_results(rubric(), {step_one()}, {result(4, 4, 1)});
    add_up(r);
    EXPECT_DOUBLE_EQ(r.rubric[0].points, 10) << "5 of 10";
    EXPECT_DOUBLE_EQ(r.rubric[1].points, 20);
    EXPECT_FALSE(r.rubric[2].graded);
    EXPECT_EQ(r.rubric[2].note, "not graded yet: needs step 3");
    EXPECT_DOUBLE_EQ(r.rubric[3].points, 5);
    EXPECT_DOUBLE_EQ(r.points, 30);
    EXPECT_DOUBLE_EQ(r.max, 40) << "rows not graded yet and extra rows are no part of the maximum";
}

TEST(Rubric, AStepLeftOutOfTheRunIsSaid) {
    Results r;
    r.rubric = rubric_results(rubric(), {step_one()}, {});
    add_up(r);
    EXPECT_EQ(r.rubric[0].note, "not graded in this run: needs step 1");
    EXPECT_EQ(r.max, 0);
}

TEST(Points, NothingForGuessing) {
    EXPECT_EQ(points_for(0, 8), 0);
    EXPECT_EQ(points_for(0.5, 8), 0);
    EXPECT_EQ(points_for(0.75, 8), 4);
    EXPECT_EQ(points_for(1, 8), 8);
}

TEST(Points, SharesAddUp) {
    for (const bool fresh : {false, true}) {
        for (const std::size_t sweeps : {0u, 1u, 3u}) {
            const Shares s = shares_of(10, true, fresh, sweeps);
            EXPECT_NEAR(s.unit + s.fresh + s.each_sweep * double(sweeps), 10, 1e-12);
        }
    }
    EXPECT_EQ(shares_of(10, false, false, 0).unit, 0);
}

TEST(Verdicts, Combine) {
    using enum Verdict;
    EXPECT_EQ(combine({pass, pass}), pass);
    EXPECT_EQ(combine({pass, fail}), partial);
    EXPECT_EQ(combine({not_started, not_started}), not_started);
    EXPECT_EQ(combine({not_started, fail}), fail);
    EXPECT_EQ(combine({not_started, crash}), crash);
    EXPECT_EQ(combine({pass, build_error}), build_error);
    EXPECT_EQ(combine({pass, infrastructure_error}), infrastructure_error);
    EXPECT_EQ(combine({}), not_started);
}

TEST(Verdicts, OfRuns) {
    Ended e;
    EXPECT_EQ(against_run(e)->verdict, Verdict::infrastructure_error);
    e.started = true;
    e.exit = 0;
    EXPECT_FALSE(against_run(e));
    e.timed_out = true;
    EXPECT_EQ(against_run(e)->verdict, Verdict::time_out);
    e.timed_out = false;
    e.signal = 11;
    EXPECT_EQ(against_run(e)->verdict, Verdict::crash);
    e.signal = 0;
    e.exit = 2;
    EXPECT_EQ(against_run(e)->verdict, Verdict::fail);
}

TEST(Verdicts, HostileStatisticsSayNothing) {
    for (const char* text : {"", "{", "[]", "{\"unfinished\":7}", "{\"unfinished\":[{\"task\":1}]}"})
        EXPECT_TRUE(unfinished_places(text).empty()) << text;
    EXPECT_EQ(unfinished_places(R"({"unfinished":[{"task":"1.3","file":"f","line":9}]})").at(0).line, 9);
}

TEST(Tasks, AreInTheOrderOfTheirNumbers) {
    EXPECT_TRUE(task_before("1.9", "1.10"));
    EXPECT_FALSE(task_before("2.1", "1.10"));
}

}  // namespace
}  // namespace rays::grader
