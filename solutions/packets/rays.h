// Eight rays that start near each other and go the same way, and what they have found.
#pragma once

#include "4_partitioning/partitioning.h"
#include "core/hit.h"
#include "packets/lanes.h"

namespace rays::packets {

struct Rays {
    Vec3s origin, direction;
    Reals direction2, inverse_direction2;  ///< |direction|^2, and 1 / that

    Rays(const Vec3s& o, const Vec3s& d)
        : origin(o), direction(d), direction2(dot(d, d)), inverse_direction2(Reals(1) / direction2) {}
    Vec3s at(Reals t) const { return origin + t * direction; }
};

/// The part of the rays that counts: near < t < far.
struct Span {
    Reals near, far;
    bool any = false;  ///< where there are roots, any number in the span will do for t
    Mask contains(Reals t) const { return (near < t) & (t < far); }
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
void each_lane(unsigned bits, const What& what) {
    for (; bits != 0; bits &= bits - 1) what(__builtin_ctz(bits));
}

/// Rays that go the same way: along each axis forwards, backwards or not at all.
class Directions {
public:
    struct Way {
        bool forwards[3];  ///< or not at all
    };

    explicit Directions(const Vec3s& d) {
        const Reals zero(0.0);
        for (int a = 0; a < 3; ++a) {
            back_[a] = (d[a] < zero).bits();
            still_[a] = (d[a] == zero).bits();
        }
    }

    /// Those of `lanes` that go the way of the first of them.
    unsigned like_the_first(unsigned lanes) const {
        const int first = __builtin_ctz(lanes);
        const auto same = [&](unsigned property) { return (property >> first & 1) ? property : ~property; };
        unsigned alike = lanes;
        for (int a = 0; a < 3; ++a) alike &= same(back_[a]) & same(still_[a]);
        return alike;
    }
    Way way(int lane) const { return {{!(back_[0] >> lane & 1), !(back_[1] >> lane & 1), !(back_[2] >> lane & 1)}}; }

private:
    unsigned back_[3], still_[3];
};

/// A root for each lane of `is`.
struct Roots {
    Mask is;
    Reals t{0.0}, u{0.0}, v{0.0}, part{0.0};  ///< as in Root

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
    bool keep_nearer(const Roots& roots, Mask active, std::uint32_t number) {
        const Reals whose(static_cast<double>(number));
        const Mask nearer = active & roots.is & ((roots.t < t) | ((roots.t == t) & (whose < primitive)));
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
