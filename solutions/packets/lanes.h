// Eight numbers at once. Every operation is the one of a single number, eight times: what is computed in lanes in the
// order of the steps' formulas has the steps' bits.
#pragma once

#include "core/vec.h"
#if defined RAYSTEPS_LANES_AVX512
#include "packets/lanes_avx512.h"
#elif defined RAYSTEPS_LANES_AVX512VL
#include "packets/lanes_avx512vl.h"
#else
#include "packets/lanes_avx2.h"
#endif

namespace rays::packets {

inline constexpr int kLanes = 8;
inline constexpr unsigned kAllLanes = (1u << kLanes) - 1;

// As in C++, a comparison with a NaN is false, but for !=.
inline Mask operator<(Reals a, Reals b) { return compared<_CMP_LT_OQ>(a, b); }
inline Mask operator>(Reals a, Reals b) { return compared<_CMP_GT_OQ>(a, b); }
inline Mask operator<=(Reals a, Reals b) { return compared<_CMP_LE_OQ>(a, b); }
inline Mask operator>=(Reals a, Reals b) { return compared<_CMP_GE_OQ>(a, b); }
inline Mask operator==(Reals a, Reals b) { return compared<_CMP_EQ_OQ>(a, b); }

struct Vec3s {
    Reals x, y, z;

    Vec3s() = default;
    Vec3s(Reals x_, Reals y_, Reals z_) : x(x_), y(y_), z(z_) {}
    Vec3s(const Vec3& v) : x(v.x), y(v.y), z(v.z) {}  // NOLINT: a vector stands for eight of it
    const Reals& operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }

    friend Vec3s operator+(const Vec3s& a, const Vec3s& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend Vec3s operator-(const Vec3s& a, const Vec3s& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend Vec3s operator*(Reals s, const Vec3s& v) { return {s * v.x, s * v.y, s * v.z}; }
    Vec3s operator-() const { return {-x, -y, -z}; }
};

inline Reals dot(const Vec3s& a, const Vec3s& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Reals length(const Vec3s& v) { return sqrt(dot(v, v)); }
/// As GLM does it: by a multiplication.
inline Vec3s normalize(const Vec3s& v) { return (Reals(1) / length(v)) * v; }
/// As step 1's; what is not in `lanes` is nobody's.
inline Vec3s unit(Mask lanes, const Vec3s& v) {
    const Reals length2 = dot(v, v), one_step = Reals(1.5) - Reals(0.5) * length2;
    const Mask are_nearly_unit = abs(length2 - Reals(1)) < Reals(kNearlyUnit);
    if (!(lanes - are_nearly_unit).any()) return one_step * v;
    return select(are_nearly_unit, one_step, Reals(1) / sqrt(length2)) * v;
}
inline Vec3s select(Mask where, const Vec3s& then, const Vec3s& otherwise) {
    return {select(where, then.x, otherwise.x), select(where, then.y, otherwise.y), select(where, then.z, otherwise.z)};
}

/// Eight numbers that came out of lanes, to be looked at one by one.
struct alignas(64) Spread {
    double lane[kLanes];
    Spread() = default;
    explicit Spread(Reals a) { a.store(lane); }
    double operator[](int i) const { return lane[i]; }
};

/// Eight floats: light.
struct Floats {
    __m256 v;

    Floats() = default;
    Floats(__m256 a) : v(a) {}                     // NOLINT
    Floats(float all) : v(_mm256_set1_ps(all)) {}  // NOLINT: a number stands for eight of it
    explicit Floats(Reals a) : v(a.narrow()) {}
    static Floats load(const float* aligned) { return _mm256_load_ps(aligned); }
    void store(float* aligned) const { _mm256_store_ps(aligned, v); }

    friend Floats operator+(Floats a, Floats b) { return a.v + b.v; }
    friend Floats operator-(Floats a, Floats b) { return a.v - b.v; }
    friend Floats operator*(Floats a, Floats b) { return a.v * b.v; }
};

inline Floats max(Floats a, Floats b) { return _mm256_max_ps(a.v, b.v); }
inline Floats min(Floats a, Floats b) { return _mm256_min_ps(a.v, b.v); }
inline Floats abs(Floats a) { return _mm256_andnot_ps(_mm256_set1_ps(-0.0f), a.v); }

inline Floats select(Mask where, Floats then, Floats otherwise) { return select(narrow(where), then.v, otherwise.v); }

/// Eight radiances, by their first three lanes: the fourth of an RGB scene is not seen.
struct Radiances {
    Floats r{0.0f}, g{0.0f}, b{0.0f};

    Radiances() = default;
    Radiances(Floats r_, Floats g_, Floats b_) : r(r_), g(g_), b(b_) {}
    template <class Radiance>
    explicit Radiances(const Radiance& all) : r(all[0]), g(all[1]), b(all[2]) {}

    friend Radiances operator+(const Radiances& x, const Radiances& y) { return {x.r + y.r, x.g + y.g, x.b + y.b}; }
    friend Radiances operator-(const Radiances& x, const Radiances& y) { return {x.r - y.r, x.g - y.g, x.b - y.b}; }
    friend Radiances operator*(const Radiances& x, const Radiances& y) { return {x.r * y.r, x.g * y.g, x.b * y.b}; }
    friend Radiances operator*(Floats s, const Radiances& a) { return {s * a.r, s * a.g, s * a.b}; }
};
inline Radiances select(Mask where, const Radiances& then, const Radiances& otherwise) {
    return {select(where, then.r, otherwise.r), select(where, then.g, otherwise.g), select(where, then.b, otherwise.b)};
}

inline Mask is_less(Floats a, Floats b) { return widen(compared<_CMP_LT_OQ>(a.v, b.v)); }
inline Mask is_greater(Floats a, Floats b) { return is_less(b, a); }
/// Of the four lanes that each radiance has, the last of which is 0.
inline Floats largest(const Radiances& a) { return max(max(a.r, a.g), max(a.b, Floats(0.0f))); }
inline Mask is_not_zero(Floats a) { return widen(compared<_CMP_NEQ_UQ>(a.v, _mm256_setzero_ps())); }
inline Mask is_not_black(const Radiances& a) { return is_not_zero(a.r) | is_not_zero(a.g) | is_not_zero(a.b); }

}  // namespace rays::packets
