// What charts of methods share: the axes, and points from measurements.
#pragma once

#include <string>
#include <vector>

#include "chart.h"
#include "laboratory.h"

namespace rays::bench {

inline const Axis kTimeOfRay{"CPU time of a ray", "ns", true};
inline const Axis kMeanError{"mean error (wrong = 1)", "sizes of the shape", true};

/// One point: the time of the method, its mean error, and in the settings also the largest error and wrong answers.
Point mean_error_point(const Measured& measured, const std::string& real);

/// The subjects as one series, in their order. Throws std::out_of_range when a subject was not measured.
Series mean_error_series(const std::string& name, const std::string& role, const MeasuredByName& measured,
                         const std::string& real, const std::vector<std::string>& subjects);

/// The four of robust and textbook roots in double and float: "sphere/near" -> subjects ".../robust", ".../textbook".
Chart roots_chart(const std::string& id, const std::string& title, const std::string& text, const std::string& subjects,
                  Laboratory& laboratory);

}  // namespace rays::bench
