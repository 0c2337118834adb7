// The octree: boxes cut into eight halves each way, only where there is something, and a walk from the top down.
#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <thread>

#include "4_partitioning/parallel.h"
#include "4_partitioning/primitive_tester.h"
#include "4_partitioning/structures.h"
#include "core/unfinished.h"

namespace rays {

Bounds octant_of(const Bounds& node, unsigned octant) {
    // Task 4.6: Along each axis the lower or the upper half, as the octant's bit says.
    unfinished("4.6");
    return {};
}

unsigned octants_overlapping(const Bounds& node, const Bounds& bounds) {
    // Task 4.6: Along each axis: does it reach the lower half, does it reach the upper one? Faces belong to both sides.
    unfinished("4.6");
    return {};
}

OctreeRay octree_ray(const Bounds& root, const Ray& ray) {
    // Task 4.7: For each axis the t of the near face and of the far one; against the axis the near face is the larger one.
    unfinished("4.7");
    return {};
}

int octants_along(const Slabs& node, unsigned mirror, Span span, std::array<Octant, 4>& octants) {
    // Task 4.7: The middle planes are passed half-way between near and far. The ray begins in the far half along every axis
    // whose middle it has passed before it enters; then it changes halves along the axis that it leaves first.
    unfinished("4.7");
    return {};
}

std::unique_ptr<Intersector> make_octree(const Scene& scene) {
    // Task 4.6: A class like the grid's.
    unfinished("4.6");
    return {};
}

}  // namespace rays
