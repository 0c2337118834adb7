// Eight doubles in two registers, and masks in registers like theirs: any processor with AVX2.
#pragma once

#include <cstdint>

#include "packets/reals_in_pairs.h"

namespace rays::packets {

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

template <int how>
Mask compared(Reals a, Reals b) {
    return {_mm256_cmp_pd(a.lo, b.lo, how), _mm256_cmp_pd(a.hi, b.hi, how)};
}

inline Reals select(Mask where, Reals then, Reals otherwise) {
    return {_mm256_blendv_pd(otherwise.lo, then.lo, where.lo), _mm256_blendv_pd(otherwise.hi, then.hi, where.hi)};
}
/// A mask as floats see it.
using FloatMask = __m256;
inline FloatMask narrow(Mask m) {
    const __m256 mixed = _mm256_shuffle_ps(_mm256_castpd_ps(m.lo), _mm256_castpd_ps(m.hi), 0x88);
    return _mm256_castpd_ps(_mm256_permute4x64_pd(_mm256_castps_pd(mixed), 0xd8));
}
/// As doubles see it.
inline Mask widen(FloatMask mask) {
    const __m256i bits = _mm256_castps_si256(mask);
    return {_mm256_castsi256_pd(_mm256_cvtepi32_epi64(_mm256_castsi256_si128(bits))),
            _mm256_castsi256_pd(_mm256_cvtepi32_epi64(_mm256_extracti128_si256(bits, 1)))};
}
template <int how>
FloatMask compared(__m256 a, __m256 b) {
    return _mm256_cmp_ps(a, b, how);
}
inline __m256 select(FloatMask where, __m256 then, __m256 otherwise) {
    return _mm256_blendv_ps(otherwise, then, where);
}
inline unsigned bits_of(FloatMask mask) { return static_cast<unsigned>(_mm256_movemask_ps(mask)); }

}  // namespace rays::packets
