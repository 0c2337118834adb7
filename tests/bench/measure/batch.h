// Rays to be asked about bodies, in double and in float.
#pragma once

#include <vector>

#include "bodies.h"
#include "core/intersector.h"
#include "core/ray.h"

namespace rays::bench {

/// Nothing is looked for nearer than this: a bounced ray shall not find where it starts.
inline constexpr Real kNearest = Real(1e-5);

struct Batch {
    std::vector<Ray> rays;        ///< every number is a float's; directions of unit length but for its rounding
    std::vector<Real> distances;  ///< to the nearest hit, from `truth`; infinite where there is none
};

/// Camera rays of a picture of 512 x 512: every eighth of its tiles of 32 x 32 pixels, so that neighbours stay
/// neighbours.
Batch primary_rays(const Bodies& bodies, const Intersector& truth);

/// One diffuse bounce from every point that the primary rays hit, its directions spread like the cosine.
Batch bounced_rays(const Batch& primary, const Intersector& truth);

}  // namespace rays::bench
