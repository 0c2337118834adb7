// An affine map together with its inverse.
#pragma once

#include "core/ray.h"

namespace rays {

/// Takes an object's own space to world space: p_world = linear * p + offset. The inverse is kept, since rays go the
/// other way. Both are finite and regular: the reader refuses degenerate matrices.
struct Transform {
    Mat3 linear{1};
    Vec3 offset{0};
    Mat3 inverse_linear{1};
    Vec3 inverse_offset{0};

    Vec3 point_to_world(const Vec3& p) const { return linear * p + offset; }
    Vec3 point_to_local(const Vec3& p) const { return inverse_linear * p + inverse_offset; }
    Vec3 vector_to_world(const Vec3& v) const { return linear * v; }
    Vec3 vector_to_local(const Vec3& v) const { return inverse_linear * v; }
};

}  // namespace rays
