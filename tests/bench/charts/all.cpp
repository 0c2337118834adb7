#include "charts.h"

namespace rays::bench {

const std::vector<NamedChart>& all_charts() {
    static const std::vector<NamedChart> charts{
        {1, float_and_double},      {1, float_against_double},  {1, sphere_near},   {1, sphere_far},
        {1, quadric_near},          {1, quadric_far},           {1, torus_methods}, {1, patch_methods},
        {1, step_1_against_povray}, {2, step_2_against_povray},
    };
    return charts;
}

}  // namespace rays::bench
