#include "support/process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <mutex>
#include <set>
#include <string_view>
#include <utility>

#ifndef CLOSE_RANGE_CLOEXEC
#define CLOSE_RANGE_CLOEXEC (1U << 2)
#endif

namespace rays {
namespace {

using Clock = std::chrono::steady_clock;

// Every process that this one started and still waits for. Other children are orphans that a command left behind.
std::mutex children_mutex;
std::set<pid_t> children;

class Descriptor {
public:
    explicit Descriptor(int fd = -1) : fd_(fd) {}
    Descriptor(Descriptor&& o) noexcept : fd_(std::exchange(o.fd_, -1)) {}
    Descriptor& operator=(Descriptor&& o) noexcept {
        std::swap(fd_, o.fd_);
        return *this;
    }
    ~Descriptor() { reset(); }
    void reset() {
        if (fd_ >= 0) ::close(fd_);
        fd_ = -1;
    }
    int get() const { return fd_; }
    bool open() const { return fd_ >= 0; }

private:
    int fd_;
};

struct Pipe {
    Descriptor read, write;
};

bool make_pipe(Pipe& pipe) {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) return false;
    pipe.read = Descriptor(ends[0]);
    pipe.write = Descriptor(ends[1]);
    return true;
}

/// Everything the child needs, made before it starts: then only async-signal-safe calls are allowed, and no memory of
/// its own but the stack.
struct Prepared {
    std::vector<char*> argv, environment;
    const char* folder = nullptr;
    Limits limits;
    int in = -1, out = -1, err = -1, report = -1;
};

void limit(int resource, rlim_t value) {
    const rlimit both{value, value};
    ::setrlimit(static_cast<__rlimit_resource>(resource), &both);
}

constexpr rlim_t kMegabyte = 1024 * 1024;

void set_limits(const Limits& limits) {
    limit(RLIMIT_CORE, 0);
    if (limits.cpu_s > 0) {
        // SIGXCPU first, so that the cause is known; a program that ignores it is killed two seconds later.
        const auto seconds = static_cast<rlim_t>(std::ceil(limits.cpu_s));
        const rlimit both{seconds, seconds + 2};
        ::setrlimit(RLIMIT_CPU, &both);
    }
    if (limits.memory_mb > 0) limit(RLIMIT_AS, static_cast<rlim_t>(limits.memory_mb) * kMegabyte);
    if (limits.processes > 0) limit(RLIMIT_NPROC, static_cast<rlim_t>(limits.processes));
    if (limits.output_mb > 0) limit(RLIMIT_FSIZE, static_cast<rlim_t>(limits.output_mb) * kMegabyte);
}

[[noreturn]] void become(const Prepared& p) {
    ::setsid();
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    for (int s = 1; s < NSIG; ++s) ::signal(s, SIG_DFL);
    sigset_t none;
    sigemptyset(&none);
    ::sigprocmask(SIG_SETMASK, &none, nullptr);
    bool good = ::dup2(p.in, 0) == 0 && ::dup2(p.out, 1) == 1 && ::dup2(p.err, 2) == 2;
    good = good && (!p.folder || ::chdir(p.folder) == 0);
    // Whatever else is open in the grader is closed by the exec, the pipe that reports a failed exec included.
    ::syscall(SYS_close_range, 3U, ~0U, CLOSE_RANGE_CLOEXEC);
    if (good) {
        set_limits(p.limits);
        ::execvpe(p.argv[0], p.argv.data(), p.environment.data());
    }
    const int why = errno;
    [[maybe_unused]] const auto written = ::write(p.report, &why, sizeof why);
    ::_exit(127);
}

std::vector<char*> pointers(const std::vector<std::string>& strings) {
    std::vector<char*> result;
    for (const std::string& s : strings) result.push_back(const_cast<char*>(s.c_str()));
    result.push_back(nullptr);
    return result;
}

std::vector<std::string> inherited_environment() {
    std::vector<std::string> result;
    for (char** e = environ; *e; ++e) result.emplace_back(*e);
    return result;
}

std::vector<std::string> clean_environment(const std::filesystem::path& folder) {
    const std::string home = folder.empty() ? "/" : folder.string();
    // One malloc arena for two threads: arenas reserve address space, which RLIMIT_AS counts.
    return {"PATH=/usr/bin:/bin", "LANG=C.UTF-8", "HOME=" + home, "TMPDIR=" + home, "MALLOC_ARENA_MAX=2"};
}

std::vector<std::string> environment_for(const Command& command) {
    auto result = command.own_environment ? inherited_environment() : clean_environment(command.folder);
    for (const auto& [name, value] : command.environment) {
        const std::string begin = name + "=";
        std::erase_if(result, [&](const std::string& entry) { return entry.starts_with(begin); });
        result.push_back(begin + value);
    }
    return result;
}

int parent_of(pid_t pid) {
    std::ifstream file(fmt::format("/proc/{}/stat", pid));
    std::string text;
    std::getline(file, text);
    const auto name_end = text.rfind(')');  // the name may hold anything, ')' included
    if (name_end == std::string::npos) return -1;
    int parent = -1;
    char state = 0;
    return std::sscanf(text.c_str() + name_end + 1, " %c %d", &state, &parent) == 2 ? parent : -1;
}

std::vector<pid_t> orphans() {
    std::vector<pid_t> result;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator("/proc", error)) {
        const auto pid = static_cast<pid_t>(std::atoi(entry.path().filename().c_str()));
        if (pid > 0 && !children.count(pid) && parent_of(pid) == ::getpid()) result.push_back(pid);
    }
    return result;
}

