// Light sources, with POV-Ray's words.
#pragma once

#include "core/radiance.h"
#include "core/vec.h"

namespace rays {

struct Light {
    enum class Kind { point, spot, cylinder };
    Kind kind = Kind::point;
    Vec3 location{0};
    Radiance color{1.0f};
    Vec3 point_at{0, 0, 1};  ///< spot, cylinder, parallel
    bool parallel = false;   ///< rays go along point_at - location, from the plane through `location` across it
    Real radius_rad = 0;     ///< spot: half angle of full light. Cylinder: `radius`, a length.
    Real falloff_rad = 0;    ///< spot: half angle where it ends. Cylinder: a length.
    Real tightness = 0;      ///< exponent of the cosine from the axis
    Real fade_distance = 0;  ///< fading needs both > 0
    Real fade_power = 0;
    bool shadowless = false;
    // Area light, step 5: location + u axis_u + v axis_v, u and v in [-1/2, 1/2].
    bool area = false;
    Vec3 axis_u{0}, axis_v{0};
    int size_u = 1, size_v = 1;
    int adaptive = 0;
    bool jitter = false, circular = false, orient = false;
};

}  // namespace rays
