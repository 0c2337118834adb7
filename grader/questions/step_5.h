// What the questions of step 5 share: claims about many points at once.
//
// Points are random, so no truth is a list of numbers. What is judged is what every right pattern and every right map
// has: how many points a cell may hold, moments, areas. Where chance decides, the margin is six standard deviations:
// once in 500 million. Where the points are the centres of a grid it is what a smooth map errs by, and a few times
// that.
#pragma once

#include <string>
#include <vector>

#include "questions.h"
#include "questions/construct.h"

namespace rays::grader::step_5 {

using construct::Dice;
using construct::L;
using construct::Notebook;
using construct::V;
using construct::V2;

/// An answer as rows of equally many numbers.
struct Table {
    const std::vector<double>& numbers;
    std::size_t width;

    std::size_t rows() const { return numbers.size() / width; }
    L at(std::size_t row, std::size_t column) const { return numbers[row * width + column]; }
    V2 pair(std::size_t row, std::size_t column = 0) const { return {at(row, column), at(row, column + 1)}; }
    V triple(std::size_t row, std::size_t column = 0) const {
        return {at(row, column), at(row, column + 1), at(row, column + 2)};
    }
};

/// All that has to hold of an answer; the first that does not is what was expected.
class Claims {
public:
    void holds(bool ok, const std::string& what);
    /// A NaN is within nothing.
    void within(L value, L truth, L margin, const std::string& what);
    Judgement judgement(const std::string& in_short) const;
    void error(L e) { error_ = std::max(error_, e); }  ///< what a sweep charts

private:
    std::string broken_;
    L error_ = 0;
};

using Claimed = std::function<void(const Table&, Claims&)>;
/// Exactly so many rows of so many finite numbers, of which the claims hold.
Judge rows_hold(std::size_t rows, std::size_t width, std::string in_short, Claimed claims);
/// One number, this near to the truth; an infinite truth is met exactly.
Judge is_number(L truth, L margin);

// ---- Points of the unit square -----------------------------------------------------------------------------------------

std::vector<V2> points_in(const Table& table);
inline constexpr L kSigmas = 6;

/// As if thrown one by one: moments, no covariance of x and y, nor of one point and the next.
void claim_random(Claims& claims, const std::vector<V2>& points);
void claim_in_square(Claims& claims, const std::vector<V2>& points);
/// Each so often, but for chance.
void claim_equal_shares(Claims& claims, const std::vector<int>& counts, const std::string& what);

/// Cells as the handout lays them: columns is the root, rounded down.
struct Grid {
    int columns, rows;
    int count() const { return columns * rows; }
    int cell(const V2& p) const;
    V2 within(const V2& p) const;  ///< where in its cell, 0 to 1
};
Grid grid_for(int samples);
/// The most that any cell, column strip and row strip holds.
int most_in_a_cell(const Grid& grid, const std::vector<V2>& points);
int most_in_a_strip(int strips, const std::vector<V2>& points, int axis);

// ---- Maps from the unit square -----------------------------------------------------------------------------------------

/// Asked for the centres of a grid: "grid COLUMNS ROWS W". An answer has room for 16384 numbers.
struct Centers {
    int columns, rows;
    L third = 0;
    std::size_t count() const { return std::size_t(columns) * std::size_t(rows); }
    std::string text() const;
};
Centers random_centers(Dice& dice, int most = 48);

L mean_of(std::size_t count, const std::function<L(std::size_t)>& f);
/// Equal areas to equal areas, of a shape of this area: most small squares of centres become as large as they have to.
void claim_equal_areas(Claims& claims, const Centers& centers, const std::vector<V2>& points, L area, L share = 0.9L);
/// Images of a grid's centres fill the unit disc evenly.
void claim_disc(Claims& claims, const Centers& centers, const std::vector<V2>& points);
/// Likewise the regular polygon whose first corner is (0, 1).
void claim_polygon(Claims& claims, const Centers& centers, const std::vector<V2>& points, int corners);
/// Likewise [-1/2, 1/2]^2.
void claim_square(Claims& claims, const Centers& centers, const std::vector<V2>& points);
/// Seen from afar a uniform disc, from every side.
void claim_ball(Claims& claims, const std::vector<V>& points, const V& side);

/// Coefficients of what lies in the plane of a and b, which need not be orthogonal, and how far it is from that plane.
struct InPlane {
    V2 at;
    L off;
};
InPlane in_plane(const V& p, const V& a, const V& b);

/// "0.25 0.5 0.75" of dice.
std::string chance(Dice& dice);

std::vector<Question> regular_and_random(std::uint64_t seed);  // 5.1
std::vector<Question> jittered(std::uint64_t seed);            // 5.2
std::vector<Question> multi_jittered(std::uint64_t seed);      // 5.3
std::vector<Question> sobol(std::uint64_t seed);               // 5.4
std::vector<Question> shapes(std::uint64_t seed);              // 5.5
std::vector<Question> filters(std::uint64_t seed);             // 5.6
std::vector<Question> lenses(std::uint64_t seed);              // 5.7
std::vector<Question> area_lights(std::uint64_t seed);         // 5.8
std::vector<Question> times(std::uint64_t seed);               // 5.9
std::vector<Question> rough_surfaces(std::uint64_t seed);      // 5.10
std::vector<Question> errors(std::uint64_t seed);              // 5.11
std::vector<Question> dimensions(std::uint64_t seed);          // 5.12
std::vector<Question> blurs(std::uint64_t seed);               // 5.13

// ---- Judges and scenes that sweeps ask with, too -----------------------------------------------------------------------

/// No two points of `samples` share a cell of the documented grid, nor (strips) a column or row of as many as it has
/// cells.
Judge stratified(int samples, bool strips);

struct LensCamera {
    V location, direction, right, up;
    L aperture = 0, focus = 1;  ///< focus: the sharp plane's depth over that of the film
    bool orthographic = false;
    int blades = 0;

    std::string scene() const;
    V axis() const { return glm::normalize(glm::cross(right, up)); }
};
/// A pixel's film point, and its pinhole's ray.
struct FilmPoint {
    int width, height, column, row;
    L dx, dy;
    std::string text() const;
    V pinhole_origin(const LensCamera& camera) const;
    V in_focus(const LensCamera& camera) const;

private:
    V on_film(const LensCamera& camera) const;
};
LensCamera upright_camera(Dice& dice);
FilmPoint film_point(Dice& dice);
Judge meets_in_focus(const LensCamera& camera, const FilmPoint& film, const Centers& centers);

/// A finish of this roughness on object 0.
std::string rough_scene(L glossy);
/// Unit normals that face the viewer, whose mirror rays leave the true surface.
void claim_proper_normals(Claims& claims, const Table& table, const V& geometric, const V& viewer);

}  // namespace rays::grader::step_5
