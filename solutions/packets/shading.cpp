#include "packets/shading.h"

#include <cmath>

namespace rays::packets {
namespace {

/// As eight of `Illumination`.
struct Illuminations {
    Vec3s to_light;
    Reals distance;
    Radiances radiance;
    Mask are;  ///< something arrives
};

bool is_parallel(const Light& light) { return light.parallel || light.kind == Light::Kind::cylinder; }

Vec3 axis_of(const Light& light) {
    const Vec3 along = light.point_at - light.location;
    const Real length = glm::length(along);
    return length > 0 ? along / length : Vec3(0, 0, 1);
}

Reals fading(const Light& light, Mask lanes, Reals distance) {
    if (!(light.fade_power > 0) || !(light.fade_distance > Real(1e-10))) return Reals(1);
    const Reals relative = abs(distance) * Reals(1 / light.fade_distance);
    const Reals grown = light.fade_power == 2 ? relative * relative : power(lanes, relative, light.fade_power);
    return Reals(2) / (Reals(1) + grown);
}

Real one_minus_cos(Real angle) { return 2 * std::sin(angle / 2) * std::sin(angle / 2); }

Reals smooth_step(Reals s) { return (Reals(3) - Reals(2) * s) * s * s; }

/// Where a spotlight's part is computed from, as in step 2; a root takes the place of hypot, whose last bits are gone
/// once the result is a float.
Reals spot_profile(const Light& light, const Lamp& lamp, Mask lanes, Reals along, Reals from_axis) {
    const Reals distance = sqrt(along * along + from_axis * from_axis), one(1), zero(0.0);
    const Reals tight = light.tightness == 0 ? one : power(lanes, along / distance, light.tightness);
    const Reals here = from_axis * from_axis / (distance * (distance + along));
    if (lamp.full >= 1) return tight;
    const Reals to_end = Reals(lamp.nothing) - here;
    const Reals rim =
        select(here < Reals(lamp.nothing), tight * smooth_step(to_end / Reals(lamp.nothing - lamp.full)), zero);
    return select(here <= Reals(lamp.full), tight, rim);
}

/// Task 2.7. Cylinders are rare: they are asked point by point.
Reals cone_of_light(const Light& light, const Lamp& lamp, Mask lanes, const Vec3s& point) {
    if (light.kind == Light::Kind::point) return Reals(1);
    if (light.kind == Light::Kind::cylinder) {
        const Spread3 points(point);
        Spread cone(Reals(0.0));
        each_lane(lanes.bits(), [&](int i) { cone.lane[i] = rays::cone_of_light(light, points[i]); });
        return Reals::load(cone.lane);
    }
    const Vec3s axis(lamp.axis), from_light = point - Vec3s(light.location);
    const Reals along = dot(from_light, axis), zero(0.0);
    const Mask before = lanes & (along > zero);
    if (light.parallel) return select(before, Reals(1), zero);
    const Reals from_axis = length(from_light - along * axis);
    return select(before, spot_profile(light, lamp, before, along, from_axis), zero);
}

/// Where light number `light` is for each of the points.
Vec3s places_of(const Light& light, std::size_t number, const SampleRays* samples, const Surfaces& at) {
    if (!samples || samples->light.empty()) return Vec3s(light.location);
    const auto component = [&](std::size_t a) {
        const auto& column = samples->light[3 * number + a];
        const Number* const of = at.tree;
        return Reals(column[of[0]], column[of[1]], column[of[2]], column[of[3]], column[of[4]], column[of[5]],
                     column[of[6]], column[of[7]]);
    };
    return {component(0), component(1), component(2)};
}

/// `place` is where the light is; only a point of an area light is not where the scene has it.
Illuminations illuminate(const Light& light, const Lamp& lamp, const Vec3s& place, Mask lanes, const Vec3s& point) {
    Illuminations result;
    if (is_parallel(light)) {
        result.to_light = -lamp.axis;
        result.distance = dot(Vec3s(light.location) - point, result.to_light);
        result.are = lanes;
    } else {
        const Vec3s to_light = place - point;
        result.distance = length(to_light);
        result.to_light = (Reals(1) / result.distance) * to_light;
        result.are = lanes & (result.distance > Reals(0));
    }
    const Floats strength(fading(light, lanes, result.distance) * cone_of_light(light, lamp, lanes, point));
    result.radiance = strength * Radiances(light.color);
    return result;
}

/// Towards the surface's colour on metal, by the angle between normal and light: task 2.5.
Radiances highlight_color(const Surfaces& at, const Illuminations& light, Reals n_dot_l) {
    const float metallic = at.finish->metallic;
    if (!(metallic > 0)) return light.radiance;
    const Spread cosines(n_dot_l);
    alignas(32) float tints[kLanes] = {};
    each_lane(light.are.bits(), [&](int i) {
        const Real x = std::acos(std::clamp(cosines[i], Real(-1), Real(1))) / (kPi / 2);
        const Real fresnel = Real(0.014567225) / ((x - Real(1.12)) * (x - Real(1.12))) - Real(0.011612903);
        tints[i] = metallic * (1 - static_cast<float>(std::clamp(fresnel, Real(0), Real(1))));
    });
    const Radiances white(Floats(1), Floats(1), Floats(1));
    return light.radiance * (white + Floats::load(tints) * (at.color - white));
}

Radiances highlights(const Surfaces& at, const Illuminations& light, Reals n_dot_l) {
    const Finish& finish = *at.finish;
    const Reals zero(0);
    Floats phong(0.0f), blinn(0.0f);
    if (finish.phong > 0) {
        const Vec3s mirrored = Reals(2) * dot(at.normal, at.to_viewer) * at.normal - at.to_viewer;
        const Reals r_dot_l = dot(mirrored, light.to_light);
        const Mask shine = light.are & (r_dot_l > zero);
        if (shine.any())
            phong = Floats(select(shine, Reals(finish.phong) * power(shine, r_dot_l, finish.phong_size), zero));
    }
    if (finish.specular > 0) {
        const Vec3s between = light.to_light + at.to_viewer;
        const Reals size = length(between), n_dot_h = dot(at.normal, between) / size;
        const Mask shine = light.are & (size > zero) & (n_dot_h > zero);
        if (shine.any())
            blinn =
                Floats(select(shine, Reals(finish.specular) * power(shine, n_dot_h, 1 / Real(finish.roughness)), zero));
    }
    const Radiances color = highlight_color(at, light, n_dot_l);
    return phong * color + blinn * color;
}

/// Where a checker has its first colour; everywhere, where there is no checker.
Mask has_first_color(const Scene& scene, const Pigment& pigment, const Vec3s& point) {
    if (!pigment.checker_other) return Mask::of(kAllLanes);
    Vec3s local = point;
    if (pigment.transform != kNone) {
        const Transform& t = scene.transforms[pigment.transform];
        local = times(t.inverse_linear, point) + Vec3s(t.inverse_offset);
    }
    const Reals e(Real(1e-10)), cubes = floor(local.x + e) + floor(local.y + e) + floor(local.z + e);
    const Reals half = cubes * Reals(0.5);
    return floor(half) == half;
}

bool is_one_opaque_color(const Pigment& pigment) { return !pigment.checker_other && !lets_light_through(pigment); }

bool is_same(const std::uint32_t (&numbers)[kLanes]) {
    return std::all_of(numbers, numbers + kLanes, [&](std::uint32_t n) { return n == numbers[0]; });
}

Radiances colors_of(const Scene& scene, const std::uint32_t (&materials)[kLanes]) {
    alignas(32) float rgb[3][kLanes];
    for (int i = 0; i < kLanes; ++i)
        for (int c = 0; c < 3; ++c) rgb[c][i] = scene.materials[materials[i]].pigment.color.rgb[c];
    return {Floats::load(rgb[0]), Floats::load(rgb[1]), Floats::load(rgb[2])};
}

void set_pigment(const Scene& scene, const std::uint32_t (&materials)[kLanes], Surfaces& at) {
    const Pigment& pigment = scene.materials[materials[0]].pigment;
    if (is_one_opaque_color(pigment) && !is_same(materials)) {
        at.color = colors_of(scene, materials);
        return;
    }
    const Color& color = pigment.color;
    const Color& other = pigment.checker_other ? *pigment.checker_other : color;
    const Mask first = has_first_color(scene, pigment, at.point);
    at.color = select(first, Radiances(color.rgb), Radiances(other.rgb));
    if (!lets_light_through(pigment)) return;
    const Floats filter = select(first, Floats(color.filter), Floats(other.filter));
    const Floats transmit = select(first, Floats(color.transmit), Floats(other.transmit));
    // As surface_at of step 2 has it.
    const Floats filtered = scene.settings.filter_by_color ? filter * largest(at.color) : filter;
    at.opacity = Floats(1.0f) - filtered - transmit;
    at.clear = filter * at.color + Radiances(transmit, transmit, transmit);
}

}  // namespace

Reals power(Mask lanes, Reals x, double exponent) { return pow(select(lanes, x, Reals(1)), Reals(exponent)); }

Radiances absorption(const Interior& interior, Reals distance) {
    const Reals relative = distance * Reals(1 / interior.fade_distance);
    const Radiances left(interior.fade_color), lost(Radiance(1.0f) - interior.fade_color);
    if (interior.fade_power < 1000) {
        const Reals weaker = Reals(1) + power(Mask::of(kAllLanes), relative, interior.fade_power);
        return left + Floats(Reals(1) / weaker) * lost;
    }
    const auto through = [&](float of_light) { return Floats(exp(Reals(-(1.0f - of_light)) * relative)); };
    return {through(interior.fade_color[0]), through(interior.fade_color[1]), through(interior.fade_color[2])};
}

Lamp::Lamp(const Light& light)
    : axis(axis_of(light)), full(one_minus_cos(light.radius_rad)), nothing(one_minus_cos(light.falloff_rad)) {}

std::vector<std::uint32_t> look_alikes(const Scene& scene) {
    constexpr std::size_t kMostCompared = 16;  // a scene of a hundred thousand looks is not worth comparing all
    std::vector<std::uint32_t> alike(scene.materials.size()), looks;
    for (std::uint32_t m = 0; m < alike.size(); ++m) {
        const Material& material = scene.materials[m];
        const auto is_alike = [&](std::uint32_t look) {
            const Material& other = scene.materials[look];
            const bool plain = is_one_opaque_color(material.pigment) && is_one_opaque_color(other.pigment);
            return material.finish == other.finish && (plain || material.pigment == other.pigment);
        };
        const auto known = std::find_if(looks.rbegin(), looks.rend(), is_alike);
        alike[m] = known == looks.rend() ? m : *known;
        if (known == looks.rend() && looks.size() < kMostCompared) looks.push_back(m);
    }
    return alike;
}

Surfaces surfaces_at(const Scene& scene, Mask lanes, const Vec3s& point, const Vec3s& normal, const Vec3s& to_viewer,
                     const std::uint32_t (&materials)[kLanes]) {
    Surfaces at;
    at.are = lanes;
    at.point = point;
    at.normal = select(dot(normal, to_viewer) < Reals(0.0), -normal, normal);
    at.to_viewer = to_viewer;
    set_pigment(scene, materials, at);
    at.finish = &scene.materials[materials[0]].finish;
    return at;
}

Radiances Shadows::visibility(std::size_t light, const Surfaces& at, Mask lanes, const Vec3s& to_light, Reals distance,
                              const Inside& inside) {
    const Rays rays(at.point, to_light);
    const Span span{Reals(kShadowTolerance), distance - Reals(kShadowTolerance)};
    const Radiances all{Floats(1.0f), Floats(1.0f), Floats(1.0f)}, none;
    if (!world_.filtered_shadows)
        return select(intersector_.occluded(rays, lanes, span, at.object, suspects_[light]), none, all);
    // Who is opaque, and who meets nothing, is soon found out; but where the light is behind glass that was asked in
    // vain.
    const Obstacles met = is_behind_glass_[light] ? Obstacles{Mask::of(0), lanes & (span.near < span.far)}
                                                  : intersector_.obstacles(rays, lanes, span);
    const Radiances left = select(met.opaque, none, all);
    if (!met.clear.any()) return left;
    const Radiances through = filtered(rays, met.clear, span, inside);
    is_behind_glass_[light] = !(met.opaque | (met.clear - is_not_black(through))).any();
    return select(met.clear, through, left);
}

/// What is left of light after ways through media that take some; null: through none.
void absorb(const Interior* (&crossed)[kLanes], const Spread& ways, Radiance (&left)[kLanes]) {
    for (int first = 0; first < kLanes; ++first) {
        const Interior* interior = crossed[first];
        if (!interior) continue;
        const Radiances factors = absorption(*interior, Reals::load(ways.lane));
        alignas(32) float of[3][kLanes];
        factors.r.store(of[0]), factors.g.store(of[1]), factors.b.store(of[2]);
        for (int i = first; i < kLanes; ++i) {
            if (crossed[i] != interior) continue;
            for (int c = 0; c < 3; ++c) left[i][c] *= of[c][i];
            crossed[i] = nullptr;
        }
    }
}

/// Task 3.7: from hit to hit, in the media that each shadow ray is in.
Radiances Shadows::filtered(const Rays& rays, Mask open, Span span, const Inside& inside) const {
    const Scene& scene = world_.scene;
    Radiance left[kLanes];
    Inside media[kLanes];
    Real last_caster[kLanes] = {};
    Spread starts(span.near);
    each_lane(open.bits(), [&](int i) {
        left[i] = Radiance(1.0f);
        media[i] = inside;
    });
    while (open.any()) {
        const Hits hits = intersector_.nearest(rays, open, span, Wanted::places);
        unsigned going_on = hits.are;
        const Interior* crossed[kLanes] = {};
        Spread ways(Reals(0.0));
        each_lane(hits.are, [&](int i) {
            starts.lane[i] = hits.t[i];
            if (scene.objects[hits.object[i]].no_shadow) return;
            const Color color = pigment_at(scene, scene.materials[hits.material[i]].pigment, hits.point[i]);
            left[i] *= color.filter * color.rgb + Radiance(color.transmit);
            if (left[i].is_black()) {
                going_on &= ~(1u << i);
                return;
            }
            const Medium medium = medium_of(scene, hits.object[i]);
            if (media[i].leave(medium)) {
                const Interior* interior = interior_of(scene, medium);
                if (interior && interior->fade_power > 0 && interior->fade_distance > 0) crossed[i] = interior;
                ways.lane[i] = hits.t[i] - last_caster[i];
            } else {
                media[i].enter(medium);
            }
            last_caster[i] = hits.t[i];
            starts.lane[i] = hits.t[i] + kShadowTolerance;
        });
        absorb(crossed, ways, left);
        open = Mask::of(going_on);
        span.near = Reals::load(starts.lane);
    }
    alignas(32) float lanes[3][kLanes];
    for (int i = 0; i < kLanes; ++i)
        for (int c = 0; c < 3; ++c) lanes[c][i] = left[i][c];
    return {Floats::load(lanes[0]), Floats::load(lanes[1]), Floats::load(lanes[2])};
}

Radiances direct_light(const Scene& scene, const std::vector<Lamp>& lamps, Shadows& shadows, const SampleRays* samples,
                       const Surfaces& at, const Inside& inside) {
    const Finish& finish = *at.finish;
    Radiances sum = at.opacity * at.color * Radiances(finish.ambient * scene.settings.ambient_light + finish.emission);
    const bool scatters = finish.diffuse > 0 && is_not_zero(at.opacity).any();
    if (!scatters && !(finish.phong > 0) && !(finish.specular > 0)) return sum;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const Light& source = scene.lights[i];
        Illuminations light = illuminate(source, lamps[i], places_of(source, i, samples, at), at.are, at.point);
        const Reals n_dot_l = dot(at.normal, light.to_light);
        light.are = light.are & is_not_black(light.radiance) & (n_dot_l > Reals(0));
        if (!light.are.any()) continue;
        if (!source.shadowless) {
            light.radiance =
                light.radiance * shadows.visibility(i, at, light.are, light.to_light, light.distance, inside);
            light.are = light.are & is_not_black(light.radiance);
            if (!light.are.any()) continue;
        }
        const Reals falloff = finish.brilliance == 1 ? n_dot_l : power(light.are, n_dot_l, finish.brilliance);
        Radiances brings = (at.opacity * Floats(finish.diffuse) * Floats(falloff)) * at.color * light.radiance;
        sum = select(light.are, sum + brings, sum);
        if (!source.shadowless) sum = select(light.are, sum + highlights(at, light, n_dot_l), sum);
    }
    return sum;
}

}  // namespace rays::packets
