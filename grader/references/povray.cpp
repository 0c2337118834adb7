#include "references/povray.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "core/error.h"
#include "support/files.h"
#include "support/process.h"

namespace rays {
namespace fs = std::filesystem;

namespace {

// -D no window, -V no progress, -GS -GR -GD no statistics, settings and debug text (fatal errors and warnings stay);
// +WT1 one thread, so that nothing depends on their order; -A one sample a pixel, -J without jitter; +FE OpenEXR.
const std::vector<std::string> kOptions{"-D", "-V", "-GS", "-GR", "-GD", "+WT1", "-A", "-J", "+FE"};

/// A home folder with an empty povray.ini, so that no option of the user's changes a picture, and a povray.conf that
/// permits what a run needs, whatever the user's and the system's say (a user's list of paths replaces the system's).
/// It is no fence: version 3.7.0.10 reads this file but on Unix never asks it; see included_files().
void make_home(const fs::path& home, const std::vector<fs::path>& readable, const fs::path& writable) {
    const fs::path folder = home / ".povray" / "3.7";
    fs::create_directories(folder);
    std::string text = "[File I/O Security]\nrestricted\n[Shellout Security]\nforbidden\n[Permitted Paths]\n";
    for (const fs::path& path : readable) text += fmt::format("read* = \"{}\"\n", fs::absolute(path).string());
    text += fmt::format("read+write* = \"{}\"\n", writable.string());
    write_atomically(folder / "povray.conf", text);
    // Read instead of the user's; an empty one avoids a message.
    write_atomically(folder / "povray.ini", std::string_view(""));
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> result;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) result.push_back(line);
    return result;
}

/// The messages in POV-Ray's output: lines with "Warning" or "rror", and the lines that continue them. The console
/// wraps at 80 columns and begins what goes on with a blank.
std::vector<std::string> messages(const std::string& output) {
    std::vector<std::string> result;
    bool inside = false;
    for (const std::string& line : lines_of(output)) {
        const bool begins = line.find("Warning") != std::string::npos || line.find("rror") != std::string::npos ||
                            line.find("not permitted") != std::string::npos;
        const bool goes_on = inside && line.starts_with(' ');
        if (goes_on) {
            result.back() += line;
        } else if (begins) {
            result.push_back(line);
        }
        inside = begins || goes_on;
    }
    return result;
}

[[noreturn]] void fail(const std::string& what, const std::string& reason, const std::string& output) {
    std::string text = fmt::format("{}: POV-Ray failed: {}", what, reason);
    std::vector<std::string> said = messages(output);
    if (said.empty()) said = lines_of(output);
    for (std::size_t i = said.size() > 12 ? said.size() - 12 : 0; i < said.size(); ++i) text += "\n    " + said[i];
    throw PovrayError(text);
}

/// Runs POV-Ray and returns what it said.
std::string run(const fs::path& program, const std::vector<std::string>& arguments, const fs::path& folder,
                const fs::path& home, double seconds, const std::string& what) {
    Command command{{program.string()}, {}, folder, only_time(seconds), true, {{"HOME", home.string()}}};
    command.argv.insert(command.argv.end(), arguments.begin(), arguments.end());
    const Ended ended = run_command(command);
    if (!ended.started) throw InputError(ended.problem);
    const std::string output = ended.out + ended.err;
    if (!ended.ok()) fail(what, "it " + how_it_ended(ended), output);
    return output;
}

std::string ask_version(const fs::path& program) {
    const TemporaryFolder temporary;
    make_home(temporary.path(), {}, temporary.path());
    const std::string output = run(program, {"--version"}, {}, temporary.path(), 30, "povray --version");
    for (const std::string& line : lines_of(output)) {
        constexpr std::string_view mark = "POV-Ray ";
        if (line.starts_with(mark)) return line.substr(mark.size());
    }
    throw PovrayError("povray --version: says no version");
}

}  // namespace

fs::path find_povray_includes() {
    std::vector<fs::path> prefixes{"/usr", "/usr/local"};
    const fs::path program = find_program("povray");
    if (!program.empty()) prefixes.insert(prefixes.begin(), fs::canonical(program).parent_path().parent_path());
    for (const fs::path& prefix : prefixes) {
        if (fs::is_directory(prefix / "share/povray-3.7/include")) return prefix / "share/povray-3.7/include";
    }
    return {};
}

Povray::Povray() : program_(find_program("povray")) {
    if (program_.empty()) {
        throw InputError("POV-Ray is not installed: apt-get install povray povray-includes");
    }
    include_folder_ = find_povray_includes();
    version_ = ask_version(program_);
}

std::vector<std::string> Povray::frame_options(const std::string& scene, Raster raster, const std::string& output,
                                               const std::vector<std::string>& declared) {
    std::vector<std::string> result{"+I" + scene, "+O" + output, fmt::format("+W{}", raster.width),
                                    fmt::format("+H{}", raster.height)};
    result.insert(result.end(), kOptions.begin(), kOptions.end());
    result.insert(result.end(), declared.begin(), declared.end());
    return result;
}

PovrayFrame Povray::frame(const fs::path& scene, Raster raster, double seconds,
                          const std::vector<std::string>& declared) const {
    const TemporaryFolder temporary;
    const fs::path folder = fs::absolute(scene).parent_path();
    std::vector<fs::path> readable{folder};
    if (!include_folder_.empty()) readable.push_back(include_folder_);
    make_home(temporary.path(), readable, temporary.path());

    const fs::path output = temporary.path() / "frame.exr";
    std::vector<std::string> options = frame_options(scene.filename().string(), raster, output.string(), declared);
    if (!include_folder_.empty()) options.push_back("+L" + include_folder_.string());
    const std::string said = run(program_, options, folder, temporary.path(), seconds, scene.string());
    if (!fs::exists(output)) fail(scene.string(), "no picture was written", said);

    PovrayFrame result{load_rgb_exr(output), messages(said)};
    if (result.image.raster.width != raster.width || result.image.raster.height != raster.height) {
        fail(scene.string(), "the picture has another size than asked for", said);
    }
    return result;
}

std::string Povray::answers(const std::string& sdl, double seconds) const {
    const TemporaryFolder temporary;
    make_home(temporary.path(), {}, temporary.path());
    write_atomically(temporary.path() / "questions.pov", sdl);
    std::vector<std::string> options = frame_options("questions.pov", {1, 1}, "frame.exr");
    const std::string said =
        run(program_, options, temporary.path(), temporary.path(), seconds, "questions to trace()");
    const fs::path file = temporary.path() / "answers";
    if (!fs::exists(file)) fail("questions to trace()", "no answers were written", said);
    return read_file(file);
}

}  // namespace rays
