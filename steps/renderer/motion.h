// A scene that changes with Time: its numbers are set anew for each sample.
#pragma once

#include <cstdint>
#include <vector>

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

}  // namespace rays
