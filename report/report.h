// The report page: results.json and its pictures become one HTML file that needs nothing else.
#pragma once

#include <filesystem>

namespace rays {

/// Reads results.json (schema raysteps-results/1) and the EXR pictures it names, relative to its folder, and writes one
/// self-contained page. The page appears whole or not at all and stays under 3 MB: long texts are cut and pixel values
/// lose precision or, at the very end, are left out (the page says so). A picture that is missing, broken or absurdly
/// large becomes a note in the page. What ./rays chart measured, in a charts.json beside results.json, becomes the
/// section "Speed against accuracy"; without results.json it is the whole page. Throws InputError when results.json
/// cannot be read, the JavaScript packages are not installed, or the page cannot be written.
void write_report(const std::filesystem::path& results_json, const std::filesystem::path& html);

}  // namespace rays
