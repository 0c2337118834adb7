// Eight rays as boxes and blocks see them, one by one: in float, with every rounding towards asking.
#pragma once

#include <algorithm>
#include <cmath>

#include "4_partitioning/beyond/float_box.h"
#include "4_partitioning/beyond/wide_tree.h"
#include "packets/rays.h"

namespace rays::packets {

using wide::above;
using wide::below;
using wide::kMaxFloat;

class FloatRays {
public:
    FloatRays(const Rays& rays, Mask active, Reals near, Reals far) : active_(active) {
        __m256 reach = _mm256_setzero_ps();
        for (int a = 0; a < 3; ++a) {
            origin_[a] = Floats(rays.origin[a]).v;
            direction_[a] = Floats(rays.direction[a]).v;
            reach = _mm256_max_ps(reach, _mm256_andnot_ps(_mm256_set1_ps(-0.0f), origin_[a]));
        }
        const __m256 n = Floats(near).v;
        near_ = _mm256_max_ps(_mm256_setzero_ps(), n - rounding_of(n));
        reach_ = _mm256_cvtss_f32(largest(reach, narrow(active)));
        end_at(far, active);
    }

    /// From now on rays count up to `far`; those that are not open do not count at all.
    void end_at(Reals far, Mask open) {
        const __m256 f = clamped(Floats(far).v);
        far_ = select(open, Floats(f + rounding_of(f)), Floats(-1.0f)).v;
    }
    /// From now on these rays count between `from` and `to` only.
    void look_between(Mask rays, Reals from, Reals to) {
        const __m256 near = Floats(from).v, far = Floats(to).v;
        near_ = select(rays, max(Floats(0.0f), Floats(near - rounding_of(near))), Floats(near_)).v;
        far_ = select(rays, Floats(far + rounding_of(far)), Floats(far_)).v;
    }
    /// From now on these rays do not count at all.
    void leave_out(Mask rays) { far_ = select(rays, Floats(-1.0f), Floats(far_)).v; }

    /// Which rays may meet a ball, or a cone, of a block: as wide::SphereRay tells, with rays and shapes in turned
    /// roles. Directions have unit length.
    unsigned rays_that_meet(const wide::SphereBlock& block, int i) const { return rays_that_meet_ball<true>(block, i); }
    unsigned rays_that_meet(const wide::ConeBlock& block, int i) const {
        const unsigned balls = rays_that_meet_ball<false>(block.around, i);
        if (balls == 0) return 0;
        const ToCenter to(*this, block.around, i);
        __m256 axis[3], along_normal = _mm256_setzero_ps(), normal2 = along_normal;
        float axis2 = 0;
        for (int a = 0; a < 3; ++a) {
            axis[a] = _mm256_broadcast_ss(&block.half_axis[a][i]);
            axis2 += block.half_axis[a][i] * block.half_axis[a][i];
        }
        for (int a = 0; a < 3; ++a) {
            const int b = (a + 1) % 3, c = (a + 2) % 3;
            const __m256 normal = _mm256_fmsub_ps(direction_[b], axis[c], direction_[c] * axis[b]);
            along_normal = _mm256_fmadd_ps(to.center[a], normal, along_normal);
            normal2 = _mm256_fmadd_ps(normal, normal, normal2);
        }
        const __m256 size = _mm256_set1_ps(2 * off(block.around) * std::sqrt(axis2));
        const __m256 most = _mm256_fmadd_ps(_mm256_broadcast_ss(&block.radius[i]), _mm256_sqrt_ps(normal2), size);
        const __m256 distance = _mm256_andnot_ps(_mm256_set1_ps(-0.0f), along_normal);
        return balls & static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(distance, most, _CMP_NGT_UQ)));
    }
    /// Triangles are asked at once: their test is as short.
    unsigned rays_that_meet(const wide::TriangleBlock&, int) const { return active_.bits(); }

protected:
    /// More than converting to float and back may change.
    static __m256 rounding_of(__m256 f) {
        const __m256 size = _mm256_andnot_ps(_mm256_set1_ps(-0.0f), f);
        return size * _mm256_set1_ps(0x1p-23f) + _mm256_set1_ps(std::numeric_limits<float>::denorm_min());
    }
    static __m256 clamped(__m256 f) {
        return _mm256_min_ps(_mm256_max_ps(f, _mm256_set1_ps(-kMaxFloat)), _mm256_set1_ps(kMaxFloat));
    }

    /// In all lanes of the result.
    static __m256 largest(__m256 f) {
        f = _mm256_max_ps(f, _mm256_permute2f128_ps(f, f, 1));
        f = _mm256_max_ps(f, _mm256_permute_ps(f, 0x4e));
        return _mm256_max_ps(f, _mm256_permute_ps(f, 0xb1));
    }
    static __m256 largest(__m256 f, FloatMask among) { return largest(select(among, f, _mm256_set1_ps(-kMaxFloat))); }
    static __m256 smallest(__m256 f, FloatMask among) {
        const __m256 sign = _mm256_set1_ps(-0.0f);
        return _mm256_xor_ps(largest(_mm256_xor_ps(f, sign), among), sign);
    }

    static constexpr float kSlack = 0x1p-20f;  ///< three roundings of 2^-24 each, and some

    Mask active_;
    __m256 origin_[3], direction_[3], near_, far_;

private:
    /// From the origins to the centre of a ball, and how far along the rays that is.
    struct ToCenter {
        __m256 center[3], along = _mm256_setzero_ps();
        ToCenter(const FloatRays& rays, const wide::SphereBlock& block, int i) {
            for (int a = 0; a < 3; ++a) {
                center[a] = _mm256_broadcast_ss(&block.center[a][i]) - rays.origin_[a];
                along = _mm256_fmadd_ps(center[a], rays.direction_[a], along);
            }
        }
    };
    /// Of the ball alone. A ray that leaves one is told only where it may be the ball's own surface that it starts on:
    /// around a cone it seldom is.
    template <bool leaves>
    unsigned rays_that_meet_ball(const wide::SphereBlock& block, int i) const {
        const ToCenter to(*this, block, i);
        const __m256 reaches = _mm256_add_ps(_mm256_broadcast_ss(&block.radius[i]), _mm256_set1_ps(off(block)));
        __m256 beside2 = _mm256_setzero_ps();
        for (int a = 0; a < 3; ++a) {
            const __m256 beside = _mm256_fnmadd_ps(to.along, direction_[a], to.center[a]);
            beside2 = _mm256_fmadd_ps(beside, beside, beside2);
        }
        // Not greater, not less: what is no number is asked.
        const __m256 met = _mm256_cmp_ps(beside2, reaches * reaches, _CMP_NGT_UQ);
        const __m256 before_far = _mm256_cmp_ps(to.along - reaches, far_, _CMP_NGT_UQ);
        const __m256 behind_near = _mm256_cmp_ps(to.along + reaches, near_, _CMP_NLT_UQ);
        const unsigned balls =
            static_cast<unsigned>(_mm256_movemask_ps(_mm256_and_ps(met, _mm256_and_ps(before_far, behind_near))));
        if (!leaves || balls == 0) return balls;
        return balls & ~wide::left_before(near_, to.along, beside2, _mm256_broadcast_ss(&block.radius[i]),
                                          block.reach + reach_);
    }

    /// What rounding may do to a coordinate, a projection, a distance: as in leaf_blocks.h.
    float off(const wide::SphereBlock& block) const { return 0x1p-19f * (block.reach + reach_); }

    float reach_ = 0;  ///< no coordinate of an origin is larger
};

}  // namespace rays::packets
