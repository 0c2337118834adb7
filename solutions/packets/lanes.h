// Eight numbers at once. Every operation is the one of a single number, eight times: what is computed in lanes in the
// order of the steps' formulas has the steps' bits.
#pragma once

#include <immintrin.h>

#include <cstdint>

#include "core/vec.h"

namespace rays::packets {

inline constexpr int kLanes = 8;
inline constexpr unsigned kAllLanes = (1u << kLanes) - 1;

/// For each lane yes (all bits) or no (none).
struct Mask {
    __m256d lo, hi;

    unsigned bits() const { return static_cast<unsigned>(_mm256_movemask_pd(lo) | _mm256_movemask_pd(hi) << 4); }
    bool any() const { return bits() != 0; }

    static Mask of(unsigned bits) {
        const __m256i all = _mm256_set1_epi64x(bits);
        const __m256i first = _mm256_setr_epi64x(1, 2, 4, 8), second = _mm256_setr_epi64x(16, 32, 64, 128);
        return {_mm256_castsi256_pd(_mm256_cmpeq_epi64(_mm256_and_si256(all, first), first)),
                _mm256_castsi256_pd(_mm256_cmpeq_epi64(_mm256_and_si256(all, second), second))};
    }

    friend Mask operator&(Mask a, Mask b) { return {_mm256_and_pd(a.lo, b.lo), _mm256_and_pd(a.hi, b.hi)}; }
    friend Mask operator|(Mask a, Mask b) { return {_mm256_or_pd(a.lo, b.lo), _mm256_or_pd(a.hi, b.hi)}; }
    friend Mask operator^(Mask a, Mask b) { return {_mm256_xor_pd(a.lo, b.lo), _mm256_xor_pd(a.hi, b.hi)}; }
    /// a, but where b.
    friend Mask operator-(Mask a, Mask b) { return {_mm256_andnot_pd(b.lo, a.lo), _mm256_andnot_pd(b.hi, a.hi)}; }
};

/// Eight of `Real`, which is double here.
struct Reals {
    __m256d lo, hi;

    Reals() = default;
    Reals(__m256d l, __m256d h) : lo(l), hi(h) {}
    Reals(double all) : lo(_mm256_set1_pd(all)), hi(lo) {}  // NOLINT: a number stands for eight of it
    static Reals load(const double* aligned) { return {_mm256_load_pd(aligned), _mm256_load_pd(aligned + 4)}; }
    void store(double* aligned) const {
        _mm256_store_pd(aligned, lo);
        _mm256_store_pd(aligned + 4, hi);
    }

    friend Reals operator+(Reals a, Reals b) { return {a.lo + b.lo, a.hi + b.hi}; }
    friend Reals operator-(Reals a, Reals b) { return {a.lo - b.lo, a.hi - b.hi}; }
    friend Reals operator*(Reals a, Reals b) { return {a.lo * b.lo, a.hi * b.hi}; }
    friend Reals operator/(Reals a, Reals b) { return {a.lo / b.lo, a.hi / b.hi}; }
    Reals operator-() const {
        const __m256d sign = _mm256_set1_pd(-0.0);
        return {_mm256_xor_pd(lo, sign), _mm256_xor_pd(hi, sign)};
    }

