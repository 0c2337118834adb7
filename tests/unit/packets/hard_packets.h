// Packets that are hard to trace: all over the place, nearly alike, along edges.
#pragma once

#include <cmath>
#include <random>

#include "eight.h"
#include "packets/intersector.h"
#include "renderer/agreement.h"

namespace rays::packets::tests {

/// Eight rays of one of several habits, and which of them ask.
struct Packet {
    Lanes<Ray> rays;
    unsigned active = kAllLanes;
    Lanes<Interval> ranges;

    Span span() const {
        Lanes<Real> near, far;
        for (std::size_t i = 0; i < kLanes; ++i) {
            near[i] = ranges[i].min;
            far[i] = ranges[i].max;
        }
        return {together(near), together(far)};
    }
};

class HardPackets {
public:
    HardPackets(const Scene& scene, std::uint64_t seed) : rays_(scene, seed), bits_(seed) {}

    /// Directions of unit length, as packets want them.
    Packet next() {
        Packet packet;
        const HardRays::Query first = forwards();
        const Real length = glm::length(first.ray.direction);
        const Real spread = std::pow(Real(10), -4 * unit());
        const std::uint64_t habit = below(6);
        for (std::size_t i = 0; i < kLanes; ++i) {
            const Ray other = rays_.next().ray;
            Ray& ray = packet.rays[i] = first.ray;
            if (habit == 0) ray = other;                                                      // all over the place
            if (habit == 1) ray.direction += spread * glm::length(ray.direction) * jitter();  // a pencil
            if (habit == 2) ray.origin += spread * glm::length(ray.direction) * jitter();     // side by side
            if (habit == 3) ray = rays_.through_the_box();
            if (habit == 4 && i % 2) ray = {ray.origin, -ray.direction};  // two ways
            if (habit == 5)
                ray.direction =
                    i < 5 ? ray.direction + spread * glm::length(ray.direction) * jitter() : other.direction;
            if (!is_ray(ray)) ray = first.ray;
            ray.direction = glm::normalize(ray.direction);
            Interval& range = packet.ranges[i] = {first.range.min * length, first.range.max * length};
            if (below(3) == 0) range.max = range.min + unit() * Real(20);
            if (below(8) == 0) range.min = unit() * Real(10);
        }
        if (below(2)) packet.active = unsigned(bits_()) & kAllLanes;
        return packet;
    }

private:
    HardRays::Query forwards() {
        for (;;) {
            const HardRays::Query q = rays_.next();
            if (q.range.min >= 0) return q;
        }
    }
    Real unit() { return Real(double(bits_() >> 11) * 0x1p-53); }
    std::uint64_t below(std::uint64_t n) { return bits_() % n; }
    Vec3 jitter() {
        const Real x = unit(), y = unit();
        return Vec3(x, y, unit()) - Real(0.5);
    }

    HardRays rays_;
    std::mt19937_64 bits_;
};

}  // namespace rays::packets::tests
