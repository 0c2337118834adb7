// The space that a packet's rays run through, as boxes see it: one test tells which of eight boxes no ray of the packet
// can meet. Interval arithmetic, as in Boulos, Wald, Shirley, "Geometric and Arithmetic Culling Methods for Entire Ray
// Packets", 2006; in float, with every rounding towards asking.
#pragma once

#include "packets/float_rays.h"

namespace rays::packets {

/// Of rays that go the same way.
class Beam : public FloatRays {
public:
    Beam(const Rays& rays, Mask active, const Directions::Way& way, const Span& span)
        : FloatRays(rays, active, span.near, span.far), way_(way) {
        const FloatMask in = narrow(active);
        for (int a = 0; a < 3; ++a) {
            const bool forwards = way.forwards[a];
            near_planes_[a] = forwards ? wide::Boxes::lower(a) : wide::Boxes::upper(a);
            far_planes_[a] = forwards ? wide::Boxes::upper(a) : wide::Boxes::lower(a);
            const __m256 off = rounding_of(origin_[a]), less = origin_[a] - off, more = origin_[a] + off;
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
        first_near_ = smallest(near_, in);
        update_far();
    }

    void end_at(Reals far, Mask open) {
        FloatRays::end_at(far, open);
        update_far();
    }
    void look_between(Mask rays, Reals from, Reals to) {
        FloatRays::look_between(rays, from, to);
        update_ends();
    }
    void leave_out(Mask rays) {
        FloatRays::leave_out(rays);
        update_ends();
    }
    float far_end() const { return far_end_; }

    using FloatRays::rays_that_meet;
    /// Which rays may meet the box of a child: what they do together, looked at one by one.
    unsigned rays_that_meet(const wide::Node& node, unsigned child) const {
        __m256 near = near_, far = far_;
        for (int a = 0; a < 3; ++a) {
            const __m256 to_near = _mm256_broadcast_ss(node.planes(near_planes_[a]) + child) - lane_near_origin_[a];
            const __m256 to_far = _mm256_broadcast_ss(node.planes(far_planes_[a]) + child) - lane_far_origin_[a];
            near = _mm256_max_ps(near, to_near * lane_near_inverse_[a]);
            far = _mm256_min_ps(far, to_far * lane_far_inverse_[a]);
        }
        return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(near, far, _CMP_LE_OQ)));
    }

    /// A bit for each child whose box some ray may meet; where the first may enter, in `enters` (aligned).
    unsigned meets(const wide::Node& node, float* enters) const {
        __m256 near[3], far[3];
        for (int a = 0; a < 3; ++a) {
            near[a] = _mm256_load_ps(node.planes(near_planes_[a]));
            far[a] = _mm256_load_ps(node.planes(far_planes_[a]));
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
            const __m256 p = _mm256_load_ps(block.corner[a]), q = p + _mm256_load_ps(block.edge[0][a]),
                         r = p + _mm256_load_ps(block.edge[1][a]);
            lo[a] = _mm256_sub_ps(_mm256_min_ps(p, _mm256_min_ps(q, r)), off);
            hi[a] = _mm256_add_ps(_mm256_max_ps(p, _mm256_max_ps(q, r)), off);
        }
        return meets(lo, hi) & ((1u << block.count) - 1);
    }

private:
    void update_far() {
        last_far_ = largest(far_);
        far_end_ = _mm256_cvtss_f32(last_far_);
    }
    void update_ends() {
        first_near_ = smallest(near_, compared<_CMP_GE_OQ>(far_, _mm256_setzero_ps()));
        update_far();
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
        __m256 near = first_near_, far = last_far_;
        for (int a = 0; a < 3; ++a) {
            const __m256 to_near = near_planes[a] - near_origin_[a], to_far = far_planes[a] - far_origin_[a];
            near = _mm256_max_ps(near, _mm256_min_ps(to_near * inverse_min_[a], to_near * inverse_max_[a]));
            far = _mm256_min_ps(far, _mm256_max_ps(to_far * inverse_min_[a], to_far * inverse_max_[a]));
        }
        if (enters) _mm256_store_ps(enters, near);
        return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(near, far, _CMP_LE_OQ)));
    }

    static constexpr float kOff = 0x1p-21f;  ///< of a corner in float, found by an edge, and of a root a little outside

    // Of all rays, and of each.
    __m256 near_origin_[3], far_origin_[3], inverse_min_[3], inverse_max_[3], first_near_, last_far_;
    __m256 lane_near_origin_[3], lane_far_origin_[3], lane_near_inverse_[3], lane_far_inverse_[3];
    float far_end_ = 0;
    std::size_t near_planes_[3], far_planes_[3];
    Directions::Way way_;
};

}  // namespace rays::packets
