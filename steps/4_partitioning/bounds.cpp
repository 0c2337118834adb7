// Boxes around primitives.
#include <algorithm>
#include <cmath>

#include "4_partitioning/partitioning.h"
#include "core/unfinished.h"

namespace rays {

Bounds bounds_of(const Scene& scene, Primitive primitive) {
    // Task 4.1: The box of the shape in its own space (of a mesh: of the face), moved by the object's transform, cut down to
    // the boxes of its clips.
    unfinished("4.1");
    return {};
}

}  // namespace rays
