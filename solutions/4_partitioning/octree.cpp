// The octree: boxes cut into eight halves each way, only where there is something, and a walk from the top down.
#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <thread>

#include "4_partitioning/parallel.h"
#include "4_partitioning/primitive_tester.h"
#include "4_partitioning/structures.h"
#include "core/unfinished.h"
//> hidden
#include "4_partitioning/beyond/box_ray.h"
#include "4_partitioning/beyond/octree_axes.h"
#include "4_partitioning/beyond/octree_nodes.h"
#include "4_partitioning/beyond/surface_test.h"
//< hidden

namespace rays {

Bounds octant_of(const Bounds& node, unsigned octant) {
    //> 4.6 Along each axis the lower or the upper half, as the octant's bit says.
    const Vec3 middle = Real(0.5) * (node.min + node.max);
    Bounds half = node;
    for (int a = 0; a < 3; ++a) (octant >> a & 1 ? half.min : half.max)[a] = middle[a];
    return half;
    //< 4.6
}

unsigned octants_overlapping(const Bounds& node, const Bounds& bounds) {
    //> 4.6 Along each axis: does it reach the lower half, does it reach the upper one? Faces belong to both sides.
    const Vec3 middle = Real(0.5) * (node.min + node.max);
    // For each axis the octants of its lower and of its upper half.
    constexpr unsigned kLower[3] = {0x55, 0x33, 0x0f}, kUpper[3] = {0xaa, 0xcc, 0xf0};
    unsigned octants = bounds.overlaps(node) ? 0xff : 0;
    for (int a = 0; a < 3; ++a)
        octants &= (bounds.min[a] <= middle[a] ? kLower[a] : 0) | (bounds.max[a] >= middle[a] ? kUpper[a] : 0);
    return octants;
    //< 4.6
}

OctreeRay octree_ray(const Bounds& root, const Ray& ray) {
    //> 4.7 For each axis the t of the near face and of the far one; against the axis the near face is the larger one.
    OctreeRay result;
    for (int a = 0; a < 3; ++a) {
        const bool backwards = ray.direction[a] < 0;
        if (backwards) result.mirror |= 1u << a;
        result.root.near[a] = ((backwards ? root.max[a] : root.min[a]) - ray.origin[a]) / ray.direction[a];
        result.root.far[a] = ((backwards ? root.min[a] : root.max[a]) - ray.origin[a]) / ray.direction[a];
    }
    return result;
    //< 4.7
}

//> hidden
namespace {

using octree::Axes;
using octree::AxesMask;
using octree::vec3;

/// The octant in which the ray is: it begins in the far half along every axis whose middle it has passed before it
/// enters; then it changes halves along the axis that it leaves first.
class Passage {
public:
    Passage() = default;
    /// From where the ray passes the node's faces, and what of it counts there.
    Passage(Axes near, Axes far, Real enter, Real exit)
        : near_(near),
          middle_(Real(0.5) * (near + far)),
          far_(far),
          enter_(enter),
          exit_(exit),
          half_(octree::bits_of(middle_ < Axes{enter, enter, enter, enter})) {}

    /// Part by part: what was just written in parts and is read as a whole has to wait until it is in the cache.
    Passage(const Passage& other) { *this = other; }
    Passage& operator=(const Passage& other) {
        near_ = other.near_, middle_ = other.middle_, far_ = other.far_;
        enter_ = other.enter_, exit_ = other.exit_;
        half_ = other.half_;
        return *this;
    }

    unsigned octant(unsigned mirror) const { return half_ ^ mirror; }
    Axes near() const { return octree::select(kHalves[half_], middle_, near_); }
    Axes far() const { return octree::select(kHalves[half_], far_, middle_); }
    Real enter() const { return enter_; }

