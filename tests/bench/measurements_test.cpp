#include "measurements.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

#include "knobs.h"
#include "support/files.h"

namespace rays::bench {
namespace {

std::string run(const std::string& name, double cpu_time, const std::string& more = "") {
    return fmt::format(R"({{"name":"{}","cpu_time":{},"time_unit":"ns","label":"how","rays":100,"bytes":7{}}})", name,
                       cpu_time, more);
}
std::string document(const std::string& runs) { return R"({"context":{},"benchmarks":[)" + runs + "]}\n"; }

TEST(Measurements, RoundsAreDocumentsOneAfterTheOther) {
    TimedByName timed;
    add_runs(timed, document(run("a", 1000) + "," + run("build/a/process_time", 300)) + document(run("a", 3000)));
    EXPECT_EQ(timed.at("a").ns, (std::vector<double>{10, 30}));
    EXPECT_EQ(timed.at("build/a").ns, std::vector<double>{3}) << "without what Google Benchmark appends";
    EXPECT_EQ(timed.at("a").settings, "how");
    EXPECT_EQ(timed.at("a").counter("bytes"), 7);
    EXPECT_THROW(timed.at("a").counter("lost"), std::runtime_error);
}

TEST(Measurements, MeansAndMediansAreNoRuns) {
    TimedByName timed;
    add_runs(timed, document(run("a", 1000, R"(,"run_type":"iteration")") + "," +
                             run("a_mean", 1000, R"(,"run_type":"aggregate")")));
    EXPECT_EQ(timed.size(), 1u);
}

TEST(Measurements, RefusesWhatIsNoMeasurement) {
    TimedByName timed;
    for (const std::string text : {"", "{}", "nonsense", "[1]"})
        EXPECT_THROW(add_runs(timed, text), std::runtime_error) << text;
    EXPECT_THROW(add_runs(timed, document(run("a", 1)) + "{"), std::runtime_error) << "the second round broke off";
    EXPECT_THROW(add_runs(timed, R"({"benchmarks":[{"name":"a","time_unit":"us","cpu_time":1,"rays":1}]})"),
                 std::runtime_error);
}

TEST(Measurements, RatiosAreThoseOfTheRounds) {
    const Timed slow{"", {20, 40, 90}, {}}, fast{"", {10, 10, 30}, {}};
    const Spread ratio = ratio_of_times(slow, fast);
    EXPECT_EQ(ratio.median, 3);
    EXPECT_EQ(ratio.low, 2);
    EXPECT_EQ(ratio.high, 4);
    EXPECT_THROW(ratio_of_times(slow, {"", {1}, {}}), std::runtime_error);
}

TEST(Knobs, ListNamesThePrograms) {
    const TemporaryFolder folder;
    EXPECT_TRUE(read_knobs(folder.path(), 4).empty()) << "a build without Google Benchmark";
    const auto write = [&](const std::string& text) { write_atomically(folder.path() / "knobs.txt", text); };
    write("3 fresnel schlick render-schlick\n4 bvh-leaf 8 measure-4-bvh-leaf-8\n");
    const auto knobs = read_knobs(folder.path(), 4);
    ASSERT_EQ(knobs.size(), 1u);
    EXPECT_EQ(knobs[0].name, "bvh-leaf");
    EXPECT_EQ(knobs[0].value, "8");
    EXPECT_EQ(knobs[0].program, folder.path() / "measure-4-bvh-leaf-8");
    write("4 bvh-leaf 8\n");
    EXPECT_THROW(read_knobs(folder.path(), 4), std::runtime_error);
}

}  // namespace
}  // namespace rays::bench
