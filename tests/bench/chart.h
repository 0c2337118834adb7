// charts.json, the data of "Speed against accuracy" in the report. Schema: charts.schema.json.
//
//     {"schema": "raysteps-charts/1", "machine": {"cpu", "cores", "os"}, "versions": {"raysteps", "povray",
//     "compiler"},
//      "charts": [{"id": "1.sphere.near", "step": 1, "kind": "scatter" | "ratios", "title", "text": "what it shows",
//        "created": "2026-01-31T12:00:00Z", "rounds": 11,
//        "x": {"label", "unit", "log"}, "y": {"label", "unit", "log"}, "front": true,
//        "series": [{"name", "role", "joined": true,
//          "points": [{"x", "x_low", "x_high", "y", "y_low", "y_high", "label", "settings", "front": true}]}]}]}
//
// role: "solution" | "float" | "student" | "naive" | "povray" | "embree" | "grid" | "octree".
// scatter: x is a cost, y an error or another cost, with y_low and y_high when it was measured in rounds; y = 0 means
// that no error was found and lies on the floor of a logarithmic axis. `joined` points are one method at several
// settings of its knob, in order. `front` of a point: no other point of the chart is better in both; of a chart: its
// front is drawn. Points of one label in several series are the same thing done in different ways, and are linked.
// ratios: one row a point, x is a ratio, y is absent. Lows and highs bound the median with 95 % confidence
// (statistics.h).
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "statistics.h"

namespace rays::bench {

struct Axis {
    std::string label = "", unit = "";
    bool log = true;
};

struct Point {
    Spread x = {};
    double y = 0;
    std::string label = "";     ///< short, drawn beside the point when not empty
    std::string settings = "";  ///< of the method at this point, in words
    bool on_front = false;
    std::optional<Spread> y_spread = {};  ///< of a y that was measured in rounds; its median is y
};

struct Series {
    std::string name;
    std::string role;
    std::vector<Point> points = {};
    bool joined = false;
};

enum class ChartKind { scatter, ratios };

struct Chart {
    std::string id = "";
    int step = 0;
    ChartKind kind = ChartKind::scatter;
    std::string title = "", text = "";
    Axis x = {}, y = {};
    bool front = false;               ///< does a front make sense? Only when all points answer the same question.
    std::vector<Series> series = {};  ///< without any there is nothing to be drawn, and the chart is left out
    int rounds = 0;                   ///< 0: as many as the laboratory's methods
};

/// Sets Point::on_front from all points of the chart, when it has a front.
void mark_front(Chart& chart);

/// A point of which both numbers were measured in rounds, or x is exact: then low and high are x.
Point point_of(const Spread& x, const Spread& y, std::string label, std::string settings);
inline Spread exactly(double x) { return {x, x, x}; }

/// One entry of "charts". `created` in ISO 8601, UTC; `rounds` unless the chart says how many.
nlohmann::json to_json(const Chart& chart, const std::string& created, int rounds);

/// For a terminal: title, then a line a point.
std::string as_text(const Chart& chart);

}  // namespace rays::bench
