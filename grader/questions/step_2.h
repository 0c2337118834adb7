// What the questions of step 2 share: dice, scene text, judges, and the truth in double precision.
//
// The truth is written in other forms than the solution's (r . l from three cosines, n . h without h), so that one slip
// does not hide in both.
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "questions/dice.h"
#include "questions/notebook.h"

namespace rays::grader::step_2 {

using V = glm::dvec3;

inline constexpr double kPi = std::numbers::pi;
inline double radians(double degrees) { return degrees * kPi / 180; }

using Notebook = BasicNotebook;

class Dice : public BasicDice {
public:
    using BasicDice::BasicDice;

    V unit();
    V color();                 ///< every channel in [0.05, 1], three decimals
    V position(double reach);  ///< every coordinate in [-reach, reach], three decimals
};

/// Some unit vector at a right angle to n, of length 1.
V across(const V& n);
/// The unit vector `angle` away from the unit vector n, turned by `turn` about it.
V tilted(const V& n, double angle, double turn);

// ---- Scene text -----------------------------------------------------------------------------------------------------

std::string number(double v);     ///< the shortest text that reads back as the same double
std::string numbers(const V& v);  ///< "x y z", for queries
std::string vector(const V& v);   ///< "<x, y, z>", for scenes
std::string rgb(const V& color);  ///< "rgb <r, g, b>"

/// Version, gamma, the colour of ambient light, a camera.
std::string header(const V& ambient_light = V(1));
/// A sphere with a pigment and the words of its finish.
std::string sphere(const V& center, double radius, const std::string& pigment, const std::string& finish,
                   const std::string& modifiers = "");

// ---- Judges ---------------------------------------------------------------------------------------------------------

/// How far an answer may be from the truth: `absolute` plus `relative` times the largest number of the truth.
struct Tolerance {
    double relative;
    double absolute;
};
/// Light is kept in float lanes, and a student may compute in float throughout; the half floats of the references
/// resolve 5e-4. A fifth of that is far above float rounding and far below every mistake.
inline constexpr Tolerance kLight{1e-4, 1e-6};
/// Directions and factors in float arithmetic: some rounding errors of 6e-8.
inline constexpr Tolerance kGeometry{2e-6, 2e-6};

Judge close_to(const V& truth, Tolerance tolerance = kLight);
Judge close_to(double truth, Tolerance tolerance);
Judge says(bool truth);

// ---- Truth ----------------------------------------------------------------------------------------------------------

struct Finish {
    V ambient{0}, emission{0};
    double diffuse = 0, phong = 0, phong_size = 40, specular = 0, roughness = 0.05, metallic = 0, brilliance = 1;
    std::string text() const;  ///< all of it, as SDL
};

double r_dot_l(const V& n, const V& l, const V& v);
double n_dot_h(const V& n, const V& l, const V& v);
/// POV-Ray's empirical Fresnel factor of `metallic`.
double fresnel(double n_dot_l);
V highlight_tint(const Finish& finish, const V& color, const V& n, const V& l);
/// What light of colour 1 from l becomes on the way to v: diffuse and, unless `matt`, highlights.
V shaded(const Finish& finish, const V& color, const V& n, const V& l, const V& v, bool matt = false);

struct Lamp {
    V location{0};
    V color{1};
    double fade_distance = 0, fade_power = 0;
    bool shadowless = false;

    std::string text() const;
    double fading(double distance) const;
    /// Colour that arrives at a point, unhindered.
    V arriving(const V& point) const { return fading(glm::length(location - point)) * color; }
    V towards(const V& point) const { return glm::normalize(location - point); }
};

// ---- The questions, by task
// ------------------------------------------------------------------------------------------

std::vector<Question> pigments(std::uint64_t seed);       // 2.1
std::vector<Question> ambients(std::uint64_t seed);       // 2.2
std::vector<Question> diffuses(std::uint64_t seed);       // 2.3
std::vector<Question> phongs(std::uint64_t seed);         // 2.4
std::vector<Question> blinns(std::uint64_t seed);         // 2.5
std::vector<Question> fadings(std::uint64_t seed);        // 2.6
std::vector<Question> cones(std::uint64_t seed);          // 2.7
std::vector<Question> illuminations(std::uint64_t seed);  // 2.8
std::vector<Question> shadows(std::uint64_t seed);        // 2.9
std::vector<Question> sums(std::uint64_t seed);           // 2.10

}  // namespace rays::grader::step_2
