#include "methods.h"

#include <fmt/format.h>

namespace rays::bench {

Point mean_error_point(const Measured& measured, const std::string& real) {
    return {.x = spread(measured.ns),
            .y = measured.error_mean,
            .label = "",
            .settings = fmt::format("{}, {}; largest error {:.2g}, {:.2g} % of the rays answered wrongly",
                                    measured.settings, real, measured.error_largest, 100 * measured.wrong)};
}

Series mean_error_series(const std::string& name, const std::string& role, const MeasuredByName& measured,
                         const std::string& real, const std::vector<std::string>& subjects) {
    Series series{.name = name, .role = role, .joined = subjects.size() > 1};
    for (const auto& subject : subjects) series.points.push_back(mean_error_point(measured.at(subject), real));
    return series;
}

Chart roots_chart(const std::string& id, const std::string& title, const std::string& text, const std::string& subjects,
                  Laboratory& laboratory) {
    const BothReals& both = laboratory.methods(1);
    const std::vector<std::string> robust{subjects + "/robust"}, textbook{subjects + "/textbook"};
    return {.id = id,
            .step = 1,
            .title = title,
            .text = text,
            .x = kTimeOfRay,
            .y = kMeanError,
            .front = true,
            .series = {mean_error_series("robust, double", "solution", both.in_double, "double", robust),
                       mean_error_series("robust, float", "float", both.in_float, "float", robust),
                       mean_error_series("textbook, double", "naive", both.in_double, "double", textbook),
                       mean_error_series("textbook, float", "naive", both.in_float, "float", textbook)}};
}

}  // namespace rays::bench
