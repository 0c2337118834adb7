// Beyond the step: a bounding volume hierarchy with eight children a node, its boxes in float, tested eight at once.
//
// Boxes only decide whom to ask; the shared test of a primitive, in `Real`, gives the answer. So boxes may be coarse as
// long as they never hide a root: every rounding errs towards asking.
#include <immintrin.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <future>
#include <limits>
#include <numeric>

#include "4_partitioning/primitive_tester.h"
#include "4_partitioning/structures.h"
#include "core/unfinished.h"

namespace rays {

//> hidden
namespace {

constexpr float kMaxFloat = std::numeric_limits<float>::max();
constexpr int kWidth = 8;

// ---- Boxes in float -------------------------------------------------------------------------------------------------

// One unit in the last place and more, without a call of nextafter: this is done for every ray.
float below(Real v) {
    const auto f = static_cast<float>(v);
    return f - (std::abs(f) * 0x1p-23f + std::numeric_limits<float>::denorm_min());
}
float above(Real v) {
    const auto f = static_cast<float>(v);
    return f + (std::abs(f) * 0x1p-23f + std::numeric_limits<float>::denorm_min());
}

struct FloatBox {
    std::array<float, 3> lo{kMaxFloat, kMaxFloat, kMaxFloat}, hi{-kMaxFloat, -kMaxFloat, -kMaxFloat};

    void add(const FloatBox& o) {
        for (int a = 0; a < 3; ++a) {
            lo[a] = std::min(lo[a], o.lo[a]);
            hi[a] = std::max(hi[a], o.hi[a]);
        }
    }
    float half_area() const {
        const float x = hi[0] - lo[0], y = hi[1] - lo[1], z = hi[2] - lo[2];
        return x < 0 ? 0 : x * y + y * z + z * x;
    }
};

/// Widened so that a root computed a little outside of the true box is still found: relative to the coordinates, and by
/// an absolute sliver for boxes that touch a coordinate plane and rays that run in it.
FloatBox widened(const Bounds& b) {
    FloatBox box;
    for (int a = 0; a < 3; ++a) {
        const Real slack = Real(1e-7) * std::max(std::abs(b.min[a]), std::abs(b.max[a])) + Real(1e-18);
        box.lo[a] = below(b.min[a] - slack);
        box.hi[a] = above(b.max[a] + slack);
    }
    return box;
}

// ---- Nodes ----------------------------------------------------------------------------------------------------------

/// Eight children: boxes lane by lane, and what is in each. count 0: an inner node, or, with the empty box, nobody.
struct alignas(64) Node {
    float lo[3][kWidth], hi[3][kWidth];
    std::uint32_t child[kWidth];
    std::uint8_t count[kWidth];
};

// ---- Build: binned surface area heuristic (Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies",
// 2007), binary first, then collapsed to eight children (Wald, Benthin, Boulos, "Getting Rid of Packets", 2008) ---------

constexpr std::uint32_t kBins = 16, kMostInLeaf = 2;
constexpr std::uint32_t kParallelFrom = 8192;  ///< below, a thread costs more than it saves

struct BinaryNode {
    FloatBox box;
    std::uint32_t begin = 0, end = 0;    ///< of a leaf
    std::uint32_t left = 0, right = 0;   ///< of an inner node; right 0: a leaf
};

struct Item {
    FloatBox box;
    std::uint32_t primitive;
    float center(int a) const { return box.lo[a] + box.hi[a]; }  // twice the centre: only compared
};

class Builder {
public:
    explicit Builder(std::vector<Item> items) : items_(std::move(items)), nodes_(2 * items_.size()) {
        if (!items_.empty()) split(0, 0, static_cast<std::uint32_t>(items_.size()), 0);
    }

