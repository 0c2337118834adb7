// Step 3, recursion: the tree of rays that mirrors and glass make.
#include "3_recursion/recursion.h"

#include <algorithm>
#include <cmath>

#include "core/unfinished.h"

namespace rays {

using glm::dot;

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

// ---- Task 3.1: mirrors ----------------------------------------------------------------------------------------------

Vec3 reflect(const Vec3& direction, const Vec3& normal) {
    // Task 3.1: d - 2 (d . n) n, normalised: errors of rounding would grow with every bounce.
    unfinished("3.1");
    return {};
}

// ---- Task 3.2: Snell's law ------------------------------------------------------------------------------------------

std::optional<Vec3> refract(const Vec3& direction, const Vec3& normal, Real relative_ior) {
    // Task 3.2: With eta = 1 / relative_ior and c = -d . n the direction is eta d + (eta c - sqrt(1 - eta^2 (1 - c^2))) n;
    // nothing when the root is of a negative number.
    unfinished("3.2");
    return {};
}

// ---- Task 3.3: Fresnel ----------------------------------------------------------------------------------------------

Real fresnel(Real cos_incident, Real relative_ior) {
    // Task 3.3: With n = relative_ior, c = cos_incident and g^2 = n^2 + c^2 - 1:
    // F = 1/2 ((g - c) / (g + c))^2 (1 + ((c (g + c) - 1) / (c (g - c) + 1))^2). A negative g^2 is total reflection.
    unfinished("3.3");
    return {};
}

Real schlick(Real cos_incident, Real relative_ior) {
    // Task 3.3: F0 + (1 - F0) (1 - c)^5 with F0 = ((n - 1) / (n + 1))^2. c is the cosine on the thinner side: the refracted
    // one when n < 1 (and 1 when there is none: total reflection).
    unfinished("3.3");
    return {};
}

// ---- Task 3.4: how much a finish reflects ---------------------------------------------------------------------------

Radiance reflectivity(const Surface& surface, Real relative_ior) {
    // Task 3.4: min + f (max - min), with f = fresnel(c) or (1 - c)^falloff, c = n . v. A metallic reflection is then
    // multiplied by 1 + metallic (1 - F) (color - 1), F as in the metallic highlights of task 2.5 but with the angle
    // between n and v.
    unfinished("3.4");
    return {};
}

// ---- Task 3.5: in and out of glass ----------------------------------------------------------------------------------

Real cross_border(const Scene& scene, Inside& inside, Medium medium) {
    // Task 3.5: Change `inside` by entering or leaving the medium, and return the index of the far side over that of the
    // near side, by POV-Ray's rule (see recursion.h). Outside of everything the index is 1.
    unfinished("3.5");
    return {};
}

Real fresnel_ior(const Scene& scene, const Inside& inside, Medium medium) {
    // Task 3.5: Outside of everything: the medium's index. Inside of this medium alone: its inverse. Inside of others:
    // entering, the medium's over the last one's; leaving, the last one's over the medium's.
    unfinished("3.5");
    return {};
}

// ---- Task 3.6: absorption in glass ----------------------------------------------------------------------------------

Radiance absorption(const Interior& interior, Real distance) {
    // Task 3.6: 1 when fade_distance is 0. Both laws lane by lane; fade_color is what would be left of white.
    unfinished("3.6");
    return {};
}

// ---- Task 3.7: shadows of glass -------------------------------------------------------------------------------------

Radiance FilteredShadows::of(const Surface& surface, const Illumination& light) const {
    // Task 3.7: Walk along the shadow ray from hit to hit. An object with no_shadow does nothing. Any other multiplies what
    // is left by `clear` of its surface and, if the shadow ray is in its medium and that fades (fade_power > 0), by
    // the absorption over the way from the last caster; then the shadow ray has left that medium, or entered it.
    // Go on kShadowTolerance behind it; stop when nothing is left, or kShadowTolerance before the light.
    unfinished("3.7");
    return {};
}

// ---- Tasks 3.8 to 3.10: the tree ------------------------------------------------------------------------------------

bool is_pruned(const GlobalSettings& settings, const Branch& branch) {
    // Task 3.8: Depth and contribution. adc_bailout 0 prunes nothing by contribution.
    unfinished("3.8");
    return {};
}

Radiance reflected_light(World& world, const Interaction& at, const Radiance& reflectivity) {
    // Task 3.9: Trace the mirror ray: one level deeper, in the same media, its weight multiplied by the largest lane of
    // reflectivity (without fresnel: by the largest lane of the finish's min and max). Each lane of what it brings
    // is raised to the finish's exponent (below 0 there is nothing to raise) before it is multiplied by the
    // reflectivity.
    unfinished("3.9");
    return {};
}

Transmitted transmitted_light(World& world, const Interaction& at, const Radiance& tint) {
    // Task 3.10: Cross the border and trace what is behind, its weight multiplied by the largest lane of tint. Where the
    // index does not change the ray goes straight on and is no level of its own. Where nothing can be refracted the
    // mirror ray takes its place, in the media of the ray that came. Light that came through the object's own
    // medium was absorbed on that way.
    unfinished("3.10");
    return {};
}

Radiance outgoing(World& world, const Interaction& at) {
    // Task 3.11: Direct light (with FilteredShadows where the world needs them), what comes through, what is mirrored. The
    // surface's tint is `clear`; with conserve_energy it is multiplied by 1 - reflectivity, and never by less than
    // nothing. Trace nothing through a surface whose tint is black (POV-Ray: whose grey 0.297 r + 0.589 g + 0.114 b
    // is not above adc_bailout: then its weight counts as pruned), and no mirror ray where nothing is reflected or
    // total reflection has taken all.
    unfinished("3.11");
    return {};
}

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

}  // namespace rays
