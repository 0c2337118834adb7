#include "core/intersector.h"

#include <gtest/gtest.h>

#include <tuple>

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

TEST(QueryLog, ABranchKnowsItsKindItsWeightAndWhatItBrought) {
    QueryLog log;
    query_log = &log;
    {
        const LoggedRay camera("camera", 1);
        Wall().nearest({}, {});
        {
            const LoggedRay mirror("reflected", 0.25f);
            Wall().nearest({}, {});
            Wall().occluded({}, {0, 5});
            mirror.brings(Radiance(0.5f));
        }
        query_log->pruned("refracted", {}, 0.001f);
        camera.brings(Radiance(0.75f));
    }
    query_log = nullptr;
    ASSERT_EQ(log.queries.size(), 4u);
    const auto& [camera, mirror, shadow, refracted] =
        std::tie(log.queries[0], log.queries[1], log.queries[2], log.queries[3]);
    EXPECT_EQ(mirror.kind, "reflected");
    EXPECT_EQ(mirror.parent, 0);
    EXPECT_EQ(mirror.depth, 1);
    EXPECT_EQ(mirror.weight, 0.25f);
    EXPECT_EQ(mirror.radiance[1], 0.5f);
    EXPECT_EQ(camera.radiance[1], 0.75f);
    EXPECT_EQ(shadow.parent, 1);
    EXPECT_EQ(refracted.parent, 0) << "a ray that is not traced starts from the hit that would have sent it";
    EXPECT_TRUE(refracted.pruned);
    EXPECT_EQ(refracted.weight, 0.001f);
    EXPECT_NE(log.to_text().find("\n  refracted ray from"), std::string::npos) << log.to_text();
    EXPECT_NE(log.to_text().find("not traced"), std::string::npos) << log.to_text();
    EXPECT_EQ(log.residual(), 0.001f);
    EXPECT_NE(log.to_text().find("residual: rays that were not traced weigh 0.001"), std::string::npos)
        << log.to_text();
    EXPECT_NE(log.to_json().find("\"residual\":0.001"), std::string::npos) << log.to_json();
    EXPECT_NE(log.to_json().find("\"weight\":0.25,\"pruned\":false"), std::string::npos) << log.to_json();
}

}  // namespace
}  // namespace rays
