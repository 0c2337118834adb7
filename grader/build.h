// From a student's files to a render program: the project's own flags, no build files of the student's.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "grader/project.h"
#include "support/process.h"

namespace rays::grader {

struct Built {
    bool good = false;
    bool infrastructure = false;  ///< the compiler could not be run or the build is broken: nobody's build error
    std::filesystem::path file;   ///< the object or the program
    std::string message;          ///< the compiler's, made plain
};

/// Compiles files of a step as the project's build does, but without link-time optimisation, and links them in the
/// place of the solution's objects. Uses the objects and archives of the build, which must be up to date.
class Builder {
public:
    /// Reads the build's compile and link commands. Throws InputError when they are not as expected.
    explicit Builder(const Project& project);

    /// The files of a step, relative to steps/ (and to solutions/): "1_ray_casting/camera.cpp".
    std::vector<std::string> files_of(int step) const;

    /// The build's object of the solution's file, which `link` takes where it is given no other.
    std::filesystem::path solution_object(const std::string& file) const { return units_.at(file).solution_object; }

    /// A text that changes with the command that compiles `file`, and whenever the build compiles the solution's file
    /// again, be it for another compiler or another library.
    std::string state(const std::string& file) const;

    /// `file` says whose flags are used. The compiler's messages name the source as "steps/<file>".
    Built compile(const std::string& file, const std::filesystem::path& source, const std::filesystem::path& object,
                  const std::string& optimisation) const;

    /// A render program of the solution's objects, but for those given here by their file.
    Built link(const std::map<std::string, std::filesystem::path>& objects, const std::filesystem::path& program) const;

private:
    struct Unit {
        int step = 0;
        std::vector<std::string> compile;  ///< without -c, -o and the source
        std::string solution_object;       ///< as on the link line
    };
    void read_compile_commands();
    void read_link_command();

    Project project_;
    std::map<std::string, Unit> units_;
    std::vector<std::string> link_;  ///< of render-solution, without -o and without link-time optimisation
};

}  // namespace rays::grader
