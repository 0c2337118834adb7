// Questions about the octree: who goes into which octant (4.6), and which a ray passes in what order (4.7).
#include <fmt/format.h>

#include <cmath>

#include "questions/step_4.h"

namespace rays::grader::step_4 {
namespace {

using construct::number;
using construct::numbers;

int octant_index(const std::array<int, 3>& half) { return half[0] + 2 * half[1] + 4 * half[2]; }

// ---- 4.6 --------------------------------------------------------------------------------------------------------------

void ask_octants(Notebook& book, Dice& dice) {
    const Box node = random_box(dice);
    const int o = dice.whole(0, 7);
    const V middle = (node.min + node.max) / 2.0L;
    Box part;
    for (int a = 0; a < 3; ++a) {
        part.min[a] = o >> a & 1 ? middle[a] : node.min[a];
        part.max[a] = o >> a & 1 ? node.max[a] : middle[a];
    }
    book.ask(fmt::format("octant {} {}", node.text(), o),
             "bit 0 is the upper half along x, bit 1 along y, bit 2 along z", [=](const Answer& answer) {
                 bool ok = has(answer, 6);
                 for (int a = 0; ok && a < 3; ++a)
                     ok = close(answer.numbers[std::size_t(a)], part.min[a]) &&
                          close(answer.numbers[std::size_t(a) + 3], part.max[a]);
                 return verdict(ok, part.text());
             });
}

/// Along each axis in the lower half, in the upper one, or in both; `beyond` both ends of the node.
void ask_overlaps(Notebook& book, Dice& dice) {
    const Box node = random_box(dice);
    V low, high;
    std::array<int, 3> where;
    for (int a = 0; a < 3; ++a) {
        where[std::size_t(a)] = dice.whole(0, 2);
        const L from = where[std::size_t(a)] == 1 ? 0.55L
                       : dice.coin()              ? 0.1L
                                                  : -0.4L,
                to = where[std::size_t(a)] == 0 ? 0.45L
                     : dice.coin()              ? 0.9L
                                                : 1.3L;
        low[a] = from;
        high[a] = to;
    }
    int mask = 0;
    for (int o = 0; o < 8; ++o) {
        bool in = true;
        for (int a = 0; a < 3; ++a) in = in && where[std::size_t(a)] != 1 - (o >> a & 1);
        mask |= in << o;
    }
    const Box box{construct::rounded(node.at(low)), construct::rounded(node.at(high))};
    book.ask(fmt::format("octants_overlapping {} {}", node.text(), box.text()),
             "the halves that it reaches along each axis", [=](const Answer& answer) {
                 return verdict(has(answer, 1) && answer.numbers[0] == mask, fmt::format("{}", mask));
             });
}

void ask_touching(Notebook& book) {
    const auto ask = [&](const std::string& box, int mask, const std::string& about) {
        book.ask("octants_overlapping 0 0 0 4 4 4 " + box, about, [=](const Answer& answer) {
            return verdict(has(answer, 1) && answer.numbers[0] == mask, fmt::format("{}", mask));
        });
    };
    ask("1 1 1 2 1.5 1.5", 3, "up to the middle plane: both sides of it");
    ask("0 2 0 4 2 4", 255, "a flat box in the middle plane: both sides");
    ask("2 2 2 2 2 2", 255, "a point in the centre: all");
    ask("4 4 4 5 5 5", 128, "touching the far corner");
    ask("5 5 5 6 6 6", 0, "beside the node: none");
    ask("-1 -1 -1 5 5 5", 255, "around the node: all");
}

// ---- 4.7 --------------------------------------------------------------------------------------------------------------

Judge passes(const std::vector<Piece>& pieces) {
    std::string expected;
    for (const Piece& p : pieces)
        expected +=
            fmt::format("{}octant {} up to {}", expected.empty() ? "" : ", ", octant_index(p.cell), number(p.exit));
    return [=](const Answer& answer) {
        bool ok = has(answer, 3 * pieces.size());
        for (std::size_t i = 0; ok && i < pieces.size(); ++i) {
            const bool last = i + 1 == pieces.size();
            ok = answer.numbers[3 * i] == octant_index(pieces[i].cell) &&
                 (last || close(answer.numbers[3 * i + 2], pieces[i].exit)) &&
                 (i == 0 || close(answer.numbers[3 * i + 1], pieces[i - 1].exit));
        }
        return verdict(ok, expected);
    };
}

void ask_passage(Notebook& book, const Box& node, const Beam& beam, const std::string& about) {
    const auto pieces = pieces_of(node, {2, 2, 2}, beam);
    if (!pieces.empty()) book.ask("octants_along " + node.text() + " " + beam.text(), about, passes(pieces));
}

void ask_passages(Notebook& book, Dice& dice) {
    const Box node = random_box(dice);
    const auto inside = [&] {
        return node.at({dice.between(0.1, 0.9), dice.between(0.1, 0.9), dice.between(0.1, 0.9)});
    };
    for (int octant = 0; octant < 8; ++octant) {
        V d = glm::abs(dice.unit()) + 0.1L;
        for (int a = 0; a < 3; ++a)
            if (octant >> a & 1) d[a] = -d[a];
        const V through = inside();
        ask_passage(book, node, from_to(through - 15.0L * d, through),
                    fmt::format("across the node, signs of the direction number {}", octant));
    }
    ask_passage(book, node, from_to(inside(), inside() + 3.0L * dice.unit()),
                "from inside: octants behind are not passed");
    Beam part = from_to(inside() - 9.0L * dice.unit(), inside());
    part.t_min = 0.9L;
    part.t_max = 1.05L;
    ask_passage(book, node, part, "a range that begins and ends in the node");
    for (int axis = 0; axis < 3; ++axis) {
        V d(dice.coin() ? 0.0L : -0.0L);
        d[axis] = dice.coin() ? 1 : -1;
        ask_passage(book, node, {construct::rounded(inside() - 10.0L * d), d}, "along an axis: zeros in the direction");
    }
    book.ask("octants_along " + node.text() + " " + from_to(node.max + 3.0L, node.max + V(4, 4, 3)).text(),
             "past the node: none", construct::misses_it());
}

}  // namespace

std::vector<Question> octree_builds(std::uint64_t seed) {
    Dice dice(seed);
    Notebook book("4.6");
    book.objects("sphere { 0, 1 }\n");
    for (int i = 0; i < 6; ++i) ask_octants(book, dice);
    for (int i = 0; i < 12; ++i) ask_overlaps(book, dice);
    ask_touching(book);
    for (const HardScene& hard : hard_scenes(dice)) {
        book.scene(construct::scene_of(hard.sdl));
        book.ask(fmt::format("agreement_octree 300 {} 1", dice.whole(1, 1000000)),
                 "random and adversarial rays: " + hard.about, all_agree());
    }
    return book.take();
}

std::vector<Question> octree_walks(std::uint64_t seed) {
    Dice dice(seed);
    Notebook book("4.7");
    book.objects("sphere { 0, 1 }\n");
    for (int i = 0; i < 2; ++i) ask_passages(book, dice);
    for (const HardScene& hard : hard_scenes(dice)) {
        book.scene(construct::scene_of(hard.sdl));
        book.ask(fmt::format("agreement_octree 1000 {} 2", dice.whole(1, 1000000)),
                 "random and adversarial rays: " + hard.about, all_agree());
    }
    return book.take();
}

}  // namespace rays::grader::step_4
