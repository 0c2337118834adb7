#include "grader/picture_parts.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "core/exr_file.h"
#include "references/manifest.h"
#include "support/files.h"
#include "support/sha256.h"

namespace rays::grader {

namespace fs = std::filesystem;

std::string stem(const std::string& scene) { return fs::path(scene).stem().string(); }

Check new_picture_check(const Bench& bench, const SceneTask& scene, const std::string& kind, const std::string& mode) {
    Check check;
    const bool isolated = mode == "isolated";
    check.id = fmt::format("{}.picture.{}{}", bench.step.number, stem(scene.scene), isolated ? "" : ".all_mine");
    check.task = scene.tasks.empty() ? std::string() : scene.tasks.front();
    check.kind = kind;
    check.mode = mode;
    check.title = scene.shows.empty() ? stem(scene.scene) : scene.shows;
    check.max = isolated ? scene.points : 0;
    check.image.emplace().scene = scene.scene;
    check.image->partition = scene.partition;
    return check;
}

ReferenceFiles reference_files(const Bench& bench, const std::string& scene, bool averaged) {
    static const Manifest manifest = load_manifest(bench.project.references() / "manifest.json");
    const ManifestEntry* entry = manifest.find(scene);
    if (!entry) throw InputError(fmt::format("{} has no reference: run ./rays references {}", scene, stem(scene)));
    ReferenceFiles result{scene_files(bench.project.scenes() / scene), bench.project.references() / entry->reference};
    if (sha256(result.scene.front().bytes) != entry->sha256)
        throw InputError(
            fmt::format("{} has changed since its reference was made: run ./rays references {}", scene, stem(scene)));
    if (entry->averaged() != averaged)
        throw InputError(fmt::format("the reference of {} is {}: in step.json, \"samples\" and \"seeds\" {}", scene,
                                     entry->method, averaged ? "are for means of frames" : "are missing"));
    return result;
}

std::string kept_picture(const Bench& bench, const std::string& name, const std::string& exr) {
    if (bench.out.empty() || exr.empty()) return {};
    write_atomically(bench.out / "images" / (name + ".exr"), exr);
    return "images/" + name + ".exr";
}

std::string kept_picture(const Bench& bench, const std::string& name, const RgbImage& picture) {
    if (bench.out.empty() || picture.pixels.empty()) return {};
    Film film(picture.raster);
    for (int y = 0; y < picture.raster.height; ++y)
        for (int x = 0; x < picture.raster.width; ++x)
            film.at(x, y) = Radiance(picture.at(x, y)[0], picture.at(x, y)[1], picture.at(x, y)[2]);
    const std::string file = "images/" + name + ".exr";
    fs::create_directories(bench.out / "images");
    write_exr(film, (bench.out / file).string());
    return file;
}

std::string unfinished_text(const std::vector<UnfinishedPlace>& places) {
    std::string text;
    for (std::size_t i = 0; i < std::min<std::size_t>(places.size(), 4); ++i)
        text += fmt::format("{}{} ({}:{})", i ? ", " : "", places[i].task, places[i].file, places[i].line);
    return text + (places.size() > 4 ? ", ..." : "");
}

std::vector<std::string> options_of(const std::string& partition) {
    if (partition.empty()) return {};
    return {"--partition", partition};
}

}  // namespace rays::grader
