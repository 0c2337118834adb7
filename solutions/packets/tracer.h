// Step 3 for blocks of pixels: the trees of their rays grow level by level. What a level meets is lit together,
// look by look; what it mirrors makes one batch of rays, what it lets through one for each medium.
#pragma once

#include <memory>
#include <vector>

#include "packets/batch.h"
#include "packets/intersector.h"
#include "packets/shading.h"
#include "renderer/packets.h"

namespace rays::packets {

class Tracer final : public PacketTracer {
public:
    Tracer(const PacketIntersector& intersector, World& world);

    void add_radiance(const Raster& raster, Block block, Vec2 offset, const Inside& inside,
                      Radiance (&sum)[Block::kSize], double (&pruned)[Block::kSize]) override;
    void trace(const SampleRays& rays, const Inside& inside, Radiance (&brought)[SampleRays::kMost],
               double (&pruned)[SampleRays::kMost]) override;

private:
    /// Tilts for rays that are traced one by one.
    class SingleRoughness final : public rays::Roughness {
    public:
        void tilt(Surface& surface, int above) override { samples->roughness->tilt(ray, surface, above); }
        const SampleRays* samples = nullptr;
        int ray = 0;
    };

    /// A batch, what it meets, and what it brings. Columns by the number of the ray.
    struct Frame {
        Batch batch;
        LightColumns brought;

        double distance[Block::kSize];
        VectorColumns point, normal;  ///< the normal is turned to the viewer once the surface is lit
        std::uint32_t object[Block::kSize], material[Block::kSize];

        Numbers hits, alike;  ///< rays that met something and are still to be lit; those in hand. Not on the stack: a
                              ///< tree may be a thousand levels deep
        Numbers mirrors;      ///< rays that are mirrored, with their share of it and the weight of what they bring
        LightColumns share;
        float mirror_weight[Block::kSize];
        Numbers clear;             ///< rays that go through
        Numbers total_reflection;  ///< those of them that cannot
        LightColumns tint;
    };

    /// The frame of rays with so many batches above.
    Frame& frame(std::size_t depth);
    void start(Frame& next, const Frame& from, const Inside& inside, bool straight) const;
    void add_camera_rays(const Raster& raster, Block block, Vec2 offset, Frame& frame) const;

    void trace(std::size_t depth);
    void trace_single(Frame& frame);
    void see_as(Number sample);
    void tilt(const Frame& frame, const Chunk& chunk, Surfaces& at) const;
    void meet(Frame& frame) const;
    void light(Frame& frame, const Numbers& hits);
    void divide(Frame& frame, const Chunk& chunk, const Material& material, const Surfaces& at);
    void prune(const Frame& frame, const Chunk& chunk, unsigned rays, Floats weight);
    void go_through(std::size_t depth);
    void send_through(Frame& frame, Medium medium, Frame& next);
    void mirror(std::size_t depth);
    void send_mirrored(const Frame& frame, const Numbers& rays, Frame& next);
    void bring_home(Frame& frame, const Frame& next, const LightColumns* share) const;

    /// Adds rays to `next` that start where those of the chunk met something, but for those that are pruned: task 3.8.
    void branch(const Frame& from, const Chunk& chunk, unsigned rays, const Vec3s& directions, Floats weight,
                Frame& next);
    void raise(const Frame& from, Frame& next) const;
    Reals fresnel_iors(const Frame& frame, const Chunk& chunk) const;
    const Interior* fading(const Frame& frame, Medium medium) const;
    void fade(const Interior& interior, const Frame& frame, Frame& next) const;
    Medium medium(const Frame& frame, Number ray) const { return medium_of(scene_, frame.object[ray]); }

    const Scene& scene_;
    const PacketIntersector& intersector_;
    World& world_;
    const std::vector<Lamp> lamps_;
    const std::vector<std::uint32_t> look_alikes_;  ///< of materials
    Shadows shadows_;
    bool has_exponents_;  ///< of mirrors
    std::vector<std::unique_ptr<Frame>> frames_;
    double* pruned_ = nullptr;             ///< of the block in hand
    const SampleRays* samples_ = nullptr;  ///< in hand; null: a block of pixels
    SingleRoughness single_roughness_;
    std::vector<Light> lights_;  ///< as the ray sees them that is traced by itself
};

}  // namespace rays::packets
