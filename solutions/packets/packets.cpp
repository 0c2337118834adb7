// Beyond the steps: blocks of pixels, eight rays at once through all of them.
#include "renderer/packets.h"

#include <algorithm>

#include "core/error.h"
#include "packets/camera_samples.h"
#include "packets/tracer.h"

namespace rays {
namespace packets {
namespace {

class ScenePackets final : public Packets {
public:
    explicit ScenePackets(const Scene& scene) : scene_(scene), intersector_(scene) {}
    const Intersector& intersector() const override { return intersector_.single(); }
    /// Deep trees of glass run thin: more rays fill more lanes. Where a hierarchy has to be walked, rays that are
    /// nearer to each other are worth more (NOTES.md).
    std::unique_ptr<PacketTracer> tracer(World& world) const override {
        return std::make_unique<Tracer>(intersector_, world);
    }

    std::unique_ptr<SampleChooser> chooser(const Raster& raster, const Purposes& purposes) const override {
        const auto& lights = scene_.lights;
        const bool has_balls =
            std::any_of(lights.begin(), lights.end(), [](const Light& l) { return l.area && l.orient; });
        if (has_balls || scene_.camera.aperture_blades > 0) return nullptr;
        return std::make_unique<CameraSamples>(scene_, raster, purposes);
    }

private:
    const Scene& scene_;
    PacketIntersector intersector_;
};

}  // namespace
}  // namespace packets

std::unique_ptr<Packets> make_packets(const Scene& scene) {
#ifdef __AVX512DQ__
    if (!__builtin_cpu_supports("avx512dq"))
        throw InputError(
            "this program was built for processors with AVX-512, which this one has not; build it here, "
            "or with cmake -DRAYSTEPS_LANES=avx2");
#endif
    // Below 0, what weighs nothing is traced, too: that is for single rays.
    if (!(scene.settings.adc_bailout >= 0) || scene.settings.max_trace_level < 1) return nullptr;
    return std::make_unique<packets::ScenePackets>(scene);
}

}  // namespace rays
