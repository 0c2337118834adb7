// The references of a folder of scenes: made, verified by fingerprints, checked by rendering anew.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "references/averaging.h"
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

/// Is the scene's reference the mean of many frames?
bool is_averaged(const ReferenceFolders& folders, const std::string& scene, const Povray& povray);

/// Renders the scene's many frames and writes their mean. Throws PovrayError, InputError.
ManifestEntry make_averaged_reference_of(const ReferenceFolders& folders, const std::string& scene,
                                         const Averaging& how);

/// What does not match any more, in words; empty when all does: the scene, its includes, the reference, the manifest.
std::vector<std::string> stale_fingerprints(const ReferenceFolders& folders, const ManifestEntry& entry,
                                            const std::filesystem::path& povray_includes);

/// What differs when the frame is rendered today, in words, or an empty text when every pixel is the same, bit by bit.
/// For what is no mean.
std::string difference_today(const ReferenceFolders& folders, const ManifestEntry& entry, const Povray& povray,
                             double seconds);

/// What differs when the frames of one replicate (0 to kReplicates - 1) are rendered today, in words, or an empty text
/// when none of its numbers is further from the mean than a replicate's can be (kFurthestReplicate). Size and number of
/// frames are the entry's.
std::string averaged_difference_today(const ReferenceFolders& folders, const ManifestEntry& entry, Averaging how,
                                      int replicate);

}  // namespace rays
