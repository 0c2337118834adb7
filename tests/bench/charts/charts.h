// All charts. To add one: write a function in a file of its own, declare it here, and name it in all.cpp.
#pragma once

#include <vector>

#include "chart.h"
#include "laboratory.h"

namespace rays::bench {

// ---- Step 1
// ----------------------------------------------------------------------------------------------------------
Chart float_and_double(Laboratory& laboratory);
Chart float_against_double(Laboratory& laboratory);
Chart sphere_near(Laboratory& laboratory);
Chart sphere_far(Laboratory& laboratory);
Chart quadric_near(Laboratory& laboratory);
Chart quadric_far(Laboratory& laboratory);
Chart torus_methods(Laboratory& laboratory);
Chart patch_methods(Laboratory& laboratory);
Chart step_1_against_povray(Laboratory& laboratory);

// ---- Step 2
// ----------------------------------------------------------------------------------------------------------
Chart step_2_against_povray(Laboratory& laboratory);

struct NamedChart {
    int step;
    Chart (*make)(Laboratory&);
};

/// In the order of the page.
const std::vector<NamedChart>& all_charts();

}  // namespace rays::bench
