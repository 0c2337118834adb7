// The boxes of a leaf's items, one after another in memory: most items are passed by, and need not be looked up at all.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "4_partitioning/partitioning.h"
#include "core/ray.h"

namespace rays::octree {

struct ItemBox {
    std::array<float, 3> min, max;
};

/// Rounded outwards.
inline ItemBox item_box(const Bounds& bounds) {
    constexpr float kLargest = std::numeric_limits<float>::max();
    ItemBox box;
    for (int a = 0; a < 3; ++a) {
        box.min[static_cast<std::size_t>(a)] = std::nextafter(static_cast<float>(bounds.min[a]), -kLargest);
        box.max[static_cast<std::size_t>(a)] = std::nextafter(static_cast<float>(bounds.max[a]), kLargest);
    }
    return box;
}

/// A ray of without_zeros, to hold boxes against. The boxes' slack covers its roundings.
class BoxRay {
public:
    BoxRay(const Ray& ray, Real begin) : origin_(ray.origin), inverse_(Real(1) / ray.direction), begin_(begin) {}

    bool meets(const ItemBox& box, Real far) const {
        const Vec3 one = (Vec3(box.min[0], box.min[1], box.min[2]) - origin_) * inverse_;
        const Vec3 other = (Vec3(box.max[0], box.max[1], box.max[2]) - origin_) * inverse_;
        const Vec3 enter = glm::min(one, other), exit = glm::max(one, other);
        return std::max(std::max(enter.x, enter.y), std::max(enter.z, begin_)) <=
               std::min(std::min(exit.x, exit.y), std::min(exit.z, far));
    }

private:
    Vec3 origin_, inverse_;
    Real begin_;
};

}  // namespace rays::octree
