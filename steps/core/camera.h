// The camera, with POV-Ray's vectors.
#pragma once

#include "core/vec.h"

namespace rays {

/// All vectors are final: sky, angle, look_at and transforms are already applied. They need be neither orthogonal nor
/// of unit length: a sheared frustum is legal. The film point (x, y) in [0,1]^2, y down, lies at
///   direction + (x - 1/2) right + (1/2 - y) up   from `location`.
struct Camera {
    enum class Kind { perspective, orthographic };
    Kind kind = Kind::perspective;
    Vec3 location{0};
    Vec3 direction{0, 0, 1};
    Vec3 right{Real(4.0 / 3.0), 0, 0};
    Vec3 up{0, 1, 0};
    // Thin lens, step 5. The lens radius is aperture / 4 in POV-Ray's convention.
    Real aperture = 0;
    Vec3 focal_point{0, 0, 1};
    int blur_samples = 0;
    int aperture_blades = 0;                   ///< corners of a polygonal aperture; 0: a disc
    Real shutter_open = 0, shutter_close = 1;  ///< Time while the film is exposed
};

/// The size of the picture in pixels.
struct Raster {
    int width = 320;
    int height = 240;
};

}  // namespace rays
