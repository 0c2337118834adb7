// A ray, and the range of its parameter that counts.
#pragma once

#include "core/vec.h"

namespace rays {

/// Points p(t) = origin + t * direction. The direction need not have unit length: t counts in lengths of it, so a ray
/// moved into an object's own space keeps its t.
struct Ray {
    Vec3 origin{0};
    Vec3 direction{0, 0, 1};

    Vec3 at(Real t) const { return origin + t * direction; }
};

/// Accepts t with min < t < max. A NaN is in no interval.
struct Interval {
    Real min = 0;
    Real max = kInfinity;

    bool contains(Real t) const { return min < t && t < max; }
};

}  // namespace rays
