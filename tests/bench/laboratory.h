// Where charts get their numbers: every measurement is made once, all sides of a comparison in turns.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "knobs.h"
#include "measurements.h"
#include "process_time.h"
#include "renderers.h"

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

/// A scene in both renderers, round by round.
struct WholeProgram {
    std::string scene;                                   ///< "2_phong/checkers"
    std::vector<double> povray_s = {}, raysteps_s = {};  ///< processor time of the whole process
    std::vector<double> single_s = {};                   ///< ours without packets
};

/// A structure of step 4 with one constant changed.
struct KnobRun {
    Knob knob;
    TimedByName timed = {};
};

/// A picture in one setting.
struct Try {
    Command command;  ///< writes `output`
    std::filesystem::path output;
};
struct Tried {
    Spread cpu_s;  ///< of the whole process
    RgbImage image;
};

class Laboratory {
public:
    struct Settings {
        std::filesystem::path bin;        ///< programs of the build in double
        std::filesystem::path float_bin;  ///< measuring programs of the build in float
        std::filesystem::path scenes;
        int rounds = 11;        ///< of methods that take nanoseconds
        int long_rounds = 3;    ///< of whole pictures, and of structures over many bodies
        double seconds = 0.02;  ///< at least so long is a subject measured in each round
        bool large = false;     ///< also what takes minutes: 10^7 bodies, the scenes of scenes/bench
    };
    explicit Laboratory(Settings settings) : settings_(std::move(settings)) {}

    const Settings& settings() const { return settings_; }
    int rounds() const { return settings_.rounds; }
    int long_rounds() const { return settings_.long_rounds; }
    std::filesystem::path program(const std::string& name) const { return settings_.bin / name; }
    std::filesystem::path scene(const std::string& name) const {
        return std::filesystem::absolute(settings_.scenes / name);
    }

    /// Runs measure-<step> of both builds in turns, when first asked.
    const BothReals& methods(int step);

    /// The structures of step 4 and Embree (measure/step_4_subjects.h), when first asked.
    const TimedByName& structures();

    /// The structures again, one constant changed in each, with bounced rays among 10^5 spheres and triangles; the
    /// rounds of all knobs in turns. Programs that were not built are left out.
    const std::vector<KnobRun>& knobs();

    /// Every scene of the step without anti-aliasing, in pairs: all scenes in each round, so that a slow minute of the
    /// machine is shared. `folder` is one of scenes/.
    std::vector<WholeProgram> whole_programs(const std::string& folder, int side) const;

    /// Runs all of them in turns, `rounds` times, and loads what they wrote.
    std::vector<Tried> try_all(const std::vector<Try>& tries, int rounds) const;

private:
    Settings settings_;
    std::map<int, BothReals> methods_;
    TimedByName structures_;
    std::vector<KnobRun> knobs_;
};

/// Adds one round: what Google Benchmark wrote as JSON. Throws std::runtime_error when it is no such thing.
void add_round(MeasuredByName& measured, const std::string& benchmark_json);

/// The scenes of a folder, without ".pov", sorted.
std::vector<std::string> scenes_of(const std::filesystem::path& folder);

}  // namespace rays::bench
