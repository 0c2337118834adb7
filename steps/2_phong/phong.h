// Step 2, Phong illumination and shadows: the contract. From a hit to the light that leaves it towards the viewer.
//
// All directions leave the surface and have unit length: `to_light`, `to_viewer`, and the normal, which is turned to
// the viewer's side. The formulas are POV-Ray's: no 1/pi, and no cosine on highlights (see the handout).
#pragma once

#include <span>

#include "core/intersector.h"
#include "core/radiance.h"
#include "core/scene.h"
#include "core/unfinished.h"

namespace rays {

/// A point of a surface, ready to be lit.
struct Surface {
    Vec3 point{0};
    Vec3 normal{0, 0, -1};            ///< unit, turned to the viewer's side
    Vec3 geometric_normal{0, 0, -1};  ///< unit, of the true surface, turned to the viewer's side
    Vec3 to_viewer{0, 0, -1};         ///< unit
    Radiance color{1.0f};             ///< of the pigment, here
    float opacity = 1;                ///< 1 - filter - transmit: how much of ambient and diffuse light is left
    Radiance clear{0.0f};             ///< color * filter + transmit: what is left of light that passes through (step 3)
    const Finish* finish = nullptr;   ///< never null
};

/// What one light sends to a point.
struct Illumination {
    Vec3 to_light{0, 1, 0};  ///< unit
    Real distance = 0;       ///< to the light's position; parallel light: to its plane, negative behind it
    Radiance radiance;       ///< after fading and the spot's cone; shadows not yet considered
};

/// What a hit is to a viewer in the direction `to_viewer` (unit): both normals turned to the viewer's side, the pigment
/// looked up. Interpolated normals are turned by their own side, as POV-Ray does: along silhouettes it matters.
Surface surface_at(const Scene& scene, const Hit& hit, const Vec3& to_viewer);

/// Shadow rays ignore what they meet nearer than this to either end, in scene units (POV-Ray's SMALL_TOLERANCE and
/// SHADOW_TOLERANCE). An absolute number: scenes should have features of at least ten times this size.
inline constexpr Real kShadowTolerance = Real(1e-3);

// ---- Task 2.1: colour ------------------------------------------------------------------------------------------------

/// The pigment's colour at a point in world space. Cubes with an odd floor(x + e) + floor(y + e) + floor(z + e) in
/// pattern space, e = 1e-10, have the other colour.
Color pigment_at(const Scene& scene, const Pigment& pigment, const Vec3& point);

/// The normal turned to the viewer's side: unchanged when normal . to_viewer >= 0, else its opposite.
Vec3 facing(const Vec3& normal, const Vec3& to_viewer);

// ---- Tasks 2.2 to 2.5: what the surface does with light --------------------------------------------------------------

/// Light that does not come from a light source: ambient and emission, both tinted by the surface.
Radiance ambient(const Surface& surface, const Radiance& ambient_light);
/// Lambert's term for light of the given radiance from `to_light`; black when the light stands behind the surface.
Radiance diffuse(const Surface& surface, const Illumination& light);
/// POV-Ray's `phong`: a (r . l)^m around the mirror direction r. Black when the light stands behind the surface.
Radiance phong(const Surface& surface, const Illumination& light);
/// POV-Ray's `specular`: a (n . h)^(1/roughness) around the half vector (Blinn 1977). Black when the light
/// stands behind the surface.
Radiance blinn(const Surface& surface, const Illumination& light);
/// The colour of a highlight: the light's, or towards the surface's when `metallic`.
Radiance highlight_color(const Surface& surface, const Illumination& light);

// ---- Tasks 2.6 to 2.8: what a light sends ----------------------------------------------------------------------------

/// 1 without fading; 2 / (1 + (|distance| / fade_distance)^fade_power) with it.
Real fading(const Light& light, Real distance);
/// 1 for a point light; for a spotlight or cylinder, how much of it goes to `point`. A spotlight made parallel lights
/// everything in front of its plane fully.
Real cone_of_light(const Light& light, const Vec3& point);
/// What the light sends to the point. A light at the very point sends nothing.
Illumination illuminate(const Light& light, const Vec3& point);

// ---- Task 2.9: shadows -----------------------------------------------------------------------------------------------

/// True when something that casts shadows stands between the point and the light. One query, along the unit vector
/// to_light, of the range (kShadowTolerance, distance - kShadowTolerance).
bool in_shadow(const Intersector& intersector, const Surface& surface, const Illumination& light);

/// True when some object with a shadow is met in the range: the any-hit query over all objects.
bool any_occluder(const Scene& scene, const Ray& ray, Interval range);

// ---- Task 2.10: the sum ----------------------------------------------------------------------------------------------

/// How much of a light gets to a surface, lane by lane: 1 all of it, 0 nothing. Step 2 knows opaque things only; step 3
/// brings another answer, which sees through glass. Asked once for each light that could show.
class Visibility {
public:
    virtual ~Visibility() = default;
    virtual Radiance of(const Surface& surface, const Illumination& light) const = 0;
};

/// Everything that casts a shadow blocks all light.
class OpaqueShadows final : public Visibility {
public:
    explicit OpaqueShadows(const Intersector& intersector) : intersector_(intersector) {}
    Radiance of(const Surface& surface, const Illumination& light) const override {
        return Radiance(in_shadow(intersector_, surface, light) ? 0.0f : 1.0f);
    }

private:
    const Intersector& intersector_;
};

/// Ambient light and the light of `lights` together: the scene's, or what stands for them (step 5). Asks for visibility
/// only where a light could show: at most once a light, never for shadowless ones, for lights behind the surface, or
/// for a finish without diffuse and highlights. POV-Ray's shadowless lights make no highlights.
Radiance direct_light(const Scene& scene, std::span<const Light> lights, const Visibility& visibility,
                      const Surface& surface);

}  // namespace rays
