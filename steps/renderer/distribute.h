// Pictures that are estimates: every pixel is a mean over samples, each with its own point of the pixel, the lens and
// the lights, its own time and its own slopes of rough surfaces. Step 5 says which; here it is put together.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "5_distributed/distributed.h"
#include "renderer/camera_media.h"
#include "renderer/moving_intersector.h"
#include "renderer/packets.h"
#include "renderer/render.h"

namespace rays {

/// Has the scene something that one ray a pixel cannot show: lights with an area, a lens, motion, rough surfaces?
bool needs_distribution(const Scene& scene);

/// What all threads share of a scene that is distributed over.
class Distribution {
public:
    /// The scene must be prepared and outlive it.
    Distribution(const Scene& scene, const RenderOptions& options);

    const Scene& scene() const { return scene_; }
    const RenderOptions& options() const { return options_; }
    Pattern pattern() const { return pattern_; }
    bool moves() const { return moves_; }
    /// For scenes that stand still; those that move have an intersector a thread.
    const Intersector* intersector() const { return packets_ ? &packets_->intersector() : still_.get(); }
    /// Null where samples are traced one by one.
    const Packets* packets() const { return packets_.get(); }
    /// A sample of this number and of so many in all.
    Draw draw(int x, int y, std::uint32_t sample, std::uint32_t samples) const;

private:
    const Scene& scene_;
    const RenderOptions& options_;
    Pattern pattern_;
    bool moves_;
    std::unique_ptr<Packets> packets_;
    std::unique_ptr<Intersector> still_;
};

/// A sample's choices but for rough surfaces, which choose when they are met.
struct Chosen {
    Ray ray;
    float weight = 1;  ///< of the pixel's filter
};

/// One thread's: the scene at the time of the sample in hand, its lights at their chosen points.
class SampleTracer final : private Roughness, private SampleRays::Roughness {
public:
    explicit SampleTracer(const Distribution& distribution);

    /// The radiance of one sample, its filter's weight included.
    Radiance sample(int x, int y, const Draw& draw);

    /// The same for samples `first.sample` to `end` - 1, many of which may be traced together, with others of the row:
    /// what(number(sample), radiance, pruned) is called for each one that was added, in this order, some time before
    /// flush() returns.
    template <class Number, class What>
    void add(int x, int y, Draw first, std::uint32_t end, Number number, What what) {
        while (first.sample < end) {
            const std::uint32_t run = std::min(end - first.sample, kRun - first.sample % kRun);
            if (!tracer_)
                add_single(x, y, first, run, number, what);
            else
                add_together(x, y, first, run, number, what);
            first.sample += run;
        }
    }
    template <class What>
    void flush(What what) {
        if (!tracer_ || rays_.count == 0) return;
        trace_together();
        for (int i = 0; i < rays_.count; ++i) what(numbers_[i], weights_[i] * brought_[i], pruned_[i]);
        rays_.count = 0;
    }

private:
    static constexpr std::uint32_t kRun = SampleRays::kTogether;

    template <class Number, class What>
    void add_single(int x, int y, Draw draw, std::uint32_t count, Number number, What what) {
        for (const std::uint32_t end = draw.sample + count; draw.sample < end; ++draw.sample) {
            world_->pruned = 0;
            const Radiance brought = sample(x, y, draw);
            what(number(draw.sample), brought, world_->pruned);
        }
    }
    template <class Number, class What>
    void add_together(int x, int y, const Draw& first, std::uint32_t count, Number number, What what) {
        if (rays_.count + static_cast<int>(count) > SampleRays::kMost) flush(what);
        const int at = rays_.count;
        put(x, y, first, count);
        for (std::uint32_t i = 0; i < count; ++i)
            numbers_[static_cast<std::uint32_t>(at) + i] = number(first.sample + i);
    }

    Chosen choose(int x, int y, const Draw& draw);
    void put(int x, int y, Draw draw, std::uint32_t count);
    void put_one(int x, int y, const Draw& draw);
    void trace_together();
    void tilt(Surface& surface, int above) override;
    void tilt(int ray, Surface& surface, int above) override;
    Draw draw_for(const Draw& sample, Purpose purpose, std::uint32_t number) const;
    Vec2 point(const Draw& sample, Purpose purpose, std::uint32_t number = 0) const;
    Real one_number(const Draw& sample, Purpose purpose, std::uint32_t number = 0) const;

    const Distribution& distribution_;
    std::unique_ptr<Scene> moving_scene_;  ///< null: the scene stands still
    std::unique_ptr<Motion> motion_;
    std::unique_ptr<Intersector> moving_intersector_;
    std::unique_ptr<World> world_;
    std::unique_ptr<CameraMedia> media_;
    std::vector<Light> lights_;
    bool has_area_lights_ = false;
    Purposes purposes_;
    Draw draw_;  ///< of the sample that is traced by itself

    std::unique_ptr<PacketTracer> tracer_;    ///< null: one by one
    std::unique_ptr<SampleChooser> chooser_;  ///< null: they are chosen one by one
    Inside everywhere_;
    SampleRays rays_;
    Draw draws_[SampleRays::kMost];
    std::uint32_t numbers_[SampleRays::kMost];
    float weights_[SampleRays::kMost];
    Radiance brought_[SampleRays::kMost];
    double pruned_[SampleRays::kMost];
};

/// As render(), by samples.
Film render_distributed(const Scene& scene, const RenderOptions& options, Residual* residual);

}  // namespace rays
