#include "questions/step_1.h"

namespace rays::grader {

std::vector<Question> questions_1_ray_casting(std::uint64_t seed) {
    using namespace step_1;
    using Author = std::vector<Question> (*)(std::uint64_t);
    std::vector<Question> all;
    std::uint64_t task = 0;
    for (const Author author :
         {perspective_cameras, orthographic_cameras, spheres, planes, triangles, polygons, boxes_and_discs, cones,
          quadrics, tori, patches, transforms, bounds, meshes, nearest_hits}) {
        auto questions = author(seed * 0x9e3779b97f4a7c15ull + ++task);
        all.insert(all.end(), std::make_move_iterator(questions.begin()), std::make_move_iterator(questions.end()));
    }
    return all;
}

}  // namespace rays::grader
