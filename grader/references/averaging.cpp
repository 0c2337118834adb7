#include "references/averaging.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <mutex>

#include "references/in_parallel.h"

namespace rays {
namespace {

/// Renders frames [begin, end) of `how.frames`.
FrameSums sums_of_frames(const Averaging& how, const std::filesystem::path& scene, int begin, int end) {
    FrameSums sums(how.raster);
    std::mutex mutex;
    int failed = end;  // the first frame that did
    std::string problem;
    in_parallel(static_cast<std::size_t>(end - begin), how.jobs, [&](std::size_t i) {
        const int frame = begin + static_cast<int>(i);
        {
            const std::lock_guard lock(mutex);
            if (failed < frame) return;  // frames before the first failure go on, so that it is always the same one
        }
        try {
            const PovrayFrame done =
                how.povray->frame(scene, how.raster, how.seconds, frame_declarations(frame, how.frames));
            refuse_warnings(scene, done.warnings);
            const std::lock_guard lock(mutex);
            sums.add(frame / (how.frames / kReplicates), done.image);
        } catch (const std::exception& e) {
            const std::lock_guard lock(mutex);
            if (frame < failed) {
                failed = frame;
                problem = e.what();
            }
        }
    });
    if (failed < end) throw PovrayError(fmt::format("frame {} of {}: {}", failed, how.frames, problem));
    return sums;
}

}  // namespace

AveragedReference average_of_frames(const Averaging& how, const std::filesystem::path& scene) {
    return sums_of_frames(how, scene, 0, how.frames).result();
}

std::vector<double> average_of_replicate(const Averaging& how, const std::filesystem::path& scene, int replicate) {
    const int each = how.frames / kReplicates;
    return sums_of_frames(how, scene, replicate * each, (replicate + 1) * each).replicate_mean(replicate);
}

void refuse_warnings(const std::filesystem::path& scene, std::vector<std::string> warnings) {
    std::erase_if(warnings, [](const std::string& warning) {
        return warning.find("Camera vectors are not perpendicular") != std::string::npos;
    });
    if (warnings.empty()) return;
    throw PovrayError(fmt::format("{}: POV-Ray warns:\n    {}", scene.string(), fmt::join(warnings, "\n    ")));
}

}  // namespace rays
