#include "grader/step_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "support/files.h"

namespace rays::grader {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

json parse(const fs::path& file) {
    try {
        return json::parse(read_file(file), nullptr, true, true);
    } catch (const json::exception& e) {
        throw InputError(fmt::format("{}: {}", file.string(), e.what()));
    }
}

Task task_of(const json& j, const Step& step) {
    Task task;
    task.id = j.at("id");
    task.title = j.at("title");
    task.points = j.at("points");
    task.rubric = j.value("rubric", "");
    task.file = j.value("file", "");
    task.hints = j.value("hints", std::vector<std::string>{});
    task.partition = j.value("partition", step.partition);
    return task;
}

/// "samples": 16, "seeds": 8, "noise": [1.75, 2.5]; the last may be left out.
void read_noise(const json& j, SceneTask& scene) {
    const auto refuse = [&](const std::string& what) {
        throw InputError(fmt::format("scene {}: {}", scene.scene, what));
    };
    if (!j.contains("samples") || !j.contains("seeds"))
        refuse("a noisy scene needs both \"samples\" and \"seeds\"; one without noise needs neither");
    if (!j.at("samples").is_number_integer() || !j.at("seeds").is_number_integer())
        refuse("\"samples\" and \"seeds\" are whole numbers");
    scene.samples = j.at("samples");
    scene.seeds = j.at("seeds");
    if (scene.samples < 1 || scene.samples > 4096)
        refuse(fmt::format("\"samples\" is {}: need 1 to 4096", scene.samples));
    if (scene.seeds < 8 || scene.seeds > 64)
        refuse(fmt::format("\"seeds\" is {}: need 8 to 64, for fewer say little of their spread", scene.seeds));
    if (!j.contains("noise")) return;
    const json& noise = j.at("noise");
    if (!noise.is_array() || noise.size() != 2 || !noise[0].is_number() || !noise[1].is_number())
        refuse("\"noise\" is two numbers: up to which ratio of variances it is well, and from which it earns nothing");
    scene.noise_full = noise[0];
    scene.noise_none = noise[1];
    if (!(scene.noise_full >= 1 && scene.noise_full < scene.noise_none))
        refuse(fmt::format("\"noise\" is [{}, {}]: need 1 <= first < second", scene.noise_full, scene.noise_none));
}

SceneTask scene_of(const json& j, const Step& step) {
    SceneTask scene;
    scene.scene = j.at("scene");
    scene.tasks = j.value("tasks", std::vector<std::string>{});
    scene.points = j.at("points");
    scene.shows = j.value("shows", "");
    scene.partition = j.value("partition", step.partition);
    if (j.contains("samples") || j.contains("seeds") || j.contains("noise")) read_noise(j, scene);
    return scene;
}

/// {"chart","time","series","scene","width","height","settings":[{"label","add","samples"}],"truth"} or
/// {"chart","time","structures","counts"}
SpeedTask speed_of(const json& j) {
    SpeedTask task;
    task.chart = j.at("chart");
    task.time = j.at("time");
    if (j.contains("structures")) {
        j.at("structures").get_to(task.structures);
        j.at("counts").get_to(task.counts);
        return task;
    }
    task.series = j.at("series");
    task.scene = j.at("scene");
    task.width = j.at("width");
    task.height = j.at("height");
    for (const json& s : j.at("settings"))
        task.settings.push_back({s.at("label"), s.value("add", ""), s.value("samples", 0)});
    task.truth = j.value("truth", "");
    return task;
}

Step step_of(const fs::path& folder) {
    const json j = parse(folder / "step.json");
    Step step;
    step.number = j.at("number");
    step.id = j.at("id");
    step.title = j.at("title");
    step.folder = folder;
    step.partition = j.value("partition", "");
    for (const json& t : j.at("tasks")) step.tasks.push_back(task_of(t, step));
    for (const json& s : j.at("scenes")) {
        try {
            step.scenes.push_back(scene_of(s, step));
        } catch (const InputError& e) {
            throw InputError(fmt::format("{}/step.json: {}", folder.string(), e.what()));
        }
    }
    if (j.contains("cost_maps"))
        for (const json& c : j.at("cost_maps")) step.cost_maps.push_back({c.at("scene"), c.at("structures")});
    if (j.contains("speed"))
        for (const json& s : j.at("speed")) step.speed.push_back(speed_of(s));
    for (const SceneTask& s : step.scenes)
        for (const std::string& t : s.tasks)
            if (!step.find(t))
                throw InputError(
                    fmt::format("{}/step.json: scene {} names the unknown task {}", folder.string(), s.scene, t));
    return step;
}

template <class F>
auto reading(const fs::path& file, F f) {
    try {
        return f();
    } catch (const json::exception& e) {
        throw InputError(fmt::format("{}: {}", file.string(), e.what()));
    }
}

}  // namespace

const Task* Step::find(const std::string& task) const {
    const auto found = std::find_if(tasks.begin(), tasks.end(), [&](const Task& t) { return t.id == task; });
    return found == tasks.end() ? nullptr : &*found;
}

double Step::points() const {
    double sum = 0;
    for (const Task& t : tasks) sum += t.points;
    for (const SceneTask& s : scenes) sum += s.points;
    return sum;
}

std::vector<Step> read_steps(const fs::path& steps_folder) {
    std::vector<Step> steps;
    if (!fs::is_directory(steps_folder)) throw InputError(steps_folder.string() + ": no such folder");
    for (const auto& entry : fs::directory_iterator(steps_folder)) {
        if (!fs::exists(entry.path() / "step.json")) continue;
        steps.push_back(reading(entry.path() / "step.json", [&] { return step_of(entry.path()); }));
    }
    std::sort(steps.begin(), steps.end(), [](const Step& a, const Step& b) { return a.number < b.number; });
    return steps;
}

Rubric read_rubric(const fs::path& file) {
    return reading(file, [&] {
        const json j = parse(file);
        Rubric rubric;
        rubric.extra_limit = j.value("extra_limit", 0.0);
        for (const json& r : j.at("rows")) {
            RubricRow row{r.at("id"), r.at("title"), r.at("points"), r.value("extra", false), {}, r.value("note", "")};
            row.counts = r.value("counts", std::vector<std::string>{row.id});
            row.shows = r.value("shows", std::vector<std::string>{});
            rubric.rows.push_back(row);
        }
        return rubric;
    });
}

bool task_before(const std::string& a, const std::string& b) {
    const auto order = [](const std::string& id) {
        const auto dot = id.find('.');
        return std::pair(std::atoi(id.c_str()), dot == std::string::npos ? 0 : std::atoi(id.c_str() + dot + 1));
    };
    return order(a) < order(b);
}

}  // namespace rays::grader
