// Affine maps in double precision, composed as POV-Ray composes them.
#pragma once

#include "core/transform.h"

namespace rays::sdl {

using V2 = glm::dvec2;
using V3 = glm::dvec3;
using M3 = glm::dmat3;

/// p -> linear * p + offset, with the inverse carried along (a rotation's or a scale's is exact, and stays so).
struct Affine {
    M3 linear{1};
    V3 offset{0};
    M3 inverse_linear{1};
    V3 inverse_offset{0};

    V3 point(const V3& p) const { return linear * p + offset; }
    V3 vector(const V3& v) const { return linear * v; }
    /// Of a plane: not normalised.
    V3 normal(const V3& n) const { return glm::transpose(inverse_linear) * n; }

    static Affine translation(const V3& by);
    static Affine scaling(const V3& by);
    /// Degrees around x, then y, then z, left-handed, as `rotate`.
    static Affine rotation(const V3& degrees);
    /// Degrees around an axis, as `vaxis_rotate`.
    static Affine axis_rotation(const V3& axis, double degrees);
    /// Regular maps only: check `is_regular` first.
    static Affine matrix(const M3& linear, const V3& offset);
    static bool is_regular(const M3& linear);
};

/// First `first`, then `second`.
Affine then(const Affine& first, const Affine& second);
Affine inverse(const Affine& map);
Transform to_transform(const Affine& map);
bool is_finite(const Affine& map);
inline bool is_finite(const V3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

}  // namespace rays::sdl
