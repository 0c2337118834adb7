// Running one command: bounded in time, memory and output, and gone with all of its children afterwards.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace rays {

/// 0 means: not limited.
struct Limits {
    double cpu_s = 20;     ///< processor seconds of one process (RLIMIT_CPU)
    double wall_s = 30;    ///< seconds on the clock, everything included
    int memory_mb = 2048;  ///< address space of one process (RLIMIT_AS)
    int processes = 64;    ///< RLIMIT_NPROC: counts all of the user's processes, and does not bind root
    int output_mb = 64;    ///< size of one file (RLIMIT_FSIZE), and of what is taken back
    int text_mb = 8;       ///< standard output and standard error, each; who writes more is killed
};

/// Nothing but the clock: for programs that are trusted.
inline Limits only_time(double seconds) { return {0, seconds, 0, 0, 0, 8}; }

struct Command {
    std::vector<std::string> argv;  ///< argv[0] is a path, or a name looked up in PATH
    std::string input;              ///< its standard input
    std::filesystem::path folder;   ///< its working directory; empty: this process's own
    Limits limits;
    bool own_environment = false;  ///< true: keeps this process's environment (compilers); false: a clean one
    std::vector<std::pair<std::string, std::string>> environment = {};  ///< set in addition, or instead
};

struct Ended {
    bool started = false;  ///< false: could not even be run; `problem` says why. Never the student's fault.
    std::string problem;
    int exit = -1;           ///< exit status, -1 when it ended by a signal
    int signal = 0;          ///< the signal that ended it, 0 for none
    bool timed_out = false;  ///< of the clock or of the processor
    bool flooded = false;    ///< killed for writing more text than text_mb
    std::string out, err;    ///< bounded, hostile
    double wall_s = 0, cpu_s = 0;

    bool ok() const { return started && exit == 0 && signal == 0 && !timed_out && !flooded; }
};

/// Runs the command in a session of its own and waits for it. Afterwards nothing that it started is alive: its process
/// group is killed, and so is every orphan that left the group (this process adopts them: PR_SET_CHILD_SUBREAPER).
/// May be called from several threads. Never throws for anything that the command does.
Ended run_command(const Command& command);

/// What did not go well, to stand behind a subject: "crashed: signal 11 (Segmentation fault)", "was stopped after 5.0 s
/// (4.9 s of processor time)", "ended with status 1". Empty when all did.
std::string how_it_ended(const Ended& ended);

/// The program's full path along PATH, or an empty path.
std::filesystem::path find_program(const std::string& name);

}  // namespace rays
