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
    Beam(const Rays& rays, Mask active, Real near, Real far) {
        for (int a = 0; a < 3; ++a) {
            const Range origin = over(active, rays.origin[a]), direction = over(active, rays.direction[a]);
            const bool positive = direction.min >= 0;
            if (!positive && !(direction.max < 0)) return;
            if (direction.min == 0 && direction.max > 0) return;
            near_origin_[a] = _mm256_set1_ps(positive ? above(origin.max) : below(origin.min));
            far_origin_[a] = _mm256_set1_ps(positive ? below(origin.min) : above(origin.max));
            const auto inverse = [&](Real d, float slack) {
                return std::clamp(static_cast<float>(1 / (positive ? std::abs(d) : d)) * slack, -kMaxFloat, kMaxFloat);
            };
            const float less = positive ? 1 - kSlack : 1 + kSlack, more = positive ? 1 + kSlack : 1 - kSlack;
            inverse_min_[a] = _mm256_set1_ps(inverse(direction.max, less));
            inverse_max_[a] = _mm256_set1_ps(inverse(direction.min, more));
            positive_[a] = positive;
        }
        // The longest axis of the rays, where it is the same for all: what triangles are sheared along.
        const Vec3s size{abs(rays.direction.x), abs(rays.direction.y), abs(rays.direction.z)};
        const Mask by_x = (size.x >= size.y) & (size.x >= size.z), by_y = size.y >= size.z;
        const unsigned x = (by_x & active).bits(), y = ((by_y - by_x) & active).bits(), all = active.bits();
        longest_axis_ = x == all ? 0 : y == all ? 1 : (x | y) == 0 ? 2 : -1;
        is_coherent_ = longest_axis_ >= 0;
        near_ = _mm256_set1_ps(std::max(0.0f, below(near)));
        shorten(far);
    }

    /// False when the rays do not go the same way along every axis: then nothing else may be asked.
    bool is_coherent() const { return is_coherent_; }
    int longest_axis() const { return longest_axis_; }
    void shorten(Real t) {
        far_end_ = t < kMaxFloat ? above(t) : kMaxFloat;
        far_ = _mm256_set1_ps(far_end_);
    }
    float far_end() const { return far_end_; }

    /// A bit for each child whose box some ray may meet; where the first may enter, in `enters`.
    unsigned meets(const wide::Node& node, float* enters) const {
        __m256 lo[3], hi[3];
        for (int a = 0; a < 3; ++a) {
            lo[a] = _mm256_load_ps(node.lo[a]);
            hi[a] = _mm256_load_ps(node.hi[a]);
        }
        return meets(lo, hi, enters);
    }

    unsigned meets(const wide::SphereBlock& block) const {
        const __m256 wider = _mm256_add_ps(_mm256_load_ps(block.radius), _mm256_set1_ps(block.reach * kOff));
        __m256 lo[3], hi[3];
        for (int a = 0; a < 3; ++a) {
            lo[a] = _mm256_sub_ps(_mm256_load_ps(block.center[a]), wider);
            hi[a] = _mm256_add_ps(_mm256_load_ps(block.center[a]), wider);
        }
        return meets(lo, hi, nullptr) & ((1u << block.count) - 1);
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
        return meets(lo, hi, nullptr) & ((1u << block.count) - 1);
    }

private:
    struct Range {
        Real min, max;
    };
    static Range over(Mask active, Reals values) {
        return {smallest(select(active, values, Reals(kInfinity))), largest(select(active, values, Reals(-kInfinity)))};
    }

    unsigned meets(const __m256 (&lo)[3], const __m256 (&hi)[3], float* enters) const {
        __m256 near = near_, far = far_;
        for (int a = 0; a < 3; ++a) {
            const __m256 to_near = _mm256_sub_ps(positive_[a] ? lo[a] : hi[a], near_origin_[a]);
            const __m256 to_far = _mm256_sub_ps(positive_[a] ? hi[a] : lo[a], far_origin_[a]);
            near = _mm256_max_ps(near, _mm256_min_ps(_mm256_mul_ps(to_near, inverse_min_[a]),
                                                     _mm256_mul_ps(to_near, inverse_max_[a])));
            far = _mm256_min_ps(far, _mm256_max_ps(_mm256_mul_ps(to_far, inverse_min_[a]),
                                                   _mm256_mul_ps(to_far, inverse_max_[a])));
        }
        if (enters) _mm256_store_ps(enters, near);
        return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(near, far, _CMP_LE_OQ)));
    }

    static constexpr float kSlack = 0x1p-20f;  ///< three roundings of 2^-24 each, and some
    static constexpr float kOff = 0x1p-21f;    ///< of a corner in float, and of a root that lies a little outside

    __m256 near_origin_[3], far_origin_[3], inverse_min_[3], inverse_max_[3], near_, far_;
    float far_end_ = 0;
    int longest_axis_ = -1;
    bool positive_[3];
    bool is_coherent_ = false;
};

}  // namespace rays::packets
