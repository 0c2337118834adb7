// Eight triangles side by side, in float: which of them a ray may meet, which it meets for certain, and between what.
//
// The test is step 1's: the triangles are sheared so that the ray runs along one axis (Woop, Benthin, Wald, "Watertight
// Ray/Triangle Intersection", JCGT 2(1), 2013). What rounding may have done is added up beside it.
#pragma once

#include <immintrin.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "4_partitioning/beyond/box_ray.h"
#include "4_partitioning/beyond/float_box.h"
#include "4_partitioning/primitive_tester.h"

namespace rays::wide {

struct alignas(64) TriangleBlock {
    float corner[3][3][kWidth] = {};  ///< corner, axis, lane
    std::uint32_t primitive[kWidth] = {};
    std::uint32_t count = 0;
    float reach = 0;  ///< no coordinate is larger
    // Where all are faces of one mesh, what asking them needs is known before they are looked up, and fetched.
    PrimitiveTester::Dispatch first = {};  ///< of the first of them
    bool is_of_one_mesh = false;
    std::uint32_t position[3][kWidth] = {};  ///< of each corner, in the mesh
};

/// The corners of a primitive of the kind `triangles`.
inline Triangle triangle_of(const Scene& scene, Primitive p) {
    const Object& object = scene.objects[p.object];
    if (object.kind == ShapeKind::triangle) return scene.triangles[object.shape];
    if (object.kind == ShapeKind::smooth_triangle) return scene.smooth_triangles[object.shape].triangle;
    const Mesh& mesh = scene.meshes[object.shape];
    const auto [a, b, c] = mesh.faces[p.part].position;
    return {mesh.positions[a], mesh.positions[b], mesh.positions[c]};
}

inline void put(TriangleBlock& block, const Triangle& triangle, std::uint32_t primitive) {
    const std::uint32_t lane = block.count++;
    block.primitive[lane] = primitive;
    const Vec3* corners[3] = {&triangle.a, &triangle.b, &triangle.c};
    for (int c = 0; c < 3; ++c)
        for (int a = 0; a < 3; ++a) {
            block.corner[c][a][lane] = static_cast<float>((*corners[c])[a]);
            block.reach = std::max(block.reach, above(std::abs((*corners[c])[a])));
        }
}

/// What a block knows about its roots.
struct TriangleRoots {
    unsigned may = 0;   ///< a bit for each lane that may have one
    unsigned must = 0;  ///< and that has one, unless its object says otherwise, by a clip or because it is a back face
    alignas(32) float earliest[kWidth];  ///< of those that may
    alignas(32) float latest[kWidth];    ///< of those that must; perhaps behind the end of the range
};

/// A ray as blocks of triangles see it.
class TriangleRay {
public:
    TriangleRay(const Ray& ray, Interval range) {
        const Vec3 size = glm::abs(ray.direction);
        z_ = size.y > size.x;  // no branches: who bounces may go any way
        z_ = size.z > std::max(size.x, size.y) ? 2 : z_;
        static constexpr int kNext[4] = {1, 2, 0, 1};
        x_ = kNext[z_];
        y_ = kNext[z_ + 1];
        const Real scale = 1 / ray.direction[z_];
        for (int a = 0; a < 3; ++a) {
            origin_[a] = static_cast<float>(ray.origin[a]);
            reach_ = std::max(reach_, std::abs(origin_[a]));
        }
        shear_x_ = static_cast<float>(ray.direction[x_] * scale);
        shear_y_ = static_cast<float>(ray.direction[y_] * scale);
        scale_ = static_cast<float>(scale);
        has_scale_ = std::abs(scale_) > 0x1p-90f && std::abs(scale_) < 0x1p90f;
        near_ = below(range.min);
    }

    /// Of the roots between the ray's near end and `far`.
    TriangleRoots roots(const TriangleBlock& block, float far) const {
        const __m256 ox = _mm256_set1_ps(origin_[x_]), oy = _mm256_set1_ps(origin_[y_]),
                     oz = _mm256_set1_ps(origin_[z_]);
        const __m256 shear_x = _mm256_set1_ps(shear_x_), shear_y = _mm256_set1_ps(shear_y_);
        __m256 x[3], y[3], z[3], size = _mm256_setzero_ps();
        for (int c = 0; c < 3; ++c) {
            z[c] = _mm256_load_ps(block.corner[c][z_]) - oz;
            x[c] = _mm256_fnmadd_ps(shear_x, z[c], _mm256_load_ps(block.corner[c][x_]) - ox);
            y[c] = _mm256_fnmadd_ps(shear_y, z[c], _mm256_load_ps(block.corner[c][y_]) - oy);
            size = _mm256_max_ps(size, _mm256_max_ps(abs(x[c]), abs(y[c])));
        }
        const auto edge = [&](int i, int j) { return _mm256_fmsub_ps(x[i], y[j], y[i] * x[j]); };
        const __m256 w[3] = {edge(1, 2), edge(2, 0), edge(0, 1)};

        TriangleRoots roots;
        // Most rays miss. For them one bound will do: no coordinate is off by more than 16 u of all that went in.
        const float reach = block.reach + reach_;
        const __m256 roughly = off_edge(_mm256_set1_ps(16 * kU * reach), size);
        roots.may = ~(less(least(w), -roughly) & less(roughly, most(w))) & ((1u << block.count) - 1);
        if (roots.may == 0) return roots;
        if (has_scale_)
            measure(w, z, size, reach, far, roots);
        else
            _mm256_store_ps(roots.earliest, _mm256_set1_ps(-kMaxFloat));
        return roots;
    }

