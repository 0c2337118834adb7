// Nearest roots in long double, by methods that have nothing in common with those that are measured.
#pragma once

#include "core/shapes.h"
#include "target.h"

namespace rays::bench {

/// From the point of the ray nearest to the centre.
ExactRoot truth_of(const Sphere& sphere);
/// From the point of the ray nearest to the origin.
ExactRoot truth_of(const Quadric& quadric);
/// A thousand steps through the ball around it, then bisection. Misses a pair of roots nearer than a step: rays that
/// nearly touch the torus must be left out (rays_around does).
ExactRoot truth_of(const Torus& torus);
/// Subdivision by boxes down to a hundred-thousandth of the patch; only there Newton's method.
ExactRoot truth_of(const BicubicPatch& patch);

}  // namespace rays::bench
