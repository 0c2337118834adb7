// What structures are measured on: many triangles or spheres, with the same numbers in double and in float.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/scene.h"

namespace rays::bench {

/// The nearest numbers of float. GCC 12 forgets the rounding when it does two lanes at once (-O2, vectors of double to
/// float and back), so each goes through a variable that it has to write.
inline Vec3 in_float(const Vec3& v) {
    const volatile float x = static_cast<float>(v.x), y = static_cast<float>(v.y), z = static_cast<float>(v.z);
    return {Real(x), Real(y), Real(z)};
}

/// One mesh or one list of spheres in a scene of its own, ready to be built over. Every coordinate is a float's number,
/// so that Embree is asked about the very same bodies.
struct Bodies {
    std::string name;  ///< "spheres/1000"
    Scene scene;
    std::size_t count = 0;  ///< triangles or spheres
    // A camera that sees all of it:
    Vec3 eye{0}, look_at{0};
    Real angle_deg = 40;  ///< of view, across the picture

    bool are_spheres() const { return !scene.spheres.empty(); }
};

/// Spheres of one size, or triangles with equal sides, anywhere in a cube of side 1. Together they cover a view along
/// an axis once on average, however many there are: a line through the cube meets about one. The same for the same
/// count.
Bodies random_spheres(std::size_t count);
Bodies random_triangles(std::size_t count);

/// The sphereflake of scenes/bench/million_triangles.pov: 820 spheres, each of 1008 triangles: 826 560 in one mesh.
Bodies tessellated_flake();

}  // namespace rays::bench
