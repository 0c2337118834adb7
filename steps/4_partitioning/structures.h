// The structures of step 4, one a file. make_structure (partitioning.h) is the way in.
#pragma once

#include <memory>

#include "core/intersector.h"
#include "core/scene.h"

namespace rays {

std::unique_ptr<Intersector> make_grid(const Scene& scene);
std::unique_ptr<Intersector> make_octree(const Scene& scene);
std::unique_ptr<Intersector> make_bvh(const Scene& scene);

}  // namespace rays
