#include "chart.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>

#include "charts/charts.h"
#include "charts/methods.h"
#include "charts_file.h"
#include "schema_check.h"
#include "support/files.h"

namespace rays::bench {
namespace {

using nlohmann::json;

Chart example() {
    return {.id = "1.x",
            .step = 1,
            .title = "t",
            .text = "what it shows",
            .x = kTimeOfRay,
            .y = kMeanError,
            .front = true,
            .series = {{"exact", "solution", {{.x = {10, 9, 11}, .y = 0, .label = "a", .settings = "s"}}},
                       {"coarse",
                        "naive",
                        {{.x = {1, 1, 1}, .y = 0.5, .label = "", .settings = "n = 1"},
                         {.x = {20, 19, 30}, .y = 0.1, .label = "", .settings = "n = 2"}},
                        true}}};
}

json schema() {
    std::ifstream in(CHARTS_SCHEMA);
    return json::parse(in);
}

TEST(Chart, FrontIsMarkedAcrossTheSeries) {
    Chart chart = example();
    mark_front(chart);
    EXPECT_TRUE(chart.series[0].points[0].on_front);
    EXPECT_TRUE(chart.series[1].points[0].on_front);
    EXPECT_FALSE(chart.series[1].points[1].on_front);
    Chart without = example();
    without.front = false;
    mark_front(without);
    EXPECT_FALSE(without.series[0].points[0].on_front);
}

TEST(Chart, FileFollowsItsSchema) {
    Chart ratios = example();
    ratios.kind = ChartKind::ratios;
    const json file = charts_file(
        {to_json(example(), "2026-01-31T12:00:00Z", 11), to_json(ratios, "2026-01-31T12:00:00Z", 1)}, "3.7");
    EXPECT_EQ(grader::schema_problems(file, schema()), std::vector<std::string>{});
    EXPECT_FALSE(file["machine"]["os"].get<std::string>().empty());
    EXPECT_EQ(file["charts"][0]["series"][0]["points"][0]["x_high"], 11);
    EXPECT_FALSE(file["charts"][1]["series"][0]["points"][0].contains("y"));
}

TEST(Chart, BothAxesMayHaveIntervals) {
    Chart costs = example();
    costs.rounds = 3;
    costs.series[1].points[0] = point_of(exactly(60), {4, 3, 5}, "leaf 8", "s");
    const json entry = to_json(costs, "2026-01-31T12:00:00Z", 11);
    EXPECT_EQ(entry["rounds"], 3) << "the chart's own";
    const json& point = entry["series"][1]["points"][0];
    EXPECT_EQ(point["x_low"], 60);
    EXPECT_EQ(point["y"], 4);
    EXPECT_EQ(point["y_low"], 3);
    EXPECT_EQ(point["y_high"], 5);
    EXPECT_FALSE(entry["series"][0]["points"][0].contains("y_low"));
    EXPECT_EQ(grader::schema_problems(charts_file({entry}, ""), schema()), std::vector<std::string>{});
}

TEST(Chart, SchemaRefusesWhatThePageCannotDraw) {
    json file = charts_file({to_json(example(), "2026-01-31T12:00:00Z", 11)}, "");
    file["charts"][0]["series"][0]["role"] = "competitor";
    file["charts"][0]["series"][1]["points"][0]["x"] = -1;
    EXPECT_EQ(grader::schema_problems(file, schema()).size(), 2u);
}

TEST(Chart, ChartsOfOtherStepsStay) {
    const TemporaryFolder folder;
    const auto path = folder.path() / "charts.json";
    json one = to_json(example(), "2026-01-31T12:00:00Z", 11), three = one;
    three["step"] = 3;
    write_atomically(path, charts_file({three, one}, "").dump());
    EXPECT_EQ(kept_charts(path, {1}), std::vector<json>{three});
    EXPECT_EQ(kept_charts(path, {1, 3}), std::vector<json>{});
    EXPECT_EQ(kept_charts(path, {2}), (std::vector<json>{one, three})) << "in the order of the steps";

    json elsewhere = charts_file({one}, "");
    elsewhere["machine"]["cpu"] = "another processor";
    write_atomically(path, elsewhere.dump());
    EXPECT_EQ(kept_charts(path, {2}), std::vector<json>{}) << "times of two machines do not mix";
    write_atomically(path, std::string_view("not JSON"));
    EXPECT_EQ(kept_charts(path, {2}), std::vector<json>{});
    EXPECT_EQ(kept_charts(folder.path() / "absent.json", {2}), std::vector<json>{});
}

std::string benchmark_output(double cpu_time, const std::string& name = "a") {
    return fmt::format(
        R"({{"context":{{}},"benchmarks":[{{"name":"{}","cpu_time":{},"time_unit":"ns","label":"how","rays":512,"error_median":1e-16,"error_mean":2e-16,"error_largest":1e-15,"wrong":0.25}}]}})",
        name, cpu_time);
}

TEST(Laboratory, RoundsOfAMeasuringProgramAddUp) {
    MeasuredByName measured;
    add_round(measured, benchmark_output(5120));
    add_round(measured, benchmark_output(10240));
    add_round(measured, benchmark_output(512, "b"));
    EXPECT_EQ(measured.at("a").ns, (std::vector<double>{10, 20}));
    EXPECT_EQ(measured.at("b").ns, std::vector<double>{1});
    EXPECT_EQ(measured.at("a").wrong, 0.25);
    const Point point = mean_error_point(measured.at("a"), "double");
    EXPECT_EQ(point.x.median, 15);
    EXPECT_EQ(point.y, 2e-16);
    EXPECT_EQ(point.settings, "how, double; largest error 1e-15, 25 % of the rays answered wrongly");
}

TEST(Laboratory, RefusesWhatIsNoMeasurement) {
    MeasuredByName measured;
    EXPECT_THROW(add_round(measured, ""), std::runtime_error);
    EXPECT_THROW(add_round(measured, R"({"benchmarks":[{"name":"a"}]})"), std::exception);
}

// A page has no two charts of one name, and every chart stands with its step.
TEST(Charts, AreListedByStep) {
    int step = 0;
    for (const NamedChart& chart : all_charts()) {
        EXPECT_GE(chart.step, step);
        step = chart.step;
        EXPECT_NE(chart.make, nullptr);
    }
    EXPECT_GE(all_charts().size(), 25u);
}

}  // namespace
}  // namespace rays::bench