    // As in C++, a comparison with a NaN is false, but for !=.
    friend Mask operator<(Reals a, Reals b) { return compared<_CMP_LT_OQ>(a, b); }
    friend Mask operator>(Reals a, Reals b) { return compared<_CMP_GT_OQ>(a, b); }
    friend Mask operator<=(Reals a, Reals b) { return compared<_CMP_LE_OQ>(a, b); }
    friend Mask operator>=(Reals a, Reals b) { return compared<_CMP_GE_OQ>(a, b); }
    friend Mask operator==(Reals a, Reals b) { return compared<_CMP_EQ_OQ>(a, b); }

private:
    template <int how>
    static Mask compared(Reals a, Reals b) {
        return {_mm256_cmp_pd(a.lo, b.lo, how), _mm256_cmp_pd(a.hi, b.hi, how)};
    }
};

inline Reals select(Mask where, Reals then, Reals otherwise) {
    return {_mm256_blendv_pd(otherwise.lo, then.lo, where.lo), _mm256_blendv_pd(otherwise.hi, then.hi, where.hi)};
}
inline Reals sqrt(Reals a) { return {_mm256_sqrt_pd(a.lo), _mm256_sqrt_pd(a.hi)}; }
inline Reals floor(Reals a) { return {_mm256_floor_pd(a.lo), _mm256_floor_pd(a.hi)}; }
inline Reals abs(Reals a) {
    const __m256d sign = _mm256_set1_pd(-0.0);
    return {_mm256_andnot_pd(sign, a.lo), _mm256_andnot_pd(sign, a.hi)};
}
/// As std::max and std::min: the first one when they are equal.
inline Reals max(Reals a, Reals b) { return {_mm256_max_pd(b.lo, a.lo), _mm256_max_pd(b.hi, a.hi)}; }
inline Reals min(Reals a, Reals b) { return {_mm256_min_pd(b.lo, a.lo), _mm256_min_pd(b.hi, a.hi)}; }
/// |size| with the sign of `sign`.
inline Reals copysign(Reals size, Reals sign) {
    const __m256d bit = _mm256_set1_pd(-0.0);
    return {_mm256_or_pd(_mm256_andnot_pd(bit, size.lo), _mm256_and_pd(bit, sign.lo)),
            _mm256_or_pd(_mm256_andnot_pd(bit, size.hi), _mm256_and_pd(bit, sign.hi))};
}
/// a b + c, rounded once.
inline Reals fma(Reals a, Reals b, Reals c) {
    return {_mm256_fmadd_pd(a.lo, b.lo, c.lo), _mm256_fmadd_pd(a.hi, b.hi, c.hi)};
}

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
inline Vec3s select(Mask where, const Vec3s& then, const Vec3s& otherwise) {
    return {select(where, then.x, otherwise.x), select(where, then.y, otherwise.y), select(where, then.z, otherwise.z)};
}

/// Eight numbers that came out of lanes, to be looked at one by one.
struct alignas(32) Spread {
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
    explicit Floats(Reals a) : v(_mm256_set_m128(_mm256_cvtpd_ps(a.hi), _mm256_cvtpd_ps(a.lo))) {}
    static Floats load(const float* aligned) { return _mm256_load_ps(aligned); }
    void store(float* aligned) const { _mm256_store_ps(aligned, v); }

    friend Floats operator+(Floats a, Floats b) { return a.v + b.v; }
    friend Floats operator-(Floats a, Floats b) { return a.v - b.v; }
    friend Floats operator*(Floats a, Floats b) { return a.v * b.v; }
};

inline Floats max(Floats a, Floats b) { return _mm256_max_ps(a.v, b.v); }
inline Floats min(Floats a, Floats b) { return _mm256_min_ps(a.v, b.v); }
inline Floats abs(Floats a) { return _mm256_andnot_ps(_mm256_set1_ps(-0.0f), a.v); }

/// A mask as floats see it.
inline __m256 narrow(Mask m) {
    const __m256 mixed = _mm256_shuffle_ps(_mm256_castpd_ps(m.lo), _mm256_castpd_ps(m.hi), 0x88);
    return _mm256_castpd_ps(_mm256_permute4x64_pd(_mm256_castps_pd(mixed), 0xd8));
}
inline Floats select(Mask where, Floats then, Floats otherwise) {
    return _mm256_blendv_ps(otherwise.v, then.v, narrow(where));
}

/// As doubles see it.
inline Mask widen(__m256 mask) {
    const __m256i bits = _mm256_castps_si256(mask);
    return {_mm256_castsi256_pd(_mm256_cvtepi32_epi64(_mm256_castsi256_si128(bits))),
            _mm256_castsi256_pd(_mm256_cvtepi32_epi64(_mm256_extracti128_si256(bits, 1)))};
}

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

inline Mask is_less(Floats a, Floats b) { return widen(_mm256_cmp_ps(a.v, b.v, _CMP_LT_OQ)); }
inline Mask is_greater(Floats a, Floats b) { return is_less(b, a); }
/// Of the four lanes that each radiance has, the last of which is 0.
inline Floats largest(const Radiances& a) { return max(max(a.r, a.g), max(a.b, Floats(0.0f))); }
inline Mask is_not_black(const Radiances& a) {
    const auto is_not_zero = [](Floats f) { return _mm256_cmp_ps(f.v, _mm256_setzero_ps(), _CMP_NEQ_UQ); };
    return widen(_mm256_or_ps(is_not_zero(a.r), _mm256_or_ps(is_not_zero(a.g), is_not_zero(a.b))));
}

}  // namespace rays::packets
