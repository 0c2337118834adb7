#include "grader/submission/format.h"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <set>

#include "grader/submission/safe_path.h"
#include "grader/text.h"

namespace rays::grader {
namespace {

using nlohmann::json;

constexpr std::size_t kLargestFile = 256 * 1024;
constexpr int kDeepest = 8;  ///< what is nested deeper is no part of the format

/// One picture's fields, read one by one; the first problem counts.
class PictureReader {
public:
    explicit PictureReader(const json& object) : object_(object) {}

    SubmittedPicture read() {
        SubmittedPicture picture;
        for (const auto& [key, value] : object_.items())
            if (!kFields.count(key)) fail(fmt::format("has the unknown field \"{}\"", plain(key, 40)));
        picture.file = name("file");
        picture.scene = plain_scene_name(name("scene"));
        check_extension("file", picture.file, {".png", ".exr"});
        check_extension("scene", picture.scene, {".pov"});
        picture.raster = {side("width"), side("height")};
        if (problem.empty() && std::int64_t{picture.raster.width} * picture.raster.height > kMostPixels)
            fail(fmt::format("has more than {} pixels", kMostPixels));
        picture.shows = features();
        return picture;
    }

    std::string problem;

private:
    inline static const std::set<std::string> kFields{"file", "scene", "width", "height", "shows"};

    void fail(const std::string& text) {
        if (problem.empty()) problem = text;
    }

    const json* field(const char* key) {
        const auto found = object_.find(key);
        if (found != object_.end()) return &*found;
        fail(fmt::format("has no \"{}\"", key));
        return nullptr;
    }

    std::string name(const char* key) {
        const json* value = field(key);
        if (!value) return {};
        if (!value->is_string()) return fail(fmt::format("\"{}\" is no text", key)), std::string();
        const auto text = plain_scene_name(value->get<std::string>());
        if (const std::string why = path_problem(text); !why.empty())
            fail(fmt::format("\"{}\": \"{}\" {}", key, plain(text, 60), why));
        return text;
    }

    void check_extension(const char* key, const std::string& file, std::initializer_list<const char*> allowed) {
        const std::string extension = std::filesystem::path(file).extension().string();
        std::string names;
        for (const char* one : allowed) {
            if (extension == one) return;
            names += (names.empty() ? "" : " or ") + std::string(one);
        }
        fail(fmt::format("\"{}\": \"{}\" does not end in {}", key, plain(file, 60), names));
    }

    int side(const char* key) {
        const json* value = field(key);
        if (!value) return 0;
        const bool good = value->is_number_integer() && *value >= 1 && *value <= kLargestSide;
        if (!good) fail(fmt::format("\"{}\" is no whole number from 1 to {}", key, kLargestSide));
        return good ? value->get<int>() : 0;
    }

    std::vector<std::string> features() {
        const json* list = field("shows");
        std::vector<std::string> result;
        if (!list) return result;
        if (!list->is_array() || list->size() > kMostFeatures)
            return fail(fmt::format("\"shows\" is no list of at most {} features", kMostFeatures)), result;
        for (const json& entry : *list) {
            if (!entry.is_string()) return fail("\"shows\" has an entry that is no text"), result;
            const auto feature = plain(entry.get<std::string>(), 60);
            if (std::find(result.begin(), result.end(), feature) == result.end()) result.push_back(feature);
        }
        return result;
    }

    const json& object_;
};

void read_pictures(const json& list, Submission& submission) {
    if (list.size() > kMostPictures)
        submission.problems.push_back(
            fmt::format("submission.json: only the first {} of {} pictures count", kMostPictures, list.size()));
    std::set<std::string> known;
    for (std::size_t i = 0; i < std::min(list.size(), kMostPictures); ++i) {
        const auto refuse = [&](const std::string& why) {
            submission.problems.push_back(fmt::format("submission.json: picture {} {}", i + 1, why));
        };
        if (!list[i].is_object()) {
            refuse("is no object");
            continue;
        }
        PictureReader reader(list[i]);
        const SubmittedPicture picture = reader.read();
        if (!reader.problem.empty())
            refuse(reader.problem);
        else if (!known.insert(picture.file).second)
            refuse(fmt::format("names \"{}\" again", plain(picture.file, 60)));
        else
            submission.pictures.push_back(picture);
    }
}

}  // namespace

std::string plain_scene_name(std::string name) {
    for (const std::string_view prefix : {"./", "submission/"})
        while (name.starts_with(prefix)) name.erase(0, prefix.size());
    return name;
}

Submission parse_submission(const std::string& text) {
    Submission submission;
    submission.present = true;
    const auto shallow = [](int depth, json::parse_event_t, json&) { return depth <= kDeepest; };
    json root;
    try {
        root = json::parse(text, shallow);
    } catch (const json::exception& e) {
        submission.problems.push_back(fmt::format("submission.json is not JSON: {}", plain(e.what())));
        return submission;
    }
    const auto version = root.is_object() ? root.find("version") : root.end();
    if (!root.is_object() || version == root.end() || *version != 1)
        submission.problems.emplace_back("submission.json: needs \"version\": 1 (steps/README.md, \"Handing in\")");
    else if (!root.contains("pictures") || !root["pictures"].is_array())
        submission.problems.emplace_back("submission.json: needs a list \"pictures\"");
    else
        read_pictures(root["pictures"], submission);
    return submission;
}

Submission read_submission(const std::filesystem::path& folder) {
    const OutputFile file = read_inside(folder, kSubmissionFile, kLargestFile);
    if (file.taken) return parse_submission(file.bytes);
    Submission submission;
    submission.present = file.problem != "was not found";
    submission.problems.push_back(std::string(kSubmissionFile) + " " + file.problem);
    return submission;
}

}  // namespace rays::grader
