#include "references/process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <thread>

#include "core/error.h"

namespace rays {
namespace {

using Clock = std::chrono::steady_clock;

std::vector<char*> pointers(std::vector<std::string>& strings) {
    std::vector<char*> result;
    for (std::string& s : strings) result.push_back(s.data());
    result.push_back(nullptr);
    return result;
}

std::vector<std::string> environment_of(const ProcessOrder& order) {
    std::vector<std::string> result;
    for (char** entry = environ; *entry != nullptr; ++entry) {
        const std::string_view text(*entry);
        bool replaced = false;
        for (const auto& [name, value] : order.environment) replaced |= text.starts_with(name + "=");
        if (!replaced) result.emplace_back(text);
    }
    for (const auto& [name, value] : order.environment) result.push_back(name + "=" + value);
    return result;
}

pid_t start(const ProcessOrder& order) {
    std::vector<std::string> arguments{order.program.string()};
    arguments.insert(arguments.end(), order.arguments.begin(), order.arguments.end());
    std::vector<std::string> environment = environment_of(order);

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, order.input.c_str(), O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, order.output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    if (!order.folder.empty()) posix_spawn_file_actions_addchdir_np(&actions, order.folder.c_str());
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);  // a group of its own, to be killed as one
    posix_spawnattr_setpgroup(&attributes, 0);

    pid_t pid = 0;
    const int failure = posix_spawn(&pid, order.program.c_str(), &actions, &attributes, pointers(arguments).data(),
                                    pointers(environment).data());
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    if (failure != 0) {
        throw InputError(fmt::format("{}: cannot be started: {}", order.program.string(), std::strerror(failure)));
    }
    return pid;
}

}  // namespace

std::string ProcessEnd::describe(const ProcessOrder& order) const {
    if (timed_out) return fmt::format("killed after {} s", order.seconds);
    if (signal != 0) return fmt::format("ended by signal {} ({})", signal, strsignal(signal));
    return fmt::format("exit status {}", status);
}

ProcessEnd run_process(const ProcessOrder& order) {
    const auto deadline = Clock::now() + std::chrono::duration<double>(order.seconds);
    const pid_t pid = start(order);
    ProcessEnd end;
    int state = 0;
    while (waitpid(pid, &state, WNOHANG) == 0) {
        if (!end.timed_out && Clock::now() > deadline) {
            end.timed_out = true;
            kill(-pid, SIGKILL);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    if (WIFEXITED(state)) end.status = WEXITSTATUS(state);
    if (WIFSIGNALED(state)) end.signal = WTERMSIG(state);
    return end;
}

std::filesystem::path find_program(const std::string& name) {
    const char* path = std::getenv("PATH");
    std::string_view rest(path == nullptr ? "" : path);
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(':'), rest.size());
        const std::filesystem::path candidate = std::filesystem::path(rest.substr(0, end)) / name;
        if (end > 0 && access(candidate.c_str(), X_OK) == 0 && !std::filesystem::is_directory(candidate))
            return candidate;
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return {};
}

}  // namespace rays
