// What primitives are asked about: the rays of a packet, and the forms of them that some tests want.
#pragma once

#include <optional>

#include "packets/shapes.h"

namespace rays::packets {

class Asked {
public:
    /// Rays that are not `open` do not count, nor what lies behind `nearest`. Both may change.
    Asked(const Rays& rays_, const Span& span_, Mask lanes, const Mask& open, const Reals& nearest)
        : rays(rays_), active(lanes), span{span_.near, span_.far, span_.any}, open_(open), nearest_(nearest) {}

    /// What still counts, for shapes whose tests cost more than to tell it. Another root at `nearest` does: the number
    /// of the primitive decides.
    Span narrow_span() const {
        const Reals just_above = nearest_ * Reals(1 + std::numeric_limits<Real>::epsilon());
        return {span.near, select(open_, min(span.far, just_above), Reals(-kInfinity)), span.any};
    }

    const ShearedRays& sheared() const {
        if (!sheared_) sheared_.emplace(rays, active);
        return *sheared_;
    }
    Interval range(int i) const { return {Spread(span.near)[i], Spread(span.far)[i]}; }
    const SpreadRays& single() const {
        if (!single_) single_.emplace(rays);
        return *single_;
    }

    const Rays& rays;
    const Mask active;
    const Span span;

private:
    const Mask& open_;
    const Reals& nearest_;
    mutable std::optional<ShearedRays> sheared_;
    mutable std::optional<SpreadRays> single_;
};

}  // namespace rays::packets
