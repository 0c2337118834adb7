// The questions of step 3, task by task.
#include "questions/step_3.h"

namespace rays::grader {

std::vector<Question> questions_3_recursion(std::uint64_t seed) {
    using namespace step_3;
    std::vector<Question> all;
    std::uint64_t task = 0;
    for (const auto make : {mirrors, refractions, fresnels, finishes, borders, absorptions, glass_shadows, prunings,
                            reflections, transmissions, trees}) {
        // Every task has dice of its own: a question more in one does not change the others.
        for (Question& question : make(seed * 16 + task)) all.push_back(std::move(question));
        ++task;
    }
    return all;
}

}  // namespace rays::grader
