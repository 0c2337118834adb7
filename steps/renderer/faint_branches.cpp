// Branches of the ray tree that nobody could see are not traced: a bound on what a branch brings, from the scene alone.
#include <algorithm>
#include <cmath>

#include "renderer/needs.h"

namespace rays {
namespace {

/// The smallest number that a half float can hold: what is less changes no picture.
constexpr double kFinestStep = 0x1p-24;
/// Of blue's part in the grey that decides whether a tint is traced at all (task 3.11).
constexpr double kLeastGrey = 0.114;

double largest(const Radiance& c) {
    return std::max({std::abs(double(c[0])), std::abs(double(c[1])), std::abs(double(c[2])), std::abs(double(c[3]))});
}
bool is_grey(const Radiance& c) { return c[0] == c[1] && c[1] == c[2]; }

/// The largest lane of what comes through.
double clear_of(const Color& c) { return double(c.filter) * largest(c.rgb) + double(c.transmit); }
/// Filter and transmit are floats: 0.9 and 0.1 may make a little more than 1.
constexpr double kShareOfAll = 1 + 1e-6;

bool is_negative(const Radiance& c) { return c[0] < 0 || c[1] < 0 || c[2] < 0; }

/// Has all that this makes of light a bound, and does the weight of a branch tell of it? Not where exponents make much
/// of little or cosines have negative powers; nor where a lane is negative: the largest lane, POV-Ray's weight, may
/// then be 0. 1 - reflectivity is negative where a mirror exceeds 1.
bool weights_tell(const Material& material) {
    const Finish& finish = material.finish;
    const Reflection& r = finish.reflection;
    if (r.exponent != 1 || !(r.falloff >= 0) || !(finish.phong_size >= 0)) return false;
    if (is_negative(r.min) || is_negative(r.max) || !(r.metallic >= 0 && r.metallic <= 1)) return false;
    const auto tells = [&](const Color& c) {
        return c.filter >= 0 && c.transmit >= 0 && !is_negative(c.rgb) && clear_of(c) <= kShareOfAll;
    };
    const Pigment& pigment = material.pigment;
    if (!tells(pigment.color) || (pigment.checker_other && !tells(*pigment.checker_other))) return false;
    const bool exceeds = std::max(largest(r.min), largest(r.max)) > 1 || r.metallic > 0;
    return !(exceeds && finish.conserve_energy && lets_light_through(pigment));
}
bool is_bounded(const Light& light) { return light.tightness >= 0; }
/// Glass that fades to more than white makes light.
bool is_bounded(const Interior& interior) {
    return !(interior.fade_distance > 0) || (!is_negative(interior.fade_color) && largest(interior.fade_color) <= 1);
}

/// The most that a surface can make of light, over all lanes, places and directions.
struct Most {
    double sends = 0;      ///< by itself, unit: radiance
    double passes = 0;     ///< of the radiance that its mirror ray and the ray behind it bring
    double outweighs = 1;  ///< what a branch passes over what its weight says
    double over_grey = 1;  ///< of a tint, its largest lane over its grey
};

/// Sum over the lights of what reaches a point, unit: radiance of a white surface. Fading doubles light at most.
double light_at_most(const Scene& scene) {
    double sum = 0;
    for (const Light& light : scene.lights) sum += (light.fade_power > 0 ? 2 : 1) * largest(light.color);
    return sum;
}

/// The largest factor of 1 + metallic (1 - F) (color - 1), lane by lane, with F from 0 to 1.
double metal_at_most(float metallic, double pigment) {
    return metallic >= 0 && metallic <= 1 ? (metallic > 0 ? std::max(1.0, pigment) : 1.0)
                                          : 1 + std::abs(double(metallic)) * (1 + pigment);
}

/// Of one of a pigment's colours.
Most most_of(const Scene& scene, const Finish& finish, const Color& color, double light, bool refracts) {
    const double pigment = largest(color.rgb);
    const double clear = clear_of(color);
    // Before version 3.7 the filter counts by its colour (step 2's surface_at).
    const double opacity = std::max(std::abs(1 - double(color.filter) - double(color.transmit)), std::abs(1 - clear));
    const Reflection& r = finish.reflection;
    const double metal = metal_at_most(r.metallic, pigment);
    const double mirrored = std::max(largest(r.min), largest(r.max)) * metal;

    Most most;
    const double ambient = largest(finish.ambient) * largest(scene.settings.ambient_light) + largest(finish.emission);
    const double highlights = std::abs(double(finish.phong)) + std::abs(double(finish.specular));
    most.sends = opacity * pigment * (ambient + std::abs(double(finish.diffuse)) * light) +
                 highlights * metal_at_most(finish.metallic, pigment) * light;
    most.passes = finish.conserve_energy ? std::max(clear, clear + mirrored * (1 - clear)) : clear + mirrored;
    most.outweighs = metal;  // a mirror's weight is without the metal's tint
    if (clear > 0 && refracts) {
        // Total reflection passes all, whatever the tint; with fresnel and conserve_energy it has no tint left.
        const double tint = finish.conserve_energy && !r.fresnel ? clear * (1 - mirrored) : clear;
        most.passes = std::max(most.passes, 1.0);
        most.outweighs = std::max(most.outweighs, tint > 0 ? 1 / tint : kInfinity);
    }
    const bool grey = (color.filter == 0 || is_grey(color.rgb)) && is_grey(r.min) && is_grey(r.max) && r.metallic == 0;
    if (clear > 0 && !grey) most.over_grey = 1 / kLeastGrey;
    return most;
}

}  // namespace

double faintest_weight(const Scene& scene) {
    const auto bounded = [](const auto& things) {
        return std::all_of(things.begin(), things.end(), [](const auto& thing) { return is_bounded(thing); });
    };
    if (!bounded(scene.lights) || !bounded(scene.interiors)) return 0;
    const double light = light_at_most(scene);
    const bool refracts =
        std::any_of(scene.interiors.begin(), scene.interiors.end(), [](const Interior& i) { return i.ior != 1; });
    Most ends, goes_on;  // of surfaces where a branch ends, and of those where it may go on
    for (const Material& material : scene.materials) {
        if (!weights_tell(material)) return 0;
        const Pigment& pigment = material.pigment;
        for (const Color* color : {&pigment.color, pigment.checker_other ? &*pigment.checker_other : &pigment.color}) {
            const Most most = most_of(scene, material.finish, *color, light, refracts);
            Most& of = most.passes > 0 ? goes_on : ends;
            of.sends = std::max(of.sends, most.sends);
            of.passes = std::max(of.passes, most.passes);
            of.outweighs = std::max(of.outweighs, most.outweighs);
            of.over_grey = std::max(of.over_grey, most.over_grey);
        }
    }
    if (goes_on.passes == 0) return 0;  // nothing to leave out
    const double at_ends = std::max(largest(scene.background), ends.sends);
    double brings = at_ends, outweighs = goes_on.over_grey;
    for (int level = 0; level < scene.settings.max_trace_level; ++level) {
        brings = std::max(at_ends, goes_on.sends + goes_on.passes * brings);
        outweighs *= goes_on.outweighs;
    }
    const double weight = kFinestStep / (brings * outweighs);
    return weight > 0 && weight < 1 ? weight : 0;
}

void drop_faint_branches(Scene& scene) {
    if (!scene.varying.empty()) return;
    scene.settings.adc_bailout = std::max(scene.settings.adc_bailout, static_cast<float>(faintest_weight(scene)));
}

}  // namespace rays
