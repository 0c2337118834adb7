// Reading an averaged reference: the one place that knows how its file looks.
#pragma once

#include <filesystem>

#include "grader/statistics.h"

namespace rays::grader {

/// One OpenEXR file with the channels R G B (the mean) and error.R error.G error.B (its standard error). Throws
/// InputError when it is none, or when its numbers are not finite.
AveragedTruth load_averaged_truth(const std::filesystem::path& file);

}  // namespace rays::grader
