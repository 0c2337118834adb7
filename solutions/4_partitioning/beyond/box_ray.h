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
        const __m128 origin = in_lanes(ray.origin, 0), direction = in_lanes(ray.direction, 1);
        const __m128 sign_bit = _mm_set1_ps(-0.0f), sign = _mm_and_ps(direction, sign_bit);
        const auto clamped = [](__m128 v) {
            return _mm_min_ps(_mm_max_ps(v, _mm_set1_ps(-kMaxFloat)), _mm_set1_ps(kMaxFloat));
        };
        const __m128 inverse = clamped(_mm_div_ps(_mm_set1_ps(1), direction));
        // As above() and below(): one unit in the last place and more, forwards.
        const __m128 ulp = _mm_add_ps(_mm_mul_ps(_mm_andnot_ps(sign_bit, origin), _mm_set1_ps(0x1p-23f)),
                                      _mm_set1_ps(std::numeric_limits<float>::denorm_min()));
        const __m128 forward = _mm_xor_ps(ulp, sign);
        spread(_mm_mul_ps(inverse, _mm_set1_ps(1 - kSlack)), near_inverse_);
        spread(clamped(_mm_mul_ps(inverse, _mm_set1_ps(1 + kSlack))), far_inverse_);
        spread(_mm_add_ps(origin, forward), near_origin_);
        spread(_mm_sub_ps(origin, forward), far_origin_);
        const auto backward = static_cast<unsigned>(_mm_movemask_ps(direction));
        for (int a = 0; a < 3; ++a) {
            const std::size_t is_backward = backward >> a & 1;
            near_planes_[a] = Boxes::lower(a) + is_backward * Boxes::upper(0);
            far_planes_[a] = Boxes::upper(a) - is_backward * Boxes::upper(0);
        }
        near_ = _mm256_set1_ps(std::max(0.0f, below(range.min)));
        shorten(range.max);
    }

    void shorten(Real t) { end_at(t < kMaxFloat ? above(t) : kMaxFloat); }
    void end_at(float t) { far_ = _mm256_set1_ps(t); }

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
    static __m128 in_lanes(const Vec3& v, float fourth) {
        return _mm_setr_ps(static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), fourth);
    }
    static void spread(__m128 xyz, __m256 (&axes)[3]) {
        axes[0] = _mm256_broadcastss_ps(xyz);
        axes[1] = _mm256_broadcastss_ps(_mm_movehdup_ps(xyz));
        axes[2] = _mm256_broadcastss_ps(_mm_movehl_ps(xyz, xyz));
    }

    static constexpr float kSlack = 0x1p-20f;  ///< three roundings of 2^-24 each, and some
    __m256 near_origin_[3], far_origin_[3], near_inverse_[3], far_inverse_[3], near_, far_;
    std::size_t near_planes_[3], far_planes_[3];
};

}  // namespace rays::wide
