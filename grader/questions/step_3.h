// What the questions of step 3 share: optics in other forms than the solution's, and scenes of mirrors and glass.
//
// Truth is computed in long double. Directions come from angles (the solution never computes one), reflectances from
// the two amplitudes r_s and r_p.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "questions/step_2.h"

namespace rays::grader::step_3 {

using step_2::across;
using step_2::close_to;
using step_2::Dice;
using step_2::header;
using step_2::kGeometry;
using step_2::kLight;
using step_2::kPi;
using step_2::Notebook;
using step_2::number;
using step_2::numbers;
using step_2::radians;
using step_2::rgb;
using step_2::says;
using step_2::sphere;
using step_2::tilted;
using step_2::Tolerance;
using step_2::V;
using step_2::vector;

using L = long double;
using Judge = decltype(Question::judge);

/// A number like those in scenes: the reader keeps indices of refraction in single precision, and so must the truth.
inline double single(double v) { return static_cast<double>(static_cast<float>(v)); }

// ---- Optics ---------------------------------------------------------------------------------------------------------

/// A ray that meets a surface: the direction points into it, the normal to where the ray comes from.
struct Meeting {
    V direction, normal;
    V sideways;  ///< unit, along the surface, where the direction leads

    std::string text() const { return numbers(direction) + " " + numbers(normal); }
};
/// At `angle` from the normal.
Meeting meeting(Dice& dice, double angle);

/// Behind the surface, at this angle from the normal.
V behind(const Meeting& m, double angle);
V mirrored(const Meeting& m, double angle);

double critical_angle(double relative_ior);  ///< for an index below 1
double angle_behind(double angle, double relative_ior);
/// Reflected share of unpolarised light, from Fresnel's two amplitudes.
double reflectance(double angle, double relative_ior);

// ---- Judges ---------------------------------------------------------------------------------------------------------

/// "Nothing": total reflection.
Judge nothing();
/// The first numbers of the answer are close to these; the others are not looked at, but must be there.
Judge starts_with(std::vector<double> truth, std::size_t count, Tolerance tolerance);

/// "r g b", all three of one value.
Judge grey(double value);

// ---- Scenes ---------------------------------------------------------------------------------------------------------

/// Global settings and camera. Nothing is pruned unless said.
std::string world(int max_trace_level = 10, double adc_bailout = 0, const std::string& background = "rgb 0");
/// A finish that only mirrors and lets through.
inline const char* const kDark = "ambient 0 diffuse 0";
/// Glass that loses nothing.
std::string lossless(double ior);
/// Something that shines by itself, the same from everywhere.
std::string shining(const V& color);

std::string plane(const std::string& normal, double distance, const std::string& more);

std::vector<Question> mirrors(std::uint64_t seed);        // 3.1
std::vector<Question> refractions(std::uint64_t seed);    // 3.2
std::vector<Question> fresnels(std::uint64_t seed);       // 3.3
std::vector<Question> finishes(std::uint64_t seed);       // 3.4
std::vector<Question> borders(std::uint64_t seed);        // 3.5
std::vector<Question> absorptions(std::uint64_t seed);    // 3.6
std::vector<Question> glass_shadows(std::uint64_t seed);  // 3.7
std::vector<Question> prunings(std::uint64_t seed);       // 3.8
std::vector<Question> reflections(std::uint64_t seed);    // 3.9
std::vector<Question> transmissions(std::uint64_t seed);  // 3.10
std::vector<Question> trees(std::uint64_t seed);          // 3.11

}  // namespace rays::grader::step_3
