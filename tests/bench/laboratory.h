// Where charts get their numbers: every measurement is made once, both sides of a comparison in turns.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "process_time.h"

namespace rays::bench {

/// One method in one build, as measured by a measuring program (measure/subject.h).
struct Measured {
    std::string settings;
    std::vector<double> ns;  ///< CPU time of a ray, one value a round
    double error_median = 0, error_mean = 0, error_largest = 0, wrong = 0;
};

/// By the subject's name, e.g. "sphere/near/robust".
using MeasuredByName = std::map<std::string, Measured>;

/// The methods of a step in both builds; round i of one build ran beside round i of the other.
struct BothReals {
    MeasuredByName in_double, in_float;
};

class Laboratory {
public:
    struct Settings {
        std::filesystem::path bin;        ///< programs of the build in double
        std::filesystem::path float_bin;  ///< measuring programs of the build in float
        std::filesystem::path scenes;
        int rounds = 11;
        double seconds = 0.02;  ///< at least so long is a subject measured in each round
    };
    explicit Laboratory(Settings settings) : settings_(std::move(settings)) {}

    int rounds() const { return settings_.rounds; }

    /// Runs measure-<step> of both builds in turns, when first asked.
    const BothReals& methods(int step);

    /// Processor time of POV-Ray (first) and of render-solution (second) for one picture without anti-aliasing, one
    /// thread, start and writing of an EXR file included. `scene` is relative to the folder of scenes.
    PairedTimes against_povray(const std::string& scene, int width, int height) const;

private:
    Settings settings_;
    std::map<int, BothReals> methods_;
};

/// Adds one round: what Google Benchmark wrote as JSON. Throws std::runtime_error when it is no such thing.
void add_round(MeasuredByName& measured, const std::string& benchmark_json);

}  // namespace rays::bench
