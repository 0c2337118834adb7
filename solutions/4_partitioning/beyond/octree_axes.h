// The octree's three axes, worked on side by side.
#pragma once

#include <immintrin.h>

#include <algorithm>

#include "core/vec.h"

namespace rays::octree {

/// One number for each axis, worked on side by side; z twice.
using Axes = Real __attribute__((vector_size(4 * sizeof(Real))));
using AxesMask = decltype(Axes{} < Axes{});

inline Axes axes(const Vec3& v) { return Axes{v.x, v.y, v.z, v.z}; }
inline Vec3 vec3(Axes v) { return {v[0], v[1], v[2]}; }
inline Real largest(Axes v) { return std::max(v[0], std::max(v[1], v[2])); }
inline Real smallest(Axes v) { return std::min(v[0], std::min(v[1], v[2])); }

#ifdef RAYSTEPS_REAL_FLOAT
using Lanes = __m128;
inline int sign_bits(Lanes v) { return _mm_movemask_ps(v); }
inline Lanes by_sign(Lanes where, Lanes then, Lanes otherwise) { return _mm_blendv_ps(otherwise, then, where); }
#else
using Lanes = __m256d;
inline int sign_bits(Lanes v) { return _mm256_movemask_pd(v); }
inline Lanes by_sign(Lanes where, Lanes then, Lanes otherwise) { return _mm256_blendv_pd(otherwise, then, where); }
#endif

/// Bit a: axis a.
inline unsigned bits_of(AxesMask mask) { return static_cast<unsigned>(sign_bits((Lanes)mask)) & 7; }
inline Axes select(AxesMask where, Axes then, Axes otherwise) {
    return (Axes)by_sign((Lanes)where, (Lanes)then, (Lanes)otherwise);
}

}  // namespace rays::octree
