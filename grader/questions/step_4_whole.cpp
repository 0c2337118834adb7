// Questions to whole structures: is anything in the way (4.8), and when are they worth their while (4.9)?
#include <fmt/format.h>

#include <cmath>

#include "questions/step_4.h"

namespace rays::grader::step_4 {
namespace {

using construct::number;
using construct::vector;

/// A cloud off to one side of a clear lane along z, and what is put into the lane.
struct Lane {
    V from, to;
    std::string sdl;
};

Lane lane_with(Dice& dice, const std::string& in_the_way, L share) {
    Lane lane;
    lane.from = V(dice.round_between(-1, 1), dice.round_between(-1, 1), -20);
    lane.to = V(dice.round_between(-1, 1), dice.round_between(-1, 1), 20);
    for (int i = 0; i < 40; ++i)
        lane.sdl +=
            fmt::format("sphere {{ {}, {} }}\n",
                        vector(V(dice.round_between(4, 12), dice.round_between(-9, 9), dice.round_between(-18, 18))),
                        number(dice.round_between(0.1, 1)));
    const V middle = construct::rounded(lane.from + share * (lane.to - lane.from));
    if (!in_the_way.empty()) lane.sdl += fmt::format("object {{ {} translate {} }}\n", in_the_way, vector(middle));
    return lane;
}

void ask(Notebook& book, const Lane& lane, L t_max, bool truth, const std::string& about) {
    book.objects(lane.sdl);
    for (const char* structure : {"grid", "octree"}) {
        Beam beam = from_to(lane.from, lane.to);
        beam.t_min = 0.001L;
        beam.t_max = t_max;
        book.ask(fmt::format("occluded_{} {}", structure, beam.text()), fmt::format("{} ({})", about, structure),
                 construct::says(truth));
    }
}

void ask_lanes(Notebook& book, Dice& dice) {
    const L share = dice.round_between(0.2, 0.7);
    ask(book, lane_with(dice, "", 0), 1, false, "a clear way");
    ask(book, lane_with(dice, "sphere { 0, 0.5 }", share), 1, true, "a sphere in the way");
    ask(book, lane_with(dice, "sphere { 0, 0.5 }", share), share - 0.05L, false, "the light stands before the sphere");
    ask(book, lane_with(dice, "sphere { 0, 0.5 }", 1.2L), 1, false, "a sphere behind the light");
    ask(book, lane_with(dice, "sphere { 0, 0.5 no_shadow }", share), 1, false, "a sphere in the way that casts none");
    ask(book, lane_with(dice, "plane { z, 0 }", share), 1, true, "a plane in the way: it has no bounds");
    ask(book, lane_with(dice, "sphere { 0, 0.5 }", share), 1e30L, true, "a light infinitely far away");
    ask(book, lane_with(dice, "box { <-30, -30, -0.1>, <30, 30, 0.1> }", share), share + 0.02L, true,
        "a wall through many cells");
}

}  // namespace

std::vector<Question> any_hits(std::uint64_t seed) {
    Dice dice(seed);
    Notebook book("4.8");
    for (int i = 0; i < 2; ++i) ask_lanes(book, dice);
    for (const char* structure : {"grid", "octree"}) {
        book.objects(random_spheres(150, dice.whole(1, 1000), "#if (mod(I, 2) = 1) no_shadow #end") +
                     "plane { y, -1 }\n");
        book.ask(fmt::format("agreement_{} 1500 {} 1", structure, dice.whole(1, 1000000)),
                 "half of the spheres cast no shadow", all_agree());
    }
    return book.take();
}

std::vector<Question> choices(std::uint64_t seed) {
    Dice dice(seed);
    Notebook book("4.9");
    constexpr double kNone = 1, kGrid = 2, kOther = 4;  // 0: the choice is put off
    const auto is = [](bool structure) {
        return [=](const Answer& answer) {
            const double n = has(answer, 1) ? answer.numbers[0] : 0;
            return verdict(structure ? n >= kGrid && n <= kOther : n == kNone, structure ? "a structure" : "none");
        };
    };
    for (int i = 0; i < 12; ++i) {
        book.objects(i % 2 ? fmt::format("sphere {{ 0, {} }}\n", i) : "plane { y, 0 }\n");
        book.ask("partition", "one primitive needs no structure", is(false));
        const int count = dice.whole(100, 400);
        book.objects(i % 2 ? random_spheres(count, i)
                           : fmt::format("mesh {{ #declare I = 0; #while (I < {}) triangle {{ I * x, I * x + y, I * x "
                                         "+ z }} #declare I = I + 1; #end }}\n",
                                         count));
        book.ask("partition", i % 2 ? "hundreds of spheres need one" : "a mesh is as many primitives as it has faces",
                 is(true));
    }
    return book.take();
}

}  // namespace rays::grader::step_4
