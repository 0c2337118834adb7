// Rays that are hard on a shape.
#pragma once

#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/ray.h"

namespace rays::test {

inline std::string text(const Vec3& v) { return fmt::format("{:.17g} {:.17g} {:.17g}", v.x, v.y, v.z); }
inline std::string text(const Ray& ray, Interval range) {
    return fmt::format("origin {} direction {} range {:.17g} {:.17g}", text(ray.origin), text(ray.direction), range.min,
                       range.max);
}

/// Where a shape is special: corners, rims, an apex, its middle; and along what: edges, generators, axes, normals.
struct Special {
    std::vector<Vec3> points{Vec3(0)};
    std::vector<Vec3> directions{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
    Real size = 1;
};

struct Question {
    Ray ray;
    Interval range;
};

/// Rays through, along, beside and inside of what is special, from any distance, of any length, some of them no rays.
class RaysAt {
public:
    RaysAt(Special special, std::uint64_t seed) : special_(std::move(special)), bits_(seed) {}

    Question next() {
        Question q{ray(), range()};
        q.ray.direction *= below(3) ? Real(1) : std::pow(Real(10), 8 * unit() - 4);
        return q;
    }
    Real unit() { return Real(double(bits_() >> 11) * 0x1p-53); }
    std::size_t below(std::size_t n) { return std::size_t(bits_() % n); }

private:
    Vec3 in_cube(Real half) {
        const Real x = unit(), y = unit();
        return half * (Real(2) * Vec3(x, y, unit()) - Real(1));
    }
    Vec3 direction() {
        for (;;) {
            const Vec3 v = in_cube(1);
            if (const Real l = glm::length(v); l > Real(0.1) && l < 1) return v / l;
        }
    }
    const Vec3& point() { return special_.points[below(special_.points.size())]; }
    Vec3 special_direction() {
        return (below(2) ? Real(1) : Real(-1)) * special_.directions[below(special_.directions.size())];
    }
    /// With one zero or two, of either sign.
    Vec3 along_axes() {
        Vec3 d = direction();
        const std::size_t axis = below(3);
        d[int(axis)] = below(2) ? Real(0) : Real(-0.0);
        if (below(2)) d[int((axis + 1) % 3)] = below(2) ? Real(0) : Real(-0.0);
        return d;
    }
    Real distance() { return special_.size * std::pow(Real(10), below(2) ? Real(2) * unit() : Real(12) * unit() - 2); }
    Vec3 awkward() {
        static const Real numbers[] = {0,
                                       Real(-0.0),
                                       1,
                                       -1,
                                       std::numeric_limits<Real>::denorm_min(),
                                       kInfinity,
                                       std::numeric_limits<Real>::quiet_NaN(),
                                       Real(1e18),
                                       Real(-1e150)};
        const auto one = [&] { return numbers[below(std::size(numbers))]; };
        const Real x = one(), y = one();
        return {x, y, one()};
    }

    Ray ray() {
        const Vec3 middle = special_.points[0];
        switch (below(10)) {
            case 0:
            case 1: {
                const Vec3 from = middle + in_cube(3 * special_.size);
                return {from, middle + in_cube(special_.size) - from};
            }
            case 2: {
                const Vec3 d = direction();
                return {point() - distance() * d, d};
            }
            case 3: {
                const Vec3 d = special_direction();
                return {point() - distance() * d, d};
            }
            case 4: {
                const Vec3 d = along_axes();
                return {(below(2) ? point() : middle + in_cube(special_.size)) - distance() * d, d};
            }
            case 5: {
                const Vec3 from = point();
                return {from, below(2) ? direction() : point() - from + Real(1e-9) * direction()};
            }
            case 6: return {middle + in_cube(Real(0.5) * special_.size), below(2) ? direction() : special_direction()};
            case 7: {  // grazing: across the line from the middle to something special
                const Vec3 at = point(), out = at - middle;
                const Vec3 d = glm::cross(out, direction()) + Real(1e-30) * direction();
                return {at - distance() * d, d};
            }
            case 8: {
                const Vec3 from = point();
                return {from - (below(2) ? Real(1) : unit()) * (point() - from),
                        point() - from + Real(1e-12) * direction()};
            }
            default: break;
        }
        return below(4) ? Ray{middle + in_cube(2 * special_.size), direction()}
                        : Ray{awkward(), below(2) ? awkward() : direction()};
    }

    Interval range() {
        const Real far = 4 * special_.size;
        switch (below(6)) {
            case 0: return {Real(1e-4), Real(1e7)};
            case 1: return {far * unit(), kInfinity};
            case 2: return {0, far * unit()};
            case 3: return {far * unit(), far * unit()};  // often empty
            default: return {0, kInfinity};
        }
    }

    Special special_;
    std::mt19937_64 bits_;
};

}  // namespace rays::test
