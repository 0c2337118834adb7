#include "grader/cost_maps.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>
#include <sstream>

#include "grader/picture.h"
#include "grader/shoot.h"
#include "grader/text.h"
#include "references/in_parallel.h"
#include "support/files.h"

namespace rays::grader {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr Raster kRaster{160, 120};
constexpr const char* kFile = "costs.exr";
/// A drawing shows no more cells than that; a grid of a thousand cells each way has 3000 along a ray.
constexpr std::size_t kMostCells = 200;
/// Several times what the slowest map takes. A structure that never ends must not hold up the grades.
constexpr double kSeconds = 12;

Limits limits_of(const Bench& bench) {
    // Sanitizers make the same work take several times as long.
    const double slower = bench.project.sanitized() ? 10 : 1;
    Limits limits = bench.limits;
    limits.cpu_s = slower * std::min(limits.cpu_s, kSeconds);
    limits.wall_s = slower * std::min(limits.wall_s, 3 * kSeconds);
    return limits;
}

// One map: who makes it, where it goes, and what came.
struct Mapping {
    fs::path program;
    std::size_t scene = 0, map = 0;
    DecodedCosts costs{};
};

struct Plan {
    std::vector<CostScene> scenes;
    std::vector<SceneFiles> files;  ///< of each scene
    std::vector<Mapping> mappings;

    CostMap& map_of(const Mapping& m) { return scenes[m.scene].maps[m.map]; }
};

Plan plan_of(const Bench& bench) {
    std::vector<std::pair<std::string, fs::path>> sides{{"solution", bench.solution}};
    if (bench.student != bench.solution) sides.insert(sides.begin(), {"student", bench.student});
    Plan plan;
    for (const CostTask& task : bench.step.cost_maps) {
        CostScene scene{task.scene, kRaster.width, kRaster.height};
        for (const auto& [whose, program] : sides) {
            for (const std::string& structure : task.structures) {
                plan.mappings.push_back({program, plan.scenes.size(), scene.maps.size()});
                scene.maps.push_back({structure, whose});
            }
        }
        plan.files.push_back(scene_files(bench.project.scenes() / task.scene));
        plan.scenes.push_back(std::move(scene));
    }
    return plan;
}

/// What the grader itself cannot do (a full disk, say) costs pictures, never grades.
template <class Work, class Otherwise>
void try_to(const Work& work, const Otherwise& otherwise) {
    try {
        work();
    } catch (const std::exception& e) {
        otherwise(std::string(e.what()));
    }
}

/// What the program says at its end: "unfinished 4.3 steps/4_partitioning/grid.cpp:15". The text is hostile.
std::string waits_for(const std::string& text) {
    std::set<std::string> tasks;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line) && tasks.size() < 8;) {
        std::istringstream words(line);
        std::string word, task;
        if (words >> word >> task && word == "unfinished") tasks.insert(plain(task, 8));
    }
    return tasks.empty() ? std::string() : fmt::format("waits for task {}", fmt::join(tasks, ", "));
}

Spread spread_of(const std::vector<float>& values) {
    return {std::accumulate(values.begin(), values.end(), 0.0) / double(values.size()),
            *std::max_element(values.begin(), values.end())};
}

void refuse(CostMap& map, Verdict verdict, const std::string& why) {
    map.verdict = verdict;
    map.message = why;
}

void render_map(const Bench& bench, const SceneFiles& files, Mapping& mapping, const std::string& scene, CostMap& map) {
    Job job = render_job(mapping.program, files, kRaster, limits_of(bench));
    job.arguments.insert(job.arguments.end(), {"--partition", map.structure, "--cost-map", kFile});
    job.outputs = {kFile};
    JobResult result = bench.sandbox.run(job);
    if (const auto against = against_run(result.ended)) return refuse(map, against->verdict, against->message);
    if (const std::string tasks = waits_for(result.ended.err); !tasks.empty())
        return refuse(map, Verdict::not_started, tasks);
    const OutputFile& file = result.files[kFile];
    if (!file.taken) return refuse(map, Verdict::fail, "the map " + file.problem);
    mapping.costs = decode_cost_map(file.bytes, kRaster.width, kRaster.height);
    if (!mapping.costs.problem.empty()) return refuse(map, Verdict::fail, "the map " + mapping.costs.problem);
    map.tests = spread_of(mapping.costs.tests);
    map.nodes = spread_of(mapping.costs.nodes);
    map.file = fmt::format("images/{}.costs.{}.{}.{}.exr", bench.step.number, fs::path(scene).stem().string(),
                           map.structure, map.whose);
    write_atomically(bench.out / map.file, file.bytes);
}

