// report.md: prose, and commands that say how each picture is rendered. Commands are read, never run by a shell.
#pragma once

#include <string>
#include <vector>

#include "core/camera.h"

namespace rays::grader {

/// A line of a code block that begins with `./rays render` or `rays render`.
struct RenderCommand {
    int line = 0;         ///< in report.md, from 1
    std::string text;     ///< as it stands there
    std::string problem;  ///< why it is refused; then the rest is worthless
    std::string scene, output;
    Raster raster;
    std::vector<std::string> options;  ///< what changes the picture besides its size: "--without", "phong", ...
};

struct ReportText {
    std::vector<RenderCommand> commands;
    std::string prose;               ///< without code blocks
    std::vector<int> to_be_written;  ///< lines that still hold the template's "(to be written"
};

inline constexpr std::size_t kLargestReport = 200 * 1024;
inline constexpr std::size_t kMostCommands = 48;
inline constexpr const char* kToBeWritten = "(to be written";

ReportText read_report(const std::string& markdown);

/// One command. Known are scene, -o, --width, --height, --threads, --partition, --from student, --without,
/// --max-trace-level and --samples 1; anything else, and any character that means something to a shell, is refused.
RenderCommand parse_command(const std::string& line);

}  // namespace rays::grader
