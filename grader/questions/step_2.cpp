// The questions of step 2, task by task.
#include "questions/step_2.h"

namespace rays::grader {

std::vector<Question> questions_2_phong(std::uint64_t seed) {
    using namespace step_2;
    std::vector<Question> all;
    std::uint64_t task = 0;
    for (const auto make :
         {pigments, ambients, diffuses, phongs, blinns, fadings, cones, illuminations, shadows, sums}) {
        // Every task has dice of its own: a question more in one does not change the others.
        for (Question& question : make(seed * 16 + task)) all.push_back(std::move(question));
        ++task;
    }
    return all;
}

}  // namespace rays::grader
