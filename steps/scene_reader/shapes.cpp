// The shapes' own numbers. What POV-Ray drops with a warning is dropped with a note; what makes no sense is an error.
#include <fmt/format.h>

#include "scene_reader/statements.h"

namespace rays::sdl {

namespace {

double positive(Interpreter& in, std::string_view what) {
    const Place place = in.peek().place;
    const double value = in.number();
    if (!(value > 0)) in.fail(place, fmt::format("{} is {}; it must be greater than 0", what, value));
    return value;
}

double not_negative(Interpreter& in, std::string_view what) {
    const Place place = in.peek().place;
    const double value = in.number();
    if (!(value >= 0)) in.fail(place, fmt::format("{} is {}; it must not be negative", what, value));
    return value;
}

V3 unit(Interpreter& in, std::string_view what) {
    const Place place = in.peek().place;
    const V3 v = in.vector();
    const double length = glm::length(v);
    if (!(length >= kEpsilon && std::isfinite(length)))
        in.fail(place, fmt::format("{} has no length; give it a direction", what));
    return v / length;
}

V3 vector_and_comma(Interpreter& in) {
    const V3 v = in.vector();
    in.comma();
    return v;
}

SphereDraft read_sphere(Interpreter& in) {
    const V3 center = vector_and_comma(in);
    return {center, positive(in, "a sphere's radius")};
}

PlaneDraft read_plane(Interpreter& in) {
    const V3 normal = unit(in, "a plane's normal");
    in.comma();
    return {normal, in.number()};
}

/// The rectangle of a box without thickness.
Shared<PolygonDraft> flat_box(const BoxDraft& box, int thin_axis) {
    const int u = (thin_axis + 1) % 3, v = (thin_axis + 2) % 3;
    auto polygon = std::make_shared<PolygonDraft>();
    for (const auto& [at_u, at_v] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
        V3 corner = box.min;
        if (at_u) corner[u] = box.max[u];
        if (at_v) corner[v] = box.max[v];
        polygon->points.push_back(corner);
    }
    polygon->contour_ends.push_back(4);
    return polygon;
}

DiscDraft read_disc(Interpreter& in) {
    DiscDraft disc{};
    disc.center = vector_and_comma(in);
    disc.normal = unit(in, "a disc's normal");
    in.comma();
    disc.radius = positive(in, "a disc's radius");
    in.comma();
    const Place place = in.peek().place;
    if (in.number_follows()) disc.hole_radius = not_negative(in, "the radius of a disc's hole");
    if (!(disc.hole_radius < disc.radius)) in.fail(place, "this disc's hole is as large as the disc");
    return disc;
}

ConeDraft finish_cone(Interpreter& in, ConeDraft cone, const Place& place) {
    if (!(glm::length(cone.cap - cone.base) >= kEpsilon))
        in.fail(place, "both ends of this cylinder or cone are the same point");
    if (!(cone.base_radius > 0 || cone.cap_radius > 0)) in.fail(place, "both radii of this cone are 0");
    cone.open = in.accept(Word::open_);
    return cone;
}

ConeDraft read_cone(Interpreter& in) {
    const Place place = in.peek().place;
    ConeDraft cone{};
    cone.base = vector_and_comma(in);
    cone.base_radius = not_negative(in, "a cone's radius");
    in.comma();
    cone.cap = vector_and_comma(in);
    cone.cap_radius = not_negative(in, "a cone's radius");
    return finish_cone(in, cone, place);
}

ConeDraft read_cylinder(Interpreter& in) {
    const Place place = in.peek().place;
    ConeDraft cone{};
    cone.base = vector_and_comma(in);
    cone.cap = vector_and_comma(in);
    cone.base_radius = cone.cap_radius = positive(in, "a cylinder's radius");
    return finish_cone(in, cone, place);
}

QuadricDraft read_quadric(Interpreter& in) {
    const Place place = in.peek().place;
    const V3 square = vector_and_comma(in);
    const V3 mixed = vector_and_comma(in);  // xy, xz, yz
    const V3 linear = vector_and_comma(in);
    const double constant = in.number();
    if (square == V3(0) && mixed == V3(0) && linear == V3(0)) in.fail(place, "this quadric has no coefficients");
    glm::dmat4 q(0);
    for (int i = 0; i < 3; ++i) {
        q[i][i] = square[i];
        q[i][3] = q[3][i] = linear[i] / 2;
    }
    q[0][1] = q[1][0] = mixed[0] / 2;
    q[0][2] = q[2][0] = mixed[1] / 2;
    q[1][2] = q[2][1] = mixed[2] / 2;
    q[3][3] = constant;
    return {q};
}

TorusDraft read_torus(Interpreter& in) {
    const double major = positive(in, "a torus's major radius");
    in.comma();
    return {major, positive(in, "a torus's minor radius")};
}

bool is_degenerate(const V3& a, const V3& b, const V3& c) { return !(glm::length(glm::cross(a - b, c - b)) > 0); }

void drop(Interpreter& in, ObjectDraft& object, std::string_view what) {
    in.note(object.place, fmt::format("{} is left out, as POV-Ray does", what));
    object.shape = NothingDraft{};
}

void read_triangle(Interpreter& in, bool smooth, ObjectDraft& object) {
    TriangleDraft triangle;
    triangle.smooth = smooth;
    bool degenerate = false;
    for (int i = 0; i < 3; ++i) {
        if (i > 0) in.comma();
        triangle.corner[i] = in.vector();
        if (!smooth) continue;
        in.comma();
        triangle.normal[i] = in.vector();
        const double length = glm::length(triangle.normal[i]);
        degenerate = degenerate || !(length > 0);
        triangle.normal[i] /= length;
    }
    if (degenerate || is_degenerate(triangle.corner[0], triangle.corner[1], triangle.corner[2])) {
        return drop(in, object, "a degenerate triangle");
    }
    object.shape = triangle;
}

bool same_point(const V3& a, const V3& b) {
    return std::abs(a.x - b.x) < kEpsilon && std::abs(a.y - b.y) < kEpsilon && std::abs(a.z - b.z) < kEpsilon;
}

/// Flat to POV-Ray's tolerance, in the plane that its first three usable points span. False when there is none.
bool is_flat(const std::vector<V3>& points) {
    std::size_t i = 1;
    while (i < points.size() && !(glm::dot(points[i] - points[0], points[i] - points[0]) > kEpsilon)) ++i;
    if (i >= points.size()) return false;
    const V3 u = points[i] - points[0];
    for (++i; i < points.size(); ++i) {
        const V3 v = points[i] - points[0];
        const V3 normal = glm::cross(u, v);
        if (!(glm::dot(v, v) > kEpsilon && glm::dot(normal, normal) > kEpsilon)) continue;
        for (const V3& point : points) {
            if (!(std::abs(glm::dot(point - points[0], glm::normalize(normal))) <= 1e-6)) return false;
        }
        return true;
    }
    return false;
}

/// A contour ends where its first point comes again.
void read_polygon(Interpreter& in, ObjectDraft& object) {
    const Place place = in.peek().place;
    const std::size_t size = in.count("the number of a polygon's points", kMostElements);
    if (size < 3) in.fail(place, "a polygon needs at least three points");
    auto polygon = std::make_shared<PolygonDraft>();
    V3 first(0);
    bool open = false;
    for (std::size_t i = 0; i < size; ++i) {
        in.comma();
        const V3 point = in.vector();
        in.hold(2 * sizeof(V3));
        if (!open) {
            first = point;
            open = true;
            polygon->points.push_back(point);
        } else if (same_point(first, point)) {
            polygon->contour_ends.push_back(static_cast<std::uint32_t>(polygon->points.size()));
            open = false;
        } else {
            polygon->points.push_back(point);
        }
    }
    if (open) {
        in.note(object.place, "this polygon is not closed: it is closed, as POV-Ray does");
        polygon->contour_ends.push_back(static_cast<std::uint32_t>(polygon->points.size()));
    }
    if (!is_flat(polygon->points)) return drop(in, object, "a polygon whose points lie on a line or in no plane");
    object.shape = Shared<PolygonDraft>(std::move(polygon));
}

/// A box whose corners share one coordinate is seen, as a rectangle; one that is a line or a point is not.
void read_box(Interpreter& in, ObjectDraft& object) {
    const V3 a = vector_and_comma(in);
    const V3 b = in.vector();
    const BoxDraft box{glm::min(a, b), glm::max(a, b)};
    int thin_axes = 0, thin_axis = 0;
    for (int axis = 0; axis < 3; ++axis) {
        if (box.min[axis] < box.max[axis]) continue;
        ++thin_axes;
        thin_axis = axis;
    }
    if (thin_axes > 1) return drop(in, object, "a box without an area");
    if (thin_axes == 1)
        object.shape = flat_box(box, thin_axis);
    else
        object.shape = box;
}

Shared<PatchDraft> read_patch(Interpreter& in) {
    for (;;) {
        const Token word = in.peek();
        if (word.is(Word::type_)) {
            in.take();
            in.integer("a patch's type", 0, 3);
        } else if (word.is(Word::flatness_) || word.is(Word::u_steps_) || word.is(Word::v_steps_) ||
                   word.is(Word::accuracy_)) {
            in.take();
            in.number();  // of POV-Ray's triangles; Raysteps intersects the patch itself
        } else {
            break;
        }
    }
    auto patch = std::make_shared<PatchDraft>();
    for (V3& point : patch->control) {
        in.comma();
        point = in.vector();
    }
    return patch;
}

}  // namespace

bool is_shape(Word word) {
    switch (word) {
        // clang-format off
        case Word::sphere_: case Word::plane_: case Word::box_: case Word::disc_: case Word::cone_: case Word::cylinder_:
        case Word::quadric_: case Word::torus_: case Word::triangle_: case Word::smooth_triangle_: case Word::polygon_:
        case Word::mesh_: case Word::mesh2_: case Word::bicubic_patch_: return true;
        // clang-format on
        default: return false;
    }
}

void read_shape(Context& context, Word word, ObjectDraft& object) {
    Interpreter& in = context.in;
    switch (word) {
        case Word::sphere_: object.shape = read_sphere(in); return;
        case Word::plane_: object.shape = read_plane(in); return;
        case Word::box_: return read_box(in, object);
        case Word::disc_: object.shape = read_disc(in); return;
        case Word::cone_: object.shape = read_cone(in); return;
        case Word::cylinder_: object.shape = read_cylinder(in); return;
        case Word::quadric_: object.shape = read_quadric(in); return;
        case Word::torus_: object.shape = read_torus(in); return;
        case Word::triangle_: return read_triangle(in, false, object);
        case Word::smooth_triangle_: return read_triangle(in, true, object);
        case Word::polygon_: return read_polygon(in, object);
        case Word::bicubic_patch_: object.shape = read_patch(in); return;
        case Word::mesh_: object.shape = read_mesh(context, object.place); return;
        case Word::mesh2_: object.shape = read_mesh2(context, object.place); return;
        default: in.unexpected("an object");
    }
}

}  // namespace rays::sdl
