#include "core/intersector.h"

#include <gtest/gtest.h>

namespace rays {
namespace {

/// Always hits at t = 2; always blocks.
class Wall final : public Intersector {
    std::optional<Hit> find_nearest(const Ray& ray, Interval) const override {
        Hit hit;
        hit.t = 2;
        hit.point = ray.at(2);
        hit.normal = hit.shading_normal = {0, 0, -1};
        return hit;
    }
    bool find_occluder(const Ray&, Interval) const override { return true; }
};

TEST(QueryLog, RecordsNothingUnlessAsked) {
    ASSERT_EQ(query_log, nullptr);
    EXPECT_TRUE(Wall().nearest({}, {}).has_value());
}

TEST(QueryLog, AShadowRayIsAChildOfTheHitItStartsFrom) {
    QueryLog log;
    query_log = &log;
    Wall().nearest({}, {});
    Wall().occluded({}, {0, 5});
    query_log = nullptr;
    ASSERT_EQ(log.queries.size(), 2u);
    EXPECT_EQ(log.queries[0].parent, -1);
    EXPECT_EQ(log.queries[1].parent, 0);
    EXPECT_EQ(log.queries[1].depth, 1);
    EXPECT_TRUE(log.queries[1].blocked);
    EXPECT_NE(log.to_text().find("t=2"), std::string::npos) << log.to_text();
    EXPECT_NE(log.to_text().find("\n  shadow ray"), std::string::npos) << log.to_text();
}

TEST(QueryLog, AnEndlessRangeIsStillJson) {
    QueryLog log;
    query_log = &log;
    Wall().nearest({}, {0, kInfinity});
    query_log = nullptr;
    EXPECT_NE(log.to_json().find("\"range\":[0,null]"), std::string::npos) << log.to_json();
}

}  // namespace
}  // namespace rays
