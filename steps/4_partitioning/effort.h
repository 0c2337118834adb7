// What a structure did for a ray, for those who ask: cost maps, charts, lectures.
#pragma once

#include <cstdint>
#include <vector>

#include "4_partitioning/partitioning.h"

namespace rays {

struct Effort {
    std::uint64_t nodes = 0;  ///< cells or nodes that the ray visited
    std::uint64_t tests = 0;  ///< primitives asked
    /// When not null: the boxes of the cells or leaves visited, in the order of the visit.
    std::vector<Bounds>* visited = nullptr;
};

/// Null but while somebody counts, on the thread that counts. A structure looks once a ray.
extern constinit thread_local Effort* effort;

/// Counts what one thread's rays cost between construction and destruction.
class EffortCount {
public:
    EffortCount() : before_(effort) { effort = &own_; }
    ~EffortCount() { effort = before_; }
    EffortCount(const EffortCount&) = delete;
    EffortCount& operator=(const EffortCount&) = delete;

    Effort& so_far() { return own_; }

private:
    Effort own_;
    Effort* before_;
};

}  // namespace rays
