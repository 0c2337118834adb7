// The oracle: POV-Ray as a process.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/camera.h"
#include "references/reference.h"

namespace rays {

/// What went wrong, with POV-Ray's own words: for a person. Not bad use of our program but a failed check.
class PovrayError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

struct PovrayFrame {
    RgbImage image;
    std::vector<std::string> warnings;  ///< POV-Ray's, one each
};

/// Where POV-Ray's include files are, or an empty path; the program itself need not be installed.
std::filesystem::path find_povray_includes();

class Povray {
public:
    /// Looks along PATH. Throws InputError that names the package when POV-Ray is not installed.
    Povray();

    /// As it says itself, e.g. "3.7.0.10.unofficial".
    const std::string& version() const { return version_; }

    /// As find_povray_includes().
    const std::filesystem::path& include_folder() const { return include_folder_; }

    /// The options of a frame that is one deterministic sample a pixel, in linear half floats: for the manifest, with
    /// names relative to the scene's folder. A person in that folder can type it.
    /// `declared` are further options that declare the scene's variables.
    static std::vector<std::string> frame_options(const std::string& scene, Raster raster, const std::string& output,
                                                  const std::vector<std::string>& declared = {});

    /// Renders one frame, whatever povray.conf and povray.ini of the user say. Throws PovrayError.
    PovrayFrame frame(const std::filesystem::path& scene, Raster raster, double seconds,
                      const std::vector<std::string>& declared = {}) const;

    /// Only parses and runs the scene's language, and returns what it wrote to the file "answers" of its working
    /// folder: for scenes that ask trace(). Throws PovrayError.
    std::string answers(const std::string& sdl, double seconds) const;

private:
    std::filesystem::path program_;
    std::filesystem::path include_folder_;
    std::string version_;
};

}  // namespace rays