// Killing an orphan hands its own children to us: repeat until there are none. A fork bomb that outruns this is bounded
// by RLIMIT_NPROC (not for root: that is the full sandbox's work).
void kill_orphans() {
    const std::lock_guard lock(children_mutex);
    for (int round = 0; round < 200; ++round) {
        const auto found = orphans();
        if (found.empty()) return;
        for (const pid_t pid : found) ::kill(pid, SIGKILL);
        for (const pid_t pid : found) ::waitpid(pid, nullptr, 0);
    }
}

pid_t start(const Prepared& prepared) {
    static const bool adopts = ::prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0) == 0;
    static_cast<void>(adopts);
    const std::lock_guard lock(children_mutex);
    // Until its exec the child borrows this memory: to copy a grader's page tables took longer than many a program
    // runs.
    const pid_t pid = ::vfork();
    if (pid == 0) become(prepared);
    if (pid > 0) children.insert(pid);
    return pid;
}

void finish(pid_t pid, Ended& ended) {
    int status = 0;
    rusage usage{};
    ::kill(-pid, SIGKILL);  // its whole group, while its number cannot belong to another process
    while (::wait4(pid, &status, 0, &usage) < 0 && errno == EINTR) {
    }
    {
        const std::lock_guard lock(children_mutex);
        children.erase(pid);
    }
    kill_orphans();
    if (WIFEXITED(status)) ended.exit = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) ended.signal = WTERMSIG(status);
    ended.timed_out = ended.timed_out || ended.signal == SIGXCPU;
    const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
    ended.cpu_s = seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// The parent's ends of a running command.
struct Streams {
    Descriptor in, out, err;
    std::size_t sent = 0;

    void make_nonblocking() const {
        for (const int fd : {in.get(), out.get(), err.get()}) ::fcntl(fd, F_SETFL, O_NONBLOCK);
    }
};

void feed(Streams& s, const std::string& input) {
    while (s.in.open() && s.sent < input.size()) {
        const auto n = ::write(s.in.get(), input.data() + s.sent, input.size() - s.sent);
        if (n < 0 && errno == EAGAIN) return;
        if (n <= 0) return s.in.reset();  // it does not read any more: its right
        s.sent += static_cast<std::size_t>(n);
    }
    s.in.reset();
}

// False when the text outgrew its bound.
bool drain(Descriptor& fd, std::string& text, std::size_t bound) {
    char buffer[65536];
    while (fd.open()) {
        const auto n = ::read(fd.get(), buffer, sizeof buffer);
        if (n < 0 && errno == EAGAIN) return true;
        if (n <= 0) {
            fd.reset();
            return true;
        }
        const auto room = bound - std::min(bound, text.size());
        text.append(buffer, std::min(room, static_cast<std::size_t>(n)));
        if (static_cast<std::size_t>(n) > room) return false;
    }
    return true;
}

