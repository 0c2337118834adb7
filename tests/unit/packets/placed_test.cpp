// Moved and clipped objects, as a scene has them: packets find the roots that step 1 finds.
#include <algorithm>

#include "../step_4/hard_scenes.h"
#include "packets/placed.h"
#include "same_roots.h"

namespace rays::packets::tests {
namespace {

using rays::tests::staged;

const std::string kMoved =
    "sphere { <1, 0, 0>, 1 scale <1, 0.1, 2> rotate 33 * z }\n"
    "box { -1, <1, 0.5, 0.3> rotate <20, 30, 10> }\n"
    "box { -1, 1 matrix <1, 0.2, 0, 0, 1, 0.5, 0.3, 0, -2, 4, 5, 6> }\n"
    "cone { 0, 1, <0, 2, 0>, 0.3 scale <1, 1, 0.4> }\n"
    "cylinder { 0, <1, 1, 1>, 0.5 open scale <2, 1, 1> rotate 20 }\n"
    "disc { <1, 2, 0>, <1, 1, 0.2>, 0.7, 0.2 scale <1, 3, 1> }\n"
    "polygon { 4, <0, 0, 0>, <1, 0, 0>, <1, 1, 0>, <0, 0, 0> scale <3, 1, 1> rotate 70 * y }\n"
    "quadric { <1, 2, 1>, <0.3, 0, 0>, <0, 1, 0>, -1 scale <1, 2, 0.5> rotate 40 * x }\n"
    "torus { 1, 0.3 rotate <40, 0, 20> scale <1, 2, 0.5> }\n"
    "plane { <1, 2, 0.5>, -0.2 scale <1, 2, 1> }\n";

/// One of each kind of clip, inverse and not, moved and not, alone and in company.
const std::string kClipped =
    "sphere { 0, 1 clipped_by { box { -0.4, 2 } } }\n"
    "sphere { 0, 1 clipped_by { box { -0.4, 2 rotate 30 } } clipped_by { plane { x, 0.5 } } }\n"
    "sphere { 0, 1 clipped_by { sphere { x, 0.9 inverse } } }\n"
    "sphere { 0, 1 scale <1, 0.5, 2> clipped_by { sphere { x, 0.9 scale <1, 2, 1> } } }\n"
    "box { -1, 1 clipped_by { cone { -2 * y, 1, 2 * y, 0.2 } } }\n"
    "box { -1, 1 rotate 25 clipped_by { cylinder { -2 * y, 2 * y, 0.8 inverse } } }\n"
    "cone { -y, 1, y, 0.2 open clipped_by { quadric { <1, 1, 1>, <0, 0, 0>, <0, 0, 0>, -0.8 } } }\n"
    "cylinder { -y, y, 1 clipped_by { disc { 0, <1, 1, 0>, 0.2 } } }\n"
    "torus { 1, 0.3 clipped_by { box { <-2, -1, -2>, <0.3, 0.1, 2> } } }\n"
    "torus { 0.5, 0.2 rotate 30 * x clipped_by { plane { x, 0.1 } } clipped_by { sphere { y, 1.2 inverse } } }\n"
    "disc { 0, <0, 1, 0.3>, 1 clipped_by { plane { x, 0.2 inverse } } }\n"
    "plane { y, 0 clipped_by { box { -1, 1 } } }\n"
    "quadric { <1, 0, 1>, <0, 0, 0>, <0, 0, 0>, -0.5 clipped_by { box { -1, 1 } } clipped_by { plane { z, 0.3 } } }\n"
    "polygon { 5, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1> clipped_by { sphere { 0, 1.1 } } }\n"
    "triangle { <-1, -1, 0>, <1, -1, 0.2>, <0, 1, 0> clipped_by { box { -0.5, 0.5 } } }\n"
    "smooth_triangle { <-1, -1, 0>, z, <1, -1, 0.2>, x, <0, 1, 0>, y clipped_by { sphere { 0, 0.6 } } }\n"
    "mesh { triangle { -x, x, y } triangle { -x, x, z } triangle { x, y, z } triangle { -x, y, z } clipped_by { box { "
    "-0.5, 0.5 inverse } } }\n";

/// A patch, and clips that have no packet test.
const std::string kAlone =
    "sphere { 0, 1 clipped_by { torus { 1, 0.3 } } }\n"
    "bicubic_patch { type 1 flatness 0 u_steps 3 v_steps 3 "
    "<0,0,0>,<1,0,1>,<2,0,0>,<3,0,0>,<0,1,0>,<1,1,1>,<2,1,0>,<3,1,1>,\n"
    "<0,2,0>,<1,2,1>,<2,2,2>,<3,2,0>,<0,3,0>,<1,3,0>,<2,3,0>,<3,3,1> }\n";

/// Where an object's box has its corners, and the middles between them.
Special special_of(const Scene& scene, Primitive p) {
    const Bounds b = bounds_of(scene, p);
    if (!b.is_finite())
        return {{Vec3(0), {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}}, 2};
    const Vec3 middle = Real(0.5) * (b.min + b.max), half = Real(0.5) * (b.max - b.min);
    Special special{{middle}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, half}, glm::length(half)};
    for (int corner = 0; corner < 27; ++corner)
        special.points.push_back(middle + half * Vec3(corner % 3 - 1, corner / 3 % 3 - 1, corner / 9 - 1));
    return special;
}

void expect_same(const Scene& scene, Primitive p) {
    const Object& object = scene.objects[p.object];
    expect_same_roots(
        fmt::format("object {}, part {}", p.object, p.part), special_of(scene, p),
        [&](const Rays& rays, const Span& span) {
            std::optional<ShearedRays> sheared_rays;
            return intersect_placed(scene, object, p.part, rays, span,
                                    [&]() -> const ShearedRays& { return sheared_rays.emplace(sheared(rays)); });
        },
        [&](const Ray& ray, Interval range) { return intersect_part(scene, object, p.part, ray, range); },
        [](const Rays&, const Roots&, const Ray&, const Root&, int) {}, 1200);
}

class PlacedObjects : public testing::TestWithParam<std::string> {};

TEST_P(PlacedObjects, RootsAreThoseOfSingleRays) {
    const Scene scene = staged(GetParam());
    for (const Primitive p : primitives_of(scene)) {
        ASSERT_TRUE(has_packet_test(scene, scene.objects[p.object])) << "object " << p.object;
        expect_same(scene, p);
    }
}

INSTANTIATE_TEST_SUITE_P(All, PlacedObjects, testing::Values(kMoved, kClipped),
                         [](const auto& of) { return of.index == 0 ? "moved" : "clipped"; });

TEST(Placed, MovedAndClippedIsWhatTheTextsHold) {
    const Scene moved = staged(kMoved), clipped = staged(kClipped);
    EXPECT_GE(
        std::count_if(moved.objects.begin(), moved.objects.end(), [](const Object& o) { return o.transform != kNone; }),
        6)
        << "the reader works most transforms into the numbers of shapes: here are some that it cannot";
    for (const Object& o : clipped.objects) EXPECT_NE(o.clip, kNone);
}

TEST(Placed, WhoHasNoPacketTestIsAskedRayByRay) {
    const Scene scene = staged(kAlone);
    for (const Object& object : scene.objects)
        EXPECT_FALSE(has_packet_test(scene, object)) << "kind " << int(object.kind);
}

TEST(Placed, InsideOfClipsIsStep1s) {
    const Scene scene = staged(kClipped);
    RaysAt points({{Vec3(0), {1, 0, 0}, {0, 1, 0}}, {{1, 0, 0}}, 1}, 3);
    int in = 0, out = 0;
    for (int n = 0; n < 400; ++n) {
        Lanes<Ray> at;
        for (Ray& ray : at) ray = points.next().ray;
        for (const ClipList& clips : scene.clips)
            for (const Object& clip : clips) {
                const unsigned got = inside(scene, clip, together(at).origin).bits();
                for (std::size_t i = 0; i < kLanes; ++i) {
                    const bool truth = rays::inside(scene, clip, at[i].origin);
                    ASSERT_EQ(got >> i & 1, unsigned{truth})
                        << "kind " << int(clip.kind) << " at " << text(at[i].origin);
                    ++(truth ? in : out);
                }
            }
    }
    EXPECT_GT(in, 5000);
    EXPECT_GT(out, 5000);
}

}  // namespace
}  // namespace rays::packets::tests
