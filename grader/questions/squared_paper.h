// Polygons drawn on squared paper, where it is plain to see which points are inside.
#pragma once

#include <string>
#include <vector>

#include "questions/construct.h"

namespace rays::grader::construct {

using Contour = std::vector<V2>;

/// Squared paper in space: p(x, y) = origin + x right + y up.
struct Paper {
    V origin{0}, right{0}, up{0};
    V at(const V2& p) const { return origin + p.x * right + p.y * up; }
    V normal() const { return glm::normalize(glm::cross(right, up)); }
};

/// In the plane across an axis (0, 1, 2: x, y, z), where always dropping the same coordinate would draw nothing.
Paper paper_across(int axis, const V& origin = V(0));

/// Four teeth 2 high and 1 wide, 1 apart, on a back from (0, 0) to (7, 1): many corners on the level y = 1.
Contour comb();

/// "polygon { ... }", every contour closed by its first point as POV-Ray wants it.
std::string polygon_text(const std::vector<Contour>& contours, const Paper& paper);

}  // namespace rays::grader::construct
