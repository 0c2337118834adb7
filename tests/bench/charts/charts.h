// All charts. To add one: write a function in a file of its own, declare it here, and name it in all.cpp.
#pragma once

#include <vector>

#include "chart.h"
#include "laboratory.h"

namespace rays::bench {

// ---- Step 1 ---------------------------------------------------------------------------------------------------------

Chart float_and_double(Laboratory& laboratory);
Chart float_against_double(Laboratory& laboratory);
Chart sphere_near(Laboratory& laboratory);
Chart sphere_far(Laboratory& laboratory);
Chart quadric_near(Laboratory& laboratory);
Chart quadric_far(Laboratory& laboratory);
Chart torus_methods(Laboratory& laboratory);
Chart patch_methods(Laboratory& laboratory);
Chart step_1_against_povray(Laboratory& laboratory);

// ---- Step 2 ---------------------------------------------------------------------------------------------------------

Chart step_2_against_povray(Laboratory& laboratory);

// ---- Step 3 ---------------------------------------------------------------------------------------------------------

Chart tree_by_time(Laboratory& laboratory);
Chart tree_by_rays(Laboratory& laboratory);
Chart fresnel_formulas(Laboratory& laboratory);
Chart schlick_in_pictures(Laboratory& laboratory);
Chart step_3_against_povray(Laboratory& laboratory);

// ---- Step 4 ---------------------------------------------------------------------------------------------------------

Chart beside_embree(Laboratory& laboratory);
Chart growth_with_spheres(Laboratory& laboratory);
Chart growth_with_triangles(Laboratory& laboratory);
Chart growth_of_build(Laboratory& laboratory);
Chart growth_of_memory(Laboratory& laboratory);
Chart knobs_with_spheres(Laboratory& laboratory);
Chart knobs_with_triangles(Laboratory& laboratory);
Chart structures_in_scenes(Laboratory& laboratory);
Chart samples_of_stadium(Laboratory& laboratory);
Chart samples_of_checkers(Laboratory& laboratory);
Chart step_4_against_povray(Laboratory& laboratory);
Chart bench_against_povray(Laboratory& laboratory);

// ---- Step 5 ---------------------------------------------------------------------------------------------------------

Chart edges_by_time(Laboratory& laboratory);
Chart edges_by_samples(Laboratory& laboratory);
Chart area_light_by_time(Laboratory& laboratory);
Chart area_light_by_samples(Laboratory& laboratory);
Chart lens_by_time(Laboratory& laboratory);
Chart lens_by_samples(Laboratory& laboratory);
Chart motion_by_time(Laboratory& laboratory);
Chart motion_by_samples(Laboratory& laboratory);
Chart glossy_by_time(Laboratory& laboratory);
Chart glossy_by_samples(Laboratory& laboratory);
Chart to_reach_an_error(Laboratory& laboratory);
Chart depth_of_field_formulas(Laboratory& laboratory);

struct NamedChart {
    int step;
    Chart (*make)(Laboratory&);
};

/// In the order of the page.
const std::vector<NamedChart>& all_charts();

}  // namespace rays::bench
