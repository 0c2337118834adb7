// The number type and the vectors of the whole course.
#pragma once

// GLM gives vectors, dot, cross, normalize and matrices; the course does not rewrite those.
#include <glm/glm.hpp>

#include <cmath>
#include <limits>
#include <numbers>

namespace rays {

/// Geometry is computed in `Real`. Double is the default: with float, paths of several bounces miss POV-Ray's
/// pixels at 1 to 2 % (see ARCHITECTURE.md, Decisions). Configure with -DRAYSTEPS_REAL=float to feel the difference.
#ifdef RAYSTEPS_REAL_FLOAT
using Real = float;
#else
using Real = double;
#endif

using Vec2 = glm::vec<2, Real>;
using Vec3 = glm::vec<3, Real>;
using Vec4 = glm::vec<4, Real>;
using Mat3 = glm::mat<3, 3, Real>;
using Mat4 = glm::mat<4, 4, Real>;

inline constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
inline constexpr Real kPi = std::numbers::pi_v<Real>;

/// How far from 1 a squared length may be whose reciprocal root one step of Newton's gives, to half a rounding.
inline constexpr Real kNearlyUnit = std::numeric_limits<Real>::digits > 24 ? Real(0x1p-27) : Real(0x1p-12);

/// v / |v|. What has unit length but for rounding, as what mirrors and glass make of unit vectors, needs neither root nor
/// division: 1 / sqrt(x) is (3 - x) / 2 there, off by 3/8 (x - 1)^2.
inline Vec3 unit(const Vec3& v) {
    const Real length2 = glm::dot(v, v);
    const bool is_nearly_unit = std::abs(length2 - 1) < kNearlyUnit;
    return (is_nearly_unit ? Real(1.5) - Real(0.5) * length2 : 1 / std::sqrt(length2)) * v;
}

inline bool is_finite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

}  // namespace rays
