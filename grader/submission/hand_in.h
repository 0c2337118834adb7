// `rays submission`: from the working copy to a file that can be handed in.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/project.h"
#include "grader/results.h"

namespace rays::grader {

struct WorkingCopy {
    std::filesystem::path steps;       ///< with N_name/x.cpp
    std::filesystem::path submission;  ///< submission.json, report.md, pictures, the student's own scenes
    std::filesystem::path program;     ///< render program of the student's steps
};

WorkingCopy working_copy(const Project& project);

struct HandInResult {
    std::vector<std::string> made;    ///< templates that were written since there was nothing: to be edited
    std::vector<std::string> failed;  ///< pictures that could not be rendered, and why
    HandedIn checked;                 ///< as the grader will see it
    std::vector<std::string> packed;
};

/// Writes what is missing of submission.json and report.md from templates, renders every listed picture with the
/// student's program (what was there is replaced), checks all of it as the grader will, and packs: as .tar.gz when
/// `out` ends so, else into the folder `out`, which must be new, empty, or an earlier hand-in. Throws InputError.
HandInResult hand_in(const Project& project, const WorkingCopy& copy, const std::filesystem::path& out);

/// What was made and what is missing, for a terminal.
std::string hand_in_text(const HandInResult& result, const std::filesystem::path& out);

/// Has everything passed?
bool is_complete(const HandInResult& result);

}  // namespace rays::grader
