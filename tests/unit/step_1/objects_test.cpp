// Transforms, bounds, culling, clips, inside, and the nearest of many.
#include <gtest/gtest.h>

#include "1_ray_casting/ray_casting.h"
#include "aim.h"

namespace rays {
namespace {

constexpr Interval kAhead{0, kInfinity};
constexpr Real kClose = 64 * std::numeric_limits<Real>::epsilon();
const Vec3 X(1, 0, 0), Y(0, 1, 0), Z(0, 0, 1);

Transform transform_of(const Mat3& linear, const Vec3& offset) {
    Transform t;
    t.linear = linear;
    t.offset = offset;
    t.inverse_linear = glm::inverse(linear);
    t.inverse_offset = -(t.inverse_linear * offset);
    return t;
}

std::uint32_t add_sphere(Scene& scene, const Vec3& center, Real radius) {
    Object object;
    object.kind = ShapeKind::sphere;
    object.shape = std::uint32_t(scene.spheres.size());
    scene.spheres.push_back({center, radius});
    scene.objects.push_back(object);
    return std::uint32_t(scene.objects.size() - 1);
}

Object plane_of(Scene& scene, const Vec3& normal, Real offset) {
    Object object;
    object.kind = ShapeKind::plane;
    object.shape = std::uint32_t(scene.planes.size());
    scene.planes.push_back({normal, offset});
    return object;
}

TEST(Transforms, TIsKeptAndNormalsStayNormal) {
    test::Aim aim(1);
    for (int i = 0; i < 1000; ++i) {
        const Mat3 linear(aim.in_cube(2), aim.in_cube(2), aim.in_cube(2));
        if (std::abs(glm::determinant(linear)) < Real(0.3)) continue;
        const Transform t = transform_of(linear, aim.in_cube(5));
        const Ray ray{aim.in_cube(5), aim.in_cube(2)};
        const Ray local = ray_to_local(t, ray);
        EXPECT_NEAR(glm::distance(t.point_to_world(local.at(2)), ray.at(2)), 0, 1000 * kClose);
        const Vec3 n = aim.direction(), tangent = glm::cross(n, aim.direction());
        const Vec3 world = glm::normalize(normal_to_world(t, n));
        EXPECT_NEAR(glm::dot(world, glm::normalize(t.vector_to_world(tangent))), 0, 100 * kClose);
        EXPECT_GT(glm::dot(world, t.vector_to_world(n)), 0) << "outside stays outside, also in mirrored spaces";
    }
}

TEST(Bounds, NeverTooEager) {
    test::Aim aim(2);
    int rejected = 0;
    for (int i = 0; i < 20'000; ++i) {
        std::vector<Vec3> points;
        for (int k = 0; k < 5; ++k) points.push_back(aim.in_cube(1) + Vec3(3, 0, 0));
        const BoundingSphere bound = bounding_sphere(points);
        for (const Vec3& p : points) ASSERT_LE(glm::distance(p, bound.center), bound.radius);
        const Ray ray = aim.through(points[0] + Real(i % 2) * aim.in_cube(4), aim.uniform(0, 6));
        const Interval range{aim.uniform(0, 1), aim.uniform(1, 9)};
        const Real speed = glm::length(ray.direction);
        Real nearest = kInfinity;  // by walking along the range
        for (int k = 0; k <= 400; ++k)
            nearest = std::min(
                nearest, glm::distance(ray.at(range.min + (range.max - range.min) * Real(k) / 400), bound.center));
        const Real step = (range.max - range.min) * speed / 400;
        const bool rejects = misses(bound, ray, range);
        rejected += rejects;
        if (nearest < bound.radius) {
            EXPECT_FALSE(rejects) << "ray " << i;
        }
        if (nearest > bound.radius + step) {
            EXPECT_TRUE(rejects) << "ray " << i;
        }
    }
    EXPECT_GT(rejected, 2000);
    EXPECT_LT(bounding_sphere({}).radius, 0);
    EXPECT_FALSE(misses(BoundingSphere{}, {Vec3(9, 9, 9), X}, kAhead)) << "a negative radius bounds nothing";
}

Mesh tetrahedron() {
    Mesh mesh;
    mesh.positions = {Vec3(0), X, Y, Z};
    for (const auto& f : {std::array<std::uint32_t, 3>{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}})
        mesh.faces.push_back({f, {}, Mesh::kObjectMaterial, false});
    return mesh;
}

TEST(Meshes, WindingOfClosedAndOpenMeshes) {
    Mesh mesh = tetrahedron();
    prepare(mesh);
    EXPECT_EQ(mesh.outward_winding, 1);
    for (auto& face : mesh.faces) std::swap(face.position[1], face.position[2]);
    prepare(mesh);
    EXPECT_EQ(mesh.outward_winding, -1);
    std::swap(mesh.faces[0].position[1], mesh.faces[0].position[2]);
    prepare(mesh);
    EXPECT_EQ(mesh.outward_winding, 0) << "one face disagrees";
    mesh.faces.pop_back();
    prepare(mesh);
    EXPECT_EQ(mesh.outward_winding, 0) << "open";
}

TEST(Meshes, CornersThatAreWrittenTwiceAreOne) {
    Mesh mesh;  // every face with corners of its own, as POV-Ray's mesh {} has them; one zero is negative
    const Mesh shared = tetrahedron();
    for (const auto& face : shared.faces) {
        const auto first = std::uint32_t(mesh.positions.size());
        for (const std::uint32_t i : face.position) mesh.positions.push_back(shared.positions[i]);
        mesh.faces.push_back({{first, first + 1, first + 2}, {}, Mesh::kObjectMaterial, false});
    }
    mesh.positions[0].x = -Real(0);
    prepare(mesh);
    EXPECT_EQ(mesh.outward_winding, 1);
}

TEST(Meshes, ACaveInASolidIsNotCulled) {
    Mesh mesh = tetrahedron();
    for (Vec3& p : mesh.positions) p *= 9;
    const Mesh inner = tetrahedron();
    for (const auto& face : inner.faces) {
        auto [a, b, c] = face.position;
        mesh.faces.push_back({{a + 4, c + 4, b + 4}, {}, Mesh::kObjectMaterial, false});
    }
    for (const Vec3& p : inner.positions) mesh.positions.push_back(p + Vec3(1));
    prepare(mesh);
    EXPECT_EQ(mesh.outward_winding, 0);
}

TEST(Nearest, OrderInTheFileDoesNotMatter) {
    for (const bool near_first : {true, false}) {
        Scene scene;
        if (near_first) add_sphere(scene, Real(5) * Z, 1);
        const auto far = add_sphere(scene, Real(9) * Z, 1);
        if (!near_first) add_sphere(scene, Real(5) * Z, 1);
        const auto hit = nearest_hit(scene, {Vec3(0), Z}, kAhead);
        ASSERT_TRUE(hit);
        EXPECT_NEAR(hit->t, 4, kClose);
        EXPECT_NE(hit->object, far);
        EXPECT_NEAR(glm::distance(hit->normal, -Z), 0, kClose);
        EXPECT_EQ(nearest_hit(scene, {Vec3(0), Z}, {7, kInfinity})->object, far);
        EXPECT_FALSE(nearest_hit(scene, {Vec3(0), -Z}, kAhead));
    }
}

TEST(Clips, RootsBehindAClippedOneAreSeen) {
    Scene scene;
    const auto ball = add_sphere(scene, Vec3(0), 2);
    scene.clips.push_back({plane_of(scene, Z, 0)});  // what lies at z < 0 is left
    scene.objects[ball].clip = 0;
    const auto bowl = nearest_hit(scene, {Vec3(0, 0, 9), -Z}, kAhead);
    ASSERT_TRUE(bowl);
    EXPECT_NEAR(bowl->t, 11, 11 * kClose);
    EXPECT_NEAR(glm::distance(bowl->normal, -Z), 0, kClose) << "the sphere's own normal, not turned";
    EXPECT_FALSE(nearest_hit(scene, {Vec3(-9, 0, 1), X}, kAhead));
    scene.clips[0][0].inverse = true;
    EXPECT_NEAR(nearest_hit(scene, {Vec3(0, 0, 9), -Z}, kAhead)->t, 7, 11 * kClose);
}

TEST(Clips, FarSideOfAClippedClosedMeshIsSeen) {
    Scene scene;
    scene.meshes.push_back(tetrahedron());
    prepare(scene.meshes[0]);
    Object object;
    object.kind = ShapeKind::mesh;
    scene.objects.push_back(object);
    const Ray ray{Vec3(2), Vec3(-1)};
    EXPECT_NEAR(nearest_hit(scene, ray, kAhead)->t, Real(5) / 3, kClose);
    scene.clips.push_back({plane_of(scene, glm::normalize(Vec3(1)), Real(0.3))});
    scene.objects[0].clip = 0;
    const auto far = nearest_hit(scene, ray, kAhead);
    ASSERT_TRUE(far) << "back faces of a closed mesh were culled where the clip shows them";
    EXPECT_NEAR(far->t, 2, kClose);
}

TEST(Inside, AsPovRaySays) {
    Scene scene;
    const auto ball = add_sphere(scene, Vec3(0), 1);
    Object object = scene.objects[ball];
    EXPECT_TRUE(inside(scene, object, Vec3(Real(0.9), 0, 0)));
    EXPECT_FALSE(inside(scene, object, Vec3(Real(1.1), 0, 0)));
    object.inverse = true;
    EXPECT_FALSE(inside(scene, object, Vec3(Real(0.9), 0, 0)));
    EXPECT_TRUE(inside(scene, plane_of(scene, Y, 1), Vec3(5, Real(0.9), 5)));
    scene.tori.push_back({2, Real(0.5)});
    Object torus;
    torus.kind = ShapeKind::torus;
    EXPECT_TRUE(inside(scene, torus, Vec3(2, Real(0.4), 0)));
    EXPECT_FALSE(inside(scene, torus, Vec3(0)));
    scene.triangles.push_back({Vec3(0), X, Y});
    Object flat;
    flat.kind = ShapeKind::triangle;
    flat.inverse = true;
    EXPECT_FALSE(inside(scene, flat, Vec3(Real(0.2), Real(0.2), 0))) << "flat things have no inside, inverse or not";
    scene.discs.push_back({Vec3(0), Y, 1, 0});
    Object disc;
    disc.kind = ShapeKind::disc;
    EXPECT_TRUE(inside(scene, disc, Vec3(9, -1, 0))) << "a disc's inside is the half space behind it";
}

}  // namespace
}  // namespace rays
