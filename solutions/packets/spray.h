// Rays that go different ways, as boxes see them: each ray is held against each box. In a scene of few boxes that is as
// quick as a beam, and nobody walks alone.
#pragma once

#include "packets/float_rays.h"

namespace rays::packets {

class Spray : public FloatRays {
public:
    Spray(const Rays& rays, Mask active, const Span& span) : FloatRays(rays, active, span.near, span.far) {
        for (int a = 0; a < 3; ++a) {
            const __m256 off = rounding_of(origin_[a]);
            less_[a] = origin_[a] - off;
            more_[a] = origin_[a] + off;
            inverse_[a] = clamped(_mm256_set1_ps(1) / direction_[a]);
        }
    }

    /// Not known: where the first ray of the eight enters a box says nothing of the others, and serves to sort only.
    static constexpr float far_end() { return std::numeric_limits<float>::infinity(); }

    void end_at(Reals far, Mask open) {
        FloatRays::end_at(far, open);
        is_as_it_was_ = false;
    }
    void look_between(Mask rays, Reals from, Reals to) {
        FloatRays::look_between(rays, from, to);
        is_as_it_was_ = false;
    }
    void leave_out(Mask rays) {
        FloatRays::leave_out(rays);
        is_as_it_was_ = false;
    }

    using FloatRays::rays_that_meet;
    /// Of a child that meets() has found.
    unsigned rays_that_meet(const wide::Node& node, unsigned child) const {
        if (is_as_it_was_) return kAllLanes;
        float enters;
        return rays_that_meet(node, child, enters);
    }

    /// A bit for each child whose box some ray may meet; where the first may enter, in `enters` (aligned).
    unsigned meets(const wide::Node& node, float* enters) const {
        const __m256 is_there = _mm256_cmp_ps(_mm256_load_ps(node.lo(0)), _mm256_load_ps(node.hi(0)), _CMP_LE_OQ);
        unsigned met = 0;
        for (auto rest = static_cast<unsigned>(_mm256_movemask_ps(is_there)); rest != 0; rest &= rest - 1) {
            const auto child = static_cast<unsigned>(__builtin_ctz(rest));
            if (rays_that_meet(node, child, enters[child]) != 0) met |= 1u << child;
        }
        return met;
    }

    /// Whom to hold against the rays one by one: all.
    unsigned meets(const wide::SphereBlock& block) const { return (1u << block.count) - 1; }
    unsigned meets(const wide::ConeBlock& block) const { return (1u << block.around.count) - 1; }
    unsigned meets(const wide::TriangleBlock& block) const { return (1u << block.count) - 1; }

private:
    unsigned rays_that_meet(const wide::Node& node, unsigned child, float& enters) const {
        __m256 near = near_, far = far_;
        for (int a = 0; a < 3; ++a) {
            const __m256 to_lo = (_mm256_broadcast_ss(&node.lo(a)[child]) - more_[a]) * inverse_[a];
            const __m256 to_hi = (_mm256_broadcast_ss(&node.hi(a)[child]) - less_[a]) * inverse_[a];
            near = _mm256_max_ps(near, _mm256_min_ps(to_lo, to_hi) * _mm256_set1_ps(1 - kSlack));
            far = _mm256_min_ps(far, _mm256_max_ps(to_lo, to_hi) * _mm256_set1_ps(1 + kSlack));
        }
        const __m256 met = _mm256_cmp_ps(near, far, _CMP_LE_OQ);
        enters = _mm256_cvtss_f32(near);
        return static_cast<unsigned>(_mm256_movemask_ps(met));
    }

    __m256 less_[3], more_[3], inverse_[3];
    bool is_as_it_was_ = true;  ///< all rays reach as far as when meets() was asked
};

}  // namespace rays::packets
