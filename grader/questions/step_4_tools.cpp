#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "questions/step_4.h"

namespace rays::grader::step_4 {

using construct::number;
using construct::numbers;

Box random_box(Dice& dice) {
    const V min = dice.position(5);
    const V size(dice.round_between(1, 6), dice.round_between(1, 6), dice.round_between(1, 6));
    return {min, construct::rounded(min + size)};
}

std::string Beam::text() const {
    return fmt::format("{} {} {} {}", numbers(origin), numbers(direction), number(t_min), number(t_max));
}

Beam from_to(const V& origin, const V& target) {
    const V o = construct::rounded(origin);
    return {o, construct::rounded(target - o)};
}

Stretch stretch_in(const Box& box, const Beam& beam) {
    Stretch s{beam.t_min, beam.t_max};
    for (int a = 0; a < 3; ++a) {
        const L o = beam.origin[a], d = beam.direction[a];
        if (d == 0) {
            if (o < box.min[a] || o > box.max[a]) return {1, -1};
            continue;
        }
        const L one = (box.min[a] - o) / d, other = (box.max[a] - o) / d;
        s.enter = std::max(s.enter, std::min(one, other));
        s.exit = std::min(s.exit, std::max(one, other));
    }
    return s;
}

std::vector<Piece> pieces_of(const Box& box, const std::array<int, 3>& cells, const Beam& beam) {
    const Stretch s = stretch_in(box, beam);
    if (!(s.enter < s.exit)) return {};
    std::vector<L> crossings;
    for (int a = 0; a < 3; ++a)
        for (int i = 1; i < cells[a] && beam.direction[a] != 0; ++i) {
            const L plane = box.min[a] + (box.max[a] - box.min[a]) * i / cells[a];
            const L t = (plane - beam.origin[a]) / beam.direction[a];
            if (t > s.enter && t < s.exit) crossings.push_back(t);
        }
    crossings.push_back(s.exit);
    std::sort(crossings.begin(), crossings.end());
    std::vector<Piece> pieces;
    L from = s.enter;
    for (const L t : crossings) {
        if (t - from < 1e-4L * (s.exit - s.enter)) return {};
        Piece piece{{}, t};
        const V middle = (beam.at((from + t) / 2) - box.min) / (box.max - box.min);
        for (int a = 0; a < 3; ++a) {
            const L place = middle[a] * cells[a];
            // In a plane between cells both are right: no question for this judge.
            if (std::abs(place - std::round(place)) < 1e-6L && place > 0.5L && place < cells[a] - 0.5L) return {};
            piece.cell[static_cast<std::size_t>(a)] = std::clamp(static_cast<int>(place), 0, cells[a] - 1);
        }
        pieces.push_back(piece);
        from = t;
    }
    return pieces;
}

bool close(L found, L truth) { return std::abs(found - truth) <= kTolerance * (1 + std::abs(truth)); }

bool has(const Answer& answer, std::size_t count) {
    return answer.kind == Answer::Kind::value && answer.numbers.size() == count;
}

Judgement verdict(bool ok, std::string expected, double error) {
    return {ok, ok ? error : std::numeric_limits<double>::infinity(), std::move(expected)};
}

Judge all_agree() {
    return [](const Answer& answer) {
        // Rays, hits, differences: a program that hits nothing has not been asked anything.
        const bool ok = has(answer, 3) && answer.numbers[0] > 0 && answer.numbers[1] > 0 && answer.numbers[2] == 0;
        return verdict(ok, "as many rays as asked, some hits, and 0 differences to asking every primitive");
    };
}

std::string random_spheres(int count, int seed, const std::string& modifiers) {
    return fmt::format(
        "#declare R = seed({});\n#declare I = 0;\n#while (I < {})\n"
        "sphere {{ <rand(R), rand(R), rand(R)> * 10, {} * (0.3 + rand(R)) {} }}\n#declare I = I + 1;\n#end\n",
        seed, count, number(std::round(1000 * 2 / std::cbrt(count)) / 1000), modifiers);
}

std::vector<HardScene> hard_scenes(Dice& dice) {
    const auto loop = [](int count, const std::string& body) {
        return fmt::format("#declare R = seed(3);\n#declare I = 0;\n#while (I < {})\n{}\n#declare I = I + 1;\n#end\n",
                           count, body);
    };
    const std::string random = "<rand(R), rand(R), rand(R)>";
    const int seed = dice.whole(1, 1000);
    return {
        {"spheres over a plane", random_spheres(150, seed) + "plane { y, -1 }\n"},
        {"triangles of a mesh", "mesh {\n" +
                                    loop(150, "#declare P = " + random + " * 10;\ntriangle { P, P + " + random +
                                                  ", P - <1, 0.5, 0.3> * rand(R) }") +
                                    "}\n"},
        {"long cylinders across many cells", loop(60, fmt::format("cylinder {{ {0} * 10, {0} * 10, 0.2 }}", random))},
        {"a floor of tiles in one plane",
         "#declare I = 0;\n#while (I < 64)\n#declare X = mod(I, 8);\n#declare Z = floor(I / 8);\n"
         "polygon { 5, <X, 0, Z>, <X + 1, 0, Z>, <X + 1, 0, Z + 1>, <X, 0, Z + 1>, <X, 0, Z> }\n#declare I = I + "
         "1;\n#end\n"},
        {"boxes face to face",
         "#declare I = 0;\n#while (I < 64)\n#declare X = mod(I, 8);\n#declare Z = floor(I / 8);\n"
         "box { <X, 0, Z>, <X + 1, 1, Z + 1> }\n#declare I = I + 1;\n#end\n"},
        {"equal spheres in one place", loop(40, "sphere { <1, 2, 3>, 0.5 }")},
        {"shells within shells", loop(60, "sphere { <0, 1, 0>, 0.2 + I / 10 }")},
        {"moved and stretched shapes",
         loop(20, fmt::format("union {{ box {{ 0, 1 }} torus {{ 0.6, 0.2 }} cone {{ -y, 0.5, y, 0 }} rotate 90 * {0} "
                              "scale 0.5 + {0} translate 8 * {0} }}",
                              random))},
        {"far from the origin", loop(80, "sphere { <10000000, -10000000, 10000000> + 10 * " + random + ", 0.4 }")},
        {"one sphere", "sphere { <1, 2, 3>, 0.5 }\n"},
        {"a few large and many small ones",
         "box { <-1000, -2, -1000>, <1000, -1, 1000> }\n" + random_spheres(100, seed + 1)},
    };
}

}  // namespace rays::grader::step_4
