// Each shape's packet test gives the bits of step 1's intersect, whatever the rays.
#include <algorithm>
#include <vector>

#include "packets/placed.h"
#include "same_roots.h"

namespace rays::packets::tests {
namespace {

constexpr auto kNoNormal = [](const Rays&, const Roots&, const Ray&, const Root&, int) {};

/// normals(points, roots) must be step 1's.
template <class Shape, class Normals>
auto with_normals(const Shape& shape, Normals normals) {
    return [&shape, normals](const Rays& rays, const Roots& roots, const Ray& ray, const Root& root, int lane) {
        const Spread3 got(normals(rays.at(roots.t), roots));
        const Vec3 truth = rays::normal(shape, ray.at(root.t), root);
        ASSERT_TRUE(same(got[lane], truth)) << "normal " << text(got[lane]) << " instead of " << text(truth);
    };
}

template <class Shape, class Hit>
void expect_same(const std::string& name, const Shape& shape, const Special& special, Hit hit) {
    expect_same_roots(
        name, special, [&](const Rays& rays, const Span& span) { return intersect(shape, rays, span); },
        [&](const Ray& ray, Interval range) { return rays::intersect(shape, ray, range); }, hit);
}

TEST(PacketShapes, Spheres) {
    for (const Sphere& s :
         {Sphere{Vec3(0), 1}, Sphere{{1, -2, 3}, Real(0.1)}, Sphere{{1e6, 0, -1e6}, 3}, Sphere{{0, -1e6, 0}, 1e6}}) {
        Special special{{s.center}, {}, s.radius};
        for (int a = 0; a < 3; ++a) {
            Vec3 d(0);
            d[a] = 1;
            special.points.push_back(s.center + s.radius * d);
            special.points.push_back(s.center - s.radius * d);
            special.directions.push_back(d);
        }
        expect_same("sphere", s, special, with_normals(s, [&](const Vec3s& p, const Roots&) { return normal(s, p); }));
    }
}

TEST(PacketShapes, Planes) {
    for (const Plane& p :
         {Plane{{0, 1, 0}, 0}, Plane{{0, 0, -1}, 2}, Plane{glm::normalize(Vec3(1, 2, -3)), Real(0.3)}}) {
        const Vec3 along = glm::cross(p.normal, Vec3(Real(0.3), 1, Real(0.2)));
        expect_same("plane", p, {{p.offset * p.normal, p.offset * p.normal + along}, {p.normal, along, {1, 0, 0}}},
                    kNoNormal);
    }
}

TEST(PacketShapes, Discs) {
    const Vec3 tilted = glm::normalize(Vec3(1, 1, Real(0.2)));
    for (const Disc& d : {Disc{{0, 0, 0}, {0, 1, 0}, 1, 0}, Disc{{1, 2, 3}, tilted, 1, Real(0.5)}}) {
        const Vec3 u = glm::normalize(glm::cross(d.normal, Vec3(1, 0, Real(0.1))));
        expect_same("disc", d, {{d.center, d.center + d.radius * u, d.center - d.hole_radius * u}, {d.normal, u}},
                    kNoNormal);
    }
}

Special special_of(const std::vector<Vec3>& corners) {
    Special special{corners, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 0};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3& next = corners[(i + 1) % corners.size()];
        special.points.push_back(Real(0.5) * (corners[i] + next));
        special.directions.push_back(next - corners[i]);
        special.size = std::max(special.size, glm::length(next - corners[i]));
    }
    return special;
}

TEST(PacketShapes, TrianglesAlsoThroughTheirEdgesAndCorners) {
    for (const Triangle& t :
         {Triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, Triangle{{1, 2, 3}, {2, Real(2.5), 3}, {1, 3, Real(4.2)}},
          Triangle{{-500, 0, 0}, {500, Real(0.001), 0}, {0, 0, 1}},
          Triangle{{1e5, 1e5, 0}, {1e5 + 1, 1e5, 0}, {1e5, 1e5, 1}}})
        expect_same_roots(
            "triangle", special_of({t.a, t.b, t.c}),
            [&](const Rays& rays, const Span& span) { return sheared(rays).intersect(t, span); },
            [&](const Ray& ray, Interval range) { return rays::intersect(t, ray, range); }, kNoNormal);
}

TEST(PacketShapes, TrianglesWithoutAreaAreMissedAlike) {
    QuestionSource source(special_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}), 1);
    const Triangle line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, point{Vec3(1), Vec3(1), Vec3(1)};
    for (int n = 0; n < 500; ++n) {
        const EightQuestions packet = source.next();
        for (const Triangle& t : {line, point}) {
            const Roots roots = sheared(together(packet.rays)).intersect(t, together(packet.ranges));
            for (std::size_t i = 0; i < kLanes; ++i)
                ASSERT_EQ(roots.is.bits() >> i & 1,
                          unsigned{intersect(t, packet.rays[i], packet.ranges[i]).has_value()})
                    << text(packet.rays[i], packet.ranges[i]);
        }
    }
}

