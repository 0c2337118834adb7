// The result of a grading run: plain data, and its one canonical form, results.json (schema raysteps-results/1).
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "references/reference.h"

namespace rays::grader {

enum class Verdict { pass, partial, fail, not_started, build_error, crash, time_out, infrastructure_error };

/// "pass", "not started", "time-out", ...
std::string to_string(Verdict verdict);

struct Diagnosis {
    std::string kind;  ///< "mutant", "tree", "picture" or "hint"
    std::string text;
    std::string mutant;  ///< its id, for kind "mutant"
};

struct AskedQuestion {
    std::string about, query, scene, expected, answer;
    bool ok = false;
};

struct RayTrees {
    std::string student, solution, first_difference;
};

struct ImageResult {
    std::string scene;
    std::string partition;                     ///< as in SceneTask; told by Check::reproduce
    std::string student, reference, solution;  ///< paths relative to the folder of results.json; empty: there is none
    int width = 0, height = 0, pixels = 0, beyond_rounding = 0, on_silhouettes = 0;
    double max_error = 0, rmse = 0;
    double tolerance = 0;           ///< for a value of 1
    double tolerance_absolute = 0;  ///< the part of it that does not grow with the value
    int worst_x = 0, worst_y = 0;
    Rgb worst_student{}, worst_reference{};
    std::optional<RayTrees> trees;
};

/// Of the mean over seeds to the reference, in one channel.
struct ChannelDifference {
    std::string channel;  ///< "R", "G" or "B"
    double difference = 0, reference = 0, margin = 0, standard_error = 0;
    double z = 0, limit = 0;  ///< standard errors beyond the margin, and how many a right picture may have
    bool wrong = false;
};

struct WorstTile {
    int x = 0, y = 0, width = 0, height = 0;
    ChannelDifference difference;
};

/// How a noisy picture was judged: the numbers of the last batch.
struct StatisticsResult {
    int samples = 0, seeds = 0, batches = 1;
    int not_finite = 0;  ///< pixels of all pictures; then there are no differences
    int tiles = 0, tiles_wrong = 0;
    double alarm_rate = 0;  ///< of all batches together
    double tile_margin = 0, whole_margin = 0;
    std::optional<WorstTile> worst{};
    std::vector<ChannelDifference> whole{};                    ///< of the whole picture, by channel
    double variance = 0;                                       ///< over the seeds, mean over pixels and channels
    std::optional<double> solution_variance{}, noise_ratio{};  ///< absent: the noise was not compared
    double noise_full = 0, noise_none = 0;
    std::string z_picture{};  ///< EXR: every pixel has its tile's z; relative to the folder of results.json
};

struct ChartSeries {
    std::string name;
    std::string role;                                              ///< "solution", "student" or "naive"
    std::vector<std::pair<double, std::optional<double>>> points;  ///< no value: failed there
};

struct Chart {
    std::string title, x_label, y_label;
    bool log_x = true, log_y = true;
    double pass_from = 0, pass_to = 0;
    std::vector<ChartSeries> series;
};

struct Check {
    std::string id;    ///< "1.3.unit", "1.picture.one_sphere", "1.3.fresh", "1.3.distance"
    std::string task;  ///< the task it belongs to
    std::string kind;  ///< "unit", "image", "statistical", "fresh", "stability", "demonstration" or "report"
    std::string mode = "isolated";  ///< or "all mine"
    std::string title;
    Verdict verdict = Verdict::fail;
    bool waits = false;  ///< nothing is wrong: what is missing waits for other tasks. Not written to the file.
    double points = 0, max = 0;
    std::string message;
    std::string reproduce;
    double seconds = 0;
    std::vector<Diagnosis> diagnosis;
    std::vector<AskedQuestion> questions;
    std::optional<ImageResult> image;
    std::optional<Chart> chart;
    std::optional<StatisticsResult> statistics{};  ///< of kind "statistical"
};

/// Pictures held against their references: they have points of their own, beside those of tasks.
inline bool is_picture(const Check& check) { return check.kind == "image" || check.kind == "statistical"; }

/// A check that has found nothing yet.
Check new_check(std::string id, std::string task, std::string kind, std::string title, double max);

/// Mean and maximum over all pixels.
struct Spread {
    double mean = 0, max = 0;
};

/// What every pixel of a scene costs with one structure, and what one camera ray visits there.
struct CostMap {
    std::string structure;            ///< "none", "grid", "octree" or "bvh"
    std::string whose;                ///< "solution" or "student"
    Verdict verdict = Verdict::pass;  ///< no points depend on it; all but pass: there is no map
    std::string message{};            ///< why there is none
    std::string file{};               ///< EXR with the channels tests, nodes; relative to the folder of results.json
    Spread tests{}, nodes{};          ///< primitives asked, and cells or nodes visited, by all rays of a pixel
    /// Least and greatest corner of what the ray of the scene visits, in this order.
    std::vector<std::array<double, 6>> cells{};
    std::size_t cells_left_out = 0;  ///< visited after these
};

/// A scene in several structures, for the pixel on which they spend most.
struct CostScene {
    std::string scene;
    int width = 0, height = 0;
    int x = 0, y = 0;                             ///< the pixel
    std::array<double, 3> origin{}, direction{};  ///< of its camera ray
    std::optional<double> distance{};             ///< to what it hits
    std::vector<CostMap> maps{};
};

/// The student's program beside the solution's, at one point of a chart of speed. No points depend on it.
struct SpeedPoint {
    std::string chart, series;  ///< the chart's id, and the solution's series
    std::string label;          ///< of the solution's point; empty: it is the one at x = at
    double at = 0;
    std::string time{};                    ///< where the chart has time: "x", "y", or "1/x"
    Verdict verdict = Verdict::pass;       ///< all but pass: there is no point
    std::string message{};                 ///< why there is none, or what is to be said about it
    double median = 0, low = 0, high = 0;  ///< the student's processor time over the solution's, run in turns
    int rounds = 0;
    std::optional<double> error{};  ///< of the picture, as charts have it
    std::string against{};          ///< what the error is a difference to
};

struct TaskResult {
    std::string id, title;
    Verdict verdict = Verdict::fail;
    double points = 0, max = 0;
    std::string hint, file;
    int line = 0;  ///< where the student has to write; 0: nobody knows, and results.json leaves it out
};

struct StepResult {
    std::string id, title;
    int number = 0;
    Verdict verdict = Verdict::fail;
    double points = 0, max = 0;
    std::vector<TaskResult> tasks;
    std::vector<Check> checks;
    std::vector<CostScene> cost_maps{};  ///< of steps that have structures
    std::vector<SpeedPoint> speed{};     ///< when there are charts to show them in
};

/// Pictures and report, judged by grader/submission.
struct HandedIn {
    Verdict verdict = Verdict::not_started;
    double points = 0, max = 0;
    std::vector<Check> checks;
    std::string report;  ///< the prose as it came, without control characters: hostile
};

struct RubricResult {
    std::string id, title;
    double points = 0, max = 0;
    bool extra = false;
    bool graded = true;  ///< false: max is not part of the score
    std::string note;
};

struct Results {
    std::string created;  ///< UTC, "2026-01-31T12:00:00Z"
    std::string submission_name, submission_from;
    std::string cpu, os;
    int cores = 0;
    std::string raysteps, povray, compiler, real;
    std::string sandbox_tier;
    double cpu_s = 0;
    int memory_mb = 0, processes = 0, output_mb = 0;
    std::uint64_t seed = 0;
    double seconds = 0;
    bool complete = false;             ///< false: a partial result, rewritten when the next step is done
    std::string infrastructure_error;  ///< not empty: this is no grade
    double points = 0, max = 0;
    double extra = 0;  ///< of the extra rows, at most what the rubric allows
    std::vector<RubricResult> rubric;
    std::vector<StepResult> steps;
    std::optional<HandedIn> handed_in;  ///< none: this run did not look at what is handed in
};

std::string to_json(const Results& results);

/// The same text in a file that appears whole or not at all.
void write_results(const Results& results, const std::filesystem::path& file);

/// Reads what write_results wrote (for `summary` and `export`). Throws InputError.
Results read_results(const std::filesystem::path& file);

}  // namespace rays::grader
