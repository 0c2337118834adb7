// Eight boxes side by side, and a ray that is held against all of them at once, in float. They only decide whom to ask.
#pragma once

#include <immintrin.h>

#include <algorithm>
#include <cmath>

#include "4_partitioning/beyond/float_box.h"
#include "core/ray.h"

namespace rays::wide {

inline constexpr int kWidth = 8;

/// Lane by lane. Who is not there has the empty box, which no ray meets.
struct alignas(32) Boxes {
    float lo[3][kWidth], hi[3][kWidth];

    void set(std::size_t lane, const FloatBox& box) {
        for (int a = 0; a < 3; ++a) {
            lo[a][lane] = box.lo[static_cast<std::size_t>(a)];
            hi[a][lane] = box.hi[static_cast<std::size_t>(a)];
        }
    }
};

/// A ray as eight boxes at once see it. In float, with every rounding towards asking: the origin is two numbers, one
/// for the near planes and one for the far ones, and so is the inverse of the direction.
class BoxRay {
public:
    BoxRay(const Ray& ray, Interval range) {
        for (int a = 0; a < 3; ++a) {
            const auto d = static_cast<float>(ray.direction[a]);
            positive_[a] = !std::signbit(d);
            const float inverse = std::clamp(1 / d, -kMaxFloat, kMaxFloat);
            near_inverse_[a] = _mm256_set1_ps(inverse * (1 - kSlack));
            far_inverse_[a] = _mm256_set1_ps(std::clamp(inverse * (1 + kSlack), -kMaxFloat, kMaxFloat));
            near_origin_[a] = _mm256_set1_ps(positive_[a] ? above(ray.origin[a]) : below(ray.origin[a]));
            far_origin_[a] = _mm256_set1_ps(positive_[a] ? below(ray.origin[a]) : above(ray.origin[a]));
        }
        near_ = _mm256_set1_ps(std::max(0.0f, below(range.min)));
        shorten(range.max);
    }

    void shorten(Real t) { far_ = _mm256_set1_ps(t < kMaxFloat ? above(t) : kMaxFloat); }

    /// A bit for each box that the ray meets; where it enters, in `enters`.
    unsigned meets(const Boxes& boxes, float (&enters)[kWidth]) const {
        __m256 near = near_, far = far_;
        for (int a = 0; a < 3; ++a) {
            const __m256 lo = _mm256_load_ps(positive_[a] ? boxes.lo[a] : boxes.hi[a]);
            const __m256 hi = _mm256_load_ps(positive_[a] ? boxes.hi[a] : boxes.lo[a]);
            near = _mm256_max_ps(near, _mm256_mul_ps(_mm256_sub_ps(lo, near_origin_[a]), near_inverse_[a]));
            far = _mm256_min_ps(far, _mm256_mul_ps(_mm256_sub_ps(hi, far_origin_[a]), far_inverse_[a]));
        }
        _mm256_store_ps(enters, near);
        return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(near, far, _CMP_LE_OQ)));
    }

    unsigned meets(const Boxes& boxes) const {
        alignas(32) float enters[kWidth];
        return meets(boxes, enters);
    }

private:
    static constexpr float kSlack = 0x1p-20f;  ///< three roundings of 2^-24 each, and some
    __m256 near_origin_[3], far_origin_[3], near_inverse_[3], far_inverse_[3], near_, far_;
    bool positive_[3];
};

}  // namespace rays::wide