/// An octahedron; closed, so its back faces are culled, or with a face missing.
Mesh octahedron(bool closed, bool inside_out) {
    Mesh mesh;
    mesh.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (std::uint32_t x : {0u, 1u})
        for (std::uint32_t y : {2u, 3u})
            for (std::uint32_t z : {4u, 5u}) {
                Mesh::Face face{.position = {x, y, z}};
                if ((x + y + z) % 2 != unsigned{inside_out}) std::swap(face.position[1], face.position[2]);
                mesh.faces.push_back(face);
            }
    if (!closed) mesh.faces.pop_back();
    prepare(mesh);
    return mesh;
}

TEST(PacketShapes, FacesOfMeshesWithTheirCulling) {
    for (const Mesh& mesh : {octahedron(true, false), octahedron(true, true), octahedron(false, false)}) {
        ASSERT_EQ(mesh.outward_winding != 0, mesh.faces.size() == 8);
        for (std::uint32_t face = 0; face < mesh.faces.size(); face += 3) {
            const Triangle t = triangle_of(mesh, face);
            Special special = special_of({t.a, t.b, t.c});
            special.points.insert(special.points.begin(), Vec3(0));  // from inside, too
            expect_same_roots(
                "face", special,
                [&](const Rays& rays, const Span& span) { return intersect(mesh, face, rays, sheared(rays), span); },
                [&](const Ray& ray, Interval range) { return rays::intersect(mesh, face, ray, range); }, kNoNormal,
                1000);
        }
    }
}

TEST(PacketShapes, InterpolatedNormals) {
    SmoothTriangle t{{{0, 0, 0}, {1, 0, 0}, {0, 1, Real(0.3)}}, {0, 0, 1}, glm::normalize(Vec3(1, 0, 1)), {0, 1, 0}};
    const auto normals = [](const SmoothTriangle& of) {
        return [&of](const Rays&, const Roots& roots, const Ray&, const Root& root, int lane) {
            const Vec3s n = interpolate(of.normal_a, of.normal_b, of.normal_c, roots.u, roots.v);
            ASSERT_TRUE(same(Spread3(n)[lane], shading_normal(of, root))) << text(shading_normal(of, root));
        };
    };
    const auto check = [&] {
        expect_same_roots(
            "smooth triangle", special_of({t.triangle.a, t.triangle.b, t.triangle.c}),
            [&](const Rays& rays, const Span& span) { return sheared(rays).intersect(t.triangle, span); },
            [&](const Ray& ray, Interval range) { return rays::intersect(t, ray, range); }, normals(t), 1000);
    };
    check();
    t.normal_c = t.normal_b = -t.normal_a;  // somewhere in between they are nothing together
    check();
}

Polygon polygon_of(const std::vector<std::vector<Vec3>>& contours) {
    Polygon p;
    for (const auto& contour : contours) {
        p.points.insert(p.points.end(), contour.begin(), contour.end());
        p.contour_ends.push_back(std::uint32_t(p.points.size()));
    }
    prepare(p);
    return p;
}

TEST(PacketShapes, PolygonsConcaveWithHolesAndIslands) {
    const auto square = [](Real half, Real turn) {
        std::vector<Vec3> corners;
        for (int k = 0; k < 4; ++k) {
            const Real angle = turn + Real(k) * kPi / 2;
            corners.push_back({half * std::cos(angle), half * std::sin(angle), half * std::cos(angle)});
        }
        return corners;
    };
    const std::vector<Vec3> star{{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}, {Real(0.5), 1, 0}, {-3, 2, 0}};
    for (const Polygon& p : {polygon_of({star}), polygon_of({square(3, 0), square(2, Real(0.3)), square(1, 1)}),
                             polygon_of({{{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}}})}) {
        Special special = special_of(p.points);
        special.points.insert(special.points.begin(), Vec3(0));
        expect_same("polygon", p, special, kNoNormal);
    }
}

TEST(PacketShapes, Boxes) {
    for (const Box& b :
         {Box{Vec3(-1), Vec3(1)}, Box{{0, 0, 0}, {1, Real(0.001), 3}}, Box{{-1e5, 2, -3}, {1e5, 3, 4}}}) {
        Special special = special_of(
            {b.min, {b.max.x, b.min.y, b.min.z}, {b.max.x, b.max.y, b.min.z}, b.max, {b.min.x, b.max.y, b.max.z}});
        special.points.insert(special.points.begin(), Real(0.5) * (b.min + b.max));
        expect_same("box", b, special,
                    with_normals(b, [](const Vec3s&, const Roots& roots) { return box_normal(roots.part); }));
    }
}

