#include "ray_set.h"

#include <array>

namespace rays::povray_trace {
namespace {

using Point = glm::dvec3;

TestRay towards(const Point& origin, const Point& target, Kind kind) {
    return {origin, glm::normalize(target - origin), kind};
}

TestRay anywhere(const Primitive& p, Random& r) {
    return towards(r.uniform(2, 5) * p.size * r.direction(), r.in_ball(p.size), Kind::random);
}

TestRay from_inside(const Primitive& p, Random& r) { return {r.in_ball(p.size), r.direction(), Kind::inside}; }

TestRay along_axis(const Primitive& p, Random& r) {
    Point direction(0);
    const auto axis = static_cast<glm::length_t>(r.below(3));
    direction[axis] = r.sign();
    Point origin = r.in_ball(p.size);
    if (r.uniform() < 0.2) origin[(axis + 1) % 3] = 0;  // through the planes of symmetry
    return {origin - 3 * p.size * direction, direction, Kind::axis};
}

TestRay tangent(const Primitive& p, Random& r) {
    const SurfacePoint at = p.surface(r);
    const Point direction = r.across(at.normal);
    const Point off = r.sign() * r.decades(-12, -1) * p.size * at.normal;
    return {at.point + off - r.uniform(2, 4) * p.size * direction, direction, Kind::tangent};
}

TestRay at_edge(const Primitive& p, Random& r) {
    const Point off = r.uniform() < 0.2 ? Point(0) : r.decades(-12, -1) * p.size * r.direction();
    return towards(r.uniform(2, 4) * p.size * r.direction(), p.edge(r) + off, Kind::edge);
}

TestRay from_afar(const Primitive& p, Random& r) {
    return towards(r.decades(1, 2.5) * p.size * r.direction(), r.in_ball(p.size), Kind::far);
}

}  // namespace

std::vector<TestRay> make_rays(const Primitive& primitive, std::size_t count, std::uint64_t seed) {
    const auto hard = primitive.edge ? at_edge : tangent;
    const std::array makers{anywhere, anywhere, anywhere, from_inside, along_axis,
                            tangent,  tangent,  hard,     hard,        from_afar};
    Random random(seed);
    std::vector<TestRay> result;
    for (std::size_t i = 0; i < count; ++i) result.push_back(makers[i % makers.size()](primitive, random));
    return result;
}

}  // namespace rays::povray_trace
