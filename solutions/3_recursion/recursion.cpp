// Step 3, recursion: the tree of rays that mirrors and glass make.
#include "3_recursion/recursion.h"

#include <algorithm>
#include <cmath>

#include "core/unfinished.h"

namespace rays {

using glm::dot;

//> given
bool Inside::contains(Medium medium) const {
    return std::find(media_.begin(), media_.begin() + count_, medium) != media_.begin() + count_;
}

void Inside::enter(Medium medium) {
    if (count_ < media_.size()) media_[count_++] = medium;
}

bool Inside::leave(Medium medium) {
    const auto end = media_.begin() + count_;
    const auto found = std::find(media_.begin(), end, medium);
    if (found == end) return false;
    std::copy(found + 1, end, found);
    --count_;
    return true;
}

World make_world(const Scene& scene, const Intersector& intersector) {
    const auto clear = [&](const Object& object) { return lets_light_through(scene, object); };
    const auto clear_caster = [&](const Object& object) { return !object.no_shadow && clear(object); };
    const auto any = [&](const auto& what) { return std::any_of(scene.objects.begin(), scene.objects.end(), what); };
    return {scene, intersector, scene.lights, nullptr, any(clear), scene.settings.filtered_shadows && any(clear_caster)};
}
//< given

// ---- Task 3.1: mirrors ----------------------------------------------------------------------------------------------

Vec3 reflect(const Vec3& direction, const Vec3& normal) {
    //> 3.1 d - 2 (d . n) n, normalised: errors of rounding would grow with every bounce.
    return unit(direction - 2 * dot(direction, normal) * normal);
    //< 3.1
}

// ---- Task 3.2: Snell's law ------------------------------------------------------------------------------------------

std::optional<Vec3> refract(const Vec3& direction, const Vec3& normal, Real relative_ior) {
    //> 3.2 With eta = 1 / relative_ior and c = -d . n the direction is eta d + (eta c - sqrt(1 - eta^2 (1 - c^2))) n;
    //>   nothing when the root is of a negative number.
    // Heckbert, "Writing a Ray Tracer", in Glassner (ed.), An Introduction to Ray Tracing, 1989.
    const Real eta = 1 / relative_ior;
    const Real cos_incident = -dot(direction, normal);
    // 1 - eta^2 (1 - c^2), in a form that keeps c^2 whole where eta is 1, however grazing.
    const Real cos2 = (1 - eta) * (1 + eta) + eta * eta * cos_incident * cos_incident;
    if (!(cos2 >= 0)) return std::nullopt;
    return unit(eta * direction + (eta * cos_incident - std::sqrt(cos2)) * normal);
    //< 3.2
}

// ---- Task 3.3: Fresnel ----------------------------------------------------------------------------------------------

Real fresnel(Real cos_incident, Real relative_ior) {
    //> 3.3 With n = relative_ior, c = cos_incident and g^2 = n^2 + c^2 - 1:
    //>   F = 1/2 ((g - c) / (g + c))^2 (1 + ((c (g + c) - 1) / (c (g - c) + 1))^2). A negative g^2 is total reflection.
    const Real c = cos_incident;
    const Real g2 = (relative_ior - 1) * (relative_ior + 1) + c * c;
    if (!(g2 > 0)) return 1;
    const Real g = std::sqrt(g2);
    // With one division for both quotients, s / r and q / p.
    const Real s = g - c, r = g + c, q = c * r - 1, p = c * s + 1;
    const Real over_both = s / (r * p);
    return std::clamp(Real(0.5) * over_both * over_both * (p * p + q * q), Real(0), Real(1));
    //< 3.3
}

Real schlick(Real cos_incident, Real relative_ior) {
    //> 3.3 F0 + (1 - F0) (1 - c)^5 with F0 = ((n - 1) / (n + 1))^2. c is the cosine on the thinner side: the refracted
    //>   one when n < 1 (and 1 when there is none: total reflection).
    const Real n = relative_ior;
    Real c = cos_incident;
    if (n < 1) {
        const Real cos2 = 1 - (1 - c * c) / (n * n);
        if (!(cos2 > 0)) return 1;
        c = std::sqrt(cos2);
    }
    const Real f0 = (n - 1) * (n - 1) / ((n + 1) * (n + 1));
    const Real m = 1 - c;
    return f0 + (1 - f0) * m * m * m * m * m;
    //< 3.3
}

// ---- Task 3.4: how much a finish reflects ---------------------------------------------------------------------------

Radiance reflectivity(const Surface& surface, Real relative_ior) {
    //> 3.4 min + f (max - min), with f = fresnel(c) or (1 - c)^falloff, c = n . v. A metallic reflection is then
    //>   multiplied by 1 + metallic (1 - F) (color - 1), F as in the metallic highlights of task 2.5 but with the angle
    //>   between n and v.
    const Reflection& r = surface.finish->reflection;
    if (r.max.is_black() && r.min.is_black()) return {};
    const Real c = std::clamp(dot(surface.normal, surface.to_viewer), Real(0), Real(1));
    const Real f = r.fresnel ? fresnel(c, relative_ior) : r.falloff == 1 ? 1 - c : std::pow(1 - c, Real(r.falloff));
    Radiance share = static_cast<float>(f) * r.max + static_cast<float>(1 - f) * r.min;
    if (r.metallic != 0) {
        const Real x = std::acos(c) / (kPi / 2) - Real(1.12);
        const Real grazing = std::clamp(Real(0.014567225) / (x * x) - Real(0.011612903), Real(0), Real(1));
        share *= Radiance(1.0f) + r.metallic * static_cast<float>(1 - grazing) * (surface.color - Radiance(1.0f));
    }
    return share;
    //< 3.4
}

// ---- Task 3.5: in and out of glass ----------------------------------------------------------------------------------

Real cross_border(const Scene& scene, Inside& inside, Medium medium) {
    //> 3.5 Change `inside` by entering or leaving the medium, and return the index of the far side over that of the
    //>   near side, by POV-Ray's rule (see recursion.h). Outside of everything the index is 1.
    const auto around = [&] { return inside.empty() ? Real(1) : index_of_refraction(scene, inside.last()); };
    const bool leaves_the_last = !inside.empty() && inside.last() == medium;
    const Real before = around();
    if (inside.leave(medium)) return leaves_the_last ? around() / before : Real(1);
    inside.enter(medium);
    return index_of_refraction(scene, medium) / before;
    //< 3.5
}

Real fresnel_ior(const Scene& scene, const Inside& inside, Medium medium) {
    //> 3.5 Outside of everything: the medium's index. Inside of this medium alone: its inverse. Inside of others:
    //>   entering, the medium's over the last one's; leaving, the last one's over the medium's.
    const Real own = index_of_refraction(scene, medium);
    if (inside.empty()) return own;
    const Real last = index_of_refraction(scene, inside.last());
    if (!inside.contains(medium)) return own / last;
    return inside.size() == 1 ? 1 / own : last / own;
    //< 3.5
}

// ---- Task 3.6: absorption in glass ----------------------------------------------------------------------------------

Radiance absorption(const Interior& interior, Real distance) {
    //> 3.6 1 when fade_distance is 0. Both laws lane by lane; fade_color is what would be left of white.
    if (!(interior.fade_distance > 0)) return Radiance(1.0f);
    const Real relative = distance * (1 / interior.fade_distance);
    const Radiance lost = Radiance(1.0f) - interior.fade_color;
    Radiance left;
    if (interior.fade_power >= 1000) {
        for (int i = 0; i < 4; ++i) left[i] = static_cast<float>(std::exp(-lost[i] * relative));
    } else {
        const Real weaker = 1 + std::pow(relative, Real(interior.fade_power));
        left = interior.fade_color + static_cast<float>(1 / weaker) * lost;
    }
    return left;
    //< 3.6
}

// ---- Task 3.7: shadows of glass -------------------------------------------------------------------------------------

Radiance FilteredShadows::of(const Surface& surface, const Illumination& light) const {
    //> 3.7 Walk along the shadow ray from hit to hit. An object with no_shadow does nothing. Any other multiplies what
    //>   is left by `clear` of its surface and, if the shadow ray is in its medium and that fades (fade_power > 0), by
    //>   the absorption over the way from the last caster; then the shadow ray has left that medium, or entered it.
    //>   Go on kShadowTolerance behind it; stop when nothing is left, or kShadowTolerance before the light.
    const Scene& scene = world_.scene;
    const Ray ray{surface.point, light.to_light};
    Interval range{kShadowTolerance, light.distance - kShadowTolerance};
    Radiance left(1.0f);
    Inside inside = inside_;
    Real last_caster = 0;
    while (const auto hit = world_.intersector.nearest(ray, range)) {
        range.min = hit->t;
        if (scene.objects[hit->object].no_shadow) continue;
        const Color color = pigment_at(scene, scene.materials[hit->material].pigment, hit->point);
        left *= color.filter * color.rgb + Radiance(color.transmit);
        if (left.is_black()) break;
        const Medium medium = medium_of(scene, hit->object);
        if (inside.leave(medium)) {
            const Interior* interior = interior_of(scene, medium);
            if (interior && interior->fade_power > 0) left *= absorption(*interior, hit->t - last_caster);
        } else {
            inside.enter(medium);
        }
        last_caster = hit->t;
        range.min = hit->t + kShadowTolerance;
    }
    return left;
    //< 3.7
}

// ---- Tasks 3.8 to 3.10: the tree ------------------------------------------------------------------------------------

bool is_pruned(const GlobalSettings& settings, const Branch& branch) {
    //> 3.8 Depth and contribution. adc_bailout 0 prunes nothing by contribution.
    return branch.level >= settings.max_trace_level || branch.weight < settings.adc_bailout;
    //< 3.8
}

//> hidden
namespace {

/// A branch that starts at a hit. A straight one above does not count as a level.
Branch branch_from(const Interaction& at, const char* kind, const Vec3& direction, float weight) {
    Branch branch;
    branch.ray = {at.surface.point, direction};
    branch.kind = kind;
    branch.level = at.from.level + (at.from.straight ? 0 : 1);
    branch.weight = weight;
    branch.inside = at.from.inside;
    return branch;
}

/// POV-Ray's weight of a mirror ray: without fresnel, the larger end of the finish's range.
float weight_of_mirror(const Reflection& reflection, const Radiance& reflectivity) {
    return reflection.fresnel ? reflectivity.largest() : std::max(reflection.max.largest(), reflection.min.largest());
}

}  // namespace
//< hidden

Radiance reflected_light(World& world, const Interaction& at, const Radiance& reflectivity) {
    //> 3.9 Trace the mirror ray: one level deeper, in the same media, its weight multiplied by the largest lane of
    //>   reflectivity (without fresnel: by the largest lane of the finish's min and max). Each lane of what it brings
    //>   is raised to the finish's exponent (below 0 there is nothing to raise) before it is multiplied by the
    //>   reflectivity.
    const Reflection& finish = at.surface.finish->reflection;
    const Vec3 direction = reflect(at.from.ray.direction, at.surface.normal);
    const float weight = at.from.weight * weight_of_mirror(finish, reflectivity);
    Radiance brought = trace(world, branch_from(at, "reflected", direction, weight));
    if (finish.exponent != 1)
        for (int i = 0; i < 4; ++i) brought[i] = std::pow(std::max(0.0f, brought[i]), finish.exponent);
    return reflectivity * brought;
    //< 3.9
}

Transmitted transmitted_light(World& world, const Interaction& at, const Radiance& tint) {
    //> 3.10 Cross the border and trace what is behind, its weight multiplied by the largest lane of tint. Where the
    //>   index does not change the ray goes straight on and is no level of its own. Where nothing can be refracted the
    //>   mirror ray takes its place, in the media of the ray that came. Light that came through the object's own
    //>   medium was absorbed on that way.
    Inside beyond = at.from.inside;
    const Real relative_ior = cross_border(world.scene, beyond, at.medium);
    const Vec3& direction = at.from.ray.direction;
    Branch branch = branch_from(at, "transmitted", direction, at.from.weight * tint.largest());
    branch.straight = std::abs(relative_ior - 1) < Real(1e-10);
    const auto bent = branch.straight ? direction : refract(direction, at.surface.normal, relative_ior);
    if (!bent) {
        branch.kind = "reflected";
        branch.ray.direction = reflect(direction, at.surface.normal);
    } else {
        if (!branch.straight) branch.kind = "refracted";
        branch.ray.direction = *bent;
        branch.inside = beyond;
    }
    Radiance brought = trace(world, branch);
    if (const Interior* interior = interior_of(world.scene, at.medium); interior && at.from.inside.contains(at.medium))
        brought *= absorption(*interior, at.distance);
    return bent ? Transmitted{tint * brought, false} : Transmitted{brought, true};
    //< 3.10
}

Radiance outgoing(World& world, const Interaction& at) {
    //> 3.11 Direct light (with FilteredShadows where the world needs them), what comes through, what is mirrored. The
    //>   surface's tint is `clear`; with conserve_energy it is multiplied by 1 - reflectivity, and never by less than
    //>   nothing. Trace nothing through a surface whose tint is black (POV-Ray: whose grey 0.297 r + 0.589 g + 0.114 b
    //>   is not above adc_bailout: then its weight counts as pruned), and no mirror ray where nothing is reflected or
    //>   total reflection has taken all.
    const Surface& surface = at.surface;
    const Finish& finish = *surface.finish;
    Radiance sum = world.filtered_shadows
                       ? direct_light(world.scene, world.lights, FilteredShadows(world, at.from.inside), surface)
                       : direct_light(world.scene, world.lights, OpaqueShadows(world.intersector), surface);
    const Real ior = finish.reflection.fresnel ? fresnel_ior(world.scene, at.from.inside, at.medium) : Real(1);
    const Radiance mirror = reflectivity(surface, ior);
    Radiance tint = surface.clear;
    if (finish.conserve_energy)
        for (int i = 0; i < 4; ++i) tint[i] *= std::min(1.0f, 1 - mirror[i]);
    const float grey = std::abs(0.297f * tint[0] + 0.589f * tint[1] + 0.114f * tint[2]);
    bool mirrors = !mirror.is_black();
    if (grey > world.scene.settings.adc_bailout) {
        const Transmitted through = transmitted_light(world, at, tint);
        sum += through.radiance;
        mirrors &= !through.total_reflection;
    } else {
        world.pruned += at.from.weight * std::max(0.0f, tint.largest());
    }
    return mirrors ? sum + reflected_light(world, at, mirror) : sum;
    //< 3.11
}

//> given
Radiance trace(World& world, const Branch& branch) {
    if (world.above >= kMostAbove || is_pruned(world.scene.settings, branch)) {
        world.pruned += branch.weight;
        if (query_log) [[unlikely]]
            query_log->pruned(branch.kind, branch.ray, branch.weight);
        return {};
    }
    const LoggedRay log(branch.kind, branch.weight);
    const auto hit = world.intersector.nearest(branch.ray, {kNearest, kFarthest});
    if (!hit) return log.brings(world.scene.background);
    Surface surface = surface_at(world.scene, *hit, -branch.ray.direction);
    if (world.roughness) [[unlikely]]
        world.roughness->tilt(surface, world.above);
    ++world.above;
    const Radiance brought = outgoing(world, {branch, hit->t, surface, medium_of(world.scene, hit->object)});
    --world.above;
    return log.brings(brought);
}
//< given

}  // namespace rays
