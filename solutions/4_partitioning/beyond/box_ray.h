// Eight boxes side by side, and a ray that is held against all of them at once, in float. They only decide whom to ask.
#pragma once

#include <immintrin.h>

#include <algorithm>
#include <array>
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
    static constexpr std::size_t lower(int axis) { return static_cast<std::size_t>(axis) * kWidth; }
    static constexpr std::size_t upper(int axis) { return static_cast<std::size_t>(3 + axis) * kWidth; }
    const float* planes(std::size_t from) const { return planes_ + from; }
    const float* lo(int axis) const { return planes(lower(axis)); }
    const float* hi(int axis) const { return planes(upper(axis)); }

private:
    float planes_[6 * kWidth];
};

/// A ray as eight boxes at once see it, in float, with every rounding towards asking. A plane is at
/// t = plane / d - o / d: one operation, which waits less than o subtracted first, but rounds o / d, so that a plane
/// seems as much nearer or farther as a rounding of o is. That is less than boxes are widened by.
class BoxRay {
public:
    BoxRay(const Ray& ray, Interval range) {
        const __m128 origin = in_lanes(ray.origin), direction = in_lanes(ray.direction);
        const __m128 sign_bit = _mm_set1_ps(-0.0f);
        const auto abs = [&](__m128 v) { return _mm_andnot_ps(sign_bit, v); };
        // What runs along a box leaves it very late; how late is a number all the same.
        const __m128 least = _mm_mul_ps(largest(abs(direction)), _mm_set1_ps(0x1p-100f));
        const __m128 inverse =
            _mm_div_ps(_mm_set1_ps(1), _mm_or_ps(_mm_max_ps(abs(direction), least), _mm_and_ps(direction, sign_bit)));
        const __m128 near_inverse = _mm_mul_ps(inverse, _mm_set1_ps(1 - kSlack)),
                     far_inverse = _mm_mul_ps(inverse, _mm_set1_ps(1 + kSlack));
        const __m128 near_t = _mm_mul_ps(origin, near_inverse), far_t = _mm_mul_ps(origin, far_inverse);
        // The origin rounded, the product rounded, and added: 3 u. Here 4.
        const __m128 off =
            _mm_add_ps(_mm_mul_ps(abs(far_t), _mm_set1_ps(0x1p-22f)), _mm_set1_ps(std::numeric_limits<float>::min()));
        // Beyond float, an axis tells nothing: all boxes are met, at once and for ever.
        const __m128 tells = _mm_cmplt_ps(abs(far_t), _mm_set1_ps(kNever));
        const auto if_it_tells = [&](__m128 v, float otherwise) {
            return _mm_blendv_ps(_mm_set1_ps(otherwise), v, tells);
        };
        spread(if_it_tells(near_inverse, 0), near_inverse_);
        spread(if_it_tells(far_inverse, 0), far_inverse_);
        spread(if_it_tells(_mm_xor_ps(_mm_add_ps(near_t, off), sign_bit), 0), near_add_);
        spread(if_it_tells(_mm_sub_ps(off, far_t), kNever), far_add_);
        order_ = &kOrders[static_cast<std::size_t>(_mm_movemask_ps(direction)) & 7];
        near_ = _mm256_set1_ps(std::max(0.0f, below(range.min)));
        shorten(range.max);
    }

    void shorten(Real t) { end_at(above(t)); }
    void end_at(float t) { far_ = _mm256_set1_ps(t); }

    /// A bit for each box that the ray meets; where it enters, in `enters`.
    ///
    /// Compared as integers, whose maxima take one cycle where those of floats take four: of floats that are not
    /// negative the greater has the greater bits, negative ones are less than all of these, and the near end is not
    /// negative.
    unsigned meets(const Boxes& boxes, float (&enters)[kWidth]) const {
        const auto t = [&](std::size_t planes, __m256 inverse, __m256 add) {
            return _mm256_castps_si256(_mm256_fmadd_ps(_mm256_load_ps(boxes.planes(planes)), inverse, add));
        };
        __m256i near = _mm256_castps_si256(near_), far = _mm256_castps_si256(far_);
        for (int a = 0; a < 3; ++a) {
            near = _mm256_max_epi32(near, t(order_->near[a], near_inverse_[a], near_add_[a]));
            far = _mm256_min_epi32(far, t(order_->far[a], far_inverse_[a], far_add_[a]));
        }
        _mm256_store_si256(reinterpret_cast<__m256i*>(enters), near);
        return 0xff ^ static_cast<unsigned>(_mm256_movemask_ps(_mm256_castsi256_ps(_mm256_cmpgt_epi32(near, far))));
    }

    unsigned meets(const Boxes& boxes) const {
        alignas(32) float enters[kWidth];
        return meets(boxes, enters);
    }

private:
    static __m128 in_lanes(const Vec3& v) {
        const auto x = static_cast<float>(v.x), y = static_cast<float>(v.y), z = static_cast<float>(v.z);
        return _mm_setr_ps(x, y, z, z);
    }
    /// Of x, y, z, z: in all lanes.
    static __m128 largest(__m128 v) {
        const __m128 pairs = _mm_max_ps(v, _mm_movehdup_ps(v)), all = _mm_max_ps(pairs, _mm_movehl_ps(pairs, pairs));
        return _mm_shuffle_ps(all, all, 0);
    }
    static void spread(__m128 xyz, __m256 (&axes)[3]) {
        axes[0] = _mm256_broadcastss_ps(xyz);
        axes[1] = _mm256_broadcastss_ps(_mm_movehdup_ps(xyz));
        axes[2] = _mm256_broadcastss_ps(_mm_movehl_ps(xyz, xyz));
    }

    /// Across each axis, the planes that a ray meets first and those that it meets last.
    struct Order {
        std::size_t near[3], far[3];
    };
    /// By the signs of its direction.
    static constexpr std::array<Order, 8> kOrders = [] {
        std::array<Order, 8> orders{};
        for (unsigned signs = 0; signs < 8; ++signs)
            for (int a = 0; a < 3; ++a) {
                const bool is_backward = signs >> a & 1;
                orders[signs].near[a] = is_backward ? Boxes::upper(a) : Boxes::lower(a);
                orders[signs].far[a] = is_backward ? Boxes::lower(a) : Boxes::upper(a);
            }
        return orders;
    }();

    static constexpr float kNever = std::numeric_limits<float>::infinity();
    static constexpr float kSlack = 0x1p-20f;  ///< of the inverse: roundings of 2^-24 each, and some
    __m256 near_inverse_[3], near_add_[3], far_inverse_[3], far_add_[3], near_, far_;
    const Order* order_;
};

}  // namespace rays::wide
