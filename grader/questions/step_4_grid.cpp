// Questions about the uniform grid: what is in it (4.3), the walk through it (4.4), and mailboxes (4.5).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "questions/step_4.h"

namespace rays::grader::step_4 {
namespace {

using construct::number;
using construct::numbers;

using Cell = std::array<int, 3>;

struct Grid {
    Box box;
    Cell cells;
    std::string text() const { return fmt::format("{} {} {} {}", box.text(), cells[0], cells[1], cells[2]); }
};

Grid random_grid(Dice& dice) { return {random_box(dice), {dice.whole(2, 7), dice.whole(2, 7), dice.whole(2, 7)}}; }

// ---- 4.3 --------------------------------------------------------------------------------------------------------------

Judge lists(const Cell& first, const Cell& last) {
    return [=](const Answer& answer) {
        bool ok = has(answer, 6);
        for (std::size_t a = 0; ok && a < 3; ++a)
            ok = answer.numbers[a] == first[a] && answer.numbers[a + 3] == last[a];
        return verdict(ok, fmt::format("{} {} {} {} {} {}", first[0], first[1], first[2], last[0], last[1], last[2]));
    };
}

void ask_overlap(Notebook& book, const Grid& grid, const Cell& first, const Cell& last, const Box& box,
                 const std::string& about) {
    book.ask("cells_overlapping " + grid.text() + " " + box.text(), about, lists(first, last));
}

/// The point at these shares of a cell.
V in_cell(const Grid& grid, const Cell& cell, const V& share) {
    V place;
    for (int a = 0; a < 3; ++a) place[a] = (cell[std::size_t(a)] + share[a]) / grid.cells[std::size_t(a)];
    return construct::rounded(grid.box.at(place));
}

void ask_overlaps(Notebook& book, Dice& dice) {
    const Grid grid = random_grid(dice);
    const auto share = [&] { return V(dice.between(0.1, 0.9), dice.between(0.1, 0.9), dice.between(0.1, 0.9)); };
    Cell first, last, end;
    for (std::size_t a = 0; a < 3; ++a) {
        first[a] = dice.whole(0, grid.cells[a] - 2);
        last[a] = dice.whole(first[a] + 1, grid.cells[a] - 1);
        end[a] = grid.cells[a] - 1;
    }
    const V low = in_cell(grid, first, share()), high = in_cell(grid, last, share());
    ask_overlap(book, grid, first, last, {low, high}, "a box over several cells: the last one counts, too");
    ask_overlap(book, grid, first, first, {low, low}, "a box of no size is in one cell");
    ask_overlap(book, grid, first, end, {low, grid.box.max},
                "up to the far face of the grid: the last cell, not one beyond it");
    ask_overlap(book, grid, end, end, {grid.box.max, grid.box.max}, "in the far corner of the grid");
    ask_overlap(book, grid, {0, 0, 0}, last, {grid.box.min - 1.0L, high}, "a box that begins before the grid");
    ask_overlap(book, grid, {0, 0, 0}, end, {grid.box.min - 1.0L, grid.box.max + 1.0L},
                "a box around the grid: all cells");
}

void ask_resolution(Notebook& book, const V& extent, int primitives, const std::string& about) {
    book.ask(fmt::format("resolution {} {}", numbers(extent), primitives), about, [=](const Answer& answer) {
        const std::string expected =
            "between a fifth of the number of primitives and fifty times as many cells, about as long as wide";
        if (!has(answer, 3)) return verdict(false, expected);
        L cells = 1, shortest = INFINITY, longest = 0;
        for (int a = 0; a < 3; ++a) {
            const L n = answer.numbers[std::size_t(a)];
            if (!(n >= 1 && n <= 1024) || (extent[a] == 0 && n != 1)) return verdict(false, expected);
            cells *= n;
            if (n < 2) continue;  // one cell may be as flat as the scene
            shortest = std::min(shortest, extent[a] / n);
            longest = std::max(longest, extent[a] / n);
        }
        return verdict(cells >= L(primitives) / 5 && cells <= 50 * L(primitives) + 8 && !(longest > 3 * shortest),
                       expected);
    });
}

void ask_contents(Notebook& book, Dice& dice) {
    const int spheres = dice.whole(20, 60), planes = dice.whole(1, 3);
    std::string sdl;
    Box tight{V(INFINITY), V(-INFINITY)};
    for (int i = 0; i < spheres + planes; ++i) {
        const V c = dice.position(5);
        const L r = dice.round_between(0.1, 0.5);
        if (i % 7 == 3 && i / 7 < planes) {
            sdl += fmt::format("plane {{ y, {} }}\n", -6 - i);
            continue;
        }
        sdl += fmt::format("sphere {{ {}, {} }}\n", construct::vector(c), number(r));
        tight = {glm::min(tight.min, c - r), glm::max(tight.max, c + r)};
    }
    book.objects(sdl);
    book.ask("contents", "planes stay outside, and the box is around all others", [=](const Answer& answer) {
        const std::string expected =
            fmt::format("{} inside, {} outside, a box around {}", spheres, planes, tight.text());
        bool ok = has(answer, 8) && answer.numbers[0] == spheres && answer.numbers[1] == planes;
        for (int a = 0; ok && a < 3; ++a) {
            const L low = answer.numbers[std::size_t(a) + 2], high = answer.numbers[std::size_t(a) + 5];
            ok = low < tight.min[a] && high > tight.max[a] && high - low < 1.5L * (tight.max[a] - tight.min[a]);
        }
        return verdict(ok, expected);
    });
}

// ---- 4.4 --------------------------------------------------------------------------------------------------------------

int index_of(const Grid& grid, const Cell& c) { return c[0] + grid.cells[0] * (c[1] + grid.cells[1] * c[2]); }

/// Cells and where each is left; the t of the very end may be that of the range or that of the next plane.
Judge walks(const Grid& grid, const std::vector<Piece>& pieces) {
    std::string expected;
    for (const Piece& p : pieces)
        expected += fmt::format("{}{} {}", expected.empty() ? "" : " ", index_of(grid, p.cell), number(p.exit));
    return [=](const Answer& answer) {
        bool ok = has(answer, 2 * pieces.size());
        for (std::size_t i = 0; ok && i < pieces.size(); ++i)
            ok = answer.numbers[2 * i] == index_of(grid, pieces[i].cell) &&
                 (i + 1 == pieces.size() || close(answer.numbers[2 * i + 1], pieces[i].exit));
        return verdict(ok, expected);
    };
}

/// Where a ray goes through edges and corners several ways are right: one step along one axis at a time, from the first
/// cell to the last.
Judge steps_from_to(const Grid& grid, const Cell& first, const Cell& last) {
    return [=](const Answer& answer) {
        const std::string expected = fmt::format("from cell {} to cell {}, one step along one axis at a time",
                                                 index_of(grid, first), index_of(grid, last));
        const auto& n = answer.numbers;
        if (answer.kind != Answer::Kind::value || n.size() % 2 != 0) return verdict(false, expected);
        bool ok = n[0] == index_of(grid, first) && n[n.size() - 2] == index_of(grid, last);
        const int x = 1, y = grid.cells[0], z = grid.cells[0] * grid.cells[1];
        for (std::size_t i = 2; ok && i < n.size(); i += 2) {
            const double step = std::abs(n[i] - n[i - 2]);
            ok = step == x || step == y || step == z;
        }
        return verdict(ok, expected);
    };
}

void ask_walk(Notebook& book, const Grid& grid, const Beam& beam, const std::string& about) {
    const auto pieces = pieces_of(grid.box, grid.cells, beam);
    if (!pieces.empty() && pieces.size() <= 30)
        book.ask("cells_along " + grid.text() + " " + beam.text(), about, walks(grid, pieces));
}

void ask_slanted_walks(Notebook& book, Dice& dice) {
    const Grid grid = random_grid(dice);
    const auto inside = [&] {
        return grid.box.at({dice.between(0.1, 0.9), dice.between(0.1, 0.9), dice.between(0.1, 0.9)});
    };
    for (int octant = 0; octant < 8; ++octant) {
        V d = glm::abs(dice.unit()) + 0.1L;
        for (int a = 0; a < 3; ++a)
            if (octant >> a & 1) d[a] = -d[a];
        const V through = inside();
        ask_walk(book, grid, from_to(through - 15.0L * d, through),
                 fmt::format("across the grid, signs of the direction number {}", octant));
    }
    ask_walk(book, grid, from_to(inside(), inside() + 3.0L * dice.unit()), "from inside");
    Beam part = from_to(inside() - 9.0L * dice.unit(), inside());
    part.t_min = 0.9L;
    part.t_max = 1.05L;
    ask_walk(book, grid, part, "a range that begins and ends in the grid");
    const V far = inside();
    ask_walk(book, grid, from_to(far - 1e5L * dice.unit(), far), "from far away");
}

void ask_straight_walks(Notebook& book, Dice& dice) {
    const Grid grid = random_grid(dice);
    for (int axis = 0; axis < 3; ++axis) {
        V d(dice.coin() ? 0.0L : -0.0L);
        d[axis] = dice.coin() ? 1 : -1;
        Cell cell;
        for (std::size_t a = 0; a < 3; ++a) cell[a] = dice.whole(0, grid.cells[a] - 1);
        const V at = in_cell(grid, cell, {0.4L, 0.3L, 0.6L});
        ask_walk(book, grid, {construct::rounded(at - 10.0L * d), d}, "along an axis: zeros in the direction");
    }
    // In cubes, so that the diagonal meets edges and corners: all planes at once.
    const int n = dice.whole(3, 6);
    const Grid cubes{{V(0), V(n)}, {n, n, n}};
    const Cell low{0, 0, 0}, high{n - 1, n - 1, n - 1};
    book.ask(fmt::format("cells_along {} -1 -1 -1 1 1 1 0 1e30", cubes.text()), "through all corners of a diagonal",
             steps_from_to(cubes, low, high));
    book.ask(fmt::format("cells_along {} {} {} {} -1 -1 -1 0 1e30", cubes.text(), n + 1, n + 1, n + 1), "and back",
             steps_from_to(cubes, high, low));
    book.ask(fmt::format("cells_along {} -1 -1 0.5 1 1 0 0 1e30", cubes.text()), "through the edges of a layer",
             steps_from_to(cubes, low, {n - 1, n - 1, 0}));
    book.ask(fmt::format("cells_along {} -1 1.5 1.5 0 1 0 0 1e30", cubes.text()), "past the grid: no cell",
             construct::misses_it());
}

}  // namespace

std::vector<Question> grid_builds(std::uint64_t seed) {
    Dice dice(seed);
    Notebook book("4.3");
    for (int i = 0; i < 3; ++i) ask_contents(book, dice);
    book.objects("sphere { 0, 1 }\n");
    for (int i = 0; i < 3; ++i) ask_overlaps(book, dice);
    ask_resolution(book, V(1, 1, 1), 1000, "a cube");
    ask_resolution(book, V(1e-4L, 1e-4L, 1e-4L), 5000, "a small cube");
    ask_resolution(book, V(1e7L, 1e7L, 1e7L), 200, "a large cube");
    ask_resolution(book, V(8, 1, 1), 4000, "a rod");
    ask_resolution(book, V(5, 0, 5), 900, "a flat floor");
    ask_resolution(book, V(0, 0, 3), 20, "a line");
    for (const HardScene& hard : hard_scenes(dice)) {
        book.scene(construct::scene_of(hard.sdl));
        book.ask(fmt::format("agreement_grid 300 {} 1", dice.whole(1, 1000000)),
                 "random and adversarial rays: " + hard.about, all_agree());
    }
    return book.take();
}

std::vector<Question> grid_walks(std::uint64_t seed) {
    Dice dice(seed);
    Notebook book("4.4");
    book.objects("sphere { 0, 1 }\n");
    for (int i = 0; i < 2; ++i) {
        ask_slanted_walks(book, dice);
        ask_straight_walks(book, dice);
    }
    for (const HardScene& hard : hard_scenes(dice)) {
        book.scene(construct::scene_of(hard.sdl));
        book.ask(fmt::format("agreement_grid 1000 {} 1", dice.whole(1, 1000000)),
                 "random and adversarial rays: " + hard.about, all_agree());
    }
    return book.take();
}

std::vector<Question> mailboxes(std::uint64_t seed) {
    Dice dice(seed);
    Notebook book("4.5");
    book.objects("sphere { 0, 1 }\n");
    for (int i = 0; i < 20; ++i) {
        std::vector<int> asked;
        const int range = i % 2 ? 100000 : 12;
        for (int k = 0; k < 30; ++k) asked.push_back(k % 3 == 2 ? asked.back() : dice.whole(0, range));
        std::string query = fmt::format("mailbox {}", asked.size());
        for (const int p : asked) query += fmt::format(" {}", p);
        book.ask(query, "remembers what was just asked, and claims nothing else", [=](const Answer& answer) {
            bool ok = has(answer, asked.size());
            std::set<int> before;
            for (std::size_t k = 0; ok && k < asked.size(); ++k) {
                const bool claimed = answer.numbers[k] != 0, just = k > 0 && asked[k] == asked[k - 1];
                ok = (!claimed || before.count(asked[k])) && (claimed || !just);
                before.insert(asked[k]);
            }
            return verdict(ok, "1 where the same number came just before, 0 where it never came");
        });
    }
    const auto scenes = hard_scenes(dice);
    for (const std::size_t i : {0u, 2u, 2u, 6u, 7u}) {
        book.scene(construct::scene_of(scenes[i].sdl));
        book.ask(fmt::format("agreement_grid 1000 {} 4", dice.whole(1, 1000000)),
                 "four threads at once: " + scenes[i].about, all_agree());
    }
    return book.take();
}

}  // namespace rays::grader::step_4
