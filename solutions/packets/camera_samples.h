// Step 5 for eight samples of a pixel at once: their points of the pixel, the lens and the lights, and the camera's
// rays.
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

/// The points of eight samples of a pixel that follow each other: sobol_point's.
class SobolPoints {
public:
    /// `first` is the draw of the first one, the number of which is a multiple of eight: all eight are alike in their
    /// upper bits, and so are the numbers that they are shuffled to.
    explicit SobolPoints(const Draw& first);

    Vec2s of(std::uint32_t dimension);

private:
    static constexpr std::uint32_t kNoPair = ~0u;

    Draw first_;
    __m256i samples_;               ///< bits reversed
    std::uint32_t pair_ = kNoPair;  ///< the even one of the two dimensions that share...
    __m256i index_;                 ///< ...these shuffled numbers...
    std::uint32_t common_ = 0;      ///< ...and all of their bits but the lowest three
};

/// What chooses them in a scene that this can be done for: Sobol points, box filter, a round lens or none, lights with
/// a point or a flat area.
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
