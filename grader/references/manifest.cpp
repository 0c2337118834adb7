#include "references/manifest.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "support/files.h"

namespace rays {
namespace {

// Keys stay in this order, so that the file reads well and differences are small.
using Json = nlohmann::ordered_json;

constexpr int kVersion = 1;

Json to_json(const ManifestEntry& entry) {
    return {{"scene", entry.scene},
            {"reference", entry.reference},
            {"width", entry.raster.width},
            {"height", entry.raster.height},
            {"method", entry.method},
            {"frames", entry.frames},
            {"standard_error", entry.standard_error},
            {"command", entry.command},
            {"sha256", entry.sha256},
            {"includes", Json(entry.includes)},
            {"sha256_reference", entry.sha256_reference}};
}

ManifestEntry entry_from(const Json& json) {
    ManifestEntry entry;
    json.at("scene").get_to(entry.scene);
    json.at("reference").get_to(entry.reference);
    json.at("width").get_to(entry.raster.width);
    json.at("height").get_to(entry.raster.height);
    json.at("method").get_to(entry.method);
    json.at("frames").get_to(entry.frames);
    json.at("standard_error").get_to(entry.standard_error);
    json.at("command").get_to(entry.command);
    json.at("sha256").get_to(entry.sha256);
    json.at("includes").get_to(entry.includes);
    json.at("sha256_reference").get_to(entry.sha256_reference);
    return entry;
}

}  // namespace

const ManifestEntry* Manifest::find(const std::string& scene) const {
    for (const ManifestEntry& entry : entries) {
        if (entry.scene == scene) return &entry;
    }
    return nullptr;
}

void Manifest::put(const ManifestEntry& entry) {
    const auto place =
        std::lower_bound(entries.begin(), entries.end(), entry.scene,
                         [](const ManifestEntry& e, const std::string& scene) { return e.scene < scene; });
    if (place != entries.end() && place->scene == entry.scene) {
        *place = entry;
    } else {
        entries.insert(place, entry);
    }
}

Manifest load_manifest(const std::filesystem::path& file) {
    const std::string text = read_file(file);
    try {
        const Json json = Json::parse(text);
        if (json.at("version") != kVersion) {
            throw InputError(fmt::format("{}: version {}, this program reads {}", file.string(),
                                         json.at("version").dump(), kVersion));
        }
        Manifest manifest;
        json.at("povray").get_to(manifest.povray);
        for (const Json& entry : json.at("entries")) manifest.put(entry_from(entry));
        return manifest;
    } catch (const nlohmann::json::exception& problem) {
        throw InputError(fmt::format("{}: {}", file.string(), problem.what()));
    }
}

void save_manifest(const Manifest& manifest, const std::filesystem::path& file) {
    Json entries = Json::array();
    for (const ManifestEntry& entry : manifest.entries) entries.push_back(to_json(entry));
    const Json json{{"version", kVersion}, {"povray", manifest.povray}, {"entries", entries}};
    write_atomically(file, json.dump(1, ' ') + "\n");
}

}  // namespace rays
