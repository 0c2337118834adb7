#include "charts.h"

namespace rays::bench {

const std::vector<NamedChart>& all_charts() {
    static const std::vector<NamedChart> charts{
        {1, float_and_double},
        {1, float_against_double},
        {1, sphere_near},
        {1, sphere_far},
        {1, quadric_near},
        {1, quadric_far},
        {1, torus_methods},
        {1, patch_methods},
        {1, step_1_against_povray},
        {2, step_2_against_povray},
        {3, tree_by_time},
        {3, tree_by_rays},
        {3, fresnel_formulas},
        {3, schlick_in_pictures},
        {3, step_3_against_povray},
        {4, beside_embree},
        {4, growth_with_spheres},
        {4, growth_with_triangles},
        {4, growth_of_build},
        {4, growth_of_memory},
        {4, knobs_with_spheres},
        {4, knobs_with_triangles},
        {4, structures_in_scenes},
        {4, samples_of_stadium},
        {4, samples_of_checkers},
        {4, step_4_against_povray},
        {4, bench_against_povray},
        {5, edges_by_time},
        {5, edges_by_samples},
        {5, area_light_by_time},
        {5, area_light_by_samples},
        {5, lens_by_time},
        {5, lens_by_samples},
        {5, motion_by_time},
        {5, motion_by_samples},
        {5, glossy_by_time},
        {5, glossy_by_samples},
        {5, to_reach_an_error},
        {5, depth_of_field_formulas},
    };
    return charts;
}

}  // namespace rays::bench
