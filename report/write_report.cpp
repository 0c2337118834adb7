#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <system_error>

#include "core/error.h"
#include "page.h"
#include "pictures.h"
#include "report.h"
#include "text.h"

namespace rays {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::size_t kMaxPage = 3'000'000;
constexpr std::size_t kMaxInput = 256u << 20;
constexpr int kMaxDepth = 32;  ///< what is nested deeper is no part of the schema and is dropped

/// How much of everything is kept. Tried from the first to the last until the page is small enough.
struct Detail {
    std::size_t text_bytes;  ///< longest text
    std::size_t failed;      ///< failed questions of a check
    std::size_t passed;      ///< examples of passed ones
};
constexpr Detail kDetails[] = {{20'000, 60, 24}, {8'000, 40, 12}, {3'000, 20, 4}, {1'000, 8, 0}, {300, 3, 0}};
constexpr std::size_t kMaxResults = 1'200'000;  ///< leaves most of the page to the pictures

/// For whom pixels are kept as they compare, tried from the first to the last until the page is small enough; all
/// others keep what one looks at. The last leaves pictures out.
enum class Compared { all, failed, none };
constexpr Compared kCompared[] = {Compared::all, Compared::failed, Compared::none};

/// An object of this schema, whatever else it holds. `how` says which command writes such a file.
json read_object(const fs::path& file, const std::string& wanted, const std::string& how) {
    std::error_code error;
    const auto size = fs::file_size(file, error);
    if (error)
        throw InputError(fmt::format("{}: cannot be read ({}); run '{}' first", file.string(), error.message(), how));
    if (size > kMaxInput) throw InputError(file.string() + ": larger than 256 MB, so not what '" + how + "' writes");
    std::ifstream in(file, std::ios::binary);
    const auto shallow = [](int depth, json::parse_event_t, json&) { return depth <= kMaxDepth; };
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    json object = json::parse(report::valid_utf8(text), shallow, false);
    if (object.is_discarded() || !object.is_object())
        throw InputError(fmt::format("{}: not JSON; run '{}' again, and look at what wrote it", file.string(), how));
    const std::string schema = object.value("schema", json()).is_string() ? object["schema"].get<std::string>() : "";
    if (schema.rfind(wanted, 0) != 0)
        throw InputError(fmt::format("{}: the schema is '{}', this program reads {}", file.string(),
                                     report::harmless(schema, 100), wanted));
    return object;
}

/// What ./rays chart measured, for the page's section on speed. A file that cannot be used becomes a notice there: it
/// must not cost anybody the report of a grade.
json read_charts(const fs::path& file) {
    try {
        return read_object(file, "raysteps-charts/1", "./rays chart");
    } catch (const InputError& e) {
        return {{"problem", e.what()}};
    }
}

/// The results, with the charts that stand beside them as "measured". Charts alone make a page, too.
json read_results(const fs::path& file) {
    const fs::path charts = file.parent_path() / "charts.json";
    json results = !fs::exists(file) && fs::exists(charts) ? json{{"schema", "raysteps-results/1"}}
                                                           : read_object(file, "raysteps-results/1", "./rays grade");
    results.erase("measured");
    if (fs::exists(charts)) results["measured"] = read_charts(charts);
    return results;
}

/// Calls visit(item) for every object in the list of that name, if there is one.
template <typename Visit>
void for_each_in(json& object, const char* list, const Visit& visit) {
    if (!object.is_object() || !object.contains(list) || !object[list].is_array()) return;
    for (json& item : object[list])
        if (item.is_object()) visit(item);
}

/// Calls work(check) for every check of every step, whatever else the file holds.
template <typename Work>
void for_each_check(json& results, const Work& work) {
    for_each_in(results, "steps", [&](json& step) { for_each_in(step, "checks", work); });
    if (results.is_object() && results.contains("handed_in")) for_each_in(results["handed_in"], "checks", work);
}

/// Calls work(map) for every cost map of every step.
template <typename Work>
void for_each_cost_map(json& results, const Work& work) {
    for_each_in(results, "steps", [&](json& step) {
        for_each_in(step, "cost_maps", [&](json& scene) { for_each_in(scene, "maps", work); });
    });
}

void shorten_questions(json& check, const Detail& detail) {
    if (!check.contains("questions") || !check["questions"].is_array()) return;
    json kept = json::array();
    std::size_t failed = 0, passed = 0;
    for (json& question : check["questions"]) {
        if (!question.is_object()) continue;
        const bool ok = question.contains("ok") && question["ok"] == true;
        if (ok) question.erase("scene");
        if ((ok ? ++passed : ++failed) <= (ok ? detail.passed : detail.failed)) kept.push_back(std::move(question));
    }
    check["questions_passed"] = passed;
    check["questions_failed"] = failed;
    check["questions"] = std::move(kept);
}

/// Everything but the pictures, harmless and short enough.
json shortened(const json& results) {
    json kept;
    for (const Detail& detail : kDetails) {
        kept = results;
        for_each_check(kept, [&](json& check) { shorten_questions(check, detail); });
        report::make_harmless(kept, detail.text_bytes);
        if (report::for_script(kept).size() <= kMaxResults) return kept;
    }
    throw InputError("results.json holds too many checks for one page");
}

struct Shown {
    json* image;
    report::Need need;
};

/// Failed checks first: they are what the pixels are for. What is not started has nothing to compare yet.
std::vector<Shown> images_by_need(json& results, Compared compared) {
    std::vector<Shown> failed, passed, waiting;
    for_each_check(results, [&](json& check) {
        if (!check.contains("image") || !check["image"].is_object()) return;
        const auto is = [&](const char* verdict) { return check.contains("verdict") && check["verdict"] == verdict; };
        const auto need = [](bool compare) { return compare ? report::Need::compare : report::Need::look; };
        json* image = &check["image"];
        // The map of z compares means of noise; their last bits are noise, which does not compress.
        const bool noisy = check.contains("statistics");
        if (is("pass"))
            passed.push_back({image, need(compared == Compared::all && !noisy)});
        else if (is("not started"))
            waiting.push_back({image, report::Need::look});
        else
            failed.push_back({image, need(compared != Compared::none)});
    });
    failed.insert(failed.end(), passed.begin(), passed.end());
    failed.insert(failed.end(), waiting.begin(), waiting.end());
    return failed;
}

std::string page_with(const report::PageParts& parts, json results, const fs::path& folder, Compared compared) {
    const bool last_resort = compared == Compared::none;
    const std::size_t fixed = report::assemble(parts, report::for_script(results), {}).size();
    report::PictureStore store(folder);
    const auto images = images_by_need(results, compared);
    std::size_t maps = 0;  // of costs and of z
    for_each_cost_map(results, [&](json&) { ++maps; });
    for_each_check(results, [&](json& check) { maps += check.contains("statistics"); });
    // A blob's description and its element take less than this beside its bytes; so do the notes of a picture.
    const std::size_t beside = fixed + 600 * (images.size() + maps) + 2000;
    const std::size_t budget = kMaxPage - std::min(kMaxPage, beside);
    const auto room = [&] { return last_resort ? budget - std::min(budget, store.bytes()) : kMaxPage * 8; };
    for (const auto& [image, need] : images) store.embed(*image, need, room());
    for_each_check(results, [&](json& check) {
        if (check.contains("statistics") && check["statistics"].is_object()) store.embed_z(check["statistics"], room());
    });
    // No points depend on these: they come last.
    for_each_cost_map(results, [&](json& map) { store.embed_costs(map, room()); });
    return report::assemble(parts, report::for_script(results), store.blobs());
}

void write_whole(const std::string& text, const fs::path& file) {
    const fs::path partial = file.string() + ".partial";
    std::error_code ignored;
    if (file.has_parent_path()) fs::create_directories(file.parent_path(), ignored);
    {
        std::ofstream out(partial, std::ios::binary);
        out << text;
        out.close();
        if (!out) {
            fs::remove(partial, ignored);
            throw InputError(file.string() + ": cannot be written; check that the folder is writable and has room");
        }
    }
    std::error_code error;
    fs::rename(partial, file, error);
    if (error) {
        fs::remove(partial, ignored);
        throw InputError(file.string() + ": cannot be written (" + error.message() + ")");
    }
}

}  // namespace

void write_report(const fs::path& results_json, const fs::path& html) {
    report::PageParts parts = report::read_parts(RAYSTEPS_REPORT_FOLDER);
    json results = shortened(read_results(results_json));
    // The gallery is for lecturers: a student's page is the student's.
    if (results.value("/submission/from"_json_pointer, "") != "solution") parts.heroes.clear();
    std::string page;
    for (const Compared compared : kCompared) {
        page = page_with(parts, results, results_json.parent_path(), compared);
        if (page.size() < kMaxPage) break;
    }
    write_whole(page, html);
}

}  // namespace rays
