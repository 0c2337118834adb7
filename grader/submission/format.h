// submission.json: which pictures are handed in, of which scenes, and what each shows (submission.schema.json).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/camera.h"

namespace rays::grader {

struct SubmittedPicture {
    std::string file;                ///< in the submission: "pictures/mirrors.png", .png or .exr
    std::string scene;               ///< "scenes/..." of the course, or a .pov file in the submission
    Raster raster;                   ///< in pixels
    std::vector<std::string> shows;  ///< features, see features.h
};

/// What cannot be read is left out and told.
struct Submission {
    bool present = false;  ///< there is a file submission.json, good or not
    std::vector<SubmittedPicture> pictures;
    std::vector<std::string> problems;  ///< for the student, one sentence each
};

inline constexpr const char* kSubmissionFile = "submission.json";
inline constexpr const char* kReportFile = "report.md";

// Generous for a hand-in, small enough that all of it is rendered in minutes.
inline constexpr std::size_t kMostPictures = 24;
inline constexpr std::size_t kMostFeatures = 24;
inline constexpr int kLargestSide = 2048;
inline constexpr int kMostPixels = 1 << 20;

/// Reads submission.json of the folder. Never throws for what stands in it.
Submission read_submission(const std::filesystem::path& folder);

/// The same of the text itself.
Submission parse_submission(const std::string& text);

/// A scene as people write it ("./scenes/x.pov", "submission/my.pov"), without what only says where one stands.
std::string plain_scene_name(std::string name);

}  // namespace rays::grader
