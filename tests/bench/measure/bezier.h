// A point and the two slopes of a bicubic Bezier patch, in any number type.
#pragma once

#include <array>

#include <glm/glm.hpp>

namespace rays::bench {

template <class Number>
struct PatchPoint {
    glm::vec<3, Number> p, du, dv;
};

template <class Number>
std::array<Number, 4> bernstein(Number t) {
    const Number s = 1 - t;
    return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
}
template <class Number>
std::array<Number, 4> bernstein_slope(Number t) {
    const Number s = 1 - t;
    return {-3 * s * s, 3 * s * s - 6 * s * t, 6 * s * t - 3 * t * t, 3 * t * t};
}

/// control[4 * i + j] belongs to u_i, v_j, as in core/shapes.h.
template <class Number>
PatchPoint<Number> patch_point(const std::array<glm::vec<3, Number>, 16>& control, Number u, Number v) {
    const auto a = bernstein(u), da = bernstein_slope(u), b = bernstein(v), db = bernstein_slope(v);
    PatchPoint<Number> at{glm::vec<3, Number>(0), glm::vec<3, Number>(0), glm::vec<3, Number>(0)};
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
            const auto& k = control[4 * i + j];
            at.p += a[i] * b[j] * k;
            at.du += da[i] * b[j] * k;
            at.dv += a[i] * db[j] * k;
        }
    }
    return at;
}

/// A root of P(u, v) = o + t d: where, and at which t.
template <class Number>
struct PatchRoot {
    Number u, v, t;
};

/// Newton's method in (u, v, t) from one start, unguarded: the step is the solution of
/// P + du a + dv b = o + t d. Ends after `steps` steps, wherever that is.
template <class Number>
PatchRoot<Number> newton_from(const std::array<glm::vec<3, Number>, 16>& control, const glm::vec<3, Number>& o,
                              const glm::vec<3, Number>& d, Number u, Number v, int steps) {
    Number t = 0;
    for (int i = 0; i < steps; ++i) {
        const auto at = patch_point(control, u, v);
        const glm::vec<3, Number> to = o - at.p, n = glm::cross(at.du, at.dv);
        const Number volume = glm::dot(d, n);
        t = -glm::dot(to, n) / volume;
        const glm::vec<3, Number> off = to + t * d;  // in the tangent plane
        const Number n2 = glm::dot(n, n);
        const Number step_u = glm::dot(glm::cross(off, at.dv), n) / n2,
                     step_v = glm::dot(glm::cross(at.du, off), n) / n2;
        u += step_u;
        v += step_v;
        if (!(std::abs(step_u) + std::abs(step_v) > 4 * std::numeric_limits<Number>::epsilon())) break;
    }
    return {u, v, t};
}

}  // namespace rays::bench
