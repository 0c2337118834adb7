// The space that a packet's rays run through, as boxes see it: one test tells which of eight boxes no ray of the packet
// can meet. Interval arithmetic, as in Boulos, Wald, Shirley, "Geometric and Arithmetic Culling Methods for Entire Ray
// Packets", 2006; in float, with every rounding towards asking.
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

class Beam {
public:
    Beam(const Rays& rays, Mask active, const Directions::Way& way, Reals near, Reals far)
        : active_(active), way_(way) {
        const __m256 in = narrow(active);
        __m256 reach = _mm256_setzero_ps();
        for (int a = 0; a < 3; ++a) {
            const bool forwards = way.forwards[a];
            const __m256 o = lane_origin_[a] = Floats(rays.origin[a]).v;
            lane_direction_[a] = Floats(rays.direction[a]).v;
            reach = _mm256_max_ps(reach, _mm256_andnot_ps(_mm256_set1_ps(-0.0f), o));
            const __m256 off = rounding_of(o), less = o - off, more = o + off;
            lane_near_origin_[a] = forwards ? more : less;
            lane_far_origin_[a] = forwards ? less : more;
            near_origin_[a] = forwards ? largest(more, in) : smallest(less, in);
            far_origin_[a] = forwards ? smallest(less, in) : largest(more, in);
            // Of 0 and -0 both, the inverse is infinite the same way.
            const __m256 d = Floats(forwards ? abs(rays.direction[a]) : rays.direction[a]).v;
            const __m256 inverse = clamped(_mm256_set1_ps(1) / d);
            lane_near_inverse_[a] = inverse * _mm256_set1_ps(1 - kSlack);
            lane_far_inverse_[a] = clamped(inverse * _mm256_set1_ps(1 + kSlack));
            inverse_min_[a] = smallest(forwards ? lane_near_inverse_[a] : lane_far_inverse_[a], in);
            inverse_max_[a] = largest(forwards ? lane_far_inverse_[a] : lane_near_inverse_[a], in);
        }
        const __m256 n = Floats(near).v;
        lane_near_ = _mm256_max_ps(_mm256_setzero_ps(), n - rounding_of(n));
        near_ = smallest(lane_near_, in);
        reach_ = _mm256_cvtss_f32(largest(reach, in));
        end_at(far, active);
    }

    /// From now on rays count up to `far`; those that are not open do not count at all.
    void end_at(Reals far, Mask open) {
        const __m256 f = clamped(Floats(far).v);
        lane_far_ = select(open, Floats(f + rounding_of(f)), Floats(-1.0f)).v;
        far_ = largest(lane_far_);
        far_end_ = _mm256_cvtss_f32(far_);
    }
    float far_end() const { return far_end_; }

    /// From now on these rays count between `from` and `to` only.
    void look_between(Mask rays, Reals from, Reals to) {
        const __m256 near = Floats(from).v, far = Floats(to).v;
        lane_near_ = select(rays, max(Floats(0.0f), Floats(near - rounding_of(near))), Floats(lane_near_)).v;
        lane_far_ = select(rays, Floats(far + rounding_of(far)), Floats(lane_far_)).v;
        update_ends();
    }
    /// From now on these rays do not count at all.
    void leave_out(Mask rays) {
        lane_far_ = select(rays, Floats(-1.0f), Floats(lane_far_)).v;
        update_ends();
    }

