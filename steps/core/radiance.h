// Radiance: what a ray carries home.
#pragma once

#include <algorithm>
#include <cmath>

namespace rays {

/// Four lanes of light, one SIMD register wide. In an RGB scene the lanes are red, green, blue and nothing; in a
/// spectral scene they are four wavelengths of one sample. Shading code is the same for both: it only adds and
/// multiplies lane by lane. Unit: POV-Ray's light unit (a white light at normal incidence on a white surface gives 1).
struct alignas(16) Radiance {
    float lane[4] = {0, 0, 0, 0};

    constexpr Radiance() = default;
    constexpr explicit Radiance(float grey) : lane{grey, grey, grey, grey} {}
    constexpr Radiance(float r, float g, float b, float fourth = 0) : lane{r, g, b, fourth} {}

    constexpr float operator[](int i) const { return lane[i]; }
    constexpr float& operator[](int i) { return lane[i]; }

    constexpr Radiance& operator+=(const Radiance& o) {
        for (int i = 0; i < 4; ++i) lane[i] += o.lane[i];
        return *this;
    }
    constexpr Radiance& operator-=(const Radiance& o) {
        for (int i = 0; i < 4; ++i) lane[i] -= o.lane[i];
        return *this;
    }
    constexpr Radiance& operator*=(const Radiance& o) {
        for (int i = 0; i < 4; ++i) lane[i] *= o.lane[i];
        return *this;
    }
    constexpr Radiance& operator*=(float s) {
        for (float& v : lane) v *= s;
        return *this;
    }
    friend constexpr Radiance operator+(Radiance a, const Radiance& b) { return a += b; }
    friend constexpr Radiance operator-(Radiance a, const Radiance& b) { return a -= b; }
    friend constexpr Radiance operator*(Radiance a, const Radiance& b) { return a *= b; }
    friend constexpr Radiance operator*(Radiance a, float s) { return a *= s; }
    friend constexpr Radiance operator*(float s, Radiance a) { return a *= s; }
    friend constexpr bool operator==(const Radiance&, const Radiance&) = default;

    constexpr bool is_black() const { return lane[0] == 0 && lane[1] == 0 && lane[2] == 0 && lane[3] == 0; }
    constexpr float largest() const { return std::max(std::max(lane[0], lane[1]), std::max(lane[2], lane[3])); }
    bool is_finite() const {
        return std::isfinite(lane[0]) && std::isfinite(lane[1]) && std::isfinite(lane[2]) && std::isfinite(lane[3]);
    }
};

}  // namespace rays