TEST(PacketShapes, ConesAndCylindersAlsoAlongTheirGenerators) {
    const Vec3 tip(1, 3, Real(-0.5));
    for (const bool open : {false, true})
        for (const Cone& c : {Cone{{0, 0, 0}, 1, {0, 1, 0}, 1, open}, Cone{{0, 0, 0}, 1, {0, 2, 0}, 0, open},
                              Cone{{0, 0, 0}, 0, {0, 2, 0}, 1, open}, Cone{{0, 0, 0}, Real(0.7), tip, Real(0.2), open},
                              Cone{{0, 0, 0}, Real(0.2), tip, Real(0.7), open},
                              Cone{{0, 0, 0}, Real(0.001), {100, 3, 5}, Real(0.001), open},
                              Cone{{1e6, 0, 0}, 1, {1e6, 1, 0}, Real(0.5), open},
                              Cone{{0, 0, 0}, 1, {0, Real(1e-3), 0}, Real(0.9), open}}) {
            const Vec3 axis = c.cap - c.base, u = glm::normalize(glm::cross(axis, Vec3(Real(0.1), Real(0.2), 1)));
            Special special{{c.base + Real(0.5) * axis, c.base, c.cap},
                            {axis, u, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                            glm::length(axis) + c.base_radius};
            for (const Vec3& d : {u, -u, glm::normalize(glm::cross(axis, u))}) {
                special.points.push_back(c.base + c.base_radius * d);
                special.points.push_back(c.cap + c.cap_radius * d);
                special.directions.push_back(axis + (c.cap_radius - c.base_radius) * d);
            }
            const auto normals = [&](const Vec3s& p, const Roots& roots) { return normal(c, p, roots.part); };
            expect_same(open ? "open cone" : "closed cone", c, special, with_normals(c, normals));
        }
}

Quadric quadric_of(const Vec3& squares, const Vec3& products, const Vec3& linear, Real constant) {
    Quadric s;
    for (int i = 0; i < 3; ++i) {
        s.q[i][i] = squares[i];
        s.q[i][3] = s.q[3][i] = linear[i] / 2;
    }
    s.q[0][1] = s.q[1][0] = products.x / 2;
    s.q[0][2] = s.q[2][0] = products.y / 2;
    s.q[1][2] = s.q[2][1] = products.z / 2;
    s.q[3][3] = constant;
    return s;
}

TEST(PacketShapes, Quadrics) {
    const Vec3 none(0);
    Special special{{Vec3(0), {1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {1, 0, 1}},
                    {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, 0, 1}, {1, 0, -1}, {0, 1, 1}},
                    2};
    // Along the cone x^2 + z^2 = y^2: nothing but rounding is left of the square.
    for (int k = 0; k < 8; ++k) special.directions.push_back(Real(0.7) * Vec3(std::cos(Real(k)), 1, std::sin(Real(k))));
    for (const Quadric& q : {quadric_of({1, 1, 1}, none, none, -1), quadric_of({1, 0, 1}, none, none, -1),
                             quadric_of({1, -1, 1}, none, none, 0), quadric_of({1, 0, 1}, none, {0, -1, 0}, 0),
                             quadric_of({1, 0, -1}, none, {0, -1, 0}, 0), quadric_of({1, -1, 1}, none, none, Real(0.3)),
                             quadric_of({1, 2, Real(0.5)}, {Real(0.3), Real(-0.7), 1}, {Real(0.1), 2, -1}, -1),
                             quadric_of(none, none, {1, 2, 3}, -1)})
        expect_same("quadric", q, special, with_normals(q, [&](const Vec3s& p, const Roots&) { return normal(q, p); }));
}

TEST(PacketShapes, ToriThinThickAndCrossingThemselves) {
    for (const Torus& t :
         {Torus{1, Real(0.25)}, Torus{1, Real(0.9)}, Torus{1, 1}, Torus{Real(0.5), 1}, Torus{100, Real(0.01)}}) {
        const Real out = t.major + t.minor, in = t.major - t.minor;
        const Special special{
            {{0, 0, 0}, {out, 0, 0}, {0, 0, -in}, {t.major, t.minor, 0}, {0, -t.minor, t.major}, {t.major, 0, 0}},
            {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {in, t.minor, 0}, {1, 0, 1}, {t.major, t.minor, 0}},
            out};
        expect_same("torus", t, special, with_normals(t, [&](const Vec3s& p, const Roots&) { return normal(t, p); }));
    }
}

TEST(PacketShapes, ToriSayForShadowsWhetherThereIsARoot) {
    const Torus torus{1, Real(0.3)};
    QuestionSource source({{{0, 0, 0}, {1, 0, 0}, {0, Real(0.3), 1}}, {{1, 0, 0}, {0, 1, 0}}, Real(1.3)}, 2);
    for (int n = 0; n < 2000; ++n) {
        const EightQuestions packet = source.next();
        Span span = together(packet.ranges);
        span.any = true;
        const Roots roots = intersect(torus, together(packet.rays), span);
        for (std::size_t i = 0; i < kLanes; ++i) {
            const bool truth = rays::intersect(torus, packet.rays[i], packet.ranges[i]).has_value();
            ASSERT_EQ(roots.is.bits() >> i & 1, unsigned{truth}) << text(packet.rays[i], packet.ranges[i]);
        }
    }
}

}  // namespace
}  // namespace rays::packets::tests
