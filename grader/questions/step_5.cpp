// The questions of step 5, task by task.
#include "questions/step_5.h"

namespace rays::grader {

std::vector<Question> questions_5_distributed(std::uint64_t seed) {
    using namespace step_5;
    std::vector<Question> all;
    std::uint64_t task = 0;
    for (const auto make : {regular_and_random, jittered, multi_jittered, sobol, shapes, filters, lenses, area_lights,
                            times, rough_surfaces, errors, dimensions, blurs}) {
        // Every task has dice of its own: a question more in one does not change the others.
        for (Question& question : make(seed * 16 + task)) all.push_back(std::move(question));
        ++task;
    }
    return all;
}

}  // namespace rays::grader