    void collapse_into(std::vector<Node>& wide, std::vector<std::uint32_t>& order) {
        order.reserve(items_.size());
        if (!items_.empty()) collapse(0, wide, order);
    }
    const FloatBox& root_box() const { return nodes_[0].box; }

private:
    struct Bin {
        FloatBox box;
        std::uint32_t count = 0;
    };
    struct Plane {
        int axis = -1;
        std::uint32_t bin = 0;
        float cost = kMaxFloat;
    };

    // A subtree of n items needs at most 2 n - 1 nodes, so the place of each follows from where its items begin: threads
    // share nothing, and the tree does not depend on them.
    void split(std::uint32_t index, std::uint32_t begin, std::uint32_t end, int depth) {
        BinaryNode& node = nodes_[index];
        node = {};
        FloatBox centers;
        for (std::uint32_t i = begin; i < end; ++i) {
            node.box.add(items_[i].box);
            FloatBox c;
            for (int a = 0; a < 3; ++a) c.lo[a] = c.hi[a] = items_[i].center(a);
            centers.add(c);
        }
        node.begin = begin;
        node.end = end;
        const std::uint32_t count = end - begin;
        if (count == 1) return;
        const Plane plane = best_plane(begin, end, centers);
        const float leaf_cost = static_cast<float>(count) * node.box.half_area();
        if (count <= kMostInLeaf && !(plane.cost + node.box.half_area() < leaf_cost)) return;
        std::uint32_t middle = begin + count / 2;
        if (plane.axis >= 0 && depth < 64) {
            const auto first = items_.begin() + begin, last = items_.begin() + end;
            const auto mid = std::partition(first, last, [&](const Item& item) {
                return bin_of(item, plane.axis, centers) <= plane.bin;
            });
            middle = static_cast<std::uint32_t>(mid - items_.begin());
        } else if (count <= kMostInLeaf) {
            return;
        }  // else all centres coincide: any halves will do
        node.left = index + 1;
        node.right = index + 2 * (middle - begin);
        if (count >= kParallelFrom && depth < 4) {
            auto other = std::async(std::launch::async, [this, &node, begin, middle, depth] { split(node.left, begin, middle, depth + 1); });
            split(node.right, middle, end, depth + 1);
            other.get();
        } else {
            split(node.left, begin, middle, depth + 1);
            split(node.right, middle, end, depth + 1);
        }
    }

    static std::uint32_t bin_of(const Item& item, int axis, const FloatBox& centers) {
        const float extent = centers.hi[axis] - centers.lo[axis];
        const float place = (item.center(axis) - centers.lo[axis]) / extent * kBins;
        return std::min(kBins - 1, static_cast<std::uint32_t>(place));
    }

    Plane best_plane(std::uint32_t begin, std::uint32_t end, const FloatBox& centers) const {
        Plane best;
        for (int axis = 0; axis < 3; ++axis) {
            const float extent = centers.hi[axis] - centers.lo[axis];
            if (!(extent > 0) || !(extent < kMaxFloat)) continue;
            std::array<Bin, kBins> bins;
            for (std::uint32_t i = begin; i < end; ++i) {
                Bin& bin = bins[bin_of(items_[i], axis, centers)];
                bin.box.add(items_[i].box);
                ++bin.count;
            }
            std::array<float, kBins> from_right{};
            Bin right;
            for (std::uint32_t i = kBins - 1; i > 0; --i) {
                right.box.add(bins[i].box);
                right.count += bins[i].count;
                from_right[i] = static_cast<float>(right.count) * right.box.half_area();
            }
            Bin left;
            for (std::uint32_t i = 0; i + 1 < kBins; ++i) {
                left.box.add(bins[i].box);
                left.count += bins[i].count;
                const float cost = static_cast<float>(left.count) * left.box.half_area() + from_right[i + 1];
                if (left.count > 0 && left.count < end - begin && cost < best.cost) best = {axis, i, cost};
            }
        }
        return best;
    }

    bool is_leaf(std::uint32_t index) const { return nodes_[index].right == 0; }

