#include "grader/course.h"

namespace rays::grader {

std::vector<Question> questions_of(int step, std::uint64_t seed) {
    switch (step) {
        case 1: return questions_1_ray_casting(seed);
        case 2: return questions_2_phong(seed);
        case 3: return questions_3_recursion(seed);
        case 4: return questions_4_partitioning(seed);
        case 5: return questions_5_distributed(seed);
        default: return {};
    }
}

std::vector<Sweep> sweeps_of(int step, std::uint64_t seed) {
    switch (step) {
        case 1: return sweeps_1_ray_casting(seed);
        case 2: return sweeps_2_phong(seed);
        case 3: return sweeps_3_recursion(seed);
        case 4: return sweeps_4_partitioning(seed);
        case 5: return sweeps_5_distributed(seed);
        default: return {};
    }
}

}  // namespace rays::grader
