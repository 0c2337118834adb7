#include "renderer/agreement.h"

#include <fmt/format.h>

#include <cmath>

#include "4_partitioning/structures.h"

namespace rays {
namespace {

std::string text(const Vec3& v) { return fmt::format("{:.17g} {:.17g} {:.17g}", v.x, v.y, v.z); }

bool same(Real a, Real b) { return (a == b && std::signbit(a) == std::signbit(b)) || (std::isnan(a) && std::isnan(b)); }
bool same(const Vec3& a, const Vec3& b) { return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z); }
bool same(const Hit& a, const Hit& b) {
    return same(a.t, b.t) && a.object == b.object && a.material == b.material && same(a.point, b.point) &&
           same(a.normal, b.normal) && same(a.shading_normal, b.shading_normal);
}
bool same(const std::optional<Hit>& a, const std::optional<Hit>& b) { return a && b ? same(*a, *b) : !a && !b; }

std::string text(const std::optional<Hit>& hit) {
    return hit ? fmt::format("object {} at {:.17g}", hit->object, hit->t) : "miss";
}

}  // namespace

HardRays::HardRays(const Scene& scene, std::uint64_t seed) : bits_(seed) {
    for (const Primitive p : primitives_of(scene)) {
        const Bounds b = bounds_of(scene, p);
        if (!b.is_finite()) continue;
        bounds_.push_back(b);
        box_.add(b);
    }
    if (bounds_.empty()) box_ = {Vec3(-10), Vec3(10)};
}

Vec3 HardRays::direction() {
    for (;;) {
        const Real x = unit(), y = unit();
        const Vec3 v = Real(2) * Vec3(x, y, unit()) - Real(1);
        if (const Real length = glm::length(v); length <= 1 && length > Real(0.1)) return v / length;
    }
}

Vec3 HardRays::in_box() {
    const Real x = unit(), y = unit();
    return box_.min + Vec3(x, y, unit()) * (box_.max - box_.min);
}

/// Where faces and corners of cells are likely: whole fractions of the box, powers of two among them.
Vec3 HardRays::on_lattice() {
    const int cells = below(2) ? 1 << below(5) : 1 + below(12);
    Vec3 p;
    for (int a = 0; a < 3; ++a)
        p[a] =
            box_.min[a] + (box_.max[a] - box_.min[a]) * static_cast<Real>(below(cells + 1)) / static_cast<Real>(cells);
    return p;
}

/// A corner of some primitive's box, or its middle.
Vec3 HardRays::at_primitive() {
    if (bounds_.empty()) return in_box();
    const Bounds& b = bounds_[static_cast<std::size_t>(bits_() % bounds_.size())];
    if (below(2)) return Real(0.5) * (b.min + b.max);
    return {below(2) ? b.min.x : b.max.x, below(2) ? b.min.y : b.max.y, below(2) ? b.min.z : b.max.z};
}

/// With one zero or two, of either sign, or diagonal.
Vec3 HardRays::along_axes() {
    Vec3 d(sign(), sign(), sign());
    const int kind = below(3), axis = below(3);
    if (kind == 0) d[axis] = below(2) ? Real(0) : Real(-0.0);
    if (kind == 1) d[(axis + 1) % 3] = d[(axis + 2) % 3] = below(2) ? Real(0) : Real(-0.0);
    if (kind == 0 && below(2)) d[(axis + 1) % 3] *= unit() + Real(0.1);
    return d;
}

Ray HardRays::ray() {
    const Real size = glm::length(box_.max - box_.min);
    switch (below(12)) {
        case 0: {
            const Vec3 o = in_box();
            return {o, direction()};
        }
        case 1: {
            const Vec3 d = direction();
            return {in_box() - size * (unit() + Real(0.5)) * d, d};
        }
        case 2: {
            const Vec3 d = along_axes();
            return {in_box() - size * d, d};
        }
        case 3: {
            const Vec3 d = along_axes();
            return {on_lattice() - size * d, d};
        }
        case 4: {
            const Vec3 o = on_lattice();
            return {o, below(2) ? along_axes() : direction()};
        }
        case 5: {
            const Vec3 d = direction();
            return {at_primitive() - (below(2) ? Real(1e7) : Real(1e10)) * d, d};
        }
        case 6: {
            const Vec3 d = below(2) ? along_axes() : direction();
            return {at_primitive() - size * unit() * d, d};
        }
        case 7: {
            const Vec3 o = at_primitive();
            return {o, in_box() - o};
        }
        case 8: {
            const Vec3 d = direction();
            return {on_lattice() - size * d, d * std::pow(Real(10), 12 * unit() - 6)};
        }
        case 9: {
            const Vec3 o = on_lattice();
            return {o, on_lattice() - o};
        }
        case 10: {
            const Vec3 o = in_box() + Real(3) * size * direction();
            return {o, at_primitive() - o};
        }
        default: break;
    }
    // Almost along an axis, or almost along two.
    Ray odd{in_box(), direction()};
    for (int i = 1 + below(2); i-- > 0;) odd.direction[below(3)] *= std::pow(Real(10), Real(-30) * unit());
    return odd;
}

Ray HardRays::through_the_box() {
    const Vec3 from = in_box();
    return {from, in_box() - from};
}

HardRays::Query HardRays::next() {
    Query query{ray(), {0, kInfinity}};
    while (!is_ray(query.ray)) query.ray = ray();
    const Real length = glm::length(query.ray.direction);
    const Real size = glm::length(box_.max - box_.min) / (length > 0 ? length : 1);
    switch (below(8)) {
        case 0: query.range = {Real(0.001), size * 2 * unit()}; break;
        case 1: query.range = {-size * unit(), size * unit()}; break;
        case 2: query.range = {size * unit(), kInfinity}; break;
        case 3: query.range = {-kInfinity, kInfinity}; break;
        case 4: query.range = {size, size * unit()}; break;  // often empty
        default: query.range = {Real(0.0001), Real(1e7)}; break;
    }
    return query;
}

Agreement compare(const Scene& scene, const Intersector& one, const Intersector& other, std::size_t count,
                  std::uint64_t seed) {
    HardRays rays(scene, seed);
    Agreement result;
    const auto differ = [&](const HardRays::Query& q, const std::string& how) {
        if (result.differences++ > 0) return;
        result.first = fmt::format("origin {} direction {} range {:.17g} {:.17g}: {}", text(q.ray.origin),
                                   text(q.ray.direction), q.range.min, q.range.max, how);
    };
    for (; result.rays < count; ++result.rays) {
        const HardRays::Query q = rays.next();
        const auto a = one.nearest(q.ray, q.range), b = other.nearest(q.ray, q.range);
        result.hits += b.has_value();
        if (!same(a, b)) differ(q, text(a) + " instead of " + text(b));
        const bool blocked = one.occluded(q.ray, q.range), truth = other.occluded(q.ray, q.range);
        if (blocked != truth) differ(q, truth ? "the occluder is not found" : "an occluder that is none");
    }
    return result;
}

}  // namespace rays
