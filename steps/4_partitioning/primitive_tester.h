// The one test of a primitive that all structures share: they differ only in which primitives they ask. Here in a
// header, since it is the innermost call of every ray.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "4_partitioning/effort.h"
#include "4_partitioning/partitioning.h"
#include "core/large_pages.h"

namespace rays {

/// The nearest root so far, and whose it is.
struct Candidate {
    Root root;
    std::uint32_t primitive = kNone;  ///< into the list of primitives; kNone: nothing found
    std::uint32_t object = kNone;     ///< that it is a part of
};

/// Counts what it is asked while somebody counts.
class PrimitiveTester {
public:
    explicit PrimitiveTester(const Scene& scene);

    const Scene& scene() const { return *scene_; }
    std::size_t size() const { return dispatch_.size(); }
    Primitive primitive(std::uint32_t number) const { return dispatch_[number].primitive; }

    /// Keeps the nearer of `best` and this primitive's root in (range.min, range.max); at equal t the smaller number.
    /// Any order of calls ends with the same best.
    void keep_nearer(std::uint32_t primitive, const Ray& ray, Interval range, Candidate& best) const {
        keep_nearer(primitive, dispatch_[primitive], ray, range, best);
    }
    /// Does this primitive cast a shadow, and have a root in the range?
    bool blocks(std::uint32_t primitive, const Ray& ray, Interval range) const {
        return blocks(dispatch_[primitive], ray, range);
    }
    /// The hit that a candidate is, if there is one.
    std::optional<Hit> complete(const Ray& ray, const Candidate& best) const;

    // Most primitives of large scenes are plain spheres, faces, triangles and cones, and most scenes have a floor:
    // these are asked without detours.
    enum class Way : std::uint8_t { sphere, face, triangle, cone, plane, other };

    /// What the test of a primitive needs to know, side by side: among millions, each place in memory is waited for.
    struct Dispatch {
        Primitive primitive;
        std::uint32_t shape;
        Way way;
        /// Its roots are iterated from the ends of the range: a range cut short would make the last bits depend on the
        /// order of the questions.
        bool iterated;
        bool casts;  ///< a shadow
    };
    const Dispatch& dispatch(std::uint32_t primitive) const { return dispatch_[primitive]; }

    /// The same for who has that at hand.
    void keep_nearer(std::uint32_t primitive, const Dispatch& d, const Ray& ray, Interval range, Candidate& best) const;
    bool blocks(const Dispatch& d, const Ray& ray, Interval range) const {
        return d.casts && ask(d, ray, range).has_value();
    }

private:
    std::optional<Root> ask(const Dispatch& d, const Ray& ray, Interval range) const {
        if (effort) [[unlikely]]
            ++effort->tests;
        switch (d.way) {
            case Way::sphere: return intersect(scene_->spheres[d.shape], ray, range);
            case Way::face: return intersect(scene_->meshes[d.shape], d.primitive.part, ray, range);
            case Way::triangle: return intersect(scene_->triangles[d.shape], ray, range);
            case Way::cone: return intersect(scene_->cones[d.shape], ray, range);
            case Way::plane: return intersect(scene_->planes[d.shape], ray, range);
            case Way::other: break;
        }
        return intersect_part(*scene_, scene_->objects[d.primitive.object], d.primitive.part, ray, range);
    }

    /// The smallest number above t.
    static Real just_above(Real t) {
        return t > 0 ? t * (1 + std::numeric_limits<Real>::epsilon()) : std::nextafter(t, kInfinity);
    }

    const Scene* scene_;
    LargeVector<Dispatch> dispatch_;
};

inline void PrimitiveTester::keep_nearer(std::uint32_t primitive, const Dispatch& d, const Ray& ray, Interval range,
                                         Candidate& best) const {
    // A little beyond the best root, so that one at equal t is seen too; the rule for ties then decides.
    if (best.primitive != kNone && !d.iterated) range.max = just_above(best.root.t);
    const auto root = ask(d, ray, range);
    if (!root) return;
    if (best.primitive == kNone || root->t < best.root.t || (root->t == best.root.t && primitive < best.primitive)) {
        // Part by part, as it has just been written: whoever loads it whole waits for its parts.
        best.root.t = root->t;
        best.root.uv = root->uv;
        best.root.part = root->part;
        best.primitive = primitive;
        best.object = d.primitive.object;
    }
}

inline std::optional<Hit> PrimitiveTester::complete(const Ray& ray, const Candidate& best) const {
    if (best.primitive == kNone) return std::nullopt;
    return complete_hit(*scene_, best.object, ray, best.root);
}

}  // namespace rays
