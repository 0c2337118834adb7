// The seam for tracing neighbouring rays together. A program without such a thing (every student's) asks ray by ray.
#pragma once

#include <memory>

#include "3_recursion/recursion.h"

namespace rays {

inline constexpr int kPacketWidth = 4, kPacketHeight = 2;  ///< pixels of a packet
inline constexpr int kPacketSize = kPacketWidth * kPacketHeight;

/// One thread's.
class PacketTracer {
public:
    virtual ~PacketTracer() = default;
    /// What `radiance` of renderer/radiance.h gives for each of the rays whose bit is set in `active`, and what pruning
    /// leaves open in each (World::pruned). Directions of any length, all rays in the same media.
    virtual void radiance(const Ray (&rays)[kPacketSize], unsigned active, const Inside& inside,
                          Radiance (&result)[kPacketSize], double (&pruned)[kPacketSize]) = 0;
};

/// What all threads share.
class Packets {
public:
    virtual ~Packets() = default;
    /// For single rays.
    virtual const Intersector& intersector() const = 0;
    /// `world` is the thread's own, over this intersector.
    virtual std::unique_ptr<PacketTracer> tracer(World& world) const = 0;
};

/// Null where there is nothing to trace packets with. The scene must outlive it.
std::unique_ptr<Packets> make_packets(const Scene& scene);

}  // namespace rays
