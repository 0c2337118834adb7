// Who is asked: the structures of step 4, and Embree beside them.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "batch.h"
#include "bodies.h"

namespace rays::bench {

/// A structure over bodies that outlive it.
class Structure {
public:
    virtual ~Structure() = default;

    /// Asks every ray for its nearest hit, one after the other; the sum of the distances of those that hit.
    virtual Real nearest(const Batch& batch) const = 0;
    /// How many rays hit anything.
    virtual std::size_t occluded(const Batch& batch) const = 0;
    /// The distance to the nearest hit of each ray, infinite where there is none.
    virtual std::vector<Real> distances(const Batch& batch) const = 0;
    /// What it occupies beside the bodies themselves.
    virtual std::size_t bytes() const = 0;
};

struct Contender {
    std::string name;      ///< "bvh"
    std::string settings;  ///< in words
    std::size_t most = 0;  ///< bodies beyond which it takes too long; 0: none
    std::unique_ptr<Structure> (*build)(const Bodies&);
};

/// none, grid, octree, bvh.
std::vector<Contender> our_contenders();
/// Embree, or nobody in a build without it.
std::vector<Contender> other_contenders();

/// How answers differ from the truth of a batch.
struct Disagreement {
    std::size_t lost = 0;       ///< missed what is there
    std::size_t found = 0;      ///< hit where nothing is
    std::size_t elsewhere = 0;  ///< hit in another distance: by more than kSameDistance of it
    std::size_t all() const { return lost + found + elsewhere; }
};
/// A thousand roundings of float: triangles seen at a grazing angle are known no better than that.
inline constexpr Real kSameDistance = Real(1e-4);
/// Throws std::invalid_argument when there are not as many answers as rays.
Disagreement disagreement(const Batch& truth, const std::vector<Real>& distances);

}  // namespace rays::bench
