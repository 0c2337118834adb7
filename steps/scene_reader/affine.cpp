#include "scene_reader/affine.h"

namespace rays::sdl {

Affine Affine::translation(const V3& by) {
    Affine map;
    map.offset = by;
    map.inverse_offset = -by;
    return map;
}

Affine Affine::scaling(const V3& by) {
    Affine map;
    for (int i = 0; i < 3; ++i) {
        map.linear[i][i] = by[i];
        map.inverse_linear[i][i] = 1 / by[i];
    }
    return map;
}

namespace {

Affine around(int axis, double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    const int j = (axis + 1) % 3;
    const int k = (axis + 2) % 3;
    Affine map;
    // Column i is where basis vector i goes; left-handed, so that rotate 90*z takes x to y.
    map.linear[j][j] = map.linear[k][k] = std::cos(angle);
    map.linear[j][k] = std::sin(angle);
    map.linear[k][j] = -std::sin(angle);
    map.inverse_linear = glm::transpose(map.linear);
    return map;
}

}  // namespace

Affine Affine::rotation(const V3& degrees) {
    return then(then(around(0, degrees.x), around(1, degrees.y)), around(2, degrees.z));
}

Affine Affine::axis_rotation(const V3& axis, double degrees) {
    // Rodrigues: v cos a + (n x v) sin a + n (n . v) (1 - cos a).
    const double angle = degrees * std::numbers::pi / 180;
    const V3 n = axis / glm::length(axis);
    const double c = std::cos(angle);
    Affine map;
    for (int i = 0; i < 3; ++i) {
        V3 v(0);
        v[i] = 1;
        map.linear[i] = v * c + glm::cross(n, v) * std::sin(angle) + n * (n[i] * (1 - c));
    }
    map.inverse_linear = glm::transpose(map.linear);
    return map;
}

bool Affine::is_regular(const M3& linear) {
    const double size = glm::length(linear[0]) * glm::length(linear[1]) * glm::length(linear[2]);
    // Columns that are parallel to 14 digits leave no digit to the inverse.
    return std::isfinite(size) && size > 0 && std::abs(glm::determinant(linear)) > 1e-14 * size;
}

Affine Affine::matrix(const M3& linear, const V3& offset) {
    Affine map;
    map.linear = linear;
    map.offset = offset;
    map.inverse_linear = glm::inverse(linear);
    map.inverse_offset = -(map.inverse_linear * offset);
    return map;
}

Affine then(const Affine& first, const Affine& second) {
    Affine map;
    map.linear = second.linear * first.linear;
    map.offset = second.point(first.offset);
    map.inverse_linear = first.inverse_linear * second.inverse_linear;
    map.inverse_offset = first.inverse_linear * second.inverse_offset + first.inverse_offset;
    return map;
}

Affine inverse(const Affine& map) { return {map.inverse_linear, map.inverse_offset, map.linear, map.offset}; }

Transform to_transform(const Affine& map) {
    return {Mat3(map.linear), Vec3(map.offset), Mat3(map.inverse_linear), Vec3(map.inverse_offset)};
}

bool is_finite(const Affine& map) {
    bool finite = is_finite(map.offset) && is_finite(map.inverse_offset);
    for (int i = 0; i < 3; ++i) finite = finite && is_finite(map.linear[i]) && is_finite(map.inverse_linear[i]);
    return finite;
}

}  // namespace rays::sdl
