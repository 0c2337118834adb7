#include "questions/squared_paper.h"

#include <fmt/format.h>

namespace rays::grader::construct {

Paper paper_across(int axis, const V& origin) {
    Paper paper{origin};
    paper.right[(axis + 1) % 3] = 1;
    paper.up[(axis + 2) % 3] = 1;
    return paper;
}

Contour comb() {
    Contour corners{{0, 0}, {7, 0}};
    for (int tooth = 6; tooth >= 0; tooth -= 2) {
        const L left = tooth, right = tooth + 1;
        if (tooth < 6) corners.push_back({right, 1});
        corners.push_back({right, 3});
        corners.push_back({left, 3});
        if (tooth > 0) corners.push_back({left, 1});
    }
    return corners;
}

std::string polygon_text(const std::vector<Contour>& contours, const Paper& paper) {
    std::size_t count = 0;
    std::string points;
    for (const Contour& contour : contours)
        for (std::size_t i = 0; i <= contour.size(); ++i, ++count)
            points += ", " + vector(rounded(paper.at(contour[i % contour.size()])));
    return fmt::format("polygon {{ {}{} }}\n", count, points);
}

}  // namespace rays::grader::construct
