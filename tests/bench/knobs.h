// The programs in which one constant of a solution has another value (knobs.cmake).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rays::bench {

struct Knob {
    int step = 0;
    std::string name;   ///< "octree-leaf"
    std::string value;  ///< "16"
    std::filesystem::path program;
};

/// Those of one step, in the order of bin/knobs.txt; nobody when there is no such file. Throws std::runtime_error for a
/// line that is none.
std::vector<Knob> read_knobs(const std::filesystem::path& bin, int step);

}  // namespace rays::bench
