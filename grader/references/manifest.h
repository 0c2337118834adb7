// scenes/references/manifest.json: how each reference was made, and from what.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/camera.h"

namespace rays {

struct ManifestEntry {
    std::string scene;      ///< relative to scenes/, e.g. "1_ray_casting/one_sphere.pov"
    std::string reference;  ///< relative to scenes/references/
    Raster raster{160, 120};
    std::string method = "one frame";  ///< or "mean of 512 frames"
    int frames = 1;
    double standard_error = 0;  ///< of a mean: root mean square over the picture; else 0
    std::string command;        ///< as a person would type it in the scene's folder; of a mean: its first frame
    std::string sha256;         ///< of the scene
    std::map<std::string, std::string> includes;  ///< name as written -> SHA-256
    std::string sha256_reference;

    /// The reference is a mean (load_averaged_reference), not a frame (load_reference).
    bool averaged() const { return method.starts_with("mean of "); }
};

struct Manifest {
    std::string povray;
    std::vector<ManifestEntry> entries;  ///< sorted by scene

    const ManifestEntry* find(const std::string& scene) const;
    /// Replaces the entry of the same scene, or inserts it.
    void put(const ManifestEntry& entry);
};

/// Throws InputError when it is missing or malformed: with the place.
Manifest load_manifest(const std::filesystem::path& file);
void save_manifest(const Manifest& manifest, const std::filesystem::path& file);

}  // namespace rays
