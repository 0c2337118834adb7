// Which of eight rays come near a torus? The others need not be asked one by one; among tori in one another these are
// nearly all.
#include "packets/placed.h"

namespace rays::packets {

Mask may_meet(const Scene& scene, const Object& object, const Rays& rays, const Span& span) {
    if (object.kind != ShapeKind::torus) return Mask::of(kAllLanes);
    const Torus& torus = scene.tori[object.shape];
    Vec3s o = rays.origin, d = rays.direction;
    if (object.transform != kNone) {
        const Transform& t = scene.transforms[object.transform];
        o = times(t.inverse_linear, o) + Vec3s(t.inverse_offset);
        d = times(t.inverse_linear, d);
    }
    // More than rounding does to a point of the ray; step 1 enlarges the torus by as much as the first term.
    const double size = torus.major + torus.minor;
    const Reals slack = Reals(1e-5 * size) + Reals(1e-14) * (abs(o.x) + abs(o.y) + abs(o.z));
    const Reals tube = Reals(torus.minor) + slack, outer = Reals(size) + slack;
    const Reals hole = Reals(torus.major - torus.minor) - slack;

    // Between the two planes that hold the torus. A comparison with a NaN, of a ray along them, is false and keeps the
    // ray.
    const Reals one = (-tube - o.y) / d.y, other = (tube - o.y) / d.y;
    const Reals sooner = select(one < other, one, other), later = select(one < other, other, one);
    const Reals low = select(sooner > span.near, sooner, span.near);
    const Reals high = select(later < span.far, later, span.far);
    const auto from_axis2 = [&](Reals t) {
        const Reals x = o.x + t * d.x, z = o.z + t * d.z;
        return x * x + z * z;
    };
    // Through the hole: at both ends near the axis, and so between them.
    const Reals hole2 = hole * hole;
    const Mask through = (hole > Reals(0)) & (from_axis2(low) < hole2) & (from_axis2(high) < hole2);
    // Past it: outside of the outer cylinder even where the ray is nearest to the axis.
    Reals nearest = -(o.x * d.x + o.z * d.z) / (d.x * d.x + d.z * d.z);
    nearest = select(nearest > low, nearest, low);
    nearest = select(nearest < high, nearest, high);
    const Mask past = from_axis2(nearest) > outer * outer;
    return Mask::of(kAllLanes) - ((low > high) | through | past);
}

}  // namespace rays::packets