    /// A bit for each lane whose triangle may have a root between the ray's near end and `far`.
    unsigned may_meet(const TriangleBlock& block, float far) const { return roots(block, far).may; }

private:
    using Lanes = __m256;

    static constexpr float kTiny = std::numeric_limits<float>::min();  ///< more than all that vanishes below it

    static Lanes abs(Lanes v) { return _mm256_andnot_ps(_mm256_set1_ps(-0.0f), v); }
    /// A bit for each lane; none for what is no number.
    static unsigned less(Lanes a, Lanes b) {
        return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(a, b, _CMP_LT_OQ)));
    }
    static Lanes least(const Lanes (&v)[3]) { return _mm256_min_ps(v[0], _mm256_min_ps(v[1], v[2])); }
    static Lanes most(const Lanes (&v)[3]) { return _mm256_max_ps(v[0], _mm256_max_ps(v[1], v[2])); }

    /// Of an edge function whose coordinates, no larger than `size`, are off by up to `off`: that times four of them,
    /// and three roundings of the products, which are less than a fifth.
    static Lanes off_edge(Lanes off, Lanes size) { return off * (5.0f * size + 2.0f * off) + kTiny; }

    /// The root is the mean of the corners' t with the weights w. To know how far it may be off, it is found twice:
    /// once anywhere near (`about`), once as the distance from there, with the errors of the weights and of the
    /// corners' t.
    void measure(const Lanes (&w)[3], const Lanes (&z)[3], Lanes size, float reach, float far,
                 TriangleRoots& roots) const {
        // A sheared coordinate: corner and origin rounded, on both axes (2 u reach); the shear (u z), and as many
        // operations (2 u z, 2 u size). Here 3 and 4. The corners' t are as far off, times the scale.
        const Lanes depths[3] = {abs(z[0]), abs(z[1]), abs(z[2])};
        const Lanes off = 4 * kU * (most(depths) + size) + 3 * kU * reach;
        const Lanes off_w = off_edge(off, size), off_sum = 4.0f * off_w, off_t = 2 * std::abs(scale_) * off;
        const Lanes sum = w[0] + (w[1] + w[2]), inverse = 1.0f / sum;
        const auto weighed = [&](const Lanes(&t)[3]) {
            return _mm256_fmadd_ps(w[0], t[0], _mm256_fmadd_ps(w[1], t[1], w[2] * t[2]));
        };
        const Lanes t[3] = {scale_ * z[0], scale_ * z[1], scale_ * z[2]};
        const Lanes about = weighed(t) * inverse;
        const Lanes from[3] = {t[0] - about, t[1] - about, t[2] - about};
        const Lanes distances[3] = {abs(from[0]), abs(from[1]), abs(from[2])};
        const Lanes off_weighed = abs(weighed(from)) + off_sum * most(distances) +
                                  off_t * (abs(w[0]) + abs(w[1]) + abs(w[2]) + off_sum) + kTiny;
        // Where the sum is off by more than an eighth (edge-on, say), the root is anywhere between the corners.
        const Lanes off_about = 1.25f * off_weighed * abs(inverse) + 4 * kU * abs(about);
        const Lanes known = _mm256_cmp_ps(8.0f * off_sum, abs(sum), _CMP_LT_OQ);
        const Lanes earliest = _mm256_blendv_ps(least(t) - off_t, about - off_about, known);
        const Lanes latest = _mm256_blendv_ps(most(t) + off_t, about + off_about, known);

        const Lanes near = _mm256_set1_ps(near_), end = _mm256_set1_ps(far);
        roots.may &= ~(less(end, earliest) | less(latest, near));
        const unsigned inside = less(off_w, least(w)) | less(most(w), -off_w);
        roots.must = roots.may & inside & less(near, earliest);
        _mm256_store_ps(roots.earliest, earliest);
        _mm256_store_ps(roots.latest, latest);
    }

    int x_, y_, z_;
    std::array<float, 3> origin_;
    float reach_ = 0, shear_x_, shear_y_, scale_, near_;
    bool has_scale_;  ///< far from the ends of float, where roundings are no longer relative
};

}  // namespace rays::wide