    /// To the next octant, if the ray enters it before `end`.
    bool go_on(Real end) {
        const Axes leave = far();
        const Real exit = octree::smallest(leave), x = leave[0], y = leave[1], z = leave[2];
        const unsigned first = x < y ? (x < z ? 1 : 4) : (y < z ? 2 : 4);
        if ((half_ & first) || !(exit <= std::min(end, exit_))) return false;
        half_ |= first;
        enter_ = exit;
        return true;
    }
    /// To the next octant of those that there are, this one included.
    bool find(unsigned octants, unsigned mirror, Real end) {
        while (!(octants >> octant(mirror) & 1))
            if (!go_on(end)) return false;
        return true;
    }

private:
    static constexpr AxesMask kHalves[8] = {{0, 0, 0, 0},   {-1, 0, 0, 0},   {0, -1, 0, 0},   {-1, -1, 0, 0},
                                            {0, 0, -1, -1}, {-1, 0, -1, -1}, {0, -1, -1, -1}, {-1, -1, -1, -1}};
    Axes near_, middle_, far_;
    Real enter_, exit_;
    unsigned half_;  ///< bit a: in the far half along axis a
};

}  // namespace
//< hidden

int octants_along(const Slabs& node, unsigned mirror, Span span, std::array<Octant, 4>& octants) {
    //> 4.7 The middle planes are passed half-way between near and far. The ray begins in the far half along every axis
    //>   whose middle it has passed before it enters; then it changes halves along the axis that it leaves first.
    const Real enter = std::max(span.enter, node.enter()), exit = std::min(span.exit, node.exit());
    if (!(enter <= exit)) return 0;
    Passage passage(octree::axes(node.near), octree::axes(node.far), enter, exit);
    int count = 0;
    do
        octants[static_cast<std::size_t>(count++)] = {passage.octant(mirror),
                                                      {vec3(passage.near()), vec3(passage.far())}};
    while (passage.go_on(exit));
    return count;
    //< 4.7
}

//> hidden
namespace {

using octree::Node;
using octree::Tree;

// ---- Build ----------------------------------------------------------------------------------------------------------

constexpr std::size_t kMostInLeaf = 48;
constexpr int kMostDeep = 20;
/// Along the way to a leaf the lists together may grow by this factor: a leaf's share of all entries is its length over
/// the growth on its way, and the shares add up to one entry a primitive, so there are at most kMostGrowth of them.
/// Without this rule a thousand nested spheres fill the memory.
constexpr Real kMostGrowth = 12;
constexpr Real kNoBurden = 65536;  ///< as many entries are allowed to every scene
/// A node with less than this part of all primitives is one thread's work; larger ones are split by all threads
/// together.
constexpr std::size_t kShares = 32;
constexpr std::size_t kWorthThreads = 4096;  ///< items to split together

class Builder {
public:
    Builder(const PrimitiveTester& tester, const Contents& contents)
        : contents_(contents),
          surfaces_(tester, contents.slack),
          most_growth_(std::max(kMostGrowth, kNoBurden / static_cast<Real>(contents.inside.size()))) {}

    /// The tree is the same for any number of threads.
    Tree build() {
        Tree tree;
        std::vector<Job> jobs;
        grow(tree, {contents_.inside, contents_.box, 0, 1, {}},
             contents_.inside.size() < kParallelFrom ? nullptr : &jobs);
        std::vector<Tree> subtrees(jobs.size());
        std::atomic<std::size_t> next = 0;
        in_parallel_parts(jobs.size(), 2, [&](std::size_t, std::size_t, std::size_t) {
            for (std::size_t i = next++; i < jobs.size(); i = next++) {
                Job job = std::move(jobs[i]);
                job.place = {};
                grow(subtrees[i], std::move(job), nullptr);
            }
        });
        for (std::size_t i = 0; i < jobs.size(); ++i) tree.attach(jobs[i].place, std::move(subtrees[i]));
        return tree;
    }

private:
    struct Job {
        std::vector<std::uint32_t> items;
        Bounds box;
        int depth = 0;
        Real growth = 1;
        Tree::Place place;
    };

    /// With `jobs`, all threads split what is larger than a share, and the rest goes there; without, this one does it
    /// all.
    void grow(Tree& tree, Job job, std::vector<Job>* jobs) const {
        if (jobs && job.items.size() <= contents_.inside.size() / kShares) {
            jobs->push_back(std::move(job));
            return;
        }
        if (job.items.size() <= kMostInLeaf || job.depth == kMostDeep) return make_leaf(tree, job);
        std::array<Job, 8> children = jobs ? split_together(job) : split(job);
        std::size_t entries = 0;
        for (const Job& child : children) entries += child.items.size();
        const Real growth = job.growth * static_cast<Real>(entries) / static_cast<Real>(job.items.size());
        if (growth > most_growth_) return make_leaf(tree, job);
        const std::uint32_t family = tree.add_family(job.place);
        job.items = {};
        for (unsigned o = 0; o < 8; ++o) {
            if (children[o].items.empty()) continue;
            children[o].growth = growth;
            children[o].place = {family, o};
            grow(tree, std::move(children[o]), jobs);
        }
    }

    std::array<Job, 8> split(const Job& job) const {
        std::array<Job, 8> children = empty_children(job);
        deal(job, 0, job.items.size(), children);
        return children;
    }

    /// Each thread deals out a part of the items; joined in the order of the parts, the lists are those of one thread.
    std::array<Job, 8> split_together(const Job& job) const {
        std::array<Job, 8> children = empty_children(job);
        std::vector<std::array<Job, 8>> parts(std::max(1u, std::thread::hardware_concurrency()), children);
        in_parallel_parts(job.items.size(), kWorthThreads, [&](std::size_t part, std::size_t begin, std::size_t end) {
            deal(job, begin, end, parts[part]);
        });
        for (unsigned o = 0; o < 8; ++o)
            for (const auto& part : parts)
                children[o].items.insert(children[o].items.end(), part[o].items.begin(), part[o].items.end());
        return children;
    }

