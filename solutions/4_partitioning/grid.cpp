#include "4_partitioning/structures.h"
namespace rays {
//> given
std::unique_ptr<Intersector> make_grid(const Scene& scene) { return make_bvh(scene); }
//< given
}  // namespace rays
