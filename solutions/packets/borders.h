// Step 3's formulas for what surfaces do with rays, for eight rays of a batch: the same order of operations, the same
// bits.
#pragma once

#include <algorithm>
#include <cmath>

#include "3_recursion/recursion.h"
#include "packets/shading.h"

namespace rays::packets {

/// Task 3.1.
inline Vec3s reflected(Mask lanes, const Vec3s& d, const Vec3s& n) {
    return unit(lanes, d - (Reals(2) * dot(d, n)) * n);
}

/// Directions behind a surface, for the rays of `are`: task 3.2. The index is not 1.
struct Refracted {
    Mask are;
    Vec3s direction;
};
inline Refracted refracted(Mask lanes, const Vec3s& d, const Vec3s& n, Real relative_ior) {
    const Real eta = 1 / relative_ior;
    const Reals cos_incident = -dot(d, n);
    const Reals cos2 = Reals((1 - eta) * (1 + eta)) + Reals(eta * eta) * cos_incident * cos_incident;
    const Mask are = cos2 >= Reals(0);
    return {are, unit(lanes & are, Reals(eta) * d + (Reals(eta) * cos_incident - sqrt(cos2)) * n)};
}

/// 1 + metallic (1 - F) (color - 1) by the cosine between normal and viewer.
inline Radiances metal_tint(const Surfaces& at, Reals cosine, float metallic) {
    const Spread cosines(cosine);
    alignas(32) float tints[kLanes] = {};
    each_lane(at.are.bits(), [&](int i) {
        const Real x = std::acos(cosines[i]) / (kPi / 2) - Real(1.12);
        const Real grazing = std::clamp(Real(0.014567225) / (x * x) - Real(0.011612903), Real(0), Real(1));
        tints[i] = metallic * static_cast<float>(1 - grazing);
    });
    const Radiances white(Floats(1.0f), Floats(1.0f), Floats(1.0f));
    return white + Floats::load(tints) * (at.color - white);
}

/// Task 3.3.
inline Reals fresnel(Reals c, Reals relative_ior) {
    const Reals zero(0.0), one(1);
    const Reals g2 = (relative_ior - one) * (relative_ior + one) + c * c;
    const Reals g = sqrt(g2);
    const Reals s = g - c, r = g + c, q = c * r - one, p = c * s + one, over_both = s / (r * p);
    const Reals f = Reals(0.5) * over_both * over_both * (p * p + q * q);
    return select(g2 > zero, select(f < zero, zero, select(f > one, one, f)), one);
}

/// How much a finish mirrors: task 3.4. iors() is asked where Fresnel's formulas need it.
template <class Iors>
Radiances reflectivity(const Surfaces& at, const Iors& iors) {
    const Reflection& r = at.finish->reflection;
    const Reals cosine = dot(at.normal, at.to_viewer), zero(0.0), one(1);
    const Reals c = select(cosine < zero, zero, select(cosine > one, one, cosine));
    Reals f = one - c;
    if (r.fresnel) {
        f = fresnel(c, iors());
    } else if (r.falloff != 1) {
        const Mask positive = f > zero;
        f = select(positive, power(positive, f, r.falloff), Reals(std::pow(Real(0), Real(r.falloff))));
    }
    const Radiances share = Floats(f) * Radiances(r.max) + Floats(one - f) * Radiances(r.min);
    return r.metallic != 0 ? share * metal_tint(at, c, r.metallic) : share;
}

/// How much a surface lets through: `clear`, less what it mirrors where energy is conserved. Task 3.11.
inline Radiances tint_of(const Surfaces& at, const Radiances& share) {
    if (!at.finish->conserve_energy) return at.clear;
    const Floats one(1.0f);
    return at.clear * Radiances(min(one, one - share.r), min(one, one - share.g), min(one, one - share.b));
}

}  // namespace rays::packets
