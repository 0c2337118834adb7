// The references of a folder of scenes: made, verified by fingerprints, checked by rendering anew.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "references/manifest.h"
#include "references/povray.h"
#include "references/reference.h"

namespace rays {

/// scenes/ and, in it, references/ with the manifest.
struct ReferenceFolders {
    std::filesystem::path scenes = "scenes";
    std::filesystem::path references() const { return scenes / "references"; }
    std::filesystem::path manifest() const { return references() / "manifest.json"; }
};

/// Renders the scene's frame and its fine frame and writes the reference. Throws PovrayError, InputError.
ManifestEntry make_reference_of(const ReferenceFolders& folders, const std::string& scene, Raster raster,
                                const Povray& povray, double seconds);

/// What does not match any more, in words; empty when all does: the scene, its includes, the reference, the manifest.
std::vector<std::string> stale_fingerprints(const ReferenceFolders& folders, const ManifestEntry& entry,
                                            const std::filesystem::path& povray_includes);

/// What differs when the frame is rendered today, in words, or an empty text when every pixel is the same, bit by bit.
std::string difference_today(const ReferenceFolders& folders, const ManifestEntry& entry, const Povray& povray,
                             double seconds);

}  // namespace rays