    /// Opens the largest inner child until there are eight.
    std::uint32_t collapse(std::uint32_t root, std::vector<Node>& wide, std::vector<std::uint32_t>& order) {
        std::array<std::uint32_t, kWidth> children{root};
        int count = 1;
        while (count < kWidth) {
            int largest = -1;
            for (int i = 0; i < count; ++i)
                if (!is_leaf(children[i]) &&
                    (largest < 0 || nodes_[children[i]].box.half_area() > nodes_[children[largest]].box.half_area()))
                    largest = i;
            if (largest < 0) break;
            const BinaryNode& opened = nodes_[children[largest]];
            children[largest] = opened.left;
            children[count++] = opened.right;
        }
        const auto index = static_cast<std::uint32_t>(wide.size());
        wide.emplace_back();
        for (int i = 0; i < kWidth; ++i) {
            const FloatBox box = i < count ? nodes_[children[i]].box : FloatBox{};
            for (int a = 0; a < 3; ++a) {
                wide[index].lo[a][i] = box.lo[a];
                wide[index].hi[a][i] = box.hi[a];
            }
            wide[index].child[i] = 0;
            wide[index].count[i] = 0;
            if (i >= count) continue;
            const BinaryNode& node = nodes_[children[i]];
            if (is_leaf(children[i])) {
                wide[index].child[i] = static_cast<std::uint32_t>(order.size());
                wide[index].count[i] = static_cast<std::uint8_t>(node.end - node.begin);
                for (std::uint32_t k = node.begin; k < node.end; ++k) order.push_back(items_[k].primitive);
            } else {
                const std::uint32_t child = collapse(children[i], wide, order);
                wide[index].child[i] = child;
            }
        }
        return index;
    }

    std::vector<Item> items_;
    std::vector<BinaryNode> nodes_;
};

// ---- Traversal ------------------------------------------------------------------------------------------------------

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

    /// A bit for each child whose box the ray meets; where it enters, in `enters`.
    unsigned meets(const Node& node, float (&enters)[kWidth]) const {
        __m256 near = near_, far = far_;
        for (int a = 0; a < 3; ++a) {
            const __m256 lo = _mm256_load_ps(positive_[a] ? node.lo[a] : node.hi[a]);
            const __m256 hi = _mm256_load_ps(positive_[a] ? node.hi[a] : node.lo[a]);
            near = _mm256_max_ps(near, _mm256_mul_ps(_mm256_sub_ps(lo, near_origin_[a]), near_inverse_[a]));
            far = _mm256_min_ps(far, _mm256_mul_ps(_mm256_sub_ps(hi, far_origin_[a]), far_inverse_[a]));
        }
        _mm256_store_ps(enters, near);
        return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(near, far, _CMP_LE_OQ)));
    }

private:
    static constexpr float kSlack = 0x1p-20f;  ///< three roundings of 2^-24 each, and some
    __m256 near_origin_[3], far_origin_[3], near_inverse_[3], far_inverse_[3], near_, far_;
    bool positive_[3];
};

class Bvh final : public Intersector {
public:
    explicit Bvh(const Scene& scene) : tester_(scene) {
        std::vector<Item> items;
        items.reserve(tester_.primitives().size());
        for (std::uint32_t i = 0; i < tester_.primitives().size(); ++i) {
            const Bounds bounds = bounds_of(scene, tester_.primitives()[i]);
            if (!bounds.is_finite()) unbounded_.push_back(i);
            else items.push_back({widened(bounds), i});
        }
        Builder(std::move(items)).collapse_into(nodes_, order_);
    }

private:
    struct LastOccluder {
        std::uint64_t of = 0;  ///< whose: an address could be a later structure's
        std::uint32_t primitive = 0;
    };

    static std::uint64_t next_number() {
        static std::atomic<std::uint64_t> last{0};
        return ++last;
    }

    /// Still to be looked at: a node (count 0) or the primitives of a leaf.
    struct Open {
        std::uint32_t child;
        std::uint32_t count;
        float enters;
    };

