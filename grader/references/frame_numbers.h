// The numbers by which the frames of an averaged reference differ.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace rays {

/// The frames of a mean are this many independent replicates, one after another, all of the same size: what they differ
/// by tells how good the mean is.
inline constexpr int kReplicates = 8;

/// Frame_u0 to Frame_u15, each in [0, 1), in millionths: POV-Ray passes on six digits of what the command line
/// declares.
using FrameNumbers = std::array<int, 16>;

/// Of frame `frame` of `frames` (a multiple of kReplicates). Within a replicate the numbers fill the 16 dimensions more
/// evenly than chance: four groups of the four first dimensions of Sobol's sequence, each group in an order of its own
/// and each number scrambled as Owen does (Burley, "Practical hash-based Owen scrambling", JCGT 9(4), 2020; direction
/// numbers: Joe and Kuo, "Constructing Sobol sequences with better two-dimensional projections", 2008). A group is what
/// one effect or two need together, its best two dimensions first: pixel and lens (0 1 2 3), first light and time
/// (5 6 7 4), second light (8 9 10 15), both tilts (11 12 13 14). Depends on nothing but its arguments.
FrameNumbers frame_numbers(int frame, int frames);

/// As options of POV-Ray: "Declare=Frame=3", "Declare=Frame_u0=0.123456", ...
std::vector<std::string> frame_declarations(int frame, int frames);

}  // namespace rays
