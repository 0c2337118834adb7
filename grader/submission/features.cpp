#include "grader/submission/features.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "grader/submission/looks.h"

namespace rays::grader {
namespace {

using nlohmann::json;

constexpr const char* kLevels = "3";  ///< the camera's ray and two reflections

std::string percent(double share) { return fmt::format("{:.3g} %", 100 * share); }

/// What the program prints about the scene; null when it prints no JSON.
json asked(const Sandbox& sandbox, const std::filesystem::path& program, const SceneFiles& files, Raster raster,
           const Limits& limits, const std::vector<std::string>& options) {
    Job job;
    job.program = program;
    job.files = files;
    job.limits = limits;
    job.arguments = {
        files.front().name, "--width", std::to_string(raster.width), "--height", std::to_string(raster.height),
        "--threads",        "1"};
    job.arguments.insert(job.arguments.end(), options.begin(), options.end());
    const JobResult result = sandbox.run(job);
    const json answer = json::parse(result.ended.ok() ? result.ended.out : std::string(), nullptr, false);
    return answer.is_object() ? answer : json::object();
}

}  // namespace

FeatureProver::FeatureProver(const Sandbox& sandbox, std::filesystem::path solution, const SceneFiles& files,
                             Raster raster, const Limits& limits, const RgbImage& whole)
    : sandbox_(sandbox),
      solution_(std::move(solution)),
      files_(files),
      raster_(raster),
      limits_(limits),
      whole_(whole) {
    ask_effects();
    ask_shapes();
}

void FeatureProver::ask_effects() {
    const json answer = asked(sandbox_, solution_, files_, raster_, limits_, {"--needs", "--json"});
    for (const json& e : answer.value("effects", json::array())) effects_[e.at("name")] = e.at("needed");
}

void FeatureProver::ask_shapes() {
    const json answer = asked(sandbox_, solution_, files_, raster_, limits_, {"--seen"});
    const double pixels = double(raster_.width) * raster_.height;
    const json seen = answer.value("seen", json::object());
    for (const auto& [name, count] : seen.items()) shapes_[name] = count.get<double>() / pixels;
    // The assignment's polygons: whatever is flat and has corners.
    for (const char* kind : {"triangles", "smooth_triangles", "meshes"})
        if (shapes_.count(kind)) shapes_["polygons"] += shapes_[kind];
}

Shot FeatureProver::shoot_with(const std::vector<std::string>& options) const {
    return shoot(sandbox_, solution_, files_, raster_, limits_, options);
}

Proof FeatureProver::changes(Proof proof, const RgbImage& before, const std::vector<std::string>& options) {
    proof.expected = fmt::format("at least {} of the pixels change by {} of 255 display levels or more",
                                 percent(kVisibleShare), kVisibleLevels);
    const Shot after = shoot_with(options);
    if (after.against) {
        proof.found = "cannot be rendered: " + after.against->message;
        return proof;
    }
    const double share = visible_share(before, after.picture);
    proof.found = percent(share);
    proof.shown = share >= kVisibleShare;
    return proof;
}

Proof FeatureProver::prove_effect(const std::string& feature) {
    Proof proof{feature, false, "rendered with --without " + feature, "a scene that needs it", "this one does not"};
    return effects_.at(feature) ? changes(proof, whole_, {"--without", feature}) : proof;
}

Proof FeatureProver::prove_shape(const std::string& feature) {
    const double share = shapes_.at(feature);
    return {feature, share >= kVisibleShare, "counted what the pixels' centres see first",
            fmt::format("at least {} of the pixels", percent(kVisibleShare)), percent(share)};
}

Proof FeatureProver::prove_depth() {
    Proof proof{kRecursiveReflection, false, fmt::format("rendered with --max-trace-level {}", kLevels),
                "a scene with mirrors", "this one has none"};
    if (!effects_["reflection"]) return proof;
    const std::vector<std::string> opaque{"--without", "transparency"}, shallow{"--max-trace-level", kLevels};
    if (!effects_["transparency"]) return changes(proof, whole_, shallow);
    const Shot before = shoot_with(opaque);
    if (before.against) return proof.found = "cannot be rendered: " + before.against->message, proof;
    return changes(proof, before.picture, {opaque[0], opaque[1], shallow[0], shallow[1]});
}

Proof FeatureProver::prove(const std::string& feature) {
    if (feature == kRecursiveReflection) return prove_depth();
    if (effects_.count(feature)) return prove_effect(feature);
    if (shapes_.count(feature)) return prove_shape(feature);
    std::string names = kRecursiveReflection;
    for (const auto& [name, share] : shapes_) names += ", " + name;
    for (const auto& [name, needed] : effects_)
        if (needed) names += ", " + name;
    return {feature, false, "looked it up", "one of " + names, "no such feature"};
}

}  // namespace rays::grader
