// How much is enough: for a pixel, and for a scene.
#include <algorithm>
#include <cmath>
#include <limits>

#include "5_distributed/distributed.h"
#include "core/unfinished.h"

namespace rays {

// ---- Task 5.11: enough? ---------------------------------------------------------------------------------------------

float standard_error(const Estimate& estimate) {
    // Task 5.11: The variance of the groups' means (divided by one less than their number: their own mean is an estimate, too)
    // over their number is that of the mean. Fewer samples than groups: nothing is known, the error is infinite.
    unfinished("5.11");
    return {};
}

bool is_enough(float own, std::span<const float> around, float wanted) {
    // Task 5.11: Its own error is small enough, and those around it are not more than four times that.
    unfinished("5.11");
    return {};
}

// ---- Task 5.12: dimensions ------------------------------------------------------------------------------------------

std::uint32_t dimension_of(Purpose purpose, std::uint32_t number, const Purposes& scene) {
    // Task 5.12: The pixel is 0. Then the lens, if there is one; each light's point; the time; a second dimension for each light,
    // which only balls need; and all above are for rough surfaces, of which nobody knows how many there will be.
    unfinished("5.12");
    return {};
}

// ---- Task 5.13: no more than a scene needs --------------------------------------------------------------------------

Real largest_blur_px(const Camera& camera, const Raster& raster, Real nearest, Real farthest) {
    // Task 5.13: A point at depth z blurs over the lens's width times |z - f| / z in the plane of focus at f, where a pixel is f / d
    // times as wide as on the film at distance d. It grows towards both ends: the larger one counts.
    unfinished("5.13");
    return {};
}

Real widest_penumbra(Real light_diameter, Real light_to_edge, Real edge_to_receiver) {
    // Task 5.13: Similar triangles at the edge.
    unfinished("5.13");
    return {};
}

}  // namespace rays