    static std::array<Job, 8> empty_children(const Job& job) {
        std::array<Job, 8> children;
        for (unsigned o = 0; o < 8; ++o) {
            children[o].box = octant_of(job.box, o);
            children[o].depth = job.depth + 1;
        }
        return children;
    }

    /// Items `begin` to `end` go to the children that they reach.
    void deal(const Job& job, std::size_t begin, std::size_t end, std::array<Job, 8>& children) const {
        const bool thorough = job.items.size() <= 4 * kMostInLeaf;
        for (std::size_t i = begin; i < end; ++i) {
            const std::uint32_t item = job.items[i];
            for (unsigned rest = octants_overlapping(job.box, contents_.bounds[item]); rest != 0; rest &= rest - 1) {
                Job& child = children[static_cast<unsigned>(std::countr_zero(rest))];
                if (surfaces_.reaches(item, child.box, thorough)) child.items.push_back(item);
            }
        }
    }

    static void make_leaf(Tree& tree, const Job& job) { tree.make_leaf(job.place, job.items); }

    const Contents& contents_;
    octree::SurfaceTest surfaces_;
    Real most_growth_;
};

// ---- Walk -----------------------------------------------------------------------------------------------------------

class Octree final : public Intersector {
public:
    explicit Octree(const Scene& scene) : tester_(scene) {
        Contents contents = contents_of(scene, primitives_of(scene), kSlack);
        outside_ = std::move(contents.outside);
        box_ = contents.box;
        slack_ = contents.slack;
        if (!contents.inside.empty()) tree_ = Builder(tester_, contents).build();
        tree_.finish();
        boxes_.resize((tree_.items.size() + wide::kWidth - 1) / wide::kWidth);
        in_parallel_each(tree_.items.size(), [&](std::size_t i) {
            boxes_[i / wide::kWidth].set(i % wide::kWidth, wide::rounded_outwards(contents.bounds[tree_.items[i]]));
        });
    }

private:
    /// Of the octree's extent: a hundredth of the smallest leaf.
    static constexpr Real kSlack = Real(1e-8);

    std::optional<Hit> find_nearest(const Ray& ray, Interval range) const override {
        Candidate best;
        ask_leaves(ray, range, [&](std::uint32_t primitive, Real& far) {
            tester_.keep_nearer(primitive, ray, range, best);
            if (best.primitive != kNone) far = best.root.t;
            return false;
        });
        return tester_.complete(ray, best);
    }

    bool find_occluder(const Ray& ray, Interval range) const override {
        return ask_leaves(ray, range,
                          [&](std::uint32_t primitive, Real&) { return tester_.blocks(primitive, ray, range); });
    }

    /// Calls ask(primitive, far) until it says true; `far` is how far the ray still has to go.
    template <class Ask>
    bool ask_leaves(const Ray& ray, Interval range, const Ask& ask) const {
        const auto usable = without_zeros(ray);
        if (!usable) return false;
        Real far = range.max;
        for (const std::uint32_t i : outside_)
            if (ask(i, far)) return true;
        if (tree_.root.is_empty()) return false;
        if (const Real blur = rounding_of(ray, box_); !(blur < slack_)) return walk_blurred(ray, range, far, blur, ask);
        return effort ? walk<true>(*usable, range, far, ask) : walk<false>(*usable, range, far, ask);
    }

