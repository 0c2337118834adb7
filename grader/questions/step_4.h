// What the questions of step 4 share: boxes, and walks through them by brute force, in long double.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "questions.h"
#include "questions/construct.h"

namespace rays::grader::step_4 {

using construct::Dice;
using construct::L;
using construct::Notebook;
using construct::V;

struct Box {
    V min, max;
    std::string text() const { return construct::numbers(min) + " " + construct::numbers(max); }
    V at(const V& share) const { return min + share * (max - min); }
};
Box random_box(Dice& dice);

/// A ray whose numbers are doubles.
struct Beam {
    V origin, direction;
    L t_min = 0, t_max = construct::kFar;

    V at(L t) const { return origin + t * direction; }
    std::string text() const;  ///< as queries take it
};
Beam from_to(const V& origin, const V& target);

/// Where the beam is between the planes of a box, slab by slab; enter > exit when it misses.
struct Stretch {
    L enter, exit;
};
Stretch stretch_in(const Box& box, const Beam& beam);

/// The pieces of a beam between planes at equal distances in a box: each between two crossings, told by its middle.
struct Piece {
    std::array<int, 3> cell;
    L exit;
};
/// Empty when the beam misses, or when two crossings lie so close together that their order is anyone's guess.
std::vector<Piece> pieces_of(const Box& box, const std::array<int, 3>& cells, const Beam& beam);

/// What double arithmetic may err, with room to spare: a cell is far larger.
inline constexpr L kTolerance = 1e-9L;

bool close(L found, L truth);
bool has(const Answer& answer, std::size_t numbers);
Judgement verdict(bool ok, std::string expected, double error = 0);

/// "agreement_grid" and the like: no ray of all differs.
Judge all_agree();

/// Many spheres, small enough that few overlap, as a loop.
std::string random_spheres(int count, int seed, const std::string& modifiers = "");
/// Scenes that are hard on structures.
struct HardScene {
    std::string about, sdl;
};
std::vector<HardScene> hard_scenes(Dice& dice);

std::vector<Question> bounds(std::uint64_t seed);         // 4.1
std::vector<Question> clips(std::uint64_t seed);          // 4.2
std::vector<Question> grid_builds(std::uint64_t seed);    // 4.3
std::vector<Question> grid_walks(std::uint64_t seed);     // 4.4
std::vector<Question> mailboxes(std::uint64_t seed);      // 4.5
std::vector<Question> octree_builds(std::uint64_t seed);  // 4.6
std::vector<Question> octree_walks(std::uint64_t seed);   // 4.7
std::vector<Question> any_hits(std::uint64_t seed);       // 4.8
std::vector<Question> choices(std::uint64_t seed);        // 4.9

}  // namespace rays::grader::step_4
