// Eight triangles side by side, in float: which of them a ray may meet, which it meets for certain, and between what.
//
// The test is step 1's: the triangles are sheared so that the ray runs along one axis (Woop, Benthin, Wald, "Watertight
// Ray/Triangle Intersection", JCGT 2(1), 2013). But of a triangle there is one corner and two edges instead of three
// corners: fewer operations, and what rounding may do to all eight is one product. It is added up beside the test.
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
    float corner[3][kWidth] = {};   ///< the first; axis, lane
    float edge[2][3][kWidth] = {};  ///< from there to the other two: off by what is rounded of a length, not of a place
    std::uint32_t count = 0;
    float reach = 0;    ///< no coordinate of a corner is larger
    float longest = 0;  ///< no coordinate of an edge is larger
    std::uint32_t primitive[kWidth] = {};
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
    const Vec3 edges[2] = {triangle.b - triangle.a, triangle.c - triangle.a};
    for (int a = 0; a < 3; ++a) {
        block.corner[a][lane] = static_cast<float>(triangle.a[a]);
        for (const Vec3& corner : {triangle.a, triangle.b, triangle.c})
            block.reach = std::max(block.reach, above(std::abs(corner[a])));
        for (int e = 0; e < 2; ++e) {
            block.edge[e][a][lane] = static_cast<float>(edges[e][a]);
            block.longest = std::max(block.longest, above(std::abs(edges[e][a])));
        }
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
        int z = size.y > size.x;  // no branches: who bounces may go any way
        z = size.z > std::max(size.x, size.y) ? 2 : z;
        static constexpr int kNext[4] = {1, 2, 0, 1};
        const int x = kNext[z], y = kNext[z + 1];
        const Real scale = 1 / ray.direction[z];
        reach_ = static_cast<float>(largest(glm::abs(ray.origin)));
        const auto axis = [&](int a) {
            return Axis{static_cast<std::size_t>(a), static_cast<float>(ray.origin[a]),
                        static_cast<float>(ray.direction[a] * scale)};
        };
        x_ = axis(x);
        y_ = axis(y);
        z_ = axis(z);
        scale_ = static_cast<float>(scale);
        has_scale_ = std::abs(scale_) > 0x1p-90f && std::abs(scale_) < 0x1p90f;
        near_ = below(range.min);
    }

    /// Of the roots between the ray's near end and `far`.
    TriangleRoots roots(const TriangleBlock& block, float far) const {
        const Sheared at(*this, block);
        TriangleRoots roots;
        // Most rays miss. For them one bound will do. It is a sum of the roundings below, with all coordinates as large
        // as they can be: 68 u reach longest for each of two weights, 60 u longest^2 for the sum of all three, and what
        // is rounded when the third is found from these, 24 and 16.
        const float reach = block.reach + reach_;
        const float roughly = kU * block.longest * (176 * reach + 80 * block.longest) + off_when_asked(reach) + kTiny;
        const Lanes least = at.least(), most = at.most();
        roots.may = ~outside(least, most, _mm256_set1_ps(roughly)) & ((1u << block.count) - 1);
        if (roots.may == 0) return roots;
        if (has_scale_)
            measure(at, least, most, reach, block.longest, far, roots);
        else
            _mm256_store_ps(roots.earliest, _mm256_set1_ps(-kMaxFloat));
        return roots;
    }

    /// A bit for each lane whose triangle may have a root between the ray's near end and `far`.
    unsigned may_meet(const TriangleBlock& block, float far) const { return roots(block, far).may; }

