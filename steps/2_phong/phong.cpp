// Step 2, Phong illumination and shadows: what a surface sends to the viewer, light by light.
#include "2_phong/phong.h"

#include <algorithm>
#include <cmath>

#include "1_ray_casting/ray_casting.h"

namespace rays {

// ---- Task 2.1: colour -----------------------------------------------------------------------------------------------

Color pigment_at(const Scene& scene, const Pigment& pigment, const Vec3& point) {
    // Task 2.1: The pigment's colour. A checker is looked up in pattern space, and 1e-10 is added to every coordinate
    // before its floor, so that a surface at a whole number does not flicker between two cubes.
    unfinished("2.1");
    return {};
}

Vec3 facing(const Vec3& normal, const Vec3& to_viewer) {
    // Task 2.1: The normal, or its opposite: whichever points to the viewer's side.
    unfinished("2.1");
    return {};
}

Surface surface_at(const Scene& scene, const Hit& hit, const Vec3& to_viewer) {
    const Material& material = scene.materials[hit.material];
    Surface surface;
    surface.point = hit.point;
    surface.geometric_normal = facing(hit.normal, to_viewer);
    surface.normal = facing(hit.shading_normal, to_viewer);
    surface.to_viewer = to_viewer;
    const Color color = pigment_at(scene, material.pigment, hit.point);
    surface.color = color.rgb;
    // Scenes from before POV-Ray 3.7 count what they filter by the brightest channel that it lets through.
    const float filtered = scene.settings.filter_by_color ? color.filter * color.rgb.largest() : color.filter;
    surface.opacity = 1 - filtered - color.transmit;
    // The fourth lane of an RGB scene stays empty: weights look at the largest lane.
    surface.clear = color.filter * color.rgb + Radiance(color.transmit, color.transmit, color.transmit);
    surface.finish = &material.finish;
    return surface;
}

// ---- Tasks 2.2 to 2.5: what the surface does with light -------------------------------------------------------------

Radiance ambient(const Surface& surface, const Radiance& ambient_light) {
    // Task 2.2: Light without a source: the finish's ambient times the scene's ambient light, and its emission. The
    // surface's colour and opacity tint both.
    unfinished("2.2");
    return {};
}

Radiance diffuse(const Surface& surface, const Illumination& light) {
    // Task 2.3: Lambert's law: the finish's diffuse times n . l, tinted by the surface's colour and opacity and by the
    // light. Nothing from behind. With a brilliance other than 1, n . l is raised to that power.
    unfinished("2.3");
    return {};
}

Radiance phong(const Surface& surface, const Illumination& light) {
    // Task 2.4: A highlight around the mirror direction r = 2 (n . v) n - v of the viewer: phong (r . l)^phong_size,
    // in the highlight's colour. Nothing from behind, nothing where r . l is not positive.
    unfinished("2.4");
    return {};
}

Radiance blinn(const Surface& surface, const Illumination& light) {
    // Task 2.5: A highlight around the half vector h = (l + v) / |l + v|: specular (n . h)^(1 / roughness), in the
    // highlight's colour. Nothing from behind. Mind l = -v.
    unfinished("2.5");
    return {};
}

Radiance highlight_color(const Surface& surface, const Illumination& light) {
    // Task 2.5: The light's colour; on metal, moved towards the surface's by metallic (1 - F). F rises from 0 at the
    // normal to 1 at grazing: F = 0.014567225 / (x - 1.12)^2 - 0.011612903, kept between 0 and 1, with
    // x = angle(n, l) / 90 degrees.
    unfinished("2.5");
    return {};
}

// ---- Tasks 2.6 to 2.8: what a light sends ---------------------------------------------------------------------------

Real fading(const Light& light, Real distance) {
    // Task 2.6: How light fades with distance: 2 / (1 + (distance / fade_distance)^fade_power) when both are positive;
    // without them it does not: 1.
    unfinished("2.6");
    return {};
}

Real cone_of_light(const Light& light, const Vec3& point) {
    // Task 2.7: A spotlight is full within `radius` of its axis and ends at `falloff`, both angles; in between, a
    // smooth step 3 s^2 - 2 s^3 of the angle's cosine. All of it is multiplied by cosine^tightness. A cylinder
    // light does the same with distances from its axis; there, tightness is the exponent of
    // 1 - distance / falloff. Neither lights what lies behind it.
    unfinished("2.7");
    return {};
}

Illumination illuminate(const Light& light, const Vec3& point) {
    // Task 2.8: Direction and distance to the light, and its colour after fading and cone. From a parallel light (a
    // cylinder light is one) all rays come along its axis, and the distance is the one to the plane across it;
    // it may be negative. A light at the very point has no direction: it sends nothing.
    unfinished("2.8");
    return {};
}

// ---- Task 2.9: shadows ----------------------------------------------------------------------------------------------

bool in_shadow(const Intersector& intersector, const Surface& surface, const Illumination& light) {
    // Task 2.9: Is the way from the point to the light blocked? What is nearer than kShadowTolerance to either end does
    // not count: neither the surface itself nor what lies beyond the light.
    unfinished("2.9");
    return {};
}

bool any_occluder(const Scene& scene, const Ray& ray, Interval range) {
    // Task 2.9: Does any object that casts shadows have a root in the range? The first one found settles it.
    unfinished("2.9");
    return {};
}

// ---- Task 2.10: the sum ---------------------------------------------------------------------------------------------

Radiance direct_light(const Scene& scene, std::span<const Light> lights, const Visibility& visibility,
                      const Surface& surface) {
    // Task 2.10: Ambient light once, and for every light diffuse, phong and blinn, its radiance first multiplied by its
    // visibility. A shadowless light is fully visible and makes no highlights. Do not ask for visibility where no
    // light would arrive anyway.
    unfinished("2.10");
    return {};
}

}  // namespace rays
