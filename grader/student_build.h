// The render programs of one submission.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "grader/build.h"
#include "grader/step_data.h"

namespace rays::grader {

struct StudentPrograms {
    std::map<int, std::filesystem::path> isolated;  ///< by step: this step the student's
    std::filesystem::path all_mine;                 ///< empty when a step does not compile
    std::map<int, std::string> build_errors;        ///< by step: the compiler's message
    std::string infrastructure_error;
};

/// Compiles the files of every step found in `submission` (N_name/x.cpp, or x.cpp on its own level; what is missing is
/// taken from the starters) and links one program for each step of `graded` and one of all. Objects and programs go to
/// `folder`, but for what is the solution's own: that stays where the build has it.
StudentPrograms build_student(const Builder& builder, const Project& project, const std::vector<Step>& steps,
                              const std::vector<Step>& graded, const std::filesystem::path& submission,
                              const std::filesystem::path& folder, int workers);

/// Where the submission has a file of the steps ("1_ray_casting/camera.cpp"); the starter's when it has none.
std::filesystem::path submitted_file(const Project& project, const std::filesystem::path& submission,
                                     const std::string& file);

}  // namespace rays::grader
