// Eight doubles in one register, and masks in registers of their own: processors with AVX-512.
#pragma once

#include <immintrin.h>

#include <cstdint>

#include "packets/float_masks.h"

// glibc's vector library (libmvec), by the names of the x86-64 vector ABI: eight doubles, AVX-512. Of 48 million
// results none differed from those of four doubles.
extern "C" __m512d _ZGVeN8vv_pow(__m512d, __m512d);
extern "C" __m512d _ZGVeN8v_exp(__m512d);

namespace rays::packets {

/// For each lane yes or no.
struct Mask {
    __mmask8 set;

    unsigned bits() const { return set; }
    bool any() const { return set != 0; }

    static Mask of(unsigned bits) { return {static_cast<__mmask8>(bits)}; }

    friend Mask operator&(Mask a, Mask b) { return of(a.bits() & b.bits()); }
    friend Mask operator|(Mask a, Mask b) { return of(a.bits() | b.bits()); }
    friend Mask operator^(Mask a, Mask b) { return of(a.bits() ^ b.bits()); }
    /// a, but where b.
    friend Mask operator-(Mask a, Mask b) { return of(a.bits() & ~b.bits()); }
};

/// Eight of `Real`, which is double here.
struct Reals {
    __m512d v;

    Reals() = default;
    Reals(__m512d a) : v(a) {}  // NOLINT
    Reals(__m256d first, __m256d last) : v(_mm512_insertf64x4(_mm512_castpd256_pd512(first), last, 1)) {}
    Reals(double a, double b, double c, double d, double e, double f, double g, double h)
        : v(_mm512_setr_pd(a, b, c, d, e, f, g, h)) {}
    explicit Reals(__m256i whole) : v(_mm512_cvtepi32_pd(whole)) {}
    Reals(double all) : v(_mm512_set1_pd(all)) {}  // NOLINT: a number stands for eight of it
    static Reals load(const double* aligned) { return _mm512_load_pd(aligned); }
    void store(double* aligned) const { _mm512_store_pd(aligned, v); }
    static Reals load_anywhere(const double* from) { return _mm512_loadu_pd(from); }
    void store_anywhere(double* to) const { _mm512_storeu_pd(to, v); }
    __m256d first_four() const { return _mm512_castpd512_pd256(v); }
    __m256d last_four() const { return _mm512_extractf64x4_pd(v, 1); }
    __m256 narrow() const { return _mm512_cvtpd_ps(v); }

    friend Reals operator+(Reals a, Reals b) { return a.v + b.v; }
    friend Reals operator-(Reals a, Reals b) { return a.v - b.v; }
    friend Reals operator*(Reals a, Reals b) { return a.v * b.v; }
    friend Reals operator/(Reals a, Reals b) { return a.v / b.v; }
    Reals operator-() const { return _mm512_xor_pd(v, _mm512_set1_pd(-0.0)); }
};

template <int how>
Mask compared(Reals a, Reals b) {
    return {_mm512_cmp_pd_mask(a.v, b.v, how)};
}

inline Reals select(Mask where, Reals then, Reals otherwise) {
    return _mm512_mask_blend_pd(where.set, otherwise.v, then.v);
}
inline Reals sqrt(Reals a) { return _mm512_sqrt_pd(a.v); }
inline Reals floor(Reals a) { return _mm512_roundscale_pd(a.v, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC); }
inline Reals abs(Reals a) { return _mm512_andnot_pd(_mm512_set1_pd(-0.0), a.v); }
/// As std::max and std::min: the first one when they are equal.
inline Reals max(Reals a, Reals b) { return _mm512_max_pd(b.v, a.v); }
inline Reals min(Reals a, Reals b) { return _mm512_min_pd(b.v, a.v); }
/// |size| with the sign of `sign`.
inline Reals copysign(Reals size, Reals sign) {
    const __m512d bit = _mm512_set1_pd(-0.0);
    return _mm512_or_pd(_mm512_andnot_pd(bit, size.v), _mm512_and_pd(bit, sign.v));
}
/// a b + c, rounded once.
inline Reals fma(Reals a, Reals b, Reals c) { return _mm512_fmadd_pd(a.v, b.v, c.v); }

/// a^b and e^a, to less than 4 units in the last place.
inline Reals pow(Reals a, Reals b) { return _ZGVeN8vv_pow(a.v, b.v); }
inline Reals exp(Reals a) { return _ZGVeN8v_exp(a.v); }

/// As floats see it.
inline FloatMask narrow(Mask m) { return m.set; }
/// As doubles see it.
inline Mask widen(FloatMask mask) { return {mask}; }

}  // namespace rays::packets
