// Is a structure nothing but faster? Random and adversarial rays, answered by it and by asking every primitive.
#pragma once

#include <cstdint>
#include <random>
#include <string>

#include "4_partitioning/partitioning.h"
#include "core/intersector.h"

namespace rays {

/// Rays that are hard on structures: with zeros in the direction, in planes and through corners between cells, from
/// afar, along faces, of any length, with ranges that end anywhere.
class HardRays {
public:
    /// Without primitives that are bounded, around the origin.
    HardRays(const Scene& scene, std::uint64_t seed);

    struct Query {
        Ray ray;
        Interval range;
    };
    Query next();
    /// An ordinary one: from one point of the box around all bounded primitives towards another.
    Ray through_the_box();

private:
    Real unit() { return static_cast<Real>(static_cast<double>(bits_() >> 11) * 0x1p-53); }
    int below(int n) { return static_cast<int>(bits_() % static_cast<std::uint64_t>(n)); }
    Real sign() { return (bits_() >> 40 & 1) != 0 ? Real(1) : Real(-1); }
    Vec3 direction();
    Vec3 in_box();
    Vec3 on_lattice();
    Vec3 at_primitive();
    Vec3 along_axes();
    Ray ray();

    std::mt19937_64 bits_;
    std::vector<Bounds> bounds_;  ///< of the bounded primitives
    Bounds box_;
};

struct Agreement {
    std::size_t rays = 0;
    std::size_t hits = 0;
    std::size_t differences = 0;
    std::string first;  ///< the first difference, in words
};

/// Asks both `count` times for the nearest hit and for an occluder. Two hits agree when all their bits do.
Agreement compare(const Scene& scene, const Intersector& one, const Intersector& other, std::size_t count,
                  std::uint64_t seed);

}  // namespace rays
