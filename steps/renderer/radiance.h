// From a camera ray to the light that comes along it: where the steps are put together.
#pragma once

#include "3_recursion/recursion.h"

namespace rays {

/// The media that a point is in, in the order of the objects: where a camera may stand. Empty when nothing in the
/// scene lets light through, for then nobody asks. What is the outside of an inverse object is a medium within its box
/// only: so has POV-Ray.
Inside media_around(const Scene& scene, const Vec3& point);

/// The radiance that arrives at ray.origin from ray.direction (any length). `inside` is where the ray starts.
Radiance radiance(World& world, Ray ray, const Inside& inside);

}  // namespace rays
