#include "grader/shoot.h"

#include <fmt/format.h>

#include "references/scene_files.h"
#include "support/files.h"

namespace rays::grader {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPicture = "picture.exr";
constexpr const char* kStats = "stats.json";

}  // namespace

Job render_job(const fs::path& program, const SceneFiles& files, Raster raster, const Limits& limits) {
    Job job;
    job.program = program;
    job.files = files;
    job.limits = limits;
    // One thread: several checks run side by side, and arenas and stacks of many threads would count as memory.
    job.arguments = {
        files.front().name, "--width", std::to_string(raster.width), "--height", std::to_string(raster.height),
        "--threads",        "1"};
    return job;
}

SceneFiles scene_files(const fs::path& scene) {
    SceneFiles files{{scene.filename().string(), read_file(scene)}};
    const fs::path povray = "/usr/share/povray-3.7/include";
    for (const auto& [name, file] : included_files(fs::absolute(scene), {povray}))
        if (file.lexically_relative(povray).string().starts_with("..")) files.push_back({name, read_file(file)});
    return files;
}

Shot shoot(const Sandbox& sandbox, const fs::path& program, const SceneFiles& files, Raster raster,
           const Limits& limits, const std::vector<std::string>& options) {
    Job job = render_job(program, files, raster, limits);
    job.arguments.insert(job.arguments.end(), options.begin(), options.end());
    for (const char* argument : {"-o", kPicture, "--stats", kStats}) job.arguments.emplace_back(argument);
    job.outputs = {kPicture, kStats};
    JobResult result = sandbox.run(job);
    Shot shot;
    shot.seconds = result.ended.wall_s;
    shot.unfinished = unfinished_places(result.files[kStats].bytes);
    shot.against = against_run(result.ended);
    if (shot.against) return shot;
    OutputFile& file = result.files[kPicture];
    if (!file.taken) {
        shot.against = Finding{Verdict::fail, "the picture " + file.problem};
        return shot;
    }
    DecodedPicture decoded = decode_exr(file.bytes, raster.width, raster.height);
    if (!decoded.problem.empty()) shot.against = Finding{Verdict::fail, "the picture " + decoded.problem};
    shot.picture = std::move(decoded.picture);
    shot.exr = std::move(file.bytes);
    return shot;
}

std::string ray_tree(const Sandbox& sandbox, const fs::path& program, const SceneFiles& files, Raster raster, int x,
                     int y, bool json, const Limits& limits, const std::vector<std::string>& options) {
    Job job = render_job(program, files, raster, limits);
    job.arguments.insert(job.arguments.end(), options.begin(), options.end());
    job.arguments.push_back("--explain");
    job.arguments.push_back(fmt::format("{},{}", x, y));
    if (json) job.arguments.emplace_back("--json");
    const JobResult result = sandbox.run(job);
    return result.ended.ok() ? result.ended.out : std::string();
}

}  // namespace rays::grader
