// Pictures that are estimates: every pixel is a mean over samples, each with its own point of the pixel, the lens and the
// lights, its own time and its own slopes of rough surfaces. Step 5 says which; here it is put together.
#pragma once

#include <memory>
#include <vector>

#include "5_distributed/distributed.h"
#include "renderer/camera_media.h"
#include "renderer/motion.h"
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
    const Intersector* intersector() const { return still_.get(); }
    /// A sample of this number and of so many in all.
    Draw draw(int x, int y, std::uint32_t sample, std::uint32_t samples) const;

private:
    const Scene& scene_;
    const RenderOptions& options_;
    Pattern pattern_;
    bool moves_;
    std::unique_ptr<Intersector> still_;
};

/// One thread's: a scene at the time of the sample in hand, its lights at their chosen points.
class SampleTracer final : private Roughness {
public:
    explicit SampleTracer(const Distribution& distribution);

    /// The radiance of one sample, its filter's weight included.
    Radiance sample(int x, int y, const Draw& draw);
    /// As World::pruned: summed up since it was last set to 0.
    double& pruned() { return world_->pruned; }

private:
    void tilt(Surface& surface) override;
    Draw draw_for(Purpose purpose, std::uint32_t number) const;
    Vec2 point(Purpose purpose, std::uint32_t number = 0) const;
    Real one_number(Purpose purpose, std::uint32_t number = 0) const;

    const Distribution& distribution_;
    std::unique_ptr<Scene> moving_scene_;  ///< null: the scene stands still
    std::unique_ptr<Motion> motion_;
    std::unique_ptr<Intersector> moving_intersector_;
    std::unique_ptr<World> world_;
    std::unique_ptr<CameraMedia> media_;
    std::vector<Light> lights_;
    bool has_area_lights_ = false;
    Draw draw_;
    std::uint32_t rough_surfaces_ = 0;  ///< met by this sample so far
};

/// As render(), by samples.
Film render_distributed(const Scene& scene, const RenderOptions& options, Residual* residual);

}  // namespace rays
