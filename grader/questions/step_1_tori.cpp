// Questions of task 1.10. That no root comes before the chosen one is certified by walking along the ray with the
// distance to the surface, which a unit step cannot change by more than one.
#include <fmt/format.h>

#include <cmath>

#include "questions/step_1.h"

namespace rays::grader::step_1 {

namespace {

struct Ring {
    L major, minor;

    L distance(const V& p) const { return std::hypot(std::hypot(p.x, p.z) - major, p.y) - minor; }
    V circle(L around) const { return major * V(std::cos(around), 0, std::sin(around)); }
    V normal(L around, L tube) const {
        return std::cos(tube) * V(std::cos(around), 0, std::sin(around)) + std::sin(tube) * V(0, 1, 0);
    }
    std::string text() const { return fmt::format("torus {{ {}, {} }}\n", number(major), number(minor)); }
};

/// True when the surface is certainly not met for `from` < t < `to`, t in lengths.
bool is_free(const Ring& ring, const V& origin, const V& unit, L from, L to) {
    const L close = 1e-4L * ring.minor;
    const bool begins_inside = ring.distance(origin + from * unit) < 0;
    while (from < to) {
        const L distance = ring.distance(origin + from * unit);
        if (std::abs(distance) < close || (distance < 0) != begins_inside) return false;
        from += std::abs(distance) * 0.999L;
    }
    return true;
}

V along(Dice& dice, const V& n) {
    for (;;) {
        const V d = dice.unit();
        if (glm::dot(d, n) > 0.2L) return d;
    }
}

/// A ray that meets the given side first, from `reach` away. Nothing of the surface comes before.
Shot first_at(Dice& dice, const Ring& ring, V& normal, L reach, bool from_inside) {
    for (;;) {
        const L around = dice.between(0, 6.283), tube = dice.between(0, 6.283);
        normal = ring.normal(around, tube);
        const V point = ring.circle(around) + ring.minor * normal, d = along(dice, from_inside ? normal : -normal);
        const L distance = from_inside ? ring.minor * dice.between(0.1, 0.8) : reach;
        const V origin = point - distance * d;
        if ((ring.distance(origin) < 0) != from_inside) continue;
        if (is_free(ring, origin, d, 0, distance - 0.01L * ring.minor))
            return aim(point, d, distance, dice.between(0.2, 5));
    }
}

}  // namespace

std::vector<Question> tori(std::uint64_t seed) {
    Dice dice(seed);
    Notebook book("1.10");
    for (const L part : {0.2L, 0.5L, 0.9L}) {
        const L major = dice.round_between(0.8, 2);
        const Ring ring{major, rounded(std::round(1000 * part * major) / 1000)};
        book.objects(ring.text());
        V n;
        for (int i = 0; i < 3; ++i) {
            const Shot outside = first_at(dice, ring, n, dice.between(1, 8), false);
            book.root(outside, "from outside: the first of up to four roots");
            book.ask(nearest_query(outside), "its normal points out of the tube", hits_with_normal(outside, n, false));
            book.root(first_at(dice, ring, n, 0, true), "from within the tube");
        }
        const Shot through = first_at(dice, ring, n, 5, false);
        book.ask(root_query(through, 0, through.t * 0.99L), "the range ends before the tube", misses_it());
        book.miss(aim(V(0), V(0, 1, 0), 5), "through the hole, along the axis");
        const L edge = major + ring.minor;
        book.miss(aim(V(1.01L * edge, 0, 0), V(0, 0, 1), 6), "past the outermost circle");
        book.miss(aim(V(0, 1.01L * ring.minor, 0), glm::normalize(V(1, 0, 0.3L)), 6), "just above the ring");
        book.root(aim(V(-edge, 0, 0), V(1, 0, 0), 4), "through the middle: the first of four roots");

        Shot second = aim(V(-edge, 0, 0), V(1, 0, 0), 4);
        const L entry = second.t;
        second.t += 2 * ring.minor;
        book.ask(root_query(second, entry + ring.minor), "through the middle: the second root", hits(second));
        second.t = entry + 2 * major;
        book.ask(root_query(second, entry + edge), "through the middle: the third root", hits(second));
        second.t = entry + 2 * edge;
        book.ask(root_query(second, entry + 2 * major + ring.minor), "through the middle: the fourth root",
                 hits(second));

        // Parallel to the axis, close to the outer wall: two roots y = +-sqrt(r^2 - (rho - R)^2) close together.
        for (const L depth : {1e-2L, 1e-4L, 1e-6L}) {
            const L rho = rounded(major + ring.minor * (1 - depth));
            Shot grazing = aim(V(rho, 0, 0), V(0, 1, 0), 4);
            grazing.t -= std::sqrt((ring.minor - (rho - major)) * (ring.minor + (rho - major)));
            book.root(grazing, fmt::format("two roots close together at the wall: {} tube radii deep", number(depth)));
            // Across the top from the hole outwards: rho = R -+ sqrt(r^2 - y^2).
            const L y = rounded(ring.minor * (1 - depth)), around = dice.between(0, 6.28);
            const V out(std::cos(around), 0, std::sin(around));
            Shot top = aim(major * out + V(0, y, 0), out, 0.7L * major);
            top.t -= std::sqrt((ring.minor - y) * (ring.minor + y));
            if (top.t > 0)
                book.root(top, fmt::format("two roots close together at the top: {} tube radii deep", number(depth)));
        }
    }
    return book.take();
}

}  // namespace rays::grader::step_1
