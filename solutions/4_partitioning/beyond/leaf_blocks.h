// What lies in a leaf, eight triangles (triangle_block.h), spheres or cones side by side, in float: one pass tells
// which of them a ray may meet, and only those are asked in Real. A block never hides a root: what rounding may have
// done is added up and allowed for. It also spares the memory: of what is not met, nothing but the block is read.
#pragma once

#include <immintrin.h>

#include <array>
#include <cstdint>
#include <optional>

#include "4_partitioning/beyond/box_ray.h"
#include "4_partitioning/beyond/float_box.h"
#include "4_partitioning/beyond/triangle_block.h"

namespace rays::wide {

// ---- What a block holds ---------------------------------------------------------------------------------------------

struct alignas(32) SphereBlock {
    float center[3][kWidth] = {};
    float radius[kWidth] = {};  ///< rounded up
    std::uint32_t primitive[kWidth] = {};
    std::uint32_t count = 0;
    float reach = 0;  ///< no coordinate of a surface is larger
};

/// Cones, and spheres among them: those have no axis.
struct alignas(32) ConeBlock {
    SphereBlock around;               ///< a ball about the middle of each
    float half_axis[3][kWidth] = {};  ///< from the middle to the cap
    float radius[kWidth] = {};        ///< the larger one, rounded up
};

/// How a leaf keeps its primitives.
enum class LeafKind : std::uint8_t { list, triangles, spheres, cones };

/// How a leaf keeps primitives of both kinds; nothing when it cannot.
inline std::optional<LeafKind> together(LeafKind a, LeafKind b) {
    const auto round = [](LeafKind k) { return k == LeafKind::spheres || k == LeafKind::cones; };
    if (a == b) return a;
    return round(a) && round(b) ? std::optional(LeafKind::cones) : std::nullopt;
}

/// Spheres, cones and triangles that are not moved go into blocks, everything else into lists. What a clip leaves of a
/// shape lies within it.
inline LeafKind leaf_kind(const Scene& scene, Primitive p) {
    const Object& object = scene.objects[p.object];
    if (object.transform != kNone) return LeafKind::list;
    switch (object.kind) {
        case ShapeKind::sphere: return LeafKind::spheres;
        case ShapeKind::cone: return LeafKind::cones;
        case ShapeKind::triangle:
        case ShapeKind::smooth_triangle:
        case ShapeKind::mesh: return LeafKind::triangles;
        default: return LeafKind::list;
    }
}

inline void put(SphereBlock& block, const Sphere& sphere, std::uint32_t primitive) {
    const std::uint32_t lane = block.count++;
    block.primitive[lane] = primitive;
    block.radius[lane] = above(sphere.radius);
    for (int a = 0; a < 3; ++a) {
        block.center[a][lane] = static_cast<float>(sphere.center[a]);
        block.reach = std::max(block.reach, above(std::abs(sphere.center[a]) + sphere.radius));
    }
}

inline void put(ConeBlock& block, const Cone& cone, std::uint32_t primitive) {
    const std::uint32_t lane = block.around.count;
    const Vec3 half_axis = Real(0.5) * (cone.cap - cone.base);
    const Real radius = std::max(cone.base_radius, cone.cap_radius);
    put(block.around, Sphere{cone.base + half_axis, glm::length(half_axis) + radius}, primitive);
    for (int a = 0; a < 3; ++a) block.half_axis[a][lane] = static_cast<float>(half_axis[a]);
    block.radius[lane] = above(radius);
}

inline void put(ConeBlock& block, const Sphere& sphere, std::uint32_t primitive) {
    block.radius[block.around.count] = above(sphere.radius);
    put(block.around, sphere, primitive);
}

// ---- Which of them a ray may meet -----------------------------------------------------------------------------------

/// A bit for each ball that a ray has certainly left by `near`: it starts on most of those that it meets behind it. The
/// centre is `along` the ray and, squared, `beside2` from it; no coordinate of ball and ray together is beyond `reach`.
inline unsigned left_before(__m256 near, __m256 along, __m256 beside2, __m256 radius, float reach) {
    const auto less = [](__m256 a, __m256 b) {
        return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(a, b, _CMP_LT_OQ)));
    };
    const unsigned behind = less(along, near);
    if (behind == 0) return 0;
    // Centre and origin rounded, on three axes (1.8 u reach), and what is computed from them (5 u of its size): so much
    // is `along` off, the distance beside twice that, and its square four times that and the radius. Here 2, 12 and 6.
    const __m256 size = _mm256_andnot_ps(_mm256_set1_ps(-0.0f), along) + radius;
    const __m256 off = 12 * kU * size + 2 * kU * reach;
    const __m256 most = radius + off, half_chord2 = most * (most + 6.0f * off) - beside2;
    const __m256 to_near = near - along - 2.0f * off;
    return behind & less(half_chord2, to_near * to_near) & less(_mm256_setzero_ps(), to_near);
}

