// The seam for tracing neighbouring rays together. A program without such a thing (every student's) asks ray by ray.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "3_recursion/recursion.h"
#include "5_distributed/distributed.h"

namespace rays {

/// A square of neighbouring pixels, given by its upper left corner. Eight that follow each other lie in two rows of
/// four; eights follow each other along Morton's curve, so that many in a row are near each other, too.
struct Block {
    static constexpr int kSide = 16, kSize = kSide * kSide;
    static constexpr int kRun = 4;  ///< so many that follow each other are side by side

    int x = 0, y = 0;
    int column(int i) const { return x + across(i / 8) * kRun + i % kRun; }
    int row(int i) const { return y + down(i / 8) * 2 + i % 8 / kRun; }

    /// Where an eight is: how many are to its left and above it.
    static int across(int eight) { return (eight >> 1 & 1) | (eight >> 2 & 2); }
    static int down(int eight) { return (eight & 1) | (eight >> 1 & 2) | (eight >> 2 & 4); }
};

/// Rays of samples, each with its own tree: where it starts, where the lights are for it, how its rough surfaces tilt.
struct SampleRays {
    static constexpr int kMost = 64;
    static constexpr int kTogether = 8;              ///< so many at most are chosen at a time...
    static constexpr int kRoom = kMost + kTogether;  ///< ...and may be written, though fewer count

    int count = 0;
    double origin[3][kRoom], direction[3][kRoom];  ///< directions of unit length
    /// Component a of the place of light l for ray i: light[3 * l + a][i]. Empty: where the scene has them.
    std::vector<std::array<double, kRoom>> light;
    /// Null: all surfaces are smooth.
    class Roughness {
    public:
        virtual ~Roughness() = default;
        virtual void tilt(int ray, Surface& surface, int above) = 0;
    }* roughness = nullptr;
};

/// Chooses samples as step 5 does, many at a time.
class SampleChooser {
public:
    virtual ~SampleChooser() = default;
    /// Puts `count` samples of a pixel, at most kTogether, behind the rays that are there; `first` is the draw of the
    /// first one, whose number is a multiple of kTogether.
    virtual void add(int x, int y, const Draw& first, int count, SampleRays& rays) const = 0;
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
    /// Sets `brought` to what each ray brings and adds to `pruned`. All rays start in the same media.
    virtual void trace(const SampleRays& rays, const Inside& inside, Radiance (&brought)[SampleRays::kMost],
                       double (&pruned)[SampleRays::kMost]) = 0;
};

/// What all threads share.
class Packets {
public:
    virtual ~Packets() = default;
    /// For single rays.
    virtual const Intersector& intersector() const = 0;
    /// `world` is the thread's own, over this intersector.
    virtual std::unique_ptr<PacketTracer> tracer(World& world) const = 0;
    /// For Sobol points and the box filter. Null where the lens or the lights are not the usual ones.
    virtual std::unique_ptr<SampleChooser> chooser(const Raster& raster, const Purposes& purposes) const = 0;
};

/// Null where there is nothing to trace packets with. The scene must outlive it.
std::unique_ptr<Packets> make_packets(const Scene& scene);

}  // namespace rays
