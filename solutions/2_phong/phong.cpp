// Step 2, Phong illumination and shadows: what a surface sends to the viewer, light by light.
#include "2_phong/phong.h"

#include <algorithm>
#include <cmath>

#include "1_ray_casting/ray_casting.h"

namespace rays {

//> hidden
namespace {

/// Every formula of this file works on unit vectors: the dot product is the cosine of the angle.
Real cosine(const Vec3& a, const Vec3& b) { return glm::dot(a, b); }

/// The smooth step 3 s^2 - 2 s^3, s in [0, 1]: POV-Ray's "cubic spline" at the rim of a light.
Real smooth_step(Real s) { return (3 - 2 * s) * s * s; }

/// Part of a spotlight that goes to a place `along` its axis (positive) and `from_axis` beside it. Angles are compared
/// by 1 - cosine, in the forms 2 sin^2(angle / 2) and from_axis^2 / (distance (distance + along)): the same smooth step
/// of the cosine, but nothing cancels in beams as narrow as one likes.
Real spot_profile(const Light& light, Real along, Real from_axis) {
    const Real distance = std::hypot(along, from_axis);
    const Real tight = light.tightness == 0 ? Real(1) : std::pow(along / distance, light.tightness);
    const auto one_minus_cos = [](Real angle) { return 2 * std::sin(angle / 2) * std::sin(angle / 2); };
    const Real here = from_axis * from_axis / (distance * (distance + along));
    const Real full = one_minus_cos(light.radius_rad);
    if (full >= 1 || here <= full) return tight;  // POV-Ray: a radius of 90 degrees or more has no rim
    const Real end = one_minus_cos(light.falloff_rad);
    return here < end ? tight * smooth_step((end - here) / (end - full)) : Real(0);
}

/// Part of a cylinder light at this distance from its axis. Tightness and rim count from the outside in.
Real cylinder_profile(const Light& light, Real from_axis) {
    const Real radius = light.radius_rad;
    const Real falloff = light.falloff_rad;
    if (!(from_axis < falloff)) return 0;
    const Real inwards = 1 - from_axis / falloff;
    const Real tight = light.tightness == 0 ? Real(1) : std::pow(inwards, light.tightness);
    if (!(radius > 0) || from_axis <= radius) return tight;
    return tight * smooth_step((falloff - from_axis) / (falloff - radius));
}

/// From the light to what it points at, unit; any unit vector when these are the same point.
Vec3 axis_of(const Light& light) {
    const Vec3 along = light.point_at - light.location;
    const Real length = glm::length(along);
    return length > 0 ? along / length : Vec3(0, 0, 1);
}

bool is_parallel(const Light& light) { return light.parallel || light.kind == Light::Kind::cylinder; }

}  // namespace
//< hidden

// ---- Task 2.1: colour -----------------------------------------------------------------------------------------------

Color pigment_at(const Scene& scene, const Pigment& pigment, const Vec3& point) {
    //> 2.1 The pigment's colour. A checker is looked up in pattern space, and 1e-10 is added to every coordinate
    //>   before its floor, so that a surface at a whole number does not flicker between two cubes.
    if (!pigment.checker_other) return pigment.color;
    const Vec3 local = pigment.transform == kNone ? point : scene.transforms[pigment.transform].point_to_local(point);
    const Vec3 cube = glm::floor(local + Real(1e-10));
    const bool odd = std::fmod(cube.x + cube.y + cube.z, Real(2)) != 0;
    return odd ? *pigment.checker_other : pigment.color;
    //< 2.1
}

Vec3 facing(const Vec3& normal, const Vec3& to_viewer) {
    //> 2.1 The normal, or its opposite: whichever points to the viewer's side.
    return cosine(normal, to_viewer) < 0 ? -normal : normal;
    //< 2.1
}

//> given
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
//< given

// ---- Tasks 2.2 to 2.5: what the surface does with light -------------------------------------------------------------

Radiance ambient(const Surface& surface, const Radiance& ambient_light) {
    //> 2.2 Light without a source: the finish's ambient times the scene's ambient light, and its emission. The
    //>   surface's colour and opacity tint both.
    const Finish& finish = *surface.finish;
    return surface.opacity * surface.color * (finish.ambient * ambient_light + finish.emission);
    //< 2.2
}

Radiance diffuse(const Surface& surface, const Illumination& light) {
    //> 2.3 Lambert's law: the finish's diffuse times n . l, tinted by the surface's colour and opacity and by the
    //>   light. Nothing from behind. With a brilliance other than 1, n . l is raised to that power.
    const Real n_dot_l = cosine(surface.normal, light.to_light);
    if (!(n_dot_l > 0)) return Radiance(0.0f);
    const float brilliance = surface.finish->brilliance;
    const auto falloff = static_cast<float>(brilliance == 1 ? n_dot_l : std::pow(n_dot_l, Real(brilliance)));
    const float strength = surface.opacity * surface.finish->diffuse * falloff;
    return strength * surface.color * light.radiance;
    //< 2.3
}

Radiance phong(const Surface& surface, const Illumination& light) {
    //> 2.4 A highlight around the mirror direction r = 2 (n . v) n - v of the viewer: phong (r . l)^phong_size,
    //>   in the highlight's colour. Nothing from behind, nothing where r . l is not positive.
    const Finish& finish = *surface.finish;
    if (!(finish.phong > 0) || !(cosine(surface.normal, light.to_light) > 0)) return Radiance(0.0f);
    const Vec3 mirrored = 2 * cosine(surface.normal, surface.to_viewer) * surface.normal - surface.to_viewer;
    const Real r_dot_l = cosine(mirrored, light.to_light);
    if (!(r_dot_l > 0)) return Radiance(0.0f);
    const Real strength = finish.phong * std::pow(r_dot_l, Real(finish.phong_size));
    return static_cast<float>(strength) * highlight_color(surface, light);
    //< 2.4
}

Radiance blinn(const Surface& surface, const Illumination& light) {
    //> 2.5 A highlight around the half vector h = (l + v) / |l + v|: specular (n . h)^(1 / roughness), in the
    //>   highlight's colour. Nothing from behind. Mind l = -v.
    const Finish& finish = *surface.finish;
    if (!(finish.specular > 0) || !(cosine(surface.normal, light.to_light) > 0)) return Radiance(0.0f);
    const Vec3 between = light.to_light + surface.to_viewer;
    const Real length = glm::length(between);
    if (!(length > 0)) return Radiance(0.0f);
    const Real n_dot_h = cosine(surface.normal, between) / length;
    if (!(n_dot_h > 0)) return Radiance(0.0f);
    const Real strength = finish.specular * std::pow(n_dot_h, 1 / Real(finish.roughness));
    return static_cast<float>(strength) * highlight_color(surface, light);
    //< 2.5
}

Radiance highlight_color(const Surface& surface, const Illumination& light) {
    //> 2.5 The light's colour; on metal, moved towards the surface's by metallic (1 - F). F rises from 0 at the
    //>   normal to 1 at grazing: F = 0.014567225 / (x - 1.12)^2 - 0.011612903, kept between 0 and 1, with
    //>   x = angle(n, l) / 90 degrees.
    const float metallic = surface.finish->metallic;
    if (!(metallic > 0)) return light.radiance;
    const Real n_dot_l = std::clamp(cosine(surface.normal, light.to_light), Real(-1), Real(1));
    const Real x = std::acos(n_dot_l) / (kPi / 2);
    const Real fresnel = Real(0.014567225) / ((x - Real(1.12)) * (x - Real(1.12))) - Real(0.011612903);
    const float tint = metallic * (1 - static_cast<float>(std::clamp(fresnel, Real(0), Real(1))));
    return light.radiance * (Radiance(1.0f) + tint * (surface.color - Radiance(1.0f)));
    //< 2.5
}

// ---- Tasks 2.6 to 2.8: what a light sends ---------------------------------------------------------------------------

Real fading(const Light& light, Real distance) {
    //> 2.6 How light fades with distance: 2 / (1 + (distance / fade_distance)^fade_power) when both are positive;
    //>   without them it does not: 1.
    if (!(light.fade_power > 0) || !(light.fade_distance > Real(1e-10))) return 1;
    const Real relative = std::abs(distance) * (1 / light.fade_distance);
    const Real grown = light.fade_power == 2 ? relative * relative : std::pow(relative, light.fade_power);
    return 2 / (1 + grown);
    //< 2.6
}

Real cone_of_light(const Light& light, const Vec3& point) {
    //> 2.7 A spotlight is full within `radius` of its axis and ends at `falloff`, both angles; in between, a
    //>   smooth step 3 s^2 - 2 s^3 of the angle's cosine. All of it is multiplied by cosine^tightness. A cylinder
    //>   light does the same with distances from its axis; there, tightness is the exponent of
    //>   1 - distance / falloff. Neither lights what lies behind it.
    if (light.kind == Light::Kind::point) return 1;
    const Vec3 axis = axis_of(light);
    const Vec3 from_light = point - light.location;
    const Real along = glm::dot(from_light, axis);
    if (!(along > 0)) return 0;
    const Real from_axis = glm::length(from_light - along * axis);
    if (light.kind == Light::Kind::cylinder) return cylinder_profile(light, from_axis);
    return light.parallel ? Real(1) : spot_profile(light, along, from_axis);
    //< 2.7
}

Illumination illuminate(const Light& light, const Vec3& point) {
    //> 2.8 Direction and distance to the light, and its colour after fading and cone. From a parallel light (a
    //>   cylinder light is one) all rays come along its axis, and the distance is the one to the plane across it;
    //>   it may be negative. A light at the very point has no direction: it sends nothing.
    Illumination result;
    if (is_parallel(light)) {
        result.to_light = -axis_of(light);
        result.distance = glm::dot(light.location - point, result.to_light);
    } else {
        const Vec3 to_light = light.location - point;
        result.distance = glm::length(to_light);
        if (!(result.distance > 0)) return result;
        result.to_light = (1 / result.distance) * to_light;
    }
    result.radiance = static_cast<float>(fading(light, result.distance) * cone_of_light(light, point)) * light.color;
    return result;
    //< 2.8
}

// ---- Task 2.9: shadows ----------------------------------------------------------------------------------------------

bool in_shadow(const Intersector& intersector, const Surface& surface, const Illumination& light) {
    //> 2.9 Is the way from the point to the light blocked? What is nearer than kShadowTolerance to either end does
    //>   not count: neither the surface itself nor what lies beyond the light.
    const Ray ray{surface.point, light.to_light};
    return intersector.occluded(ray, {kShadowTolerance, light.distance - kShadowTolerance});
    //< 2.9
}

bool any_occluder(const Scene& scene, const Ray& ray, Interval range) {
    //> 2.9 Does any object that casts shadows have a root in the range? The first one found settles it.
    if (!(range.min < range.max)) return false;
    for (const Object& object : scene.objects)
        if (!object.no_shadow && intersect(scene, object, ray, range)) return true;
    return false;
    //< 2.9
}

// ---- Task 2.10: the sum ---------------------------------------------------------------------------------------------

Radiance direct_light(const Scene& scene, std::span<const Light> lights, const Visibility& visibility,
                      const Surface& surface) {
    //> 2.10 Ambient light once, and for every light diffuse, phong and blinn, its radiance first multiplied by its
    //>   visibility. A shadowless light is fully visible and makes no highlights. Do not ask for visibility where no
    //>   light would arrive anyway.
    const Finish& finish = *surface.finish;
    Radiance sum = ambient(surface, scene.settings.ambient_light);
    if (!(finish.diffuse > 0) && !(finish.phong > 0) && !(finish.specular > 0)) return sum;
    for (const Light& source : lights) {
        Illumination light = illuminate(source, surface.point);
        if (light.radiance.is_black() || !(cosine(surface.normal, light.to_light) > 0)) continue;
        if (!source.shadowless) light.radiance *= visibility.of(surface, light);
        if (light.radiance.is_black()) continue;
        sum += diffuse(surface, light);
        if (!source.shadowless) sum += phong(surface, light) + blinn(surface, light);
    }
    return sum;
    //< 2.10
}

}  // namespace rays
