#include "grader/student_speed.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <optional>
#include <random>
#include <sstream>

#include "grader/picture.h"
#include "grader/shoot.h"
#include "grader/text.h"
#include "references/averaged.h"
#include "references/picture_error.h"

namespace rays::grader {
namespace {

constexpr const char* kPicture = "picture.exr";
/// Of one run. Ten times what the solution takes for the slowest, so that who is slow is still charted.
constexpr double kSeconds = 10;
/// Rays through a structure: the solution takes some tenth of a second for them.
constexpr int kRays = 100'000;
/// Tests that asking all spheres for a comparison may take.
constexpr int kTestsToCompare = 2'000'000;

/// What the two sides do in turns, and what of it counts.
struct Work {
    Job job;                         ///< the program is the side's
    std::optional<Job> beside = {};  ///< its time is taken off: what has to be done anyway
};

/// One side's runs of a round. Throws Finding: what goes wrong is a verdict, and ends the point.
struct Ran {
    double cpu_s = 0;
    JobResult last;
};

Ran run(const Bench& bench, const std::filesystem::path& program, const Work& work) {
    const auto timed = [&](Job job) {
        job.program = program;
        JobResult result = bench.sandbox.run(job);
        if (const auto against = against_run(result.ended)) throw *against;
        return result;
    };
    Ran ran;
    if (work.beside) ran.cpu_s -= timed(*work.beside).ended.cpu_s;
    ran.last = timed(work.job);
    ran.cpu_s += ran.last.ended.cpu_s;
    return ran;
}

/// The tasks that a program names at its end, or in its answer. The text is hostile.
void expect_finished(const Ended& ended) {
    for (const std::string* text : {&ended.err, &ended.out}) {
        std::istringstream lines(*text);
        std::string word, task;
        for (std::string line; std::getline(lines, line);) {
            std::istringstream words(line);
            if (words >> word >> task && word == "unfinished")
                throw Finding{Verdict::not_started, "waits for task " + plain(task, 8)};
        }
    }
}

void set_ratio(SpeedPoint& point, std::vector<double> ratios) {
    std::sort(ratios.begin(), ratios.end());
    point.rounds = static_cast<int>(ratios.size());
    point.median = ratios[ratios.size() / 2];
    point.low = ratios.front();
    point.high = ratios.back();
}

/// Runs both sides in turns and sets the ratio. Returns the student's last run.
JobResult compare(const Bench& bench, const Work& work, SpeedPoint& point) {
    JobResult students;
    std::vector<double> ratios;
    // The first round warms up and does not count; it tells early what does not run at all.
    for (int round = 0; round <= kSpeedRounds; ++round) {
        double student = 0, solution = 0;
        for (const bool mine : {round % 2 == 0, round % 2 != 0}) {
            Ran ran = run(bench, mine ? bench.student : bench.solution, work);
            (mine ? student : solution) = ran.cpu_s;
            if (!mine) continue;
            students = std::move(ran.last);
            expect_finished(students.ended);
        }
        if (round == 0) continue;
        if (!(student > 0 && solution > 0)) throw Finding{Verdict::fail, "too quick to be timed"};
        ratios.push_back(student / solution);
    }
    set_ratio(point, std::move(ratios));
    return students;
}

/// Fills in a point; what is found against the run becomes its verdict.
template <class Measure>
SpeedPoint attempted(SpeedPoint point, const Measure& measure) {
    try {
        measure(point);
    } catch (const Finding& f) {
        point.verdict = f.verdict;
        point.message = f.message;
    } catch (const std::exception& e) {
        // What the grader itself cannot do costs a point in a chart, never a grade.
        point.verdict = Verdict::infrastructure_error;
        point.message = e.what();
    }
    return point;
}

Limits limits_of(const Bench& bench) {
    Limits limits = bench.limits;
    const double slower = bench.project.sanitized() ? 10 : 1;
    limits.cpu_s = std::min(limits.cpu_s, slower * kSeconds);
    limits.wall_s = std::min(limits.wall_s, 3 * slower * kSeconds);
    return limits;
}

// ---- Pictures -------------------------------------------------------------------------------------------------------

Job picture_job(const Bench& bench, const SpeedTask& task, SceneFiles files, const std::string& settings,
                int samples = 0) {
    if (!settings.empty()) files.front().bytes += fmt::format("\nglobal_settings {{ {} }}\n", settings);
    Job job = render_job({}, files, {task.width, task.height}, limits_of(bench));
    job.arguments.insert(job.arguments.end(), {"-o", kPicture});
    if (samples > 0)
        job.arguments.insert(job.arguments.end(), {"--pattern", "sobol", "--samples", std::to_string(samples)});
    job.outputs = {kPicture};
    return job;
}

RgbImage picture_of(const JobResult& result, const SpeedTask& task) {
    const OutputFile& file = result.files.at(kPicture);
    if (!file.taken) throw Finding{Verdict::fail, "the picture " + file.problem};
    DecodedPicture decoded = decode_exr(file.bytes, task.width, task.height);
    if (!decoded.problem.empty()) throw Finding{Verdict::fail, "the picture " + decoded.problem};
    return std::move(decoded.picture);
}

/// What errors of a task's pictures are differences to.
class Truth {
public:
    Truth(const Bench& bench, const SpeedTask& task, const SceneFiles& files) {
        if (task.truth == SpeedTask::kReference) {
            reference_ = load_averaged_reference((bench.project.references() / task.scene).replace_extension(".exr"));
        } else {
            picture_ = picture_of(run(bench, bench.solution, {picture_job(bench, task, files, task.truth)}).last, task);
        }
    }
    double error_of(const RgbImage& picture) const {
        return reference_ ? picture_error(picture, *reference_) : picture_error(picture, picture_);
    }

private:
    std::optional<AveragedReference> reference_;
    RgbImage picture_;
};

void time_pictures(const Bench& bench, const SpeedTask& task, std::vector<SpeedPoint>& points) {
    const SceneFiles files = scene_files(bench.project.scenes() / task.scene);
    std::optional<Truth> truth;
    for (const auto& setting : task.settings) {
        SpeedPoint point{task.chart, task.series, setting.label};
        point.time = task.time;
        points.push_back(attempted(std::move(point), [&](SpeedPoint& p) {
            const JobResult result = compare(bench, {picture_job(bench, task, files, setting.add, setting.samples)}, p);
            const RgbImage picture = picture_of(result, task);
            if (task.truth.empty()) return;
            if (!truth) truth.emplace(bench, task, files);
            const double error = truth->error_of(picture);
            if (!std::isfinite(error)) throw Finding{Verdict::fail, "the picture is no number somewhere"};
            p.error = error;
            if (task.truth != SpeedTask::kReference) p.against = task.truth;
        }));
    }
}

// ---- Structures -----------------------------------------------------------------------------------------------------

Job answer_job(const Bench& bench, const std::string& scene, const std::string& query) {
    Job job;
    job.arguments = {"--answer"};
    job.input = fmt::format("scene {}\n{}{}\n", scene.size(), scene, query);
    job.limits = limits_of(bench);
    return job;
}

/// Of some rays, how many the student's structure answers otherwise than asking all spheres; empty when none.
std::string disagreement(const Bench& bench, const std::string& scene, const std::string& structure, int count) {
    const int rays = std::clamp(kTestsToCompare / count, 20, 2000);
    const std::string query = fmt::format("agreement_{} {} 1 1", structure, rays);
    const Ran ran = run(bench, bench.student, {answer_job(bench, scene, query)});
    std::istringstream words(ran.last.ended.out);
    double asked = 0, hits = 0, differences = 0;
    if (!(words >> asked >> hits >> differences)) return "it does not say whether its answers are right";
    if (differences == 0) return {};
    return fmt::format("{:.0f} of {:.0f} rays are answered otherwise than by asking all", differences, asked);
}

void time_structures(const Bench& bench, const SpeedTask& task, std::vector<SpeedPoint>& points) {
    for (const int count : task.counts) {
        const std::string scene = cube_of_spheres(count);
        for (const std::string& structure : task.structures) {
            SpeedPoint point{task.chart, structure, ""};
            point.at = count;
            point.time = task.time;
            points.push_back(attempted(std::move(point), [&](SpeedPoint& p) {
                const auto rays = [&](int many) {
                    return answer_job(bench, scene, fmt::format("effort_{} {} {}", structure, many, bench.seed % 1000));
                };
                // With a single ray all is read and built as well.
                compare(bench, {rays(kRays), rays(1)}, p);
                p.message = disagreement(bench, scene, structure, count);
            }));
        }
    }
}

}  // namespace

std::string cube_of_spheres(int count) {
    std::mt19937_64 random(static_cast<std::uint64_t>(count));
    const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    // count * pi r^2 = 1
    const double radius = std::sqrt(1 / (std::numbers::pi * count));
    std::string scene;
    for (int i = 0; i < count; ++i) {
        const double x = unit() - 0.5, y = unit() - 0.5, z = unit() - 0.5;
        scene += fmt::format("sphere {{ <{:.7g}, {:.7g}, {:.7g}>, {:.7g} }}\n", x, y, z, radius);
    }
    return scene;
}

std::vector<SpeedPoint> time_student(const Bench& bench) {
    std::vector<SpeedPoint> points;
    if (bench.student == bench.solution) return points;
    for (const SpeedTask& task : bench.step.speed)
        task.structures.empty() ? time_pictures(bench, task, points) : time_structures(bench, task, points);
    return points;
}

}  // namespace rays::grader
