#include "grader/ray_trees.h"

#include <gtest/gtest.h>

#include "core/query_log.h"

namespace rays::grader {
namespace {

// A camera ray that hits object 2, and a shadow ray from there.
QueryLog tree() {
    QueryLog log;
    Hit hit;
    hit.t = 5;
    hit.object = 2;
    hit.point = {0, 0, 0};
    hit.normal = hit.shading_normal = {0, 0, -1};
    log.nearest({{0, 0, -5}, {0, 0, 1}}, {0, 1e9}, hit);
    log.occluded({{0, 0, 0}, {0, 3, -4}}, {0, 1}, false);
    log.queries[0].radiance = Radiance(0.5f);
    return log;
}

std::string difference(const QueryLog& student) { return first_difference(student.to_json(), tree().to_json()); }

TEST(RayTrees, EqualTreesDoNotDiffer) {
    EXPECT_EQ(difference(tree()), "");
    QueryLog longer = tree();
    longer.queries[0].ray.direction *= 2;
    longer.queries[0].hit->t /= 2;
    EXPECT_EQ(difference(longer), "") << "the length of a direction is free";
}

TEST(RayTrees, NamesWeightsAndWhatIsNotTraced) {
    const auto with_mirror = [](float weight, bool traced) {
        QueryLog log = tree();
        if (traced) {
            log.next_kind = "reflected";
            log.next_weight = weight;
            log.nearest({{0, 0, 0}, {0, 0, -1}}, {0, 1e9}, {});
        } else {
            log.pruned("reflected", {{0, 0, 0}, {0, 0, -1}}, weight);
        }
        return log.to_json();
    };
    EXPECT_EQ(first_difference(with_mirror(0.5f, true), with_mirror(0.25f, true)),
              "depth 1: the reflected ray has the weight 0.5; the solution's has 0.25");
    EXPECT_EQ(first_difference(with_mirror(0.5f, true), with_mirror(0.001f, false)),
              "depth 1: the reflected ray is traced (weight 0.5); the solution's is not (weight 0.001)");
    EXPECT_EQ(first_difference(with_mirror(0.5f, false), with_mirror(0.5f, true)),
              "depth 1: the reflected ray is not traced (weight 0.5); the solution's is");
    EXPECT_EQ(first_difference(with_mirror(0.5f, false), with_mirror(0.5f, false)), "");
}

TEST(RayTrees, NamesDirections) {
    QueryLog t = tree();
    t.queries[1].ray.direction = {0, 4, -3};
    EXPECT_EQ(
        difference(t),
        "depth 1: the shadow ray has a direction that differs by 16.3 degrees: (0, 4, -3), the solution's (0, 3, -4)");
}

TEST(RayTrees, NamesHits) {
    QueryLog t = tree();
    t.queries[0].hit.reset();
    EXPECT_EQ(difference(t), "depth 0: the camera ray misses everything; the solution's hits object 2 at t = 5");
    t = tree();
    t.queries[0].hit->object = 1;
    EXPECT_EQ(difference(t), "depth 0: the camera ray hits object 1 at t = 5; the solution's object 2 at t = 5");
    t = tree();
    t.queries[0].hit->t = 4;
    EXPECT_EQ(difference(t), "depth 0: the camera ray hits object 2 at distance 4; the solution's at 5");
    t = tree();
    t.queries[0].hit->shading_normal = {0, 0, 1};
    EXPECT_NE(difference(t).find("a normal that differs by 180 degrees"), std::string::npos);
}

TEST(RayTrees, NamesShadowsMissingRaysAndRadiance) {
    QueryLog t = tree();
    t.queries[1].blocked = true;
    EXPECT_EQ(difference(t), "depth 1: the shadow ray is blocked; the solution's reaches the light");
    t = tree();
    t.queries.pop_back();
    EXPECT_EQ(difference(t), "depth 1: the shadow ray is missing");
    t = tree();
    t.occluded({{0, 0, 0}, {1, 0, 0}}, {0, 1}, false);
    EXPECT_EQ(difference(t), "depth 1: the shadow ray is asked, which the solution does not ask");
    t = tree();
    t.queries[0].radiance = Radiance(0.25f);
    EXPECT_NE(difference(t).find("agrees in all geometry, but brings home (0.25, 0.25, 0.25)"), std::string::npos);
}

TEST(RayTrees, NanDiffers) {
    QueryLog t = tree();
    t.queries[0].hit->t = NAN;
    EXPECT_NE(difference(t), "");
}

TEST(RayTrees, SurvivesHostileText) {
    for (const std::string text :
         {"", "{", "[]", "{\"queries\":3}", "{\"queries\":[{}]}", "{\"queries\":[{\"kind\":5}]}", "Grade :=>> 100"})
        EXPECT_EQ(first_difference(text, tree().to_json()), "the student's program prints no ray tree");
    EXPECT_EQ(first_difference(std::string(100000, '['), tree().to_json()), "the student's program prints no ray tree");
}

}  // namespace
}  // namespace rays::grader
