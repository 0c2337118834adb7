#include "grader/results.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "support/files.h"

namespace rays::grader {
namespace {

using nlohmann::ordered_json;
using Json = ordered_json;

constexpr const char* kSchema = "raysteps-results/1";

constexpr std::array kVerdicts{"pass",        "partial", "fail",     "not started",
                               "build error", "crash",   "time-out", "infrastructure error"};

Verdict verdict_of(const std::string& text) {
    for (std::size_t i = 0; i < kVerdicts.size(); ++i)
        if (text == kVerdicts[i]) return static_cast<Verdict>(i);
    throw InputError("unknown verdict " + text);
}

// A sum of thirds is shown as 7, not as 6.9999999999.
double rounded(double points) { return std::round(points * 1000) / 1000; }

// JSON knows no NaN: null stands for it, and for infinity.
Json number(double v) { return std::isfinite(v) ? Json(v) : Json(nullptr); }
Json color(const Rgb& c) { return Json::array({number(c[0]), number(c[1]), number(c[2])}); }

template <class T>
Json list(const std::vector<T>& items);

Json json_of(const Diagnosis& d) {
    Json j{{"kind", d.kind}, {"text", d.text}};
    if (!d.mutant.empty()) j["mutant"] = d.mutant;
    return j;
}

Json json_of(const AskedQuestion& q) {
    return {{"about", q.about},       {"query", q.query},   {"scene", q.scene},
            {"expected", q.expected}, {"answer", q.answer}, {"ok", q.ok}};
}

Json json_of(const ImageResult& i) {
    Json j{{"scene", i.scene}};
    if (!i.student.empty()) j["student"] = i.student;
    if (!i.reference.empty()) j["reference"] = i.reference;
    if (!i.solution.empty()) j["solution"] = i.solution;
    j.update({{"width", i.width},
              {"height", i.height},
              {"pixels", i.pixels},
              {"beyond_rounding", i.beyond_rounding},
              {"on_silhouettes", i.on_silhouettes},
              {"max_error", number(i.max_error)},
              {"rmse", number(i.rmse)},
              {"tolerance", i.tolerance},
              {"tolerance_absolute", i.tolerance_absolute}});
    j["worst"] = {{"x", i.worst_x},
                  {"y", i.worst_y},
                  {"student", color(i.worst_student)},
                  {"reference", color(i.worst_reference)}};
    if (i.trees)
        j["trees"] = {{"student", i.trees->student},
                      {"solution", i.trees->solution},
                      {"first_difference", i.trees->first_difference}};
    return j;
}

Json json_of(const ChannelDifference& d) {
    return {{"channel", d.channel},
            {"difference", number(d.difference)},
            {"reference", number(d.reference)},
            {"margin", number(d.margin)},
            {"standard_error", number(d.standard_error)},
            {"z", number(d.z)},
            {"limit", number(d.limit)},
            {"wrong", d.wrong}};
}

Json json_of(const StatisticsResult& s) {
    Json j{{"samples", s.samples},          {"seeds", s.seeds},
           {"batches", s.batches},          {"alarm_rate", s.alarm_rate},
           {"not_finite", s.not_finite},    {"tiles", s.tiles},
           {"tiles_wrong", s.tiles_wrong},  {"tile_margin", s.tile_margin},
           {"whole_margin", s.whole_margin}};
    if (s.worst) {
        j["worst"] = {{"x", s.worst->x}, {"y", s.worst->y}, {"width", s.worst->width}, {"height", s.worst->height}};
        j["worst"].update(json_of(s.worst->difference));
    }
    j["whole"] = list(s.whole);
    j["noise"] = {{"variance", number(s.variance)}, {"full", s.noise_full}, {"none", s.noise_none}};
    if (s.solution_variance) j["noise"]["solution"] = number(*s.solution_variance);
    if (s.noise_ratio) j["noise"]["ratio"] = number(*s.noise_ratio);
    if (!s.z_picture.empty()) j["z_picture"] = s.z_picture;
    return j;
}

Json json_of(const Chart& c) {
    Json series = Json::array();
    for (const ChartSeries& s : c.series) {
        Json points = Json::array();
        for (const auto& [x, y] : s.points) points.push_back(Json::array({number(x), y ? number(*y) : Json(nullptr)}));
        series.push_back({{"name", s.name}, {"role", s.role}, {"points", points}});
    }
    return {{"title", c.title}, {"x_label", c.x_label},     {"y_label", c.y_label}, {"log_x", c.log_x},
            {"log_y", c.log_y}, {"pass_from", c.pass_from}, {"pass_to", c.pass_to}, {"series", series}};
}

Json json_of(const Check& c) {
    Json j{{"id", c.id},
           {"task", c.task},
           {"kind", c.kind},
           {"mode", c.mode},
           {"title", c.title},
           {"verdict", to_string(c.verdict)},
           {"points", rounded(c.points)},
           {"max", c.max},
           {"message", c.message},
           {"reproduce", c.reproduce},
           {"seconds", rounded(c.seconds)},
           {"diagnosis", list(c.diagnosis)}};
    if (!c.questions.empty()) j["questions"] = list(c.questions);
    if (c.image) j["image"] = json_of(*c.image);
    if (c.chart) j["chart"] = json_of(*c.chart);
    if (c.statistics) j["statistics"] = json_of(*c.statistics);
    return j;
}

Json json_of(const TaskResult& t) {
    Json j{{"id", t.id},
           {"title", t.title},
           {"verdict", to_string(t.verdict)},
           {"points", rounded(t.points)},
           {"max", t.max},
           {"hint", t.hint},
           {"file", t.file}};
    if (t.line > 0) j["line"] = t.line;
    return j;
}

Json json_of(const Spread& s) { return {{"mean", rounded(s.mean)}, {"max", s.max}}; }

Json json_of(const CostMap& m) {
    Json j{{"structure", m.structure}, {"whose", m.whose}, {"verdict", to_string(m.verdict)}};
    if (!m.message.empty()) j["message"] = m.message;
    if (m.file.empty()) return j;
    j.update({{"file", m.file}, {"tests", json_of(m.tests)}, {"nodes", json_of(m.nodes)}, {"cells", m.cells}});
    if (m.cells_left_out > 0) j["cells_left_out"] = m.cells_left_out;
    return j;
}

Json json_of(const CostScene& s) {
    Json j{{"scene", s.scene}, {"width", s.width}, {"height", s.height}};
    j["ray"] = {{"x", s.x}, {"y", s.y}, {"origin", s.origin}, {"direction", s.direction}};
    if (s.distance) j["ray"]["distance"] = number(*s.distance);
    j["maps"] = list(s.maps);
    return j;
}

Json json_of(const SpeedPoint& p) {
    Json j{{"chart", p.chart}, {"series", p.series}, {"time", p.time}, {"verdict", to_string(p.verdict)}};
    if (p.label.empty())
        j["at"] = p.at;
    else
        j["label"] = p.label;
    if (!p.message.empty()) j["message"] = p.message;
    if (p.verdict != Verdict::pass) return j;
    j["ratio"] = {{"median", number(p.median)}, {"low", number(p.low)}, {"high", number(p.high)}};
    j["rounds"] = p.rounds;
    if (p.error) j.update({{"error", number(*p.error)}, {"against", p.against}});
    return j;
}

Json json_of(const StepResult& s) {
    Json j{{"id", s.id},
           {"number", s.number},
           {"title", s.title},
           {"verdict", to_string(s.verdict)},
           {"points", rounded(s.points)},
           {"max", s.max},
           {"tasks", list(s.tasks)},
           {"checks", list(s.checks)}};
    if (!s.cost_maps.empty()) j["cost_maps"] = list(s.cost_maps);
    if (!s.speed.empty()) j["speed"] = list(s.speed);
    return j;
}

Json json_of(const HandedIn& h) {
    return {{"id", "handed_in"},
            {"title", "Pictures and report"},
            {"verdict", to_string(h.verdict)},
            {"points", rounded(h.points)},
            {"max", h.max},
            {"checks", list(h.checks)},
            {"report", h.report}};
}

Json json_of(const RubricResult& r) {
    return {{"id", r.id},         {"title", r.title}, {"points", rounded(r.points)}, {"max", r.max}, {"extra", r.extra},
            {"graded", r.graded}, {"note", r.note}};
}

template <class T>
Json list(const std::vector<T>& items) {
    Json j = Json::array();
    for (const T& item : items) j.push_back(json_of(item));
    return j;
}

Json json_of(const Results& r) {
    const bool broken = !r.infrastructure_error.empty();
    Json j{
        {"schema", kSchema},
        {"created", r.created},
        {"submission", {{"name", r.submission_name}, {"from", r.submission_from}}},
        {"machine", {{"cpu", r.cpu}, {"cores", r.cores}, {"os", r.os}}},
        {"versions", {{"raysteps", r.raysteps}, {"povray", r.povray}, {"compiler", r.compiler}, {"real", r.real}}},
        {"sandbox",
         {{"tier", r.sandbox_tier},
          {"limits",
           {{"cpu_s", r.cpu_s}, {"memory_mb", r.memory_mb}, {"processes", r.processes}, {"output_mb", r.output_mb}}}}},
        {"seed", r.seed},
        {"seconds", rounded(r.seconds)},
        {"complete", r.complete},
        {"status", broken ? "infrastructure error" : "graded"},
        {"message", r.infrastructure_error},
        {"score", {{"points", rounded(r.points)}, {"max", r.max}, {"extra", rounded(r.extra)}}},
        {"rubric", list(r.rubric)},
        {"steps", list(r.steps)}};
    if (r.handed_in) j["handed_in"] = json_of(*r.handed_in);
    return j;
}

// ---- reading, for the summary and the exporters: no pictures' details, no charts
// -------------------------------------

Check check_of(const Json& j) {
    Check c;
    c.id = j.at("id"), c.task = j.at("task"), c.kind = j.at("kind"), c.mode = j.at("mode"), c.title = j.at("title");
    c.verdict = verdict_of(j.at("verdict"));
    c.points = j.at("points"), c.max = j.at("max"), c.message = j.at("message"), c.reproduce = j.at("reproduce");
    c.seconds = j.at("seconds");
    for (const Json& d : j.at("diagnosis")) c.diagnosis.push_back({d.at("kind"), d.at("text"), d.value("mutant", "")});
    if (j.contains("image")) {
        const Json& i = j.at("image");
        c.image.emplace();
        c.image->scene = i.at("scene");
        c.image->student = i.value("student", ""), c.image->reference = i.value("reference", ""),
        c.image->solution = i.value("solution", "");
    }
    return c;
}

StepResult step_of(const Json& j) {
    StepResult s;
    s.id = j.at("id"), s.number = j.at("number"), s.title = j.at("title"), s.verdict = verdict_of(j.at("verdict"));
    s.points = j.at("points"), s.max = j.at("max");
    for (const Json& t : j.at("tasks"))
        s.tasks.push_back({t.at("id"), t.at("title"), verdict_of(t.at("verdict")), t.at("points"), t.at("max"),
                           t.at("hint"), t.at("file"), t.value("line", 0)});
    for (const Json& c : j.at("checks")) s.checks.push_back(check_of(c));
    return s;
}

Results results_of(const Json& j) {
    if (j.at("schema") != kSchema) throw InputError("not of schema " + std::string(kSchema));
    Results r;
    r.created = j.at("created"), r.submission_name = j.at("submission").at("name"),
    r.submission_from = j.at("submission").at("from");
    r.sandbox_tier = j.at("sandbox").at("tier"), r.seed = j.at("seed"), r.seconds = j.at("seconds"),
    r.complete = j.at("complete");
    r.infrastructure_error = j.at("message");
    r.points = j.at("score").at("points"), r.max = j.at("score").at("max");
    for (const Json& row : j.at("rubric"))
        r.rubric.push_back({row.at("id"), row.at("title"), row.at("points"), row.at("max"), row.at("extra"),
                            row.at("graded"), row.at("note")});
    for (const Json& s : j.at("steps")) r.steps.push_back(step_of(s));
    r.extra = j.at("score").value("extra", 0.0);
    if (j.contains("handed_in")) {
        const Json& h = j.at("handed_in");
        r.handed_in = HandedIn{verdict_of(h.at("verdict")), h.at("points"), h.at("max"), {}, h.at("report")};
        for (const Json& c : h.at("checks")) r.handed_in->checks.push_back(check_of(c));
    }
    return r;
}

}  // namespace

Check new_check(std::string id, std::string task, std::string kind, std::string title, double max) {
    Check check;
    check.id = std::move(id);
    check.task = std::move(task);
    check.kind = std::move(kind);
    check.title = std::move(title);
    check.max = max;
    return check;
}

std::string to_string(Verdict verdict) { return kVerdicts[static_cast<std::size_t>(verdict)]; }

std::string to_json(const Results& results) {
    // Texts were made plain where they came in; should a byte have slipped through, it must not lose the whole result.
    return json_of(results).dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

void write_results(const Results& results, const std::filesystem::path& file) {
    write_atomically(file, to_json(results));
}

Results read_results(const std::filesystem::path& file) {
    try {
        return results_of(Json::parse(read_file(file)));
    } catch (const Json::exception& e) {
        throw InputError(fmt::format("{}: {}", file.string(), e.what()));
    }
}

}  // namespace rays::grader
