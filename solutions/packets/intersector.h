// The two questions of a ray tracer, asked for eight rays at once.
#pragma once

#include <algorithm>
#include <bit>
#include <memory>
#include <vector>

#include "4_partitioning/beyond/hierarchy.h"
#include "core/intersector.h"
#include "packets/hits.h"
#include "packets/placed.h"

namespace rays::packets {

/// What stands in the way of eight rays.
struct Obstacles {
    Mask opaque = Mask::of(0);  ///< these are blocked
    Mask clear = Mask::of(0);   ///< these meet something that lets light through, and have to walk from hit to hit
};

/// Of a hit: shadow rays ask what they meet and where, not how it is turned.
enum class Wanted { places, normals };

using ObjectNumbers = std::uint32_t[kLanes];

/// Whom to ask first: who took a light away last, where the same object was lit. Neighbours on an object tend to lie in
/// the same shadow.
class Suspects {
public:
    explicit Suspects(std::size_t objects) : of_(std::bit_ceil(std::clamp<std::size_t>(objects, 1, kMost)), kNone) {}

    /// A primitive, or kNone. Where there are more objects than places, some share one.
    std::uint32_t& of(std::uint32_t object) { return of_[object & (of_.size() - 1)]; }

private:
    static constexpr std::size_t kMost = 16384;  ///< measured (NOTES.md)
    std::vector<std::uint32_t> of_;
};

class Asked;

/// Rays that go the same way walk the hierarchy together, others alone; among a few things, all rays together. The
/// answers are those of single rays, bit by bit. Directions have unit length.
class PacketIntersector {
public:
    explicit PacketIntersector(const Scene& scene);

    const Scene& scene() const { return hierarchy_->tester.scene(); }
    const Intersector& single() const { return *single_; }
    /// Need rays not go the same way to walk together?
    bool takes_any_way() const { return takes_any_way_; }

    /// The nearest hits in the span, 0 <= near. `active` are the rays that ask.
    Hits nearest(const Rays& rays, Mask active, const Span& span, Wanted wanted = Wanted::normals) const;

    /// Which rays meet something that casts a shadow in the span? They start on the objects `lit`, and `suspects` are
    /// those of one light.
    Mask occluded(const Rays& rays, Mask active, const Span& span, const ObjectNumbers& lit, Suspects& suspects) const;

    /// The same where shadows are filtered.
    Obstacles obstacles(const Rays& rays, Mask active, const Span& span) const;

private:
    /// Fewer rays are faster one by one; measured (NOTES.md).
    static constexpr int kFewestTogether = 6;
    static constexpr int kFewestBelow = 3;  ///< where a part of the hierarchy is concerned

    std::uint32_t material_of(std::uint32_t primitive) const;
    bool has_packet_test(std::uint32_t primitive) const;
    template <class Together>
    unsigned grouped(const Rays& rays, Mask active, const Together& together) const;
    template <class WalkWith>
    void with_front(const Rays& rays, Mask lanes, const Directions::Way* way, const Span& span,
                    const WalkWith& walk_with) const;
    template <bool sorted, class Front, class Ask, class AskAlone>
    void walk(Front& front, const Ask& ask, const AskAlone& ask_alone) const;
    Roots roots_of(std::uint32_t primitive, const Asked& asked) const;
    bool keep_nearer(std::uint32_t primitive, const Asked& asked, Found& found) const;
    Mask blocked_by(std::uint32_t primitive, const Asked& asked, Mask open) const;
    void complete(const Rays& rays, const Found& found, Wanted wanted, Hits& hits) const;
    void complete(std::uint32_t primitive, Mask lanes, const Rays& rays, const Found& found, Wanted wanted,
                  Hits& hits) const;

    std::shared_ptr<const wide::Hierarchy> hierarchy_;
    std::unique_ptr<wide::SingleRays> single_;
    std::vector<bool> clear_materials_;
    bool takes_any_way_ = false, has_triangles_ = false;
};

}  // namespace rays::packets
