// That processes are measured, not how fast they are.
#include "process_time.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "support/files.h"

namespace rays::bench {
namespace {

Command shell(const std::string& script) {
    Command command;
    command.argv = {"/bin/sh", "-c", script};
    return command;
}

TEST(ProcessTime, SidesTakeTurns) {
    const TemporaryFolder folder;
    const auto note = [&](const std::string& letter) {
        Command command = shell("printf " + letter + " >> order");
        command.folder = folder.path();
        return command;
    };
    const PairedTimes times = time_in_pairs(note("a"), note("b"), 3);
    EXPECT_EQ(read_file(folder.path() / "order"),
              "ab"
              "ab"
              "ba"
              "ab")
        << "one of each that does not count, then turns";
    EXPECT_GT(times.first_s.low, 0);
    EXPECT_LE(times.ratio.low, times.ratio.median);
    EXPECT_LE(times.ratio.median, times.ratio.high);
}

TEST(ProcessTime, ManyTakeTurnsThereAndBack) {
    const TemporaryFolder folder;
    std::vector<Command> commands;
    for (const std::string letter : {"a", "b", "c"}) {
        commands.push_back(shell("printf " + letter + " >> order"));
        commands.back().folder = folder.path();
    }
    const auto times = time_in_turns(commands, 3);
    EXPECT_EQ(read_file(folder.path() / "order"), "abccbaabc");
    ASSERT_EQ(times.size(), 3u);
    for (const auto& of_command : times) EXPECT_EQ(of_command.size(), 3u);
}

TEST(ProcessTime, PairsAreComparedRoundByRound) {
    const PairedTimes times = paired({2, 4, 30}, {1, 1, 10});
    EXPECT_EQ(times.ratio.median, 3);
    EXPECT_EQ(times.first_s.median, 4);
    EXPECT_THROW(paired({1, 2}, {1}), std::exception);
}

TEST(ProcessTime, AFailedRunIsNoMeasurement) {
    try {
        time_in_pairs(shell("exit 0"), shell("echo no scene >&2; exit 3"), 1);
        FAIL() << "the second command failed";
    } catch (const std::runtime_error& e) {
        EXPECT_NE(std::string(e.what()).find("no scene"), std::string::npos) << e.what();
        EXPECT_NE(std::string(e.what()).find("status 3"), std::string::npos) << e.what();
    }
    EXPECT_THROW(run_or_throw(shell("kill -9 $$")), std::runtime_error);
    Command absent;
    absent.argv = {"/no/such/program"};
    EXPECT_THROW(run_or_throw(absent), std::runtime_error);
}

}  // namespace
}  // namespace rays::bench
