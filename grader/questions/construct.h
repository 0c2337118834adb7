// Questions about rays whose answer is known because it was chosen first: the point of the surface, then the ray.
//
// Truth is computed in long double from numbers that are doubles, so that scene, query and truth speak of the same
// shape.
#pragma once

#include <glm/glm.hpp>

#include <functional>
#include <string>
#include <utility>

#include "questions/dice.h"
#include "questions/notebook.h"

namespace rays::grader::construct {

using L = long double;
using V = glm::vec<3, L>;
using V2 = glm::vec<2, L>;

inline constexpr L kPi = 3.14159265358979323846264338327950288L;
inline constexpr double kFar = 1e30;

/// Dice for long double: every number is a double all the same.
class Dice : public BasicDice {
public:
    using BasicDice::BasicDice;

    L between(double low, double high) { return BasicDice::between(low, high); }
    L round_between(double low, double high) { return BasicDice::round_between(low, high); }
    V unit();
    V position(double reach);  ///< three decimals
};

/// The nearest double.
inline L rounded(L x) { return static_cast<double>(x); }
inline V rounded(const V& v) { return {rounded(v.x), rounded(v.y), rounded(v.z)}; }

/// Unit vectors across n that make a right-angled frame with it.
void frame(const V& n, V& x, V& y);

std::string number(L v);          ///< the shortest text that reads back as the same double
std::string numbers(const V& v);  ///< "x y z", for queries
std::string vector(const V& v);   ///< "<x, y, z>", for scenes

/// A scene with a camera and these objects, all of one look.
std::string scene_of(const std::string& objects);

/// A ray whose numbers are doubles, and the t of its point nearest to what it was aimed at.
struct Shot {
    V origin, direction;
    L t = 0;

    L speed() const { return glm::length(direction); }
    V at(L s) const { return origin + s * direction; }
    std::string text() const { return numbers(origin) + " " + numbers(direction); }
};

/// From `distance` before the target. `speed` is the direction's length.
Shot aim(const V& target, const V& unit_direction, L distance, L speed = 1);

/// "root OBJECT ..." and "nearest ..." for a shot.
std::string root_query(const Shot& shot, L t_min = 0, L t_max = kFar, int object = 0);
std::string nearest_query(const Shot& shot, L t_min = 0, L t_max = kFar);

// ---- Judges
// ----------------------------------------------------------------------------------------------------------

/// Every formula in double errs by less than 1e-9 at the distances of these questions, float ones by 1e-5; a student's
/// mistake errs by 1e-2. In lengths of the scene, relative to 1 + distance.
inline constexpr double kLength = 1e-6;
/// Length of the difference of unit normals, for the same reasons.
inline constexpr double kNormal = 1e-5;

Judge misses_it();
/// |t - truth| in length of the scene.
Judge hits_at(L t, L speed, L tolerance);
Judge hits(const Shot& shot);
/// A hit at the shot's t, with this normal (unit), of that object. `either_side`: the sign of the normal is free.
Judge hits_with_normal(const Shot& shot, const V& normal, bool either_side, int object = 0);
/// The same for the shading normal, its sign strict.
Judge hits_with_shading_normal(const Shot& shot, const V& shading_normal);
Judge says(bool truth);
/// The hit's distance from a surface: any root on the right surface is right. `off_surface` gives a length.
Judge lands_on(const Shot& shot, std::function<L(const V&)> off_surface, L tolerance);

/// Takes down questions of one task, most of them about rays and one object.
class Notebook : public BasicNotebook {
public:
    using BasicNotebook::BasicNotebook;

    void objects(const std::string& sdl) { scene(scene_of(sdl)); }
    void root(const Shot& shot, std::string about) { ask(root_query(shot), std::move(about), hits(shot)); }
    void miss(const Shot& shot, std::string about) { ask(root_query(shot), std::move(about), misses_it()); }
};

}  // namespace rays::grader::construct
