// The demonstration check: a picture counts when it can be rendered again and shows what is claimed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/project.h"
#include "grader/results.h"
#include "grader/sandbox.h"
#include "grader/shoot.h"
#include "grader/submission/features.h"
#include "grader/submission/format.h"

namespace rays::grader {

/// What the checks of a hand-in share.
struct HandInBench {
    const Project& project;
    const Sandbox& sandbox;
    std::filesystem::path solution;  ///< render program of the solutions
    std::filesystem::path student;   ///< all steps the student's; empty: they do not build
    std::filesystem::path folder;    ///< with submission.json
    std::filesystem::path out;       ///< folder of results.json; empty: no pictures are kept
    Limits limits;
    int workers = 1;
};

/// The scene of a picture or of a command, as files. Throws InputError in words for the student.
SceneFiles submitted_scene(const HandInBench& bench, const std::string& scene);

struct Demonstration {
    SubmittedPicture picture;
    Check check;                ///< kind "demonstration", without points; its questions are the proofs
    bool reproduced = false;    ///< the submitted file is what the student's program renders
    bool counts = false;        ///< reproduced, and the solution renders the same
    std::vector<Proof> proofs;  ///< of the features; shown only if `counts`
};

/// `number` tells pictures with like names apart.
Demonstration demonstrate(const HandInBench& bench, const SubmittedPicture& picture, std::size_t number);

inline constexpr std::size_t kLargestPicture = 32u << 20;  ///< bytes of a handed-in picture

}  // namespace rays::grader
