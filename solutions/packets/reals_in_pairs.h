// Eight doubles in two registers of four.
#pragma once

#include <immintrin.h>

// glibc's vector library (libmvec), by the names of the x86-64 vector ABI: four doubles, AVX2.
extern "C" __m256d _ZGVdN4vv_pow(__m256d, __m256d);
extern "C" __m256d _ZGVdN4v_exp(__m256d);

namespace rays::packets {

/// Eight of `Real`, which is double here.
struct Reals {
    __m256d lo, hi;

    Reals() = default;
    Reals(__m256d l, __m256d h) : lo(l), hi(h) {}
    Reals(double a, double b, double c, double d, double e, double f, double g, double h)
        : lo(_mm256_setr_pd(a, b, c, d)), hi(_mm256_setr_pd(e, f, g, h)) {}
    explicit Reals(__m256i whole)
        : lo(_mm256_cvtepi32_pd(_mm256_castsi256_si128(whole))),
          hi(_mm256_cvtepi32_pd(_mm256_extracti128_si256(whole, 1))) {}
    Reals(double all) : lo(_mm256_set1_pd(all)), hi(lo) {}  // NOLINT: a number stands for eight of it
    static Reals load(const double* aligned) { return {_mm256_load_pd(aligned), _mm256_load_pd(aligned + 4)}; }
    void store(double* aligned) const {
        _mm256_store_pd(aligned, lo);
        _mm256_store_pd(aligned + 4, hi);
    }

    static Reals load_anywhere(const double* from) { return {_mm256_loadu_pd(from), _mm256_loadu_pd(from + 4)}; }
    void store_anywhere(double* to) const {
        _mm256_storeu_pd(to, lo);
        _mm256_storeu_pd(to + 4, hi);
    }
    __m256d first_four() const { return lo; }
    __m256d last_four() const { return hi; }
    __m256 narrow() const { return _mm256_set_m128(_mm256_cvtpd_ps(hi), _mm256_cvtpd_ps(lo)); }

    friend Reals operator+(Reals a, Reals b) { return {a.lo + b.lo, a.hi + b.hi}; }
    friend Reals operator-(Reals a, Reals b) { return {a.lo - b.lo, a.hi - b.hi}; }
    friend Reals operator*(Reals a, Reals b) { return {a.lo * b.lo, a.hi * b.hi}; }
    friend Reals operator/(Reals a, Reals b) { return {a.lo / b.lo, a.hi / b.hi}; }
    Reals operator-() const {
        const __m256d sign = _mm256_set1_pd(-0.0);
        return {_mm256_xor_pd(lo, sign), _mm256_xor_pd(hi, sign)};
    }
};

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

/// a^b and e^a, to less than 4 units in the last place.
inline Reals pow(Reals a, Reals b) { return {_ZGVdN4vv_pow(a.lo, b.lo), _ZGVdN4vv_pow(a.hi, b.hi)}; }
inline Reals exp(Reals a) { return {_ZGVdN4v_exp(a.lo), _ZGVdN4v_exp(a.hi)}; }

}  // namespace rays::packets
