#include "references/library.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstring>

#include "core/error.h"
#include "support/files.h"
#include "references/scene_files.h"
#include "support/sha256.h"

namespace rays {
namespace fs = std::filesystem;

namespace {

std::string reference_name(const std::string& scene) {
    return fs::path(scene).replace_extension(".exr").generic_string();
}

std::string command_of(const std::string& scene, Raster raster) {
    const std::string file = fs::path(scene).filename().string();
    return fmt::format("povray {}", fmt::join(Povray::frame_options(file, raster, reference_name(file)), " "));
}

std::map<std::string, std::string> fingerprints_of_includes(const fs::path& scene, const fs::path& povray_includes) {
    std::map<std::string, std::string> result;
    std::vector<fs::path> folders;
    if (!povray_includes.empty()) folders.push_back(povray_includes);
    for (const auto& [name, file] : included_files(scene, folders)) result[name] = sha256_of_file(file);
    return result;
}

/// A reference must be beyond doubt. A sheared camera is meant, though, wherever there is one.
void refuse_warnings(const fs::path& scene, std::vector<std::string> warnings) {
    std::erase_if(warnings, [](const std::string& warning) {
        return warning.find("Camera vectors are not perpendicular") != std::string::npos;
    });
    if (warnings.empty()) return;
    throw PovrayError(fmt::format("{}: POV-Ray warns:\n    {}", scene.string(), fmt::join(warnings, "\n    ")));
}

}  // namespace

ManifestEntry make_reference_of(const ReferenceFolders& folders, const std::string& scene, Raster raster,
                                const Povray& povray, double seconds) {
    const fs::path file = folders.scenes / scene;
    ManifestEntry entry;
    entry.scene = scene;
    entry.reference = reference_name(scene);
    entry.raster = raster;
    entry.command = command_of(scene, raster);
    // Fingerprints first: a scene that is edited meanwhile is then stale, not wrong in silence.
    entry.sha256 = sha256_of_file(file);
    entry.includes = fingerprints_of_includes(file, povray.include_folder());

    PovrayFrame frame = povray.frame(file, raster, seconds);
    const PovrayFrame fine = povray.frame(file, {4 * raster.width, 4 * raster.height}, seconds);
    refuse_warnings(file, frame.warnings);
    save_reference(make_reference(std::move(frame.image), fine.image), folders.references() / entry.reference);
    entry.sha256_reference = sha256_of_file(folders.references() / entry.reference);
    return entry;
}

std::vector<std::string> stale_fingerprints(const ReferenceFolders& folders, const ManifestEntry& entry,
                                            const fs::path& povray_includes) {
    std::vector<std::string> result;
    const fs::path scene = folders.scenes / entry.scene;
    const fs::path reference = folders.references() / entry.reference;
    if (!fs::exists(scene)) return {"the scene is gone"};
    if (sha256_of_file(scene) != entry.sha256) result.push_back("the scene has changed");
    if (fingerprints_of_includes(scene, povray_includes) != entry.includes) {
        result.push_back("an included file has changed");
    }
    if (!fs::exists(reference)) {
        result.push_back("the reference is missing");
    } else if (sha256_of_file(reference) != entry.sha256_reference) {
        result.push_back("the reference has changed");
    }
    if (entry.command != command_of(entry.scene, entry.raster)) result.push_back("POV-Ray is called differently now");
    return result;
}

std::string difference_today(const ReferenceFolders& folders, const ManifestEntry& entry, const Povray& povray,
                             double seconds) {
    const Reference committed = load_reference(folders.references() / entry.reference);
    const RgbImage today = povray.frame(folders.scenes / entry.scene, entry.raster, seconds).image;
    const Raster raster = committed.raster();
    if (raster.width != today.raster.width || raster.height != today.raster.height) {
        return fmt::format("the size is {} x {}, today {} x {}", raster.width, raster.height, today.raster.width,
                           today.raster.height);
    }
    int count = 0;
    std::string first;
    for (int y = 0; y < raster.height; ++y) {
        for (int x = 0; x < raster.width; ++x) {
            const Rgb& then = committed.frame.at(x, y);
            const Rgb& now = today.at(x, y);
            if (std::memcmp(&then, &now, sizeof(Rgb)) == 0) continue;
            if (count++ == 0) first = fmt::format("pixel {},{} was {}, is {}", x, y, then, now);
        }
    }
    return count == 0 ? "" : fmt::format("{} of {} pixels differ; {}", count, today.pixels.size(), first);
}

}  // namespace rays
