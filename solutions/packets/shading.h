// Step 2 for eight points of the same material: what they send to the viewer.
#pragma once

#include <vector>

#include "3_recursion/recursion.h"
#include "packets/batch.h"
#include "packets/hits.h"
#include "packets/intersector.h"

namespace rays::packets {

/// As eight of `Surface`, all of them of one finish.
struct Surfaces {
    Mask are;
    Vec3s point, normal, to_viewer;
    Radiances color;
    Floats opacity{1.0f};
    Radiances clear;
    const Finish* finish;
    ObjectNumbers object;
    Number tree[kLanes] = {};  ///< the sample or pixel that it is seen by
};

/// For each material the number of one that looks like it: the same finish, and the same pigment or each one opaque
/// colour of its own.
std::vector<std::uint32_t> look_alikes(const Scene& scene);

/// Points of materials that look alike; `normal` is turned to the viewer.
Surfaces surfaces_at(const Scene& scene, Mask lanes, const Vec3s& point, const Vec3s& normal, const Vec3s& to_viewer,
                     const std::uint32_t (&materials)[kLanes]);

/// What of a light is the same for all points.
struct Lamp {
    explicit Lamp(const Light& light);

    Vec3 axis;           ///< from the light to what it points at
    Real full, nothing;  ///< spotlights: 1 - cosine of the half angles of full light and of its end
};

/// How much of the light number `light` gets to the points, in the given directions and distances.
class Shadows {
public:
    Shadows(const PacketIntersector& intersector, const World& world)
        : intersector_(intersector),
          world_(world),
          suspects_(world.scene.lights.size(), Suspects(world.scene.objects.size())),
          is_behind_glass_(world.scene.lights.size()) {}

    Radiances visibility(std::size_t light, const Surfaces& at, Mask lanes, const Vec3s& to_light, Reals distance,
                         const Inside& inside);

private:
    Radiances filtered(const Rays& rays, Mask open, Span span, const Inside& inside) const;

    const PacketIntersector& intersector_;
    const World& world_;
    std::vector<Suspects> suspects_;     ///< of each light
    std::vector<bool> is_behind_glass_;  ///< did the last rays to each light meet clear things only?
};

/// `samples`: null, or where the lights are for each sample.
Radiances direct_light(const Scene& scene, const std::vector<Lamp>& lamps, Shadows& shadows, const SampleRays* samples,
                       const Surfaces& surfaces, const Inside& inside);

/// What is left of light after these ways: task 3.6. fade_distance is positive.
Radiances absorption(const Interior& interior, Reals distance);

/// x^exponent for positive x; 1 for the lanes that are not asked. To less than 4 units in the last place.
Reals power(Mask lanes, Reals x, double exponent);

}  // namespace rays::packets
