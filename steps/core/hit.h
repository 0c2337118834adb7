// Where a ray meets a surface.
#pragma once

#include <cstdint>

#include "core/vec.h"

namespace rays {

/// A root of F(ray.at(t)) = 0 on one shape, and where on the shape it lies.
struct Root {
    Real t = 0;
    Vec2 uv{0};              ///< triangle: weights of b and c; patch: (u, v); else unused
    std::uint32_t part = 0;  ///< mesh: the face; box: the side; cone: 0 mantle, 1 base, 2 cap
};

/// The nearest visible root of a ray in a scene. Both normals have unit length, in world space, and are *not* turned
/// to the viewer: they point where the shape's own convention says.
struct Hit {
    Real t = 0;
    Vec3 point{0};
    Vec3 normal{0};            ///< of the true surface
    Vec3 shading_normal{0};    ///< interpolated, on smooth triangles; else the same
    std::uint32_t object = 0;  ///< into Scene::objects
    std::uint32_t material = 0;
};

}  // namespace rays