    template <bool kWatched, class Ask>
    bool walk(const Ray& ray, Interval range, Real far, const Ask& ask) const {
        Mailbox mailbox;
        wide::BoxRay box_ray(ray, range);
        const auto ask_leaf = [&](const Node& leaf) {
            const std::uint32_t end = leaf.first + leaf.count;
            __builtin_prefetch(&tree_.items[leaf.first]);  // looked at only once the boxes are there
            for (std::uint32_t first = leaf.first / wide::kWidth * wide::kWidth; first < end; first += wide::kWidth) {
                unsigned met = box_ray.meets(boxes_[first / wide::kWidth]);
                if (first < leaf.first) met &= ~0u << (leaf.first - first);  // those before are another leaf's
                if (end - first < wide::kWidth) met &= ~(~0u << (end - first));
                for (; met != 0; met &= met - 1) {
                    const std::uint32_t item = tree_.items[first + static_cast<unsigned>(std::countr_zero(met))];
                    if (mailbox.was_asked(item)) continue;
                    const Real before = far;
                    if (ask(item, far)) return true;
                    if (far < before) box_ray.shorten(far);
                }
            }
            return false;
        };
        struct Open {
            Node node;
            Passage passage;  ///< stands at an octant that is still to be entered
        };
        const OctreeRay seen = octree_ray(box_, ray);
        const auto find = [&](Open& open) { return open.passage.find(open.node.children(), seen.mirror, far); };
        const auto ask_items = [&](const Node& leaf) {
            return range.min < 0 ? ask_all_of(leaf, far, ask) : ask_leaf(leaf);
        };
        Axes near = octree::axes(seen.root.near), leave = octree::axes(seen.root.far);
        Real enter = std::max(range.min, octree::largest(near)), exit = octree::smallest(leave);
        if (!(enter <= std::min(far, exit))) return false;
        if constexpr (kWatched) watch(tree_.root, {vec3(near), vec3(leave)}, ray);
        if (tree_.root.is_leaf()) return ask_items(tree_.root);

        std::array<Open, kMostDeep> stack;  // nodes on the way down with more to enter
        std::size_t size = 0;
        Open here{tree_.root, Passage(near, leave, enter, std::min(far, exit))};
        for (bool has_more = find(here);;) {
            if (!has_more) {
                if (size == 0) return false;
                here = stack[--size];
            }
            const octree::Family& family = tree_.families[here.node.first];
            const Node node = family.children[here.passage.octant(seen.mirror)];
            near = here.passage.near();
            leave = here.passage.far();
            enter = here.passage.enter();
            exit = octree::smallest(leave);
            has_more = here.passage.go_on(far) && find(here);
            if (has_more) fetch(family.children[here.passage.octant(seen.mirror)]);  // while this one is asked
            if (!(enter <= std::min(far, exit))) continue;
            if constexpr (kWatched) watch(node, {vec3(near), vec3(leave)}, ray);
            if (node.is_leaf()) {
                if (ask_items(node)) return true;
                continue;
            }
            if (has_more) stack[size++] = here;
            here.node = node;
            here.passage = Passage(near, leave, enter, std::min(far, exit));
            has_more = find(here);
        }
    }

    [[gnu::always_inline]] void fetch(const Node& node) const {
        if (node.is_leaf()) {
            const char* boxes = reinterpret_cast<const char*>(&boxes_[node.first / wide::kWidth]);
            for (std::size_t i = 0; i < sizeof(wide::Boxes); i += 64) __builtin_prefetch(boxes + i);
        } else {
            __builtin_prefetch(&tree_.families[node.first]);
        }
    }

    template <class Ask>
    bool ask_all_of(const Node& leaf, Real& far, const Ask& ask) const {
        for (std::uint32_t k = leaf.first; k < leaf.first + leaf.count; ++k)
            if (ask(tree_.items[k], far)) return true;
        return false;
    }

    /// For rays from so far away that their rounding is larger than the slack: every box as large as the blur.
    template <class Ask>
    bool walk_blurred(const Ray& ray, Interval range, Real far, Real blur, const Ask& ask) const {
        struct Blurred {
            Node node;
            Bounds box;
        };
        std::array<Blurred, 7 * kMostDeep + 8> stack;
        std::size_t size = 0;
        stack[size++] = {tree_.root, box_};
        while (size > 0) {
            const auto [node, box] = stack[--size];
            if (!clip(ray, {range.min, far}, {box.min - blur, box.max + blur})) continue;
            if (node.is_leaf()) {
                if (ask_all_of(node, far, ask)) return true;
                continue;
            }
            for (unsigned o = 0; o < 8; ++o) {
                const Node& child = tree_.families[node.first].children[o];
                if (!child.is_empty()) stack[size++] = {child, octant_of(box, o)};
            }
        }
        return false;
    }

    static void watch(const Node& node, const Slabs& slabs, const Ray& ray) {
        ++effort->nodes;
        if (!effort->visited || !node.is_leaf()) return;
        Bounds box;
        for (int a = 0; a < 3; ++a) {
            const Real near = ray.origin[a] + slabs.near[a] * ray.direction[a];
            const Real far = ray.origin[a] + slabs.far[a] * ray.direction[a];
            box.min[a] = std::min(near, far);
            box.max[a] = std::max(near, far);
        }
        effort->visited->push_back(box);
    }

    PrimitiveTester tester_;
    Bounds box_;
    Real slack_ = 0;
    std::vector<std::uint32_t> outside_;  ///< asked by every ray
    Tree tree_;
    LargeVector<wide::Boxes> boxes_;  ///< of the tree's items, eight by eight
};

}  // namespace
//< hidden

std::unique_ptr<Intersector> make_octree(const Scene& scene) {
    //> 4.6 A class like the grid's.
    return std::make_unique<Octree>(scene);
    //< 4.6
}

}  // namespace rays
