#include "renderers.h"

#include <fmt/format.h>

#include <regex>
#include <stdexcept>

#include "references/povray.h"
#include "support/files.h"

namespace rays::bench {
namespace {

namespace fs = std::filesystem;

constexpr double kLongest_s = 1200;  ///< of one run: slower than this nothing can be charted

}  // namespace

Command trusted(std::vector<std::string> argv, const fs::path& folder) {
    Command command;
    command.argv = std::move(argv);
    command.folder = folder;
    command.limits = only_time(kLongest_s);
    return command;
}

Command raysteps_command(const fs::path& program, const Picture& picture, const fs::path& folder,
                         const std::string& output, const std::vector<std::string>& more) {
    Command command = trusted(
        {fs::absolute(program).string(), picture.scene.string(), "-o", output, "--width",
         std::to_string(picture.raster.width), "--height", std::to_string(picture.raster.height), "--threads", "1"},
        folder);
    command.argv.insert(command.argv.end(), more.begin(), more.end());
    return command;
}

Command povray_command(const Picture& picture, const fs::path& folder, const std::string& output,
                       const std::vector<std::string>& more) {
    const fs::path program = find_program("povray");
    if (program.empty()) throw std::runtime_error("POV-Ray is not installed: apt-get install povray povray-includes");
    Command command = trusted({program.string()}, folder);
    for (const auto& option : Povray::frame_options(picture.scene.string(), picture.raster, output))
        command.argv.push_back(option);
    for (const fs::path& library : {picture.scene.parent_path(), find_povray_includes()})
        command.argv.push_back("+L" + library.string());
    command.argv.insert(command.argv.end(), more.begin(), more.end());
    return command;
}

fs::path with_settings(const fs::path& scene, const std::string& global_settings, const fs::path& folder,
                       const std::string& name) {
    const fs::path file = folder / (name + ".pov");
    write_atomically(file, read_file(scene) + fmt::format("\nglobal_settings {{ {} }}\n", global_settings));
    return file;
}

double povray_rays(const std::string& statistics) {
    static const std::regex line(R"((^|\n)Rays: +([0-9]+))");
    std::smatch found;
    if (!std::regex_search(statistics, found, line)) throw std::runtime_error("POV-Ray's statistics name no rays");
    return std::stod(found[2]);
}

RgbImage averaged(const RgbImage& fine, int side) {
    const auto [width, height] = fine.raster;
    if (side < 1 || width % side != 0 || height % side != 0)
        throw std::invalid_argument("blocks do not fit into the picture");
    RgbImage result{{width / side, height / side}, {}};
    for (int y = 0; y < height / side; ++y) {
        for (int x = 0; x < width / side; ++x) {
            double sums[3] = {};
            for (int i = 0; i < side * side; ++i)
                for (std::size_t lane = 0; lane < 3; ++lane)
                    sums[lane] += fine.at(x * side + i % side, y * side + i / side)[lane];
            Rgb mean;
            for (std::size_t lane = 0; lane < 3; ++lane) mean[lane] = static_cast<float>(sums[lane] / (side * side));
            result.pixels.push_back(mean);
        }
    }
    return result;
}

}  // namespace rays::bench
