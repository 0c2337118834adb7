// Beyond the steps: blocks of pixels, eight rays at once through all of them.
#include "renderer/packets.h"

#include "packets/tracer.h"

namespace rays {
namespace packets {
namespace {

class ScenePackets final : public Packets {
public:
    explicit ScenePackets(const Scene& scene) : intersector_(scene) {}
    const Intersector& intersector() const override { return intersector_.single(); }
    std::unique_ptr<PacketTracer> tracer(World& world) const override {
        return std::make_unique<Tracer>(intersector_, world);
    }

private:
    PacketIntersector intersector_;
};

}  // namespace
}  // namespace packets

std::unique_ptr<Packets> make_packets(const Scene& scene) {
    // Below 0, what weighs nothing is traced, too: that is for single rays.
    if (!(scene.settings.adc_bailout >= 0) || scene.settings.max_trace_level < 1) return nullptr;
    return std::make_unique<packets::ScenePackets>(scene);
}

}  // namespace rays
