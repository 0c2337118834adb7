// From a POV-Ray scene file to a Scene.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/camera.h"
#include "core/error.h"
#include "core/scene.h"

namespace rays {

struct ReadOptions {
    Raster raster;                                         ///< image_width, image_height
    Real clock = 0;                                        ///< `clock`
    int frame_number = 0;                                  ///< `frame_number`
    std::vector<std::pair<std::string, double>> declared;  ///< as POV-Ray's Declare=name=value
    std::vector<std::filesystem::path> include_folders;    ///< searched after the scene's own; empty: POV-Ray's, if any
    std::function<void(const std::string&)> debug;         ///< gets what the scene says with #debug; empty: nobody
    bool tabulate = true;                                  ///< false: Time and Wavelength stay at their first value
};

/// Reads the file. Throws InputError "file:line:column: what; what next" for anything outside the documented subset
/// (scenes/README.md), within bounded time and memory whatever the input.
Scene read_scene(const std::filesystem::path& file, const ReadOptions& options = {});

/// The same from text; `name` stands in messages, includes are searched beside it.
Scene read_scene_text(std::string_view text, const std::string& name, const ReadOptions& options = {});

/// Where POV-Ray's own include files are installed, or an empty path.
std::filesystem::path povray_include_folder();

}  // namespace rays
