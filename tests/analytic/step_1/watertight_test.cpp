// No ray slips through a common edge or corner of a closed mesh.
#include <gtest/gtest.h>

#include "aim.h"
#include "tessellation.h"

namespace rays {
namespace {

/// Rays aimed at corners and at points of edges, as exactly as numbers allow: where leaks are.
void expect_no_leak(const Mesh& mesh, const Vec3& center, Real radius, double distance, int count, std::uint64_t seed) {
    test::Aim aim(seed);
    int leaks = 0;
    for (int i = 0; i < count; ++i) {
        const auto& face = mesh.faces[std::size_t(aim.uniform(0, double(mesh.faces.size())))];
        const Vec3& a = mesh.positions[face.position[0]];
        const Vec3& b = mesh.positions[face.position[1]];
        const Real s = i % 4 == 0 ? Real(0) : aim.uniform(0, 1);  // every fourth: the corner itself
        const Vec3 target = a + s * (b - a);
        // From outside, within 30 degrees of the radius: no face around the target is seen from behind (37 degrees lie
        // between the radius and a face at the corner of an icosahedron). A ray that grazes may miss.
        const Vec3 out = glm::normalize(target - center), side = aim.direction();
        const Vec3 origin = target + Real(distance) * radius * glm::normalize(out + Real(0.5) * side);
        const Ray ray{origin, target - origin};
        const auto hit = intersect(mesh, ray, {0, kInfinity});
        leaks += !(hit && hit->t < Real(1.001));
    }
    EXPECT_EQ(leaks, 0) << "of " << count << " rays at edges and corners, seed " << seed << ", distance " << distance;
}

TEST(Watertight, MillionRaysAtEdgesAndCornersOfAnIcosahedron) {
    Mesh mesh = test::ball_of_triangles(0, 1, {Real(0.1), Real(0.2), Real(0.3)});
    prepare(mesh);
    expect_no_leak(mesh, {Real(0.1), Real(0.2), Real(0.3)}, 1, 3, 800'000, 1);
    mesh.outward_winding = 0;
    mesh.bound = {};
    expect_no_leak(mesh, {Real(0.1), Real(0.2), Real(0.3)}, 1, 3, 100'000, 2);
}

TEST(Watertight, FinerFartherAndAwayFromTheOrigin) {
    Mesh fine = test::ball_of_triangles(2, Real(0.01), {300, -200, 100});
    prepare(fine);
    expect_no_leak(fine, {300, -200, 100}, Real(0.01), 1000, 50'000, 3);
    Mesh coarse = test::ball_of_triangles(1, 50, {0, 0, 0});
    prepare(coarse);
    expect_no_leak(coarse, {0, 0, 0}, 50, Real(1.5), 100'000, 4);
}

TEST(Watertight, PatchesWithACommonEdge) {
    // One bicubic surface as two patches, split by de Casteljau's algorithm in u at 1/2: rays at the seam hit one of
    // them.
    BicubicPatch whole, left, right;
    test::Aim aim(5);
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) whole.control[std::size_t(4 * i + j)] = Vec3(i, j, 0) + aim.in_cube(0.4);
    for (std::size_t j = 0; j < 4; ++j) {
        const Vec3 a = whole.control[j], b = whole.control[4 + j], c = whole.control[8 + j], d = whole.control[12 + j];
        const Vec3 ab = (a + b) / Real(2), bc = (b + c) / Real(2), cd = (c + d) / Real(2);
        const Vec3 abc = (ab + bc) / Real(2), bcd = (bc + cd) / Real(2), m = (abc + bcd) / Real(2);
        left.control[j] = a, left.control[4 + j] = ab, left.control[8 + j] = abc, left.control[12 + j] = m;
        right.control[j] = m, right.control[4 + j] = bcd, right.control[8 + j] = cd, right.control[12 + j] = d;
    }
    prepare(left);
    prepare(right);
    int leaks = 0;
    for (int i = 0; i < 50'000; ++i) {
        const Real v = aim.uniform(0.001, 0.999), w = 1 - v;
        const auto& k = right.control;
        const Vec3 target = w * w * w * k[0] + 3 * w * w * v * k[1] + 3 * w * v * v * k[2] + v * v * v * k[3];
        const Vec3 origin = target + Vec3(aim.uniform(-2, 2), aim.uniform(-2, 2), -8);
        const Ray ray{origin, target - origin};
        leaks += !intersect(left, ray, {0, 2}) && !intersect(right, ray, {0, 2});
    }
    EXPECT_EQ(leaks, 0);
}

}  // namespace
}  // namespace rays
