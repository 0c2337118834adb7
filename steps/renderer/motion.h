// A scene that changes with Time: its numbers are set anew for each sample, and structures are built around everywhere
// that moving things will be.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "4_partitioning/partitioning.h"
#include "core/scene.h"

namespace rays {

/// The scene's numbers as functions of Time. It keeps pointers into the scene: whoever changes the length of its arrays
/// binds them anew.
class Motion {
public:
    explicit Motion(Scene& scene);

    void bind();
    /// Sets every number that changes with Time, and what is computed from them.
    void set_time(Real time);
    /// The objects whose shape, place or clips change, ascending.
    const std::vector<std::uint32_t>& moving() const { return moving_; }
    /// Times between which all numbers are linear functions of Time, from open to close.
    std::vector<Real> knots(Real open, Real close) const;

    /// Do corners of this mesh move one by one?
    bool changes_mesh(std::uint32_t mesh) const;

private:
    struct Number {
        Real* real = nullptr;
        float* single = nullptr;
        const Varying* function = nullptr;
    };
    void find_moving();

    Scene& scene_;
    std::vector<Varying> functions_;
    std::vector<Number> numbers_;
    std::vector<std::uint32_t> moving_, transforms_, polygons_, meshes_, patches_;  ///< what has to be computed anew
};

/// What finds hits in a scene whose moving things stand where Motion::set_time last put them. Everything that moves is
/// partitioned by the box of all its places while the shutter is open; meshes have a structure each, in their own space.
/// The scene must outlive it; it may be used by one thread, the one that sets the time.
std::unique_ptr<Intersector> make_moving_intersector(Scene& scene, Motion& motion, Partition partition);

}  // namespace rays
