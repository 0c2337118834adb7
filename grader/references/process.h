// Another program, waited for with a time limit.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace rays {

struct ProcessOrder {
    std::filesystem::path program;
    std::vector<std::string> arguments;
    std::filesystem::path folder;                                  ///< the working folder; empty: this process's
    std::vector<std::pair<std::string, std::string>> environment;  ///< set in addition to this process's
    std::filesystem::path input = "/dev/null";                     ///< its standard input
    std::filesystem::path output;                                  ///< receives standard output and standard error
    double seconds = 60;                                           ///< wall time, after which it is killed
};

struct ProcessEnd {
    int status = -1;  ///< exit status, or -1 when a signal ended it
    int signal = 0;
    bool timed_out = false;
    bool good() const { return status == 0; }
    /// In words, e.g. "exit status 1", "killed after 60 s".
    std::string describe(const ProcessOrder& order) const;
};

/// Runs it to its end; when its time is up, its children are killed with it. Throws InputError when it cannot be
/// started.
ProcessEnd run_process(const ProcessOrder& order);

/// The program's full path along PATH, or an empty path.
std::filesystem::path find_program(const std::string& name);

}  // namespace rays