private:
    using Lanes = __m256;

    static constexpr float kTiny = std::numeric_limits<float>::min();  ///< more than all that vanishes below it

    static Real largest(const Vec3& v) { return std::max(v.x, std::max(v.y, v.z)); }
    static Lanes abs(Lanes v) { return _mm256_andnot_ps(_mm256_set1_ps(-0.0f), v); }
    static Lanes lowest(const Lanes (&v)[3]) { return _mm256_min_ps(v[0], _mm256_min_ps(v[1], v[2])); }
    static Lanes highest(const Lanes (&v)[3]) { return _mm256_max_ps(v[0], _mm256_max_ps(v[1], v[2])); }
    /// Of a weight as step 1 finds it, from the corners themselves: 7 eps / 2 of the reach in each of four coordinates,
    /// none longer than twice the reach, and 12 for the products. From very far away that finds roots that are none.
    static float off_when_asked(float reach) {
        return 64 * static_cast<float>(std::numeric_limits<Real>::epsilon()) * reach * reach;
    }
    /// A bit for each lane; none for what is no number.
    static unsigned less(Lanes a, Lanes b) {
        return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(a, b, _CMP_LT_OQ)));
    }
    /// Weights, off by up to `off`, of which one is negative for certain and another positive. Of what is no number
    /// nothing is certain.
    static unsigned outside(Lanes least, Lanes most, Lanes off) {
        return static_cast<unsigned>(_mm256_movemask_ps(
            _mm256_and_ps(_mm256_cmp_ps(least, -off, _CMP_LT_OQ), _mm256_cmp_ps(off, most, _CMP_LT_OQ))));
    }

    /// Triangles as seen from the ray's origin, sheared so that it runs along z.
    struct Sheared {
        Lanes x, y, z;                          ///< the first corner
        Lanes edge_x[2], edge_y[2], edge_z[2];  ///< from there to the others
        Lanes weight[3], sum;                   ///< of the corners where the ray passes, times their sum

        Sheared(const TriangleRay& ray, const TriangleBlock& block) {
            const Lanes shear_x = _mm256_set1_ps(ray.x_.shear), shear_y = _mm256_set1_ps(ray.y_.shear);
            const auto from_origin = [&](const Axis& a) {
                return _mm256_load_ps(block.corner[a.number]) - _mm256_set1_ps(a.origin);
            };
            z = from_origin(ray.z_);
            x = _mm256_fnmadd_ps(shear_x, z, from_origin(ray.x_));
            y = _mm256_fnmadd_ps(shear_y, z, from_origin(ray.y_));
            for (int e = 0; e < 2; ++e) {
                const auto& edge = block.edge[e];
                edge_z[e] = _mm256_load_ps(edge[ray.z_.number]);
                edge_x[e] = _mm256_fnmadd_ps(shear_x, edge_z[e], _mm256_load_ps(edge[ray.x_.number]));
                edge_y[e] = _mm256_fnmadd_ps(shear_y, edge_z[e], _mm256_load_ps(edge[ray.y_.number]));
            }
            const auto cross = [](Lanes ax, Lanes ay, Lanes bx, Lanes by) { return _mm256_fmsub_ps(ax, by, ay * bx); };
            sum = cross(edge_x[0], edge_y[0], edge_x[1], edge_y[1]);
            weight[1] = cross(edge_x[1], edge_y[1], x, y);
            weight[2] = cross(x, y, edge_x[0], edge_y[0]);
            weight[0] = sum - weight[1] - weight[2];
        }
        // Of weights that are no numbers the others are the answer; the first is none if another is none.
        Lanes least() const { return lowest(weight); }
        Lanes most() const { return highest(weight); }
    };

    /// Between what the roots are, and once more which there are, with the lanes' own coordinates.
    void measure(const Sheared& at, Lanes least, Lanes most, float reach, float longest, float far,
                 TriangleRoots& roots) const {
        // A sheared coordinate of the corner: corner and origin rounded, on both axes (2 u reach); the shear (u z), and
        // as many operations (2 u z, 2 u size). Here 3 and 4. Of an edge: itself on both axes, the shear, the
        // operation, 5 u longest; here 6.
        const Lanes size = _mm256_max_ps(abs(at.x), abs(at.y));
        const Lanes edge = _mm256_max_ps(_mm256_max_ps(abs(at.edge_x[0]), abs(at.edge_y[0])),
                                         _mm256_max_ps(abs(at.edge_x[1]), abs(at.edge_y[1])));
        const Lanes off = 4 * kU * (size + abs(at.z)) + 3 * kU * reach;
        // A weight is a difference of two products of these, 2 (edge off + 6 u longest size), and rounded, 6 u edge
        // size. The sum is one of two edges, which are no longer than twice the longest: 48 u longest^2, and 12.
        const Lanes off_weight = edge * (2.125f * off + 6 * kU * size) + 12.5f * kU * longest * size +
                                 40 * kU * longest * off + off_when_asked(reach) + kTiny;
        const float off_sum = 64 * kU * longest * longest + 3 * off_when_asked(reach) + kTiny;
        // The third is what the others leave: twice as far off, and rounded twice.
        const Lanes off_any = 2.5f * off_weight + 2 * off_sum;
        roots.may &= ~outside(least, most, off_any);
        const unsigned inside = less(off_any, least) | less(most, -off_any);

        // t is that of the corner and, along the edges, what their weights add.
        const Lanes inverse = 1.0f / at.sum;
        const Lanes added = _mm256_fmadd_ps(at.weight[1], at.edge_z[0], at.weight[2] * at.edge_z[1]) * inverse;
        const Lanes off_added =
            ((off_weight + 4 * kU * (abs(at.weight[1]) + abs(at.weight[2]))) * (abs(at.edge_z[0]) + abs(at.edge_z[1])) +
             off_sum * abs(added) + kTiny) *
            abs(inverse);
        const Lanes z = at.z + added;
        const Lanes about = scale_ * z;
        const Lanes off_about =
            std::abs(scale_) * (1.25f * off_added + 3 * kU * reach + 4 * kU * abs(added)) + 4 * kU * abs(about);
        Lanes earliest = about - off_about, latest = about + off_about;
        const Lanes known = _mm256_cmp_ps(_mm256_set1_ps(8 * off_sum), abs(at.sum), _CMP_LT_OQ);
        if ((roots.may & ~static_cast<unsigned>(_mm256_movemask_ps(known))) != 0) [[unlikely]] {
            // Where the sum is off by more than an eighth (edge-on, say), the root is anywhere between the corners.
            const Lanes ends[3] = {scale_ * at.z, scale_ * (at.z + at.edge_z[0]), scale_ * (at.z + at.edge_z[1])};
            const float off_end = 8 * kU * std::abs(scale_) * (reach + longest);
            earliest = _mm256_blendv_ps(lowest(ends) - off_end, earliest, known);
            latest = _mm256_blendv_ps(highest(ends) + off_end, latest, known);
        }

        const Lanes near = _mm256_set1_ps(near_), end = _mm256_set1_ps(far);
        roots.may &= ~(less(end, earliest) | less(latest, near));
        roots.must = roots.may & inside & less(near, earliest);
        _mm256_store_ps(roots.earliest, earliest);
        _mm256_store_ps(roots.latest, latest);
    }

    struct Axis {
        std::size_t number;
        float origin, shear;
    };
    Axis x_, y_, z_;  ///< z: the longest of the direction
    float reach_, scale_, near_;
    bool has_scale_;  ///< far from the ends of float, where roundings are no longer relative
};

}  // namespace rays::wide