    std::optional<Hit> find_nearest(const Ray& ray, Interval range) const override {
        if (!is_ray(ray)) return std::nullopt;
        Candidate best;
        for (const std::uint32_t i : unbounded_) tester_.keep_nearer(i, ray, range, best);
        walk<true>(ray, range, best, [&](std::uint32_t primitive, BoxRay& box_ray, float& far) {
            const std::uint32_t before = best.primitive;
            tester_.keep_nearer(primitive, ray, range, best);
            if (best.primitive != before) {
                box_ray.shorten(best.root.t);
                far = above(best.root.t);
            }
            return false;
        });
        return tester_.complete(ray, best);
    }

    bool find_occluder(const Ray& ray, Interval range) const override {
        if (!is_ray(ray) || !(range.min < range.max)) return false;
        // Neighbouring points tend to lie in the same shadow: who blocked last is asked first.
        thread_local LastOccluder last;
        if (last.of == number_ && tester_.blocks(last.primitive, ray, range)) return true;
        const bool blocked = walk<false>(ray, range, {}, [&](std::uint32_t primitive, BoxRay&, float&) {
            if (!tester_.blocks(primitive, ray, range)) return false;
            last = {number_, primitive};
            return true;
        });
        return blocked || std::any_of(unbounded_.begin(), unbounded_.end(),
                                      [&](std::uint32_t i) { return tester_.blocks(i, ray, range); });
    }

    /// Asks the primitives whose boxes the ray meets until ask(...) says enough; near boxes first, when sorted.
    template <bool sorted, class Ask>
    bool walk(const Ray& ray, Interval range, const Candidate& best, Ask ask) const {
        if (nodes_.empty()) return false;
        if (range.min < 0) return ask_all(ray, range, ask);
        BoxRay box_ray(ray, range);
        float far = kMaxFloat;
        if (best.primitive != kNone) {
            box_ray.shorten(best.root.t);
            far = above(best.root.t);
        }
        Open stack[kStackSize];
        int size = 0;
        stack[size++] = {0, 0, 0};
        while (size > 0) {
            const Open open = stack[--size];
            if (open.enters > far) continue;
            for (std::uint32_t k = 0; k < open.count; ++k)
                if (ask(order_[open.child + k], box_ray, far)) return true;
            if (open.count > 0) continue;
            if (effort) [[unlikely]]
                ++effort->nodes;
            const Node& node = nodes_[open.child];
            alignas(32) float enters[kWidth];
            [[maybe_unused]] const int first = size;
            for (unsigned mask = box_ray.meets(node, enters); mask != 0; mask &= mask - 1) {
                const int i = std::countr_zero(mask);
                int place = size++;
                if constexpr (sorted)  // the nearest ends on top
                    for (; place > first && stack[place - 1].enters < enters[i]; --place) stack[place] = stack[place - 1];
                stack[place] = {node.child[i], node.count[i], enters[i]};
            }
        }
        return false;
    }

    /// Boxes are for rays that go forward. Whoever looks back is rare enough to be asked everything.
    template <class Ask>
    bool ask_all(const Ray& ray, Interval range, Ask ask) const {
        BoxRay box_ray(ray, range);
        float far = kMaxFloat;
        for (const std::uint32_t primitive : order_)
            if (ask(primitive, box_ray, far)) return true;
        return false;
    }

    static constexpr int kStackSize = 8 * 80;  ///< splits stop being uneven at depth 64; then halves of 2^32 items

    PrimitiveTester tester_;
    const std::uint64_t number_ = next_number();
    std::vector<std::uint32_t> unbounded_;
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> order_;  ///< primitives, leaf by leaf
};

}  // namespace
//< hidden

std::unique_ptr<Intersector> make_bvh(const Scene& scene) {
    //> 4.10 Beyond the step: any structure of your own, the faster the better. Until then, the octree stands in.
    return std::make_unique<Bvh>(scene);
    //< 4.10
}

}  // namespace rays
