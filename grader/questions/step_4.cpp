// The questions of step 4, task by task.
#include "questions/step_4.h"

namespace rays::grader {

std::vector<Question> questions_4_partitioning(std::uint64_t seed) {
    using namespace step_4;
    std::vector<Question> all;
    std::uint64_t task = 0;
    for (const auto make :
         {bounds, clips, grid_builds, grid_walks, mailboxes, octree_builds, octree_walks, any_hits, choices}) {
        // Every task has dice of its own: a question more in one does not change the others.
        for (Question& question : make(seed * 16 + task)) all.push_back(std::move(question));
        ++task;
    }
    return all;
}

}  // namespace rays::grader
