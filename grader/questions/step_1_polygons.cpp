// Questions of task 1.6.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "questions/squared_paper.h"
#include "questions/step_1.h"

namespace rays::grader::step_1 {

namespace {

struct Sample {
    V2 point;
    bool inside;
    const char* about;
};

struct Drawing {
    const char* name;
    std::vector<Contour> contours;
    std::vector<Sample> samples;
};

/// A comb with a point in the middle of an edge and one point twice.
Contour stumbling_comb() {
    Contour contour = comb();
    contour.insert(contour.begin() + 1, V2(1, 0));
    contour.insert(std::find(contour.begin(), contour.end(), V2(4, 1)), V2(4, 1));
    return contour;
}

std::vector<Drawing> drawings() {
    const auto star = [](int i) { return V2(std::sin(i * 0.8L * kPi), std::cos(i * 0.8L * kPi)); };
    return {
        {"a square with a notch",
         {{{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}}},
         {{{2, 2}, false, "in the notch"},
          {{2, 0.5L}, true, "below the notch"},
          {{0.3L, 3}, true, "left of the notch"},
          {{3.7L, 3}, true, "right of the notch"},
          {{2, 1.1L}, false, "just above the notch's point"},
          {{2, 0.9L}, true, "just below the notch's point"},
          {{-0.1L, 2}, false, "left of all"}}},
        {"a frame: a square with a square hole",
         {{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 1}, {3, 1}, {3, 3}, {1, 3}}},
         {{{2, 2}, false, "in the hole"},
          {{0.5L, 2}, true, "in the frame, left"},
          {{2, 3.5L}, true, "in the frame, above"},
          {{1.1L, 1.1L}, false, "in the hole's corner"},
          {{0.9L, 0.9L}, true, "outside of the hole's corner"}}},
        {"a frame whose hole runs the other way round, with an island",
         {{{0, 0}, {6, 0}, {6, 6}, {0, 6}}, {{1, 1}, {1, 5}, {5, 5}, {5, 1}}, {{2, 2}, {4, 2}, {4, 4}, {2, 4}}},
         {{{1.5L, 3}, false, "between island and frame"},
          {{3, 3}, true, "on the island"},
          {{5.5L, 3}, true, "in the frame"},
          {{3, 4.5L}, false, "above the island"}}},
        {"a square on its corner",
         {{{0, 0}, {2, -2}, {4, 0}, {2, 2}}},
         {{{1, 0}, true, "on a level with its left and right corner"},
          {{3.5L, 0}, true, "on a level with them, close to the right one"},
          {{2, 1}, true, "straight below its upper corner"},
          {{2, -1.5L}, true, "straight above its lower corner"},
          {{-1, 0}, false, "left of it, on a level with its corners"},
          {{2, -3}, false, "straight below it"}}},
        {"two squares apart",
         {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{3, 3}, {5, 3}, {5, 5}, {3, 5}}},
         {{{0.5L, 0.5L}, true, "in the first"}, {{4, 4}, true, "in the second"}, {{2, 2}, false, "between them"}}},
        {"a star of five points in one stroke",
         {{star(0), star(1), star(2), star(3), star(4)}},
         {{{0, 0}, false, "in the middle, inside of two windings: even-odd says outside"},
          {{0, 0.7L}, true, "in the upper tip"},
          {{0, -0.6L}, false, "between the lower tips"}}},
        {"a comb, first three points in a line, one point twice",
         {stumbling_comb()},
         {{{0.5L, 2}, true, "in the first tooth"},
          {{1.5L, 2}, false, "in the first gap"},
          {{4.5L, 2}, true, "in the third tooth"},
          {{5.5L, 2}, false, "in the last gap"},
          {{6.5L, 1}, true, "in the last tooth, on a level with many corners"},
          {{3.5L, 0.5L}, true, "in the comb's back"}}},
    };
}

/// Exactly across an axis; or tilted.
Paper any_paper(Dice& dice, int kind) {
    const V origin = dice.position(2);
    if (kind < 3) return paper_across(kind, origin);
    Paper paper{origin};
    frame(dice.unit(), paper.right, paper.up);
    return paper;
}

}  // namespace

std::vector<Question> polygons(std::uint64_t seed) {
    Dice dice(seed);
    Notebook book("1.6");
    int kind = dice.whole(0, 2);
    for (int round = 0; round < 2; ++round) {
        for (const Drawing& drawing : drawings()) {
            const Paper paper = any_paper(dice, round == 0 ? kind++ % 3 : 3);
            book.objects(polygon_text(drawing.contours, paper));
            for (const Sample& sample : drawing.samples) {
                // Straight on in axis planes: then the hit is on a level with corners to the last digit.
                V d = round == 0 ? paper.normal() : dice.unit();
                while (std::abs(glm::dot(d, paper.normal())) < 0.3L) d = dice.unit();
                const Shot shot =
                    aim(paper.at(sample.point), dice.coin() ? d : -d, dice.between(2, 9), dice.between(0.2, 5));
                const std::string about = fmt::format("{}: {}", drawing.name, sample.about);
                sample.inside ? book.root(shot, about) : book.miss(shot, about);
            }
            const Sample& first_inside =
                *std::find_if(drawing.samples.begin(), drawing.samples.end(), [](const Sample& s) { return s.inside; });
            const Shot shot = aim(paper.at(first_inside.point), dice.coin() ? paper.normal() : -paper.normal(), 3);
            book.ask(nearest_query(shot), std::string(drawing.name) + ": its normal",
                     hits_with_normal(shot, paper.normal(), true));
            book.miss(aim(paper.at(first_inside.point), paper.normal(), -3),
                      std::string(drawing.name) + ": behind the origin");
        }
    }
    return book.take();
}

}  // namespace rays::grader::step_1
