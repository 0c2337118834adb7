#include "primitives.h"

#include <fmt/format.h>

#include <array>

namespace rays::povray_trace {
namespace {

using Point = glm::dvec3;
using Contour = std::vector<Point>;

constexpr double kTurn = 2 * std::numbers::pi;

std::string text(const Point& p) { return fmt::format("<{:.17g}, {:.17g}, {:.17g}>", p.x, p.y, p.z); }

Point between(const Point& a, const Point& b, double t) { return a + t * (b - a); }

/// A point of the outline, and sometimes exactly a corner.
Point on_outline(const std::vector<Contour>& contours, Random& random) {
    const Contour& contour = contours[random.below(contours.size())];
    const std::size_t i = random.below(contour.size());
    return random.uniform() < 0.2 ? contour[i]
                                  : between(contour[i], contour[(i + 1) % contour.size()], random.uniform());
}

Point on_circle(const Point& center, const Point& axis, double radius, Random& random) {
    return center + radius * random.across(axis);
}

SurfacePoint in_triangle(const Contour& corners, Random& random) {
    double u = random.uniform(), v = random.uniform();
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const Point e = corners[1] - corners[0], f = corners[2] - corners[0];
    return {corners[0] + u * e + v * f, glm::normalize(glm::cross(e, f))};
}

/// A point near `start` on F = 0, by Newton's method along the gradient.
template <class Function, class Gradient>
SurfacePoint project(Point p, const Function& f, const Gradient& gradient) {
    for (int i = 0; i < 60; ++i) {
        const Point g = gradient(p);
        p -= (f(p) / std::max(glm::dot(g, g), 1e-6)) * g;
    }
    const Point g = gradient(p);
    return {p, g / std::max(glm::length(g), 1e-12)};
}

Primitive sphere() {
    const Point center{0.3, -0.2, 0.5};
    return {.name = "sphere",
            .sdl = fmt::format("sphere {{ {}, 1.3 }}", text(center)),
            .size = 1.9,
            .surface =
                [center](Random& r) {
                    const Point n = r.direction();
                    return SurfacePoint{center + 1.3 * n, n};
                },
            .edge = {}};
}

Primitive plane() {
    const Point normal = glm::normalize(Point(0.3, 0.8, -0.5));
    return {.name = "plane",
            .sdl = "plane { <0.3, 0.8, -0.5>, 0.4 }",
            .surface =
                [normal](Random& r) {
                    return SurfacePoint{0.4 * normal + r.uniform(-3, 3) * r.across(normal), normal};
                },
            .edge = {}};
}

Primitive triangle(bool smooth) {
    const Contour c{{-1, -0.5, 0.2}, {1.2, -0.3, -0.4}, {0.1, 1.3, 0.6}};
    const std::string flat = fmt::format("triangle {{ {}, {}, {} }}", text(c[0]), text(c[1]), text(c[2]));
    const std::string round =
        fmt::format("smooth_triangle {{ {}, <-0.5, -0.6, -1>, {}, <0.8, -0.4, -0.9>, {}, <0, 2, -1> }}", text(c[0]),
                    text(c[1]), text(c[2]));
    return {.name = smooth ? "smooth_triangle" : "triangle",
            .sdl = smooth ? round : flat,
            .closed = false,
            .smooth = smooth,
            .surface = [c](Random& r) { return in_triangle(c, r); },
            .edge = [c](Random& r) { return on_outline({c}, r); }};
}

Primitive polygon() {
    // In the plane z = 0.3 x - 0.2 y + 0.1: a concave outline, a hole, an island in the hole.
    const auto lift = [](double x, double y) { return Point(x, y, 0.3 * x - 0.2 * y + 0.1); };
    const std::vector<Contour> contours{
        {lift(-1.2, -1), lift(1.3, -0.9), lift(0.4, 0), lift(1.4, 1.1), lift(0, 0.9), lift(-1.1, 1.3)},
        {lift(-0.8, -0.6), lift(0.1, -0.5), lift(-0.1, 0.5), lift(-0.7, 0.6)},
        {lift(-0.5, -0.2), lift(-0.2, -0.2), lift(-0.4, 0.2)}};
    std::string points;
    std::size_t count = 0;
    for (const Contour& contour : contours) {
        for (const Point& p : contour) points += ", " + text(p);
        points += ", " + text(contour[0]);
        count += contour.size() + 1;
    }
    return {.name = "polygon",
            .sdl = fmt::format("polygon {{ {}{} }}", count, points),
            .size = 1.9,
            .closed = false,
            .surface =
                [lift](Random& r) {
                    return SurfacePoint{lift(r.uniform(-1.2, 1.4), r.uniform(-1, 1.3)),
                                        glm::normalize(Point(-0.3, 0.2, 1))};
                },
            .edge = [contours](Random& r) { return on_outline(contours, r); }};
}

Primitive mesh() {
    // An octahedron pulled out of shape.
    const std::array<Point, 6> v{Point(1.2, 0.1, 0), {-1, 0, 0.2}, {0, 1.4, 0.1},
                                 {0.1, -1.1, 0},     {0, 0, 1.3},  {0.2, 0, -1}};
    std::vector<Contour> faces;
    for (int x = 0; x < 2; ++x) {
        for (int y = 2; y < 4; ++y) {
            for (int z = 4; z < 6; ++z) {
                const bool turn = (x + y + z) % 2 == 0;  // all counter-clockwise seen from the same side
                faces.push_back({v[static_cast<std::size_t>(x)], v[static_cast<std::size_t>(turn ? z : y)],
                                 v[static_cast<std::size_t>(turn ? y : z)]});
            }
        }
    }
    std::string sdl = "mesh {";
    for (const Contour& f : faces) sdl += fmt::format(" triangle {{ {}, {}, {} }}", text(f[0]), text(f[1]), text(f[2]));
    // POV-Ray keeps a mesh's corners, normals and distances in single precision: 6e-8 each.
    return {.name = "mesh",
            .sdl = sdl + " }",
            .closed = false,
            .tolerance = 5e-7,
            // Tangent where it is convex, at the edges. (In the plane of a face single precision decides alone.)
            .surface =
                [faces](Random& r) {
                    const Point p = on_outline(faces, r);
                    return SurfacePoint{p, glm::normalize(p)};
                },
            .edge = [faces](Random& r) { return on_outline(faces, r); }};
}

Primitive box() {
    const Point low{-1, -0.7, -0.4}, high{0.8, 1.1, 0.9};
    const auto inside = [low, high](Random& r) {
        return Point(r.uniform(low.x, high.x), r.uniform(low.y, high.y), r.uniform(low.z, high.z));
    };
    const auto pin = [low, high](Point& p, std::size_t axis, Random& r) {  // onto one of two faces
        const auto a = static_cast<glm::length_t>(axis);
        p[a] = r.sign() > 0 ? high[a] : low[a];
        return a;
    };
    return {.name = "box",
            .sdl = fmt::format("box {{ {}, {} }}", text(low), text(high)),
            .surface =
                [=](Random& r) {
                    Point p = inside(r), n(0);
                    const auto a = pin(p, r.below(3), r);
                    n[a] = p[a] == high[a] ? 1 : -1;
                    return SurfacePoint{p, n};
                },
            .edge =
                [=](Random& r) {
                    Point p = inside(r);
                    const std::size_t a = r.below(3);
                    pin(p, a, r);
                    pin(p, (a + 1) % 3, r);
                    if (r.uniform() < 0.2) pin(p, (a + 2) % 3, r);
                    return p;
                }};
}

Primitive disc() {
    const Point center{0.2, -0.1, 0.3}, normal = glm::normalize(Point(0.4, 1, -0.3));
    return {.name = "disc",
            .sdl = fmt::format("disc {{ {}, <0.4, 1, -0.3>, 1.3, 0.5 }}", text(center)),
            .size = 1.7,
            .closed = false,
            .surface =
                [=](Random& r) {
                    return SurfacePoint{on_circle(center, normal, r.uniform(0, 1.5), r), normal};
                },
            .edge = [=](Random& r) { return on_circle(center, normal, r.sign() > 0 ? 1.3 : 0.5, r); }};
}

Primitive cone(const std::string& name, double base_radius, double cap_radius, bool open) {
    const Point base{-0.3, -0.9, 0.2}, cap{0.4, 0.8, -0.3};
    const Point axis = glm::normalize(cap - base);
    const double height = glm::length(cap - base);
    const std::string radii =
        base_radius == cap_radius
            ? fmt::format("cylinder {{ {}, {}, {:.17g}", text(base), text(cap), base_radius)
            : fmt::format("cone {{ {}, {:.17g}, {}, {:.17g}", text(base), base_radius, text(cap), cap_radius);
    return {.name = name,
            .sdl = radii + (open ? " open }" : " }"),
            .closed = !open,
            .surface =
                [=](Random& r) {
                    const Point side = r.across(axis);
                    const double t = r.uniform();
                    const double slope = (base_radius - cap_radius) / height;
                    return SurfacePoint{between(base, cap, t) + (base_radius + t * (cap_radius - base_radius)) * side,
                                        glm::normalize(side + slope * axis)};
                },
            .edge =
                [=](Random& r) {
                    return r.sign() > 0 ? on_circle(base, axis, base_radius, r) : on_circle(cap, axis, cap_radius, r);
                }};
}

/// s . (x^2, y^2, z^2) + m . (xy, xz, yz) + l . (x, y, z) + c = 0.
Primitive quadric(const std::string& name, const Point& s, const Point& m, const Point& l, double c) {
    const auto f = [=](const Point& p) {
        return glm::dot(s, p * p) + glm::dot(m, Point(p.x * p.y, p.x * p.z, p.y * p.z)) + glm::dot(l, p) + c;
    };
    const auto gradient = [=](const Point& p) {
        return 2.0 * s * p + Point(m.x * p.y + m.y * p.z, m.x * p.x + m.z * p.z, m.y * p.x + m.z * p.y) + l;
    };
    return {.name = "quadric, " + name,
            .sdl = fmt::format("quadric {{ {}, {}, {}, {:.17g} }}", text(s), text(m), text(l), c),
            .size = 2,
            .surface = [=](Random& r) { return project(r.in_ball(2), f, gradient); },
            .edge = {}};
}

SurfacePoint on_torus(double major, double minor, Random& r) {
    const double u = r.uniform(0, kTurn), v = r.uniform(0, kTurn);
    const Point out{std::cos(u), 0, std::sin(u)};
    const Point normal = std::cos(v) * out + Point(0, std::sin(v), 0);
    return {major * out + minor * normal, normal};
}

Primitive torus(const std::string& name, double major, double minor) {
    return {.name = name,
            .sdl = fmt::format("torus {{ {:.17g}, {:.17g} }}", major, minor),
            .size = major + minor,
            .surface = [=](Random& r) { return on_torus(major, minor, r); },
            .distance = [=](const Point& p) { return std::abs(std::hypot(std::hypot(p.x, p.z) - major, p.y) - minor); },
            .edge = {}};
}

/// `plain` sheared and shifted by matrices that both sides read.
Primitive sheared(Primitive plain) {
    const glm::dmat3 m(Point(1.1, 0.2, 0), Point(0.5, 0.7, -0.1), Point(0, 0.3, 0.9));
    const Point shift{0.2, -0.3, 0.1};
    const glm::dmat3 normals = glm::transpose(glm::inverse(m));
    const std::string matrix = " matrix <1.1, 0.2, 0, 0.5, 0.7, -0.1, 0, 0.3, 0.9, 0.2, -0.3, 0.1> }";
    Primitive result = plain;
    result.name = "sheared " + plain.name;
    result.sdl = plain.sdl.substr(0, plain.sdl.rfind('}')) + matrix;
    result.size = 1.6 * plain.size;
    result.surface = [=](Random& r) {
        const SurfacePoint s = plain.surface(r);
        return SurfacePoint{m * s.point + shift, glm::normalize(normals * s.normal)};
    };
    const glm::dmat3 back = glm::inverse(m);  // shrinks lengths by no more than a factor of two
    if (plain.distance) result.distance = [=](const Point& p) { return plain.distance(back * (p - shift)); };
    if (plain.edge) result.edge = [=](Random& r) { return m * plain.edge(r) + shift; };
    return result;
}

}  // namespace

std::vector<Primitive> all_primitives() {
    const Point none{0};
    return {sphere(), plane(), triangle(false), triangle(true), polygon(), mesh(), box(), disc(),
            cone("cylinder", 0.8, 0.8, false), cone("open cylinder", 0.8, 0.8, true), cone("cone", 0.9, 0.35, false),
            cone("open cone", 0.4, 0.9, true), cone("cone with a tip", 1.0, 0, false),
            quadric("ellipsoid", {1, 2, 0.7}, none, {0.2, -0.1, 0.3}, -1.5),
            quadric("rotated ellipsoid", {1, 1.5, 0.8}, {0.4, -0.3, 0.2}, {0.2, -0.1, 0.3}, -1.2),
            // The vertex stands in the origin, since POV-Ray bounds a paraboloid wrongly elsewhere.
            quadric("paraboloid", {1, 0, 0.6}, none, {0, -1, 0}, 0),
            quadric("hyperboloid of one sheet", {1, -1, 0.8}, {0.1, 0, 0}, none, -0.3),
            quadric("hyperboloid of two sheets", {-1, 1, -0.8}, {0.1, 0, 0}, none, -0.3),
            quadric("saddle", none, {0, 1, 0}, {0, -1, 0}, 0), quadric("double cone", {1, -0.5, 1}, none, none, 0),
            quadric("cylinder", {1, 0, 0.8}, none, none, -0.9), torus("torus", 1.1, 0.35),
            torus("thin torus", 1.2, 0.05), torus("torus without a hole", 0.5, 0.8), sheared(sphere()),
            sheared(cone("cone", 0.9, 0.35, false)), sheared(torus("torus", 1.1, 0.35)), sheared(box())};
}

}  // namespace rays::povray_trace
