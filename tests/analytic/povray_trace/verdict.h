// Two answers to the same ray held against each other.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "ask.h"

namespace rays::povray_trace {

/// A ray that misses or hits by less than this share of the size may go either way. POV-Ray tests bounding boxes in
/// single precision (6e-8), wants half of a sphere's chord, squared, above 1e-10, and takes as one what lies within
/// 1e-6 of a box's face.
inline constexpr double kTie = 2e-6;

struct Difference {
    double off_surface = 0;  ///< of the points along the normal, as a share of the size
    double turned = 0;       ///< of the normals, times the cosine of incidence: a grazing hit slides along the surface
};

/// By kind of ray.
using Counts = std::array<std::size_t, kKindNames.size()>;

struct Verdict {
    std::size_t hits = 0;  ///< both hit, and agree
    Difference worst;      ///< among them
    Counts ties{};         ///< POV-Ray's answer is ours for a ray a hair beside
    Counts leaks{};        ///< POV-Ray went through a seam and found what we find behind it
    Counts imprecise{};    ///< our point is on the surface by its closed form, POV-Ray's root was not polished
    std::vector<std::string> wrong;  ///< the rest, described
};

using Solution = std::function<Meetings(const std::vector<TestRay>&)>;

/// `solution` is asked again for rays on which the two differ.
Verdict compare(const Primitive& primitive, const std::vector<TestRay>& rays, const Meetings& povray,
                const Solution& solution);

}  // namespace rays::povray_trace