/// The pixel that is dear in all of the solution's structures: greatest geometric mean of tests and nodes together.
void choose_pixel(const std::vector<Mapping>& mappings, std::size_t scene, CostScene& costs) {
    std::vector<double> sum(static_cast<std::size_t>(kRaster.width * kRaster.height));
    for (const Mapping& m : mappings) {
        const CostMap& map = costs.maps[m.map];
        if (m.scene != scene || map.whose != "solution" || map.structure == "none" || m.costs.tests.empty()) continue;
        for (std::size_t i = 0; i < sum.size(); ++i)
            sum[i] += std::log1p(double(m.costs.tests[i]) + double(m.costs.nodes[i]));
    }
    const auto worst = std::max_element(sum.begin(), sum.end()) - sum.begin();
    costs.x = static_cast<int>(worst) % kRaster.width;
    costs.y = static_cast<int>(worst) / kRaster.width;
}

/// Origin, direction and hit of the pixel's camera ray, as the solution tells them.
void find_ray(const Bench& bench, const SceneFiles& files, CostScene& costs) {
    const std::string tree =
        ray_tree(bench.sandbox, bench.solution, files, kRaster, costs.x, costs.y, true, limits_of(bench));
    const json camera = json::parse(tree).at("queries").at(0);
    costs.origin = camera.at("origin");
    costs.direction = camera.at("direction");
    if (camera.at("hit").is_object()) costs.distance = camera.at("hit").at("t").get<double>();
}

void find_cells(const Bench& bench, const Mapping& mapping, const SceneFiles& files, const CostScene& costs,
                CostMap& map) {
    if (map.file.empty() || map.structure == "none") return;
    const std::string answer = ray_tree(bench.sandbox, mapping.program, files, kRaster, costs.x, costs.y, false,
                                        limits_of(bench), {"--visited", "--partition", map.structure});
    VisitedBoxes visited = visited_boxes(answer, kMostCells);
    map.cells = std::move(visited.boxes);
    map.cells_left_out = visited.left_out;
}

double seven_digits(double v) { return std::strtod(fmt::format("{:.7g}", v).c_str(), nullptr); }

/// Least and greatest corner; nothing when it is no box.
std::optional<std::array<double, 6>> box_of(const json& j) {
    if (!j.is_array() || j.size() != 6) return {};
    std::array<double, 6> box{};
    for (std::size_t i = 0; i < 6; ++i) {
        if (!j[i].is_number()) return {};
        box[i] = seven_digits(j[i].get<double>());
        if (!std::isfinite(box[i])) return {};
    }
    for (std::size_t a = 0; a < 3; ++a)
        if (box[a] > box[a + 3]) return {};
    return box;
}

}  // namespace

VisitedBoxes visited_boxes(const std::string& answer, std::size_t most) {
    VisitedBoxes result;
    const json all = json::parse(answer, nullptr, false);
    if (!all.is_object() || !all.contains("visited") || !all["visited"].is_array()) return result;
    for (const json& j : all["visited"]) {
        const auto box = box_of(j);
        if (!box) continue;
        if (result.boxes.size() < most)
            result.boxes.push_back(*box);
        else
            ++result.left_out;
    }
    return result;
}

std::vector<CostScene> map_costs(const Bench& bench, int workers) {
    if (bench.out.empty() || bench.step.cost_maps.empty()) return {};
    Plan plan = plan_of(bench);
    std::vector<Mapping>& mappings = plan.mappings;
    std::vector<CostScene>& scenes = plan.scenes;
    in_parallel(mappings.size(), workers, [&](std::size_t i) {
        CostMap& map = plan.map_of(mappings[i]);
        const auto broken = [&](const std::string& why) { refuse(map, Verdict::infrastructure_error, why); };
        try_to(
            [&] {
                render_map(bench, plan.files[mappings[i].scene], mappings[i], scenes[mappings[i].scene].scene, map);
            },
            broken);
    });
    // Without the ray or its cells a map is still a map.
    const auto nothing = [](const std::string&) {};
    in_parallel(scenes.size(), workers, [&](std::size_t i) {
        choose_pixel(mappings, i, scenes[i]);
        try_to([&] { find_ray(bench, plan.files[i], scenes[i]); }, nothing);
    });
    in_parallel(mappings.size(), workers, [&](std::size_t i) {
        const Mapping& m = mappings[i];
        try_to([&] { find_cells(bench, m, plan.files[m.scene], scenes[m.scene], plan.map_of(m)); }, nothing);
    });
    return std::move(plan.scenes);
}

}  // namespace rays::grader
