// The seam between the grader and the way in which a student's program is confined.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "support/process.h"

namespace rays::grader {

struct InputFile {
    std::string name;  ///< relative, without ".."
    std::string bytes;
};

/// One run of a student's program. It sees a working directory of its own with `files` in it and nothing else.
struct Job {
    std::filesystem::path program;
    std::vector<std::string> arguments;
    std::string input;
    std::vector<InputFile> files;
    std::vector<std::string> outputs;  ///< names of the files to take back
    Limits limits;
};

/// A file that came back: bytes, or why there are none ("was not written", "is not a regular file", ...).
struct OutputFile {
    bool taken = false;
    std::string bytes;
    std::string problem;
};

struct JobResult {
    Ended ended;
    std::map<std::string, OutputFile> files;  ///< one for each of Job::outputs
};

class Sandbox {
public:
    virtual ~Sandbox() = default;
    virtual std::string tier() const = 0;
    virtual JobResult run(const Job& job) const = 0;
};

/// Tier "limits": a process in its own session and directory, with resource limits, a clean environment and no open
/// files but the three standard ones; killed with all of its descendants. Output files are opened without following
/// links and without waiting, must be regular, of one name only, and within the size limit. What this tier does NOT
/// do: a program that knows an absolute path can read what the user can read, it can use the network, and as root the
/// limit on processes does not bind. The namespaces tier closes that.
std::unique_ptr<Sandbox> make_sandbox();

}  // namespace rays::grader
