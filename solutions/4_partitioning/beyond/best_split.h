// Which plane parts best what is to be put into a tree: the binned surface area heuristic (Wald, "On fast Construction
// of SAH-based Bounding Volume Hierarchies", 2007). A box is two registers, one for each corner, so that one pass looks
// along all three axes at once.
#pragma once

#include <immintrin.h>

#include <bit>
#include <cstdint>
#include <span>

#include "4_partitioning/beyond/float_box.h"
#include "4_partitioning/beyond/leaf_blocks.h"

namespace rays::wide {

/// The corners of a box; their fourth lanes are nobody's.
struct Corners {
    __m128 lo = _mm_set1_ps(kMaxFloat), hi = _mm_set1_ps(-kMaxFloat);

    void add(const Corners& o) {
        lo = _mm_min_ps(lo, o.lo);
        hi = _mm_max_ps(hi, o.hi);
    }
    void add(__m128 point) { add({point, point}); }
    float half_area() const {
        const __m128 size = _mm_sub_ps(hi, lo);  // x y + y z + z x
        const __m128 products = _mm_mul_ps(size, _mm_shuffle_ps(size, size, _MM_SHUFFLE(3, 0, 2, 1)));
        const float xy = _mm_cvtss_f32(products), yz = _mm_cvtss_f32(_mm_movehdup_ps(products)),
                    zx = _mm_cvtss_f32(_mm_movehl_ps(products, products));
        return _mm_cvtss_f32(size) < 0 ? 0 : xy + yz + zx;
    }
    FloatBox box() const {
        alignas(16) float from[4], to[4];
        _mm_store_ps(from, lo);
        _mm_store_ps(to, hi);
        return {{from[0], from[1], from[2]}, {to[0], to[1], to[2]}};
    }
};

/// What goes into a tree: in the corners' fourth lanes its number and its kind.
class Item {
public:
    Item(const FloatBox& box, std::uint32_t primitive, LeafKind kind)
        : lo_(_mm_setr_ps(box.lo[0], box.lo[1], box.lo[2], std::bit_cast<float>(primitive))),
          hi_(_mm_setr_ps(box.hi[0], box.hi[1], box.hi[2], std::bit_cast<float>(static_cast<std::uint32_t>(kind)))) {}

    Corners corners() const { return {lo_, hi_}; }
    /// Twice the centre: it is only compared. The fourth lane is 0.
    __m128 center() const { return _mm_blend_ps(_mm_add_ps(lo_, hi_), _mm_setzero_ps(), 8); }
    std::uint32_t primitive() const { return fourth(lo_); }
    LeafKind kind() const { return static_cast<LeafKind>(fourth(hi_)); }

private:
    static std::uint32_t fourth(__m128 v) {
        return static_cast<std::uint32_t>(_mm_extract_epi32(_mm_castps_si128(v), 3));
    }
    __m128 lo_, hi_;
};

/// Between this bin and the next.
struct Split {
    int axis = -1;
    std::uint32_t bin = 0;
    float cost = kMaxFloat;
};

/// The centres of things in bins, along each axis where they differ.
class Bins {
public:
    Bins(const Corners& centers, std::uint32_t count) : count_(bins_for(count)), lo_(centers.lo) {
        scale_ = _mm_div_ps(_mm_set1_ps(static_cast<float>(count_)), _mm_sub_ps(centers.hi, centers.lo));
        const __m128 differ =
            _mm_and_ps(_mm_cmpgt_ps(scale_, _mm_setzero_ps()), _mm_cmplt_ps(scale_, _mm_set1_ps(kMaxFloat)));
        axes_ = static_cast<unsigned>(_mm_movemask_ps(differ)) & 7;
    }

    bool is_before(const Split& split, const Item& item) const {
        const __m128i behind = _mm_cmpgt_epi32(bins_of(item), _mm_set1_epi32(static_cast<int>(split.bin)));
        return (_mm_movemask_ps(_mm_castsi128_ps(behind)) >> split.axis & 1) == 0;
    }

    /// None where all centres coincide. cost_of(kind) is what asking a primitive costs, where opening a pair of boxes
    /// is 1.
    template <class CostOf>
    Split best_split(std::span<const Item> items, const CostOf& cost_of) const {
        Bin bins[3][kMostBins];
        for (const Item& item : items) {
            const __m128i bin = bins_of(item);
            const Corners corners = item.corners();
            const float cost = cost_of(item.kind());
            bins[0][_mm_extract_epi32(bin, 0)].add(corners, cost);
            bins[1][_mm_extract_epi32(bin, 1)].add(corners, cost);
            bins[2][_mm_extract_epi32(bin, 2)].add(corners, cost);
        }
        Split best;
        for (int axis = 0; axis < 3; ++axis)
            if (axes_ >> axis & 1) sweep(axis, bins[axis], static_cast<std::uint32_t>(items.size()), best);
        return best;
    }

private:
    struct Bin {
        Corners corners;
        float cost = 0;
        std::uint32_t count = 0;

        void add(const Corners& c, float k) {
            corners.add(c);
            cost += k;
            ++count;
        }
    };

    /// Fine ones are worth it among many (random triangles: 0.97 of a ray's time); among few they only take time.
    static constexpr std::uint32_t kMostBins = 32;
    static std::uint32_t bins_for(std::uint32_t count) { return count < 512 ? kMostBins / 2 : kMostBins; }

    /// Unsigned: what is no number comes last. The fourth lane is nobody's.
    __m128i bins_of(const Item& item) const {
        const __m128 place = _mm_mul_ps(_mm_sub_ps(item.center(), lo_), scale_);
        return _mm_min_epu32(_mm_cvttps_epi32(place), _mm_set1_epi32(static_cast<int>(count_ - 1)));
    }

    void sweep(int axis, const Bin* bins, std::uint32_t items, Split& best) const {
        float from_right[kMostBins];
        Bin right, left;
        for (std::uint32_t i = count_ - 1; i > 0; --i) {
            right.corners.add(bins[i].corners);
            right.cost += bins[i].cost;
            from_right[i] = right.cost * right.corners.half_area();
        }
        for (std::uint32_t i = 0; i + 1 < count_; ++i) {
            left.corners.add(bins[i].corners);
            left.cost += bins[i].cost;
            left.count += bins[i].count;
            const float cost = left.cost * left.corners.half_area() + from_right[i + 1];
            if (left.count > 0 && left.count < items && cost < best.cost) best = {axis, i, cost};
        }
    }

    std::uint32_t count_;
    __m128 lo_, scale_;
    unsigned axes_;  ///< a bit for each along which centres differ
};

}  // namespace rays::wide
