// Eight rays together and one by one, for the tests of packets.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "../step_1/rays_at.h"
#include "core/hit.h"
#include "core/ray.h"
#include "packets/rays.h"

namespace rays::packets::tests {

template <class T>
using Lanes = std::array<T, kLanes>;

inline Reals together(const Lanes<Real>& values) {
    Spread spread;
    for (int i = 0; i < kLanes; ++i) spread.lane[i] = values[std::size_t(i)];
    return Reals::load(spread.lane);
}

inline Rays together(const Lanes<Ray>& rays) {
    const auto component = [&](const Vec3 Ray::*of, int axis) {
        Lanes<Real> values;
        for (std::size_t i = 0; i < kLanes; ++i) values[i] = (rays[i].*of)[axis];
        return together(values);
    };
    const auto vectors = [&](const Vec3 Ray::*of) {
        return Vec3s(component(of, 0), component(of, 1), component(of, 2));
    };
    return {vectors(&Ray::origin), vectors(&Ray::direction)};
}

/// The same bits, -0 told from 0; of what is no number, any.
inline bool same(double a, double b) {
    return (std::isnan(a) && std::isnan(b)) || std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
inline bool same(const Vec3& a, const Vec3& b) { return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z); }

using test::text;

/// As far as packets know hits: they have no normal but the one that is shaded.
inline bool same(const std::optional<Hit>& a, const std::optional<Hit>& b) {
    if (!a || !b) return !a && !b;
    return same(a->t, b->t) && same(a->point, b->point) && same(a->shading_normal, b->shading_normal) &&
           a->object == b->object && a->material == b->material;
}
inline std::string text(const std::optional<Hit>& hit) {
    return hit ? fmt::format("object {} at {:.17g}, normal {}", hit->object, hit->t, text(hit->shading_normal))
               : "miss";
}

}  // namespace rays::packets::tests
