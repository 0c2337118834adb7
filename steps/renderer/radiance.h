// From a ray to the light that comes along it: where the steps are put together.
#pragma once

#include "core/intersector.h"
#include "core/radiance.h"
#include "core/scene.h"

namespace rays {

/// The distance beyond which POV-Ray sees nothing (its MAX_DISTANCE). A plane's horizon depends on it.
inline constexpr Real kFarthest = 1e7;

/// The radiance that arrives at ray.origin from ray.direction (any length).
Radiance radiance(const Scene& scene, const Intersector& intersector, Ray ray);

}  // namespace rays
