// Eight rays that start near each other and go the same way, and what they have found.
#pragma once

#include "4_partitioning/partitioning.h"
#include "core/hit.h"
#include "packets/lanes.h"

namespace rays::packets {

struct Rays {
    Vec3s origin, direction;
    Reals direction2;  ///< |direction|^2

    Rays(const Vec3s& o, const Vec3s& d) : origin(o), direction(d), direction2(dot(d, d)) {}
    Vec3s at(Reals t) const { return origin + t * direction; }
};

/// Eight vectors, to be looked at one by one.
struct Spread3 {
    Spread x, y, z;
    explicit Spread3(const Vec3s& v) : x(v.x), y(v.y), z(v.z) {}
    Vec3 operator[](int i) const { return {x[i], y[i], z[i]}; }
};

/// Eight rays, to be looked at one by one.
struct SpreadRays {
    Spread3 origin, direction;
    explicit SpreadRays(const Rays& rays) : origin(rays.origin), direction(rays.direction) {}
    Ray operator[](int i) const { return {origin[i], direction[i]}; }
};

/// Calls what(lane) for every lane that is set.
template <class What>
void each_lane(unsigned bits, What what) {
    for (; bits != 0; bits &= bits - 1) what(__builtin_ctz(bits));
}

/// A root for each lane of `is`.
struct Roots {
    Mask is;
    Reals t, u{0.0}, v{0.0}, part{0.0};  ///< as in Root

    static Roots none() { return {Mask::of(0), Reals(0.0)}; }
};

/// The nearest roots so far, and whose they are.
struct Found {
    static constexpr double kNobody = kNone;

    Reals t{kInfinity}, u{0.0}, v{0.0}, part{0.0};
    Reals primitive{kNobody};

    Mask is() const { return primitive < Reals(kNobody); }
    Root root(int i) const {
        return {Spread(t)[i], {Spread(u)[i], Spread(v)[i]}, static_cast<std::uint32_t>(Spread(part)[i])};
    }
    /// Keeps the nearer one; at equal t the primitive with the smaller number. True when that changed anything.
    bool keep_nearer(const Roots& roots, std::uint32_t number) {
        const Reals whose(static_cast<double>(number));
        const Mask nearer = roots.is & ((roots.t < t) | ((roots.t == t) & (whose < primitive)));
        if (!nearer.any()) return false;
        t = select(nearer, roots.t, t);
        u = select(nearer, roots.u, u);
        v = select(nearer, roots.v, v);
        part = select(nearer, roots.part, part);
        primitive = select(nearer, whose, primitive);
        return true;
    }
};

}  // namespace rays::packets
