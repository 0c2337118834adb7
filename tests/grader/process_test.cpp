#include "support/process.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "tools.h"

namespace rays::grader {
namespace {

Ended run(const std::string& shell, Limits limits = {}, std::string input = {}) {
    return run_command({{"/bin/sh", "-c", shell}, std::move(input), {}, limits, false});
}

// A process that was reaped has no folder in /proc, or is a zombie on its way.
bool alive(int pid) { return pid > 0 && ::kill(pid, 0) == 0; }

TEST(Process, GivesOutputAndStatus) {
    const Ended e = run("echo out; echo err >&2; exit 7");
    EXPECT_TRUE(e.started);
    EXPECT_FALSE(e.ok());
    EXPECT_EQ(e.exit, 7);
    EXPECT_EQ(e.out, "out\n");
    EXPECT_EQ(e.err, "err\n");
}

TEST(Process, SetsVariablesInAdditionOrInstead) {
    const Command command{{"/bin/sh", "-c", "echo $GREETING $LANG"}, {}, {}, {}, false,
                          {{"GREETING", "hello"}, {"LANG", "C"}}};
    EXPECT_EQ(run_command(command).out, "hello C\n");
}

TEST(Process, SaysHowItEnded) {
    EXPECT_EQ(how_it_ended(run("exit 0")), "");
    EXPECT_EQ(how_it_ended(run("exit 3")), "ended with status 3");
    const Ended late = run("sleep 30", only_time(0.2));
    EXPECT_TRUE(how_it_ended(late).starts_with("was stopped after 0.")) << how_it_ended(late);
}

TEST(Process, FindsProgramsAlongThePath) {
    EXPECT_TRUE(find_program("sh").is_absolute());
    EXPECT_EQ(find_program("no-such-program"), "");
}

TEST(Process, FeedsInputBiggerThanAPipe) {
    const std::string input(1 << 20, 'x');
    EXPECT_EQ(run("cat", {}, input).out, input);
}

TEST(Process, DoesNotMindAProgramThatDoesNotRead) { EXPECT_EQ(run("exit 0", {}, std::string(1 << 20, 'x')).exit, 0); }

TEST(Process, ToldApartFromAProgramThatIsNotThere) {
    const Ended e = run_command({{"/no/such/program"}, {}, {}, {}, false});
    EXPECT_FALSE(e.started);
    EXPECT_NE(e.problem.find("No such file"), std::string::npos) << e.problem;
}

TEST(Process, ReportsCrashes) {
    const Ended e = run("kill -SEGV $$");
    EXPECT_EQ(e.signal, SIGSEGV);
    EXPECT_FALSE(e.timed_out);
    EXPECT_EQ(how_it_ended(e), "crashed: signal 11 (Segmentation fault)");
}

TEST(Process, StopsOnTheClock) {
    Limits limits;
    limits.wall_s = 0.3;
    const Ended e = run("sleep 30", limits);
    EXPECT_TRUE(e.timed_out);
    EXPECT_LT(e.wall_s, 10);
}

TEST(Process, StopsByProcessorTime) {
    Limits limits;
    limits.cpu_s = 1;
    limits.wall_s = 60;
    const Ended e = run("while :; do :; done", limits);
    EXPECT_TRUE(e.timed_out);
    EXPECT_LT(e.cpu_s, 4);
}

TEST(Process, BoundsMemory) {
    Limits limits;
    limits.memory_mb = 200;
    // dd wants one block of a gigabyte.
    const Ended e = run("dd if=/dev/zero of=/dev/null bs=1G count=1", limits);
    EXPECT_NE(e.exit, 0);
    EXPECT_NE(e.err.find("memory exhausted"), std::string::npos) << e.err;
}

TEST(Process, StopsAFloodOfText) {
    Limits limits;
    limits.text_mb = 1;
    for (const char* flood : {"yes", "yes >&2"}) {
        const Ended e = run(flood, limits);
        EXPECT_TRUE(e.flooded);
        EXPECT_LE(e.out.size() + e.err.size(), 1u << 20);
        EXPECT_LT(e.wall_s, 20);
    }
}

TEST(Process, BoundsFiles) {
    const TemporaryFolder folder;
    Limits limits;
    limits.output_mb = 1;
    const Ended e =
        run_command({{"/bin/sh", "-c", "head -c 5000000 /dev/zero > big"}, {}, folder.path(), limits, false});
    EXPECT_FALSE(e.ok());
    EXPECT_LE(std::filesystem::file_size(folder.path() / "big"), 1u << 20);
}

TEST(Process, KillsChildrenOfItsGroup) {
    const Ended e = run("sleep 300 & echo $!");
    EXPECT_EQ(e.exit, 0);
    EXPECT_FALSE(alive(std::atoi(e.out.c_str())));
    EXPECT_LT(e.wall_s, 20) << "the child holds the output open: not waited for";
}

TEST(Process, KillsChildrenThatLeftTheSession) {
    const Ended e = run("setsid sh -c 'echo $$; exec sleep 300' & sleep 0.3");
    ASSERT_GT(std::atoi(e.out.c_str()), 0);
    EXPECT_FALSE(alive(std::atoi(e.out.c_str())));
}

TEST(Process, EnvironmentIsClean) {
    ::setenv("RAYSTEPS_SECRET", "secret", 1);
    EXPECT_EQ(run("env").out.find("secret"), std::string::npos);
    Command own{{"env"}, {}, {}, {}, true};
    EXPECT_NE(run_command(own).out.find("secret"), std::string::npos) << "compilers keep the environment";
}

TEST(Process, OpenFilesAreNotInherited) {
    const int secret = ::open("/proc/self/status", O_RDONLY);  // without close-on-exec
    ASSERT_GE(secret, 3);
    // ls itself opens one descriptor to read the folder.
    EXPECT_EQ(run("ls /proc/self/fd").out, "0\n1\n2\n3\n");
    ::close(secret);
}

TEST(Process, RunsSideBySide) {
    std::vector<std::jthread> threads;
    std::array<Ended, 6> ended;
    for (std::size_t i = 0; i < ended.size(); ++i)
        threads.emplace_back([&, i] { ended[i] = run("sleep 0.2; setsid sleep 100 & echo " + std::to_string(i)); });
    threads.clear();
    for (std::size_t i = 0; i < ended.size(); ++i) EXPECT_EQ(ended[i].out, std::to_string(i) + "\n");
}

}  // namespace
}  // namespace rays::grader
