// Numbers of a scene as functions of Time or Wavelength, sampled.
#pragma once

#include <cstddef>
#include <vector>

#include "core/scene.h"

namespace rays::sdl {

struct Variable {
    Varying::Variable kind;
    const char* name;
    double first, last;

    double at(double part) const { return first + part * (last - first); }
};
inline constexpr Variable kTime{Varying::Variable::time, "Time", 0, 1};
inline constexpr Variable kWavelength{Varying::Variable::wavelength_nm, "Wavelength", 380, 780};

/// Floats, which colours are, are rounded by this part of themselves.
inline constexpr double kNumberRounding = 1e-6;

/// Samples at equal distances over the variable's range, of those of the scene's numbers that change with it. A number
/// joins when it is first seen to change; until then it was what it is in `base`.
class NumberTable {
public:
    /// `base`: all numbers of the scene as read first; they must outlive the table.
    NumberTable(const Variable& variable, const std::vector<double>& base) : variable_(variable), base_(&base) {}

    const Variable& variable() const { return variable_; }
    std::size_t intervals() const { return samples_.size() - 1; }
    /// Which numbers of the scene it holds, ascending.
    const std::vector<std::size_t>& which() const { return which_; }
    /// How many doubles that is.
    double held() const { return static_cast<double>(samples_.size()) * static_cast<double>(which_.size()); }

    /// All numbers of the scene, at the next place.
    void add(const std::vector<double>& values) { samples_.push_back(taken(values)); }
    /// All numbers of the scene in the middle of the next interval.
    void add_middle(const std::vector<double>& values) { middles_.push_back(taken(values)); }
    /// Do the middles lie where linear interpolation says?
    bool middles_agree() const;
    /// And these, at this part of the range? The middles must be there for all intervals, or for none.
    bool agrees(double part, const std::vector<double>& values);
    /// The middles become samples: twice as many intervals.
    void merge_middles();

    /// Rotations by different angles give lengths that differ in their last bits: that is no change.
    bool is_constant(std::size_t k) const;
    /// Number which()[k], with as few samples as its error allows.
    Varying thinned(std::size_t k) const;

private:
    std::vector<double> taken(const std::vector<double>& values);
    void admit(const std::vector<double>& values);
    void widen(std::vector<double>& sample, const std::vector<std::size_t>& all) const;
    double allowed(std::size_t k) const;

    Variable variable_;
    const std::vector<double>* base_;
    std::vector<std::size_t> which_;
    std::vector<std::vector<double>> samples_;  ///< [i][k]: number which_[k] at i / intervals() of the range
    std::vector<std::vector<double>> middles_;  ///< samples between those, while the table gets finer
};

}  // namespace rays::sdl
