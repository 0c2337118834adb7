// Hits on what moves: structures are built around everywhere that moving things will be.
#pragma once

#include <memory>

#include "4_partitioning/partitioning.h"
#include "core/intersector.h"
#include "renderer/motion.h"

namespace rays {

/// What finds hits in a scene whose moving things stand where Motion::set_time last put them. Everything that moves is
/// partitioned by the box of all its places while the shutter is open; meshes have a structure each, in their own
/// space. The scene must outlive it; it may be used by one thread, the one that sets the time.
std::unique_ptr<Intersector> make_moving_intersector(Scene& scene, Motion& motion, Partition partition);

}  // namespace rays
