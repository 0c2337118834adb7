// Objects of the course's own files, which most submissions hold some of: not compiled again for each of them.
#pragma once

#include <filesystem>
#include <string>

#include "grader/build.h"

namespace rays::grader {

/// Compiles submitted files, but for those whose text is the solution's or that of steps/.
class KeptObjects {
public:
    KeptObjects(const Builder& builder, const Project& project);

    /// What `builder.compile` (-O2) gives. A file with the solution's text has its object in the build. One with the
    /// text of steps/ is compiled once for each state of that text, the headers of steps/ and the build; `object`
    /// becomes a copy. Any other text is compiled and not kept, so at most one object a file of the steps is: no
    /// submission fills the folder. Only this process writes there, and never what is not whole.
    Built compile(const std::string& file, const std::filesystem::path& source,
                  const std::filesystem::path& object) const;

private:
    Built compile_starter(const std::string& file, const std::string& text, const std::filesystem::path& object) const;

    const Builder& builder_;
    const Project& project_;
    std::filesystem::path folder_;
    std::string headers_;  ///< digest of the headers of steps/
};

}  // namespace rays::grader
