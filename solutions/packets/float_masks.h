// Masks of eight floats where they have registers of their own: AVX-512.
#pragma once

#include <immintrin.h>

namespace rays::packets {

/// A mask as floats see it.
using FloatMask = __mmask8;

template <int how>
FloatMask compared(__m256 a, __m256 b) {
    return _mm256_cmp_ps_mask(a, b, how);
}
inline __m256 select(FloatMask where, __m256 then, __m256 otherwise) {
    return _mm256_mask_blend_ps(where, otherwise, then);
}
inline unsigned bits_of(FloatMask mask) { return mask; }

}  // namespace rays::packets
