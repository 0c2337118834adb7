// Step 2, Phong illumination and shadows: the contract. From a hit to the light that leaves it towards the viewer.
//
// All directions leave the surface and have unit length: `to_light`, `to_viewer`, and the normal, which is turned to
// the viewer's side. The formulas are POV-Ray's: no 1/pi, and no cosine on highlights (see the handout).
#pragma once

#include "core/intersector.h"
#include "core/radiance.h"
#include "core/scene.h"

namespace rays {

/// A point of a surface, ready to be lit.
struct Surface {
    Vec3 point{0};
    Vec3 normal{0, 0, -1};            ///< unit, turned to the viewer's side
    Vec3 geometric_normal{0, 0, -1};  ///< unit, of the true surface, turned to the viewer's side
    Vec3 to_viewer{0, 0, -1};         ///< unit
    Radiance color{1.0f};             ///< of the pigment, here
    const Finish* finish = nullptr;   ///< never null
};

/// What one light sends to a point.
struct Illumination {
    Vec3 to_light{0, 1, 0};  ///< unit
    Real distance = 0;       ///< to the light's position (parallel light: to its plane)
    Radiance radiance;       ///< after fading and the spot's cone; shadows not yet considered
};

// ---- Task 2.1: colour ------------------------------------------------------------------------------------------------

/// The pigment's colour at a point in world space.
Color pigment_at(const Scene& scene, const Pigment& pigment, const Vec3& point);

/// The side of a normal that the viewer sees.
Vec3 facing(const Vec3& normal, const Vec3& to_viewer);

// ---- Tasks 2.2 to 2.5: what the surface does with light --------------------------------------------------------------

/// Light that does not come from a light source: ambient and emission.
Radiance ambient(const Surface& surface, const Radiance& ambient_light);
/// Lambert's term for light of the given radiance from `to_light`; black when the light stands behind the surface.
Radiance diffuse(const Surface& surface, const Illumination& light);
/// POV-Ray's `phong`: a (r . l)^m around the mirror direction r.
Radiance phong(const Surface& surface, const Illumination& light);
/// POV-Ray's `specular`: a (n . h)^(1/roughness) around the half vector (Blinn 1977).
Radiance blinn(const Surface& surface, const Illumination& light);
/// The colour of a highlight: the light's, or towards the surface's when `metallic`.
Radiance highlight_color(const Surface& surface, const Illumination& light);

// ---- Tasks 2.6 to 2.8: what a light sends ----------------------------------------------------------------------------

/// 1 without fading; 2 / (1 + (distance / fade_distance)^fade_power) with it.
Real fading(const Light& light, Real distance);
/// 1 for a point light; for a spotlight or cylinder, how much of it goes to `point`.
Real cone_of_light(const Light& light, const Vec3& point);
Illumination illuminate(const Light& light, const Vec3& point);

// ---- Task 2.9: shadows -----------------------------------------------------------------------------------------------

/// True when something that casts shadows stands between the point and the light.
bool in_shadow(const Intersector& intersector, const Surface& surface, const Illumination& light);

/// True when some object with a shadow is met in the range: the any-hit query over all objects.
bool any_occluder(const Scene& scene, const Ray& ray, Interval range);

// ---- Task 2.10: the sum ----------------------------------------------------------------------------------------------

/// Ambient light and all light sources together.
Radiance direct_light(const Scene& scene, const Intersector& intersector, const Surface& surface);

}  // namespace rays
