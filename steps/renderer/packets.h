// The seam for tracing neighbouring rays together. A program without such a thing (every student's) asks ray by ray.
#pragma once

#include <memory>

#include "3_recursion/recursion.h"

namespace rays {

/// A square of neighbouring pixels, given by its upper left corner. Eight that follow each other lie in two rows of four.
struct Block {
    static constexpr int kSide = 8, kSize = kSide * kSide;

    int x = 0, y = 0;
    int column(int i) const { return x + i / 8 % 2 * 4 + i % 4; }
    int row(int i) const { return y + i / 16 * 2 + i % 8 / 4; }
};

/// One thread's.
class PacketTracer {
public:
    virtual ~PacketTracer() = default;
    /// Adds to each pixel of a block what camera_ray and `radiance` bring it, through its point at `offset`, and to
    /// `pruned` what pruning leaves open (World::pruned). Pixels beyond the raster get nothing. All rays start in the
    /// same media.
    virtual void add_radiance(const Raster& raster, Block block, Vec2 offset, const Inside& inside,
                              Radiance (&sum)[Block::kSize], double (&pruned)[Block::kSize]) = 0;
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