/// A ray as blocks of spheres see it: how far it passes by their centres.
class SphereRay {
public:
    SphereRay(const Ray& ray, Interval range) {
        // Most directions have unit length, but for rounding that the margins allow for.
        const Real length2 = glm::dot(ray.direction, ray.direction);
        const bool is_unit = std::abs(length2 - 1) < Real(1e-9);
        length_ = is_unit ? 1 : std::sqrt(length2);
        const Real inverse = is_unit ? 1 : 1 / length_;
        for (int a = 0; a < 3; ++a) {
            origin_[a] = static_cast<float>(ray.origin[a]);
            direction_[a] = static_cast<float>(ray.direction[a] * inverse);
            reach_ = std::max(reach_, std::abs(origin_[a]));
        }
        near_ = below(range.min * length_);
    }

    unsigned may_meet(const SphereBlock& block, float far) const { return may_meet<true>(block, far); }

    /// Of the balls alone. That a ray leaves one is told only where it may be the ball's own surface that it starts on:
    /// around a cone it seldom is.
    template <bool leaves>
    unsigned may_meet(const SphereBlock& block, float far) const {
        // Of a coordinate, a projection, a distance: some ten roundings of what went in, as above.
        const __m256 off = _mm256_set1_ps(0x1p-19f * (block.reach + reach_));
        __m256 to_center[3], along = _mm256_setzero_ps(), beside2 = _mm256_setzero_ps();
        for (int a = 0; a < 3; ++a) {
            to_center[a] = _mm256_sub_ps(_mm256_load_ps(block.center[a]), _mm256_set1_ps(origin_[a]));
            along = _mm256_fmadd_ps(to_center[a], _mm256_set1_ps(direction_[a]), along);
        }
        for (int a = 0; a < 3; ++a) {
            const __m256 beside = _mm256_fnmadd_ps(along, _mm256_set1_ps(direction_[a]), to_center[a]);
            beside2 = _mm256_fmadd_ps(beside, beside, beside2);
        }
        // Not greater, not less: what is no number is asked.
        const __m256 reaches = _mm256_add_ps(_mm256_load_ps(block.radius), off);
        const __m256 met = _mm256_cmp_ps(beside2, _mm256_mul_ps(reaches, reaches), _CMP_NGT_UQ);
        const auto far_distance = static_cast<float>(far * length_);
        const __m256 before_far =
            _mm256_cmp_ps(_mm256_sub_ps(along, reaches), _mm256_set1_ps(far_distance), _CMP_NGT_UQ);
        const __m256 behind_near = _mm256_cmp_ps(_mm256_add_ps(along, reaches), _mm256_set1_ps(near_), _CMP_NLT_UQ);
        const __m256 all = _mm256_and_ps(met, _mm256_and_ps(before_far, behind_near));
        const unsigned balls = static_cast<unsigned>(_mm256_movemask_ps(all)) & ((1u << block.count) - 1);
        if (!leaves || balls == 0) return balls;
        return balls &
               ~left_before(_mm256_set1_ps(near_), along, beside2, _mm256_load_ps(block.radius), block.reach + reach_);
    }

    /// Balls first; of those that are met, the ones whose axis the ray passes by no farther than the radius: the
    /// distance of two lines is the part of what is between them along their common normal.
    unsigned may_meet(const ConeBlock& block, float far) const {
        const unsigned balls = may_meet<false>(block.around, far);
        if (balls == 0) return 0;
        __m256 between[3], axis[3];
        for (int a = 0; a < 3; ++a) {
            between[a] = _mm256_sub_ps(_mm256_load_ps(block.around.center[a]), _mm256_set1_ps(origin_[a]));
            axis[a] = _mm256_load_ps(block.half_axis[a]);
        }
        __m256 along_normal = _mm256_setzero_ps(), normal2 = along_normal, axis2 = along_normal;
        for (int a = 0; a < 3; ++a) {
            const int b = (a + 1) % 3, c = (a + 2) % 3;
            const __m256 normal = _mm256_fmsub_ps(_mm256_set1_ps(direction_[b]), axis[c],
                                                  _mm256_mul_ps(_mm256_set1_ps(direction_[c]), axis[b]));
            along_normal = _mm256_fmadd_ps(between[a], normal, along_normal);
            normal2 = _mm256_fmadd_ps(normal, normal, normal2);
            axis2 = _mm256_fmadd_ps(axis[a], axis[a], axis2);
        }
        // The parts of the product are as large as the reach and the axis: some ten roundings of those.
        const __m256 size =
            _mm256_mul_ps(_mm256_set1_ps(0x1p-18f * (block.around.reach + reach_)), _mm256_sqrt_ps(axis2));
        const __m256 most = _mm256_fmadd_ps(_mm256_load_ps(block.radius), _mm256_sqrt_ps(normal2), size);
        const __m256 distance = _mm256_andnot_ps(_mm256_set1_ps(-0.0f), along_normal);
        return balls & static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(distance, most, _CMP_NGT_UQ)));
    }

private:
    Real length_;
    std::array<float, 3> origin_, direction_;
    float reach_ = 0, near_;
};

}  // namespace rays::wide
