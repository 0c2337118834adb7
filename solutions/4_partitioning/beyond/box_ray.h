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
class alignas(32) Boxes {
public:
    void set(std::size_t lane, const FloatBox& box) {
        for (int a = 0; a < 3; ++a) {
            planes_[lower(a) + lane] = box.lo[static_cast<std::size_t>(a)];
            planes_[upper(a) + lane] = box.hi[static_cast<std::size_t>(a)];
        }
    }

    /// Where the eight lower planes across an axis begin, and the eight upper ones: who goes one way all along asks
    /// once.
    static std::size_t lower(int axis) { return static_cast<std::size_t>(axis) * kWidth; }
    static std::size_t upper(int axis) { return static_cast<std::size_t>(3 + axis) * kWidth; }
    const float* planes(std::size_t from) const { return planes_ + from; }
    const float* lo(int axis) const { return planes(lower(axis)); }
    const float* hi(int axis) const { return planes(upper(axis)); }

private:
    float planes_[6 * kWidth];
};

/// A ray as eight boxes at once see it. In float, with every rounding towards asking: the origin is two numbers, one
/// for the near planes and one for the far ones, and so is the inverse of the direction.
class BoxRay {
public:
    BoxRay(const Ray& ray, Interval range) {
        for (int a = 0; a < 3; ++a) {
            const auto d = static_cast<float>(ray.direction[a]);
            const bool is_positive = !std::signbit(d);
            near_planes_[a] = is_positive ? Boxes::lower(a) : Boxes::upper(a);
            far_planes_[a] = is_positive ? Boxes::upper(a) : Boxes::lower(a);
            const float inverse = std::clamp(1 / d, -kMaxFloat, kMaxFloat);
            near_inverse_[a] = _mm256_set1_ps(inverse * (1 - kSlack));
            far_inverse_[a] = _mm256_set1_ps(std::clamp(inverse * (1 + kSlack), -kMaxFloat, kMaxFloat));
            near_origin_[a] = _mm256_set1_ps(is_positive ? above(ray.origin[a]) : below(ray.origin[a]));
            far_origin_[a] = _mm256_set1_ps(is_positive ? below(ray.origin[a]) : above(ray.origin[a]));
        }
        near_ = _mm256_set1_ps(std::max(0.0f, below(range.min)));
        shorten(range.max);
    }

    void shorten(Real t) { far_ = _mm256_set1_ps(t < kMaxFloat ? above(t) : kMaxFloat); }

    /// A bit for each box that the ray meets; where it enters, in `enters`.
    unsigned meets(const Boxes& boxes, float (&enters)[kWidth]) const {
        __m256 near = near_, far = far_;
        for (int a = 0; a < 3; ++a) {
            const __m256 first = _mm256_load_ps(boxes.planes(near_planes_[a]));
            const __m256 last = _mm256_load_ps(boxes.planes(far_planes_[a]));
            near = _mm256_max_ps(near, _mm256_mul_ps(_mm256_sub_ps(first, near_origin_[a]), near_inverse_[a]));
            far = _mm256_min_ps(far, _mm256_mul_ps(_mm256_sub_ps(last, far_origin_[a]), far_inverse_[a]));
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
    std::size_t near_planes_[3], far_planes_[3];
};

}  // namespace rays::wide