    /// Which rays may meet the box of a child: what they do together, looked at one by one.
    unsigned rays_that_meet(const wide::Node& node, unsigned child) const {
        __m256 near = lane_near_, far = lane_far_;
        for (int a = 0; a < 3; ++a) {
            const float* near_plane = way_.forwards[a] ? &node.lo[a][child] : &node.hi[a][child];
            const float* far_plane = way_.forwards[a] ? &node.hi[a][child] : &node.lo[a][child];
            const __m256 to_near = _mm256_broadcast_ss(near_plane) - lane_near_origin_[a];
            const __m256 to_far = _mm256_broadcast_ss(far_plane) - lane_far_origin_[a];
            near = _mm256_max_ps(near, to_near * lane_near_inverse_[a]);
            far = _mm256_min_ps(far, to_far * lane_far_inverse_[a]);
        }
        return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(near, far, _CMP_LE_OQ)));
    }

    /// Which rays may meet a ball, or a cone, of a block: as wide::SphereRay tells, with rays and shapes in turned
    /// roles. Directions have unit length.
    unsigned rays_that_meet(const wide::SphereBlock& block, int i) const {
        const ToCenter to(*this, block, i);
        const __m256 reaches = _mm256_add_ps(_mm256_broadcast_ss(&block.radius[i]), _mm256_set1_ps(off(block)));
        __m256 beside2 = _mm256_setzero_ps();
        for (int a = 0; a < 3; ++a) {
            const __m256 beside = _mm256_fnmadd_ps(to.along, lane_direction_[a], to.center[a]);
            beside2 = _mm256_fmadd_ps(beside, beside, beside2);
        }
        // Not greater, not less: what is no number is asked.
        const __m256 met = _mm256_cmp_ps(beside2, reaches * reaches, _CMP_NGT_UQ);
        const __m256 before_far = _mm256_cmp_ps(to.along - reaches, lane_far_, _CMP_NGT_UQ);
        const __m256 behind_near = _mm256_cmp_ps(to.along + reaches, lane_near_, _CMP_NLT_UQ);
        return static_cast<unsigned>(_mm256_movemask_ps(_mm256_and_ps(met, _mm256_and_ps(before_far, behind_near))));
    }
    unsigned rays_that_meet(const wide::ConeBlock& block, int i) const {
        const unsigned balls = rays_that_meet(block.around, i);
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
            const __m256 normal = _mm256_fmsub_ps(lane_direction_[b], axis[c], lane_direction_[c] * axis[b]);
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

    /// A bit for each child whose box some ray may meet; where the first may enter, in `enters`.
    unsigned meets(const wide::Node& node, float* enters) const {
        __m256 near[3], far[3];
        for (int a = 0; a < 3; ++a) {
            near[a] = _mm256_load_ps(way_.forwards[a] ? node.lo[a] : node.hi[a]);
            far[a] = _mm256_load_ps(way_.forwards[a] ? node.hi[a] : node.lo[a]);
        }
        return between(near, far, enters);
    }

    unsigned meets(const wide::SphereBlock& block) const {
        const __m256 wider = _mm256_add_ps(_mm256_load_ps(block.radius), _mm256_set1_ps(block.reach * kOff));
        __m256 lo[3], hi[3];
        for (int a = 0; a < 3; ++a) {
            lo[a] = _mm256_sub_ps(_mm256_load_ps(block.center[a]), wider);
            hi[a] = _mm256_add_ps(_mm256_load_ps(block.center[a]), wider);
        }
        return meets(lo, hi) & ((1u << block.count) - 1);
    }

    unsigned meets(const wide::ConeBlock& block) const {
        const __m256 radius = _mm256_add_ps(_mm256_load_ps(block.radius), _mm256_set1_ps(block.around.reach * kOff));
        __m256 lo[3], hi[3];
        for (int a = 0; a < 3; ++a) {
            const __m256 half = _mm256_andnot_ps(_mm256_set1_ps(-0.0f), _mm256_load_ps(block.half_axis[a]));
            lo[a] = _mm256_sub_ps(_mm256_load_ps(block.around.center[a]), _mm256_add_ps(half, radius));
            hi[a] = _mm256_add_ps(_mm256_load_ps(block.around.center[a]), _mm256_add_ps(half, radius));
        }
        return meets(lo, hi) & ((1u << block.around.count) - 1);
    }

    unsigned meets(const wide::TriangleBlock& block) const {
        const __m256 off = _mm256_set1_ps(block.reach * kOff);
        __m256 lo[3], hi[3];
        for (int a = 0; a < 3; ++a) {
            const __m256 p = _mm256_load_ps(block.corner[0][a]), q = _mm256_load_ps(block.corner[1][a]),
                         r = _mm256_load_ps(block.corner[2][a]);
            lo[a] = _mm256_sub_ps(_mm256_min_ps(p, _mm256_min_ps(q, r)), off);
            hi[a] = _mm256_add_ps(_mm256_max_ps(p, _mm256_max_ps(q, r)), off);
        }
        return meets(lo, hi) & ((1u << block.count) - 1);
    }

private:
    void update_ends() {
        near_ = smallest(lane_near_, _mm256_cmp_ps(lane_far_, _mm256_setzero_ps(), _CMP_GE_OQ));
        far_ = largest(lane_far_);
        far_end_ = _mm256_cvtss_f32(far_);
    }

    /// From the origins to the centre of a ball, and how far along the rays that is.
    struct ToCenter {
        __m256 center[3], along = _mm256_setzero_ps();
        ToCenter(const Beam& beam, const wide::SphereBlock& block, int i) {
            for (int a = 0; a < 3; ++a) {
                center[a] = _mm256_broadcast_ss(&block.center[a][i]) - beam.lane_origin_[a];
                along = _mm256_fmadd_ps(center[a], beam.lane_direction_[a], along);
            }
        }
    };
    /// What rounding may do to a coordinate, a projection, a distance: as in leaf_blocks.h.
    float off(const wide::SphereBlock& block) const { return 0x1p-19f * (block.reach + reach_); }

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
    static __m256 largest(__m256 f, __m256 among) {
        return largest(_mm256_blendv_ps(_mm256_set1_ps(-kMaxFloat), f, among));
    }
    static __m256 smallest(__m256 f, __m256 among) {
        const __m256 sign = _mm256_set1_ps(-0.0f);
        return _mm256_xor_ps(largest(_mm256_xor_ps(f, sign), among), sign);
    }

    unsigned meets(const __m256 (&lo)[3], const __m256 (&hi)[3]) const {
        __m256 near[3], far[3];
        for (int a = 0; a < 3; ++a) {
            near[a] = way_.forwards[a] ? lo[a] : hi[a];
            far[a] = way_.forwards[a] ? hi[a] : lo[a];
        }
        return between(near, far, nullptr);
    }

    /// Eight boxes by their planes on the rays' near side and on their far side.
    unsigned between(const __m256 (&near_planes)[3], const __m256 (&far_planes)[3], float* enters) const {
        __m256 near = near_, far = far_;
        for (int a = 0; a < 3; ++a) {
            const __m256 to_near = near_planes[a] - near_origin_[a], to_far = far_planes[a] - far_origin_[a];
            near = _mm256_max_ps(near, _mm256_min_ps(to_near * inverse_min_[a], to_near * inverse_max_[a]));
            far = _mm256_min_ps(far, _mm256_max_ps(to_far * inverse_min_[a], to_far * inverse_max_[a]));
        }
        if (enters) _mm256_store_ps(enters, near);
        return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(near, far, _CMP_LE_OQ)));
    }

    static constexpr float kSlack = 0x1p-20f;  ///< three roundings of 2^-24 each, and some
    static constexpr float kOff = 0x1p-21f;    ///< of a corner in float, and of a root that lies a little outside

    __m256 near_origin_[3], far_origin_[3], inverse_min_[3], inverse_max_[3], near_, far_;
    __m256 lane_near_origin_[3], lane_far_origin_[3], lane_near_inverse_[3], lane_far_inverse_[3], lane_near_,
        lane_far_;
    __m256 lane_origin_[3], lane_direction_[3];
    float reach_ = 0;
    Mask active_;
    float far_end_ = 0;
    Directions::Way way_;
};

}  // namespace rays::packets
