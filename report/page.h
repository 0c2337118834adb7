// The page as one text: template, styles, libraries and scripts inlined, and a policy that allows exactly these.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pictures.h"

namespace rays::report {

/// The parts of every page, read from this folder of the sources and from the npm packages below it.
struct PageParts {
    std::string html;  ///< with {{csp}} {{styles}} {{notices}} {{heroes}} {{results}} {{pixels}} {{scripts}}
    std::vector<std::string> styles;   ///< each becomes one style element
    std::vector<std::string> scripts;  ///< each becomes one script element
    std::vector<std::string> modules;  ///< the same, run after all of those; modules may wait for something
    std::string notices;               ///< licences of the libraries
    std::string heroes;  ///< an img element for each step's picture of the gallery; for the solutions' page
};

/// Throws InputError saying what to run when the npm packages are missing.
PageParts read_parts(const std::filesystem::path& report_folder);

/// results: JSON, which enters the page deflated.
std::string assemble(const PageParts& parts, const std::string& results, const std::vector<PictureStore::Blob>& blobs);

}  // namespace rays::report
