// What the course says about its steps: steps/N_*/step.json and grader/rubric.json.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rays::grader {

struct Task {
    std::string id, title;
    double points = 0;
    std::string rubric;  ///< the row of rubric.json it counts for; may be empty
    std::string file;    ///< within the step's folder
    std::vector<std::string> hints;
    std::string partition{};  ///< with which structure its fresh scenes are rendered
};

/// A scene whose picture is held against its reference.
struct SceneTask {
    std::string scene;               ///< "1_ray_casting/one_sphere.pov"
    std::vector<std::string> tasks;  ///< the first one's rubric row gets the points
    double points = 0;
    std::string shows;
    std::string partition;  ///< with which structure it is rendered: "grid"; empty: as the program chooses
    // A noisy scene is judged statistically.
    int samples = 0;                             ///< a pixel; 0: the scene has no noise, its picture is exact
    int seeds = 0;                               ///< of the first batch
    double noise_full = 1.75, noise_none = 2.5;  ///< variance over the solution's: full points up to, none from

    bool statistical() const { return samples > 0; }
};

/// A scene of which maps are drawn of what every pixel costs.
struct CostTask {
    std::string scene;
    std::vector<std::string> structures;  ///< "none", "grid", "octree", "bvh": in this order
};

/// What the student's program is timed on, for a chart of speed (tests/bench/chart.h): pictures, or rays through
/// structures over more and more spheres.
struct SpeedTask {
    std::string chart;   ///< its id
    std::string series;  ///< of the solution, whose points the student's stand beside; structures name their own
    std::string time;    ///< where the chart has time: "x", "y", or "1/x"
    // Pictures.
    std::string scene;
    int width = 0, height = 0;
    struct Setting {
        std::string label, add;  ///< of the solution's point, and global settings that make it
        int samples = 0;         ///< Sobol's; 0: the picture is no mean
    };
    std::vector<Setting> settings;
    /// Settings of the solution's picture that errors are differences to; kReference: POV-Ray's frames, averaged;
    /// empty: no errors.
    std::string truth;
    static constexpr const char* kReference = "reference";
    // Structures.
    std::vector<std::string> structures;
    std::vector<int> counts;
};

struct Step {
    int number = 0;
    std::string id, title;
    std::filesystem::path folder;
    std::string partition;  ///< of tasks and scenes that do not say otherwise
    std::vector<Task> tasks;
    std::vector<SceneTask> scenes;
    std::vector<CostTask> cost_maps;  ///< no points depend on them
    std::vector<SpeedTask> speed;     ///< nor on these

    const Task* find(const std::string& task) const;
    double points() const;  ///< of all tasks and scenes
};

/// Every built step (a folder steps/N_name with a step.json), in order. Throws InputError naming file and field.
std::vector<Step> read_steps(const std::filesystem::path& steps_folder);

struct RubricRow {
    std::string id, title;
    double points = 0;
    bool extra = false;
    std::vector<std::string> counts;   ///< the `rubric` words of tasks that count for it; its own id when none is given
    std::string note;                  ///< why it is not graded yet, when no task counts for it
    std::vector<std::string> shows{};  ///< features that pictures of a hand-in must show; equal shares of its points
};

struct Rubric {
    std::vector<RubricRow> rows;
    double extra_limit = 0;  ///< extra rows give at most this much together
};

Rubric read_rubric(const std::filesystem::path& file);

/// Tasks in the order of their ids: "1.9" before "1.10".
bool task_before(const std::string& a, const std::string& b);

}  // namespace rays::grader