// Until it ends, floods or runs out of time.
void converse(pid_t pid, Streams& s, const Command& command, Ended& ended) {
    const Descriptor alive(static_cast<int>(::syscall(SYS_pidfd_open, pid, 0U)));
    const auto bound = static_cast<std::size_t>(std::max(1, command.limits.text_mb)) * kMegabyte;
    const auto begin = Clock::now();
    for (;;) {
        const double left = command.limits.wall_s - std::chrono::duration<double>(Clock::now() - begin).count();
        if (command.limits.wall_s > 0 && !(left > 0)) {
            ended.timed_out = true;
            return;
        }
        pollfd wait[4] = {
            {alive.get(), POLLIN, 0}, {s.out.get(), POLLIN, 0}, {s.err.get(), POLLIN, 0}, {s.in.get(), POLLOUT, 0}};
        const int patience = command.limits.wall_s > 0 ? static_cast<int>(std::ceil(left * 1000)) : -1;
        if (::poll(wait, 4, patience) < 0 && errno != EINTR) return;
        feed(s, command.input);
        const bool ended_now = (wait[0].revents & POLLIN) != 0;
        const bool out_fits = drain(s.out, ended.out, bound), err_fits = drain(s.err, ended.err, bound);
        ended.flooded = !out_fits || !err_fits;
        if (ended_now || ended.flooded) return;
    }
}

// What the exec could not do arrives on this pipe; nothing arrives when it worked.
int exec_error(const Descriptor& report) {
    int why = 0;
    return ::read(report.get(), &why, sizeof why) == sizeof why ? why : 0;
}

}  // namespace

std::string how_it_ended(const Ended& e) {
    if (!e.started) return e.problem;
    if (e.timed_out) return fmt::format("was stopped after {:.1f} s ({:.1f} s of processor time)", e.wall_s, e.cpu_s);
    if (e.flooded) return "was stopped: it printed more text than allowed";
    if (e.signal) {
        const char* name = ::strsignal(e.signal);
        return fmt::format("crashed: signal {} ({})", e.signal, name ? name : "unknown");
    }
    return e.exit == 0 ? std::string() : fmt::format("ended with status {}", e.exit);
}

std::filesystem::path find_program(const std::string& name) {
    const char* path = std::getenv("PATH");
    std::string_view rest(path == nullptr ? "" : path);
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(':'), rest.size());
        const std::filesystem::path candidate = std::filesystem::path(rest.substr(0, end)) / name;
        if (end > 0 && ::access(candidate.c_str(), X_OK) == 0 && !std::filesystem::is_directory(candidate))
            return candidate;
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return {};
}

Ended run_command(const Command& command) {
    Ended ended;
    static const auto ignored = std::signal(SIGPIPE, SIG_IGN);  // a command that does not read is no reason to die
    static_cast<void>(ignored);
    Pipe in, out, err, report;
    if (command.argv.empty() || !make_pipe(in) || !make_pipe(out) || !make_pipe(err) || !make_pipe(report)) {
        ended.problem =
            command.argv.empty() ? "no command" : fmt::format("cannot make a pipe: {}", std::strerror(errno));
        return ended;
    }
    const auto environment = environment_for(command);
    const std::string folder = command.folder.string();
    const Prepared prepared{pointers(command.argv), pointers(environment), folder.empty() ? nullptr : folder.c_str(),
                            command.limits,         in.read.get(),         out.write.get(),
                            err.write.get(),        report.write.get()};
    const auto begin = Clock::now();
    const pid_t pid = start(prepared);
    if (pid < 0) {
        ended.problem = fmt::format("cannot start a process: {}", std::strerror(errno));
        return ended;
    }
    in.read.reset();
    out.write.reset();
    err.write.reset();
    report.write.reset();
    const int why = exec_error(report.read);
    ended.started = why == 0;
    if (why) ended.problem = fmt::format("cannot run {}: {}", command.argv[0], std::strerror(why));
    Streams streams{std::move(in.write), std::move(out.read), std::move(err.read)};
    streams.make_nonblocking();
    if (ended.started) converse(pid, streams, command, ended);
    finish(pid, ended);
    ended.wall_s = std::chrono::duration<double>(Clock::now() - begin).count();
    return ended;
}

}  // namespace rays
