// Step 5 for eight samples of a pixel at once: their points of the pixel, the lens and the lights, and the camera's rays.
#pragma once

#include "5_distributed/distributed.h"
#include "packets/lanes.h"
#include "packets/rays.h"
#include "renderer/packets.h"

namespace rays::packets {

/// As eight of Vec2.
struct Vec2s {
    Reals x, y;
};

/// Eight samples that follow each other, the first of which is `first`, see it at these points: sobol_point's.
Vec2s sobol_points(const Draw& first);

/// What chooses them in a scene that this can be done for: Sobol points, box filter, a round lens or none, lights with a point
/// or a flat area.
class CameraSamples final : public SampleChooser {
public:
    CameraSamples(const Scene& scene, const Raster& raster, const Purposes& purposes);

    /// Puts `count` (at most eight) rays behind those that are there.
    void add(int x, int y, const Draw& first, int count, SampleRays& rays) const override;

private:
    Rays camera_rays(int x, int y, Vec2s offset, Vec2s lens) const;
    Rays through_lens(const Rays& pinhole, Vec2s lens) const;

    const Scene& scene_;
    Raster raster_;
    Purposes purposes_;
    Vec3 axis_, lens_right_, lens_up_;
};

}  // namespace rays::packets
