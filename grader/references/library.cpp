#include "references/library.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstring>

#include "core/error.h"
#include "references/scene_files.h"
#include "support/files.h"
#include "support/sha256.h"

namespace rays {
namespace fs = std::filesystem;

namespace {

std::string reference_name(const std::string& scene) {
    return fs::path(scene).replace_extension(".exr").generic_string();
}

std::vector<fs::path> include_folders(const fs::path& povray_includes) {
    if (povray_includes.empty()) return {};
    return {povray_includes};
}

std::string command_of(const ManifestEntry& entry) {
    const std::string file = fs::path(entry.scene).filename().string();
    const std::vector<std::string> declared =
        entry.averaged() ? frame_declarations(0, entry.frames) : std::vector<std::string>{};
    const std::string command = fmt::format(
        "povray {}", fmt::join(Povray::frame_options(file, entry.raster, reference_name(file), declared), " "));
    if (!entry.averaged()) return command;
    return fmt::format("{}  # frame 0 of {}; Frame and Frame_u0 to Frame_u15 vary", command, entry.frames);
}

std::map<std::string, std::string> fingerprints_of_includes(const fs::path& scene, const fs::path& povray_includes) {
    std::map<std::string, std::string> result;
    for (const auto& [name, file] : included_files(scene, include_folders(povray_includes)))
        result[name] = sha256_of_file(file);
    return result;
}

/// What stands in the entry before anything is rendered: a scene that is edited meanwhile is then stale, not wrong in
/// silence.
ManifestEntry begun_entry(const ReferenceFolders& folders, const std::string& scene, Raster raster,
                          const Povray& povray) {
    ManifestEntry entry;
    entry.scene = scene;
    entry.reference = reference_name(scene);
    entry.raster = raster;
    entry.sha256 = sha256_of_file(folders.scenes / scene);
    entry.includes = fingerprints_of_includes(folders.scenes / scene, povray.include_folder());
    return entry;
}

}  // namespace

ManifestEntry make_reference_of(const ReferenceFolders& folders, const std::string& scene, Raster raster,
                                const Povray& povray, double seconds) {
    const fs::path file = folders.scenes / scene;
    ManifestEntry entry = begun_entry(folders, scene, raster, povray);
    entry.command = command_of(entry);
    PovrayFrame frame = povray.frame(file, raster, seconds);
    const PovrayFrame fine = povray.frame(file, {4 * raster.width, 4 * raster.height}, seconds);
    refuse_warnings(file, frame.warnings);
    save_reference(make_reference(std::move(frame.image), fine.image), folders.references() / entry.reference);
    entry.sha256_reference = sha256_of_file(folders.references() / entry.reference);
    return entry;
}

bool is_averaged(const ReferenceFolders& folders, const std::string& scene, const Povray& povray) {
    return has_frames(folders.scenes / scene, include_folders(povray.include_folder()));
}

ManifestEntry make_averaged_reference_of(const ReferenceFolders& folders, const std::string& scene,
                                         const Averaging& how) {
    ManifestEntry entry = begun_entry(folders, scene, how.raster, *how.povray);
    entry.method = fmt::format("mean of {} frames", how.frames);
    entry.frames = how.frames;
    entry.command = command_of(entry);
    const AveragedReference reference = average_of_frames(how, folders.scenes / scene);
    entry.standard_error = rms_error(reference);
    save_averaged_reference(reference, folders.references() / entry.reference);
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
    if (entry.command != command_of(entry)) result.push_back("POV-Ray is called differently now");
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

std::string averaged_difference_today(const ReferenceFolders& folders, const ManifestEntry& entry, Averaging how,
                                      int replicate) {
    const AveragedReference committed = load_averaged_reference(folders.references() / entry.reference);
    how.raster = entry.raster;
    how.frames = entry.frames;
    return difference_of_replicate(committed, average_of_replicate(how, folders.scenes / entry.scene, replicate));
}

}  // namespace rays
