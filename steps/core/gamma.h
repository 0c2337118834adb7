// What the numbers of a scene's colours mean: light itself, or light behind a curve.
#pragma once

#include <algorithm>
#include <cmath>

namespace rays {

/// A scene computes with the numbers that it states. With POV-Ray's `assumed_gamma` g these are light to the power 1 /
/// g, so that the picture's numbers have to be raised to g to be light again.
struct Gamma {
    bool srgb = false;  ///< sRGB's curve (IEC 61966-2-1) instead of a power
    float power = 1;    ///< when not srgb

    bool is_linear() const { return !srgb && power == 1; }
};

inline float srgb_to_light(float value) {
    return value < 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
}

/// The light that one of the scene's numbers stands for.
inline float to_light(float value, const Gamma& gamma) {
    if (gamma.is_linear()) return value;
    return gamma.srgb ? srgb_to_light(value) : std::pow(std::max(value, 0.0f), gamma.power);
}

/// The number of the scene that stands for a number of sRGB, 0 to 1.
inline float from_srgb(float value, const Gamma& gamma) {
    if (gamma.srgb) return value;
    const float light = srgb_to_light(value);
    return gamma.power == 1 ? light : std::pow(std::max(light, 0.0f), 1 / gamma.power);
}

}  // namespace rays
