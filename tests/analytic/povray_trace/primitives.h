// The objects that are asked about.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "random.h"

namespace rays::povray_trace {

struct SurfacePoint {
    glm::dvec3 point;
    glm::dvec3 normal;  ///< of unit length
};

struct Primitive {
    std::string name;
    std::string sdl;          ///< one object
    double size = 1.5;        ///< about its radius around the origin
    bool closed = true;       ///< false: the sign of the normal is a matter of taste
    bool smooth = false;      ///< trace() tells the interpolated normal
    double tolerance = 1e-9;  ///< as a share of the size, for the reason that the test states
    std::function<SurfacePoint(Random&)> surface;
    /// How far a point lies off the surface, where that has a closed form and POV-Ray's own root is in doubt.
    std::function<double(const glm::dvec3&)> distance = {};
    std::function<glm::dvec3(Random&)> edge;  ///< where the surface ends or breaks; empty: nowhere
};

std::vector<Primitive> all_primitives();

}  // namespace rays::povray_trace
