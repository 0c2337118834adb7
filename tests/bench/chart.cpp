#include "chart.h"

#include <fmt/format.h>

namespace rays::bench {
namespace {

using nlohmann::json;

json axis(const Axis& a) { return {{"label", a.label}, {"unit", a.unit}, {"log", a.log}}; }

json point(const Point& p, ChartKind kind) {
    json result{{"x", p.x.median},  {"x_low", p.x.low},       {"x_high", p.x.high},
                {"label", p.label}, {"settings", p.settings}, {"front", p.on_front}};
    if (kind == ChartKind::scatter) result["y"] = p.y;
    if (kind == ChartKind::scatter && p.y_spread) {
        result["y_low"] = p.y_spread->low;
        result["y_high"] = p.y_spread->high;
    }
    return result;
}

json series(const Series& s, ChartKind kind) {
    json points = json::array();
    for (const Point& p : s.points) points.push_back(point(p, kind));
    return {{"name", s.name}, {"role", s.role}, {"joined", s.joined}, {"points", points}};
}

}  // namespace

Point point_of(const Spread& x, const Spread& y, std::string label, std::string settings) {
    return {.x = x, .y = y.median, .label = std::move(label), .settings = std::move(settings), .y_spread = y};
}

void mark_front(Chart& chart) {
    if (!chart.front) return;
    std::vector<CostAndError> values;
    std::vector<Point*> points;
    for (Series& s : chart.series) {
        for (Point& p : s.points) {
            values.push_back({p.x.median, p.y});
            points.push_back(&p);
        }
    }
    for (const std::size_t i : pareto_front(values)) points[i]->on_front = true;
}

json to_json(const Chart& chart, const std::string& created, int rounds) {
    json all = json::array();
    for (const Series& s : chart.series) all.push_back(series(s, chart.kind));
    json result{{"id", chart.id},
                {"step", chart.step},
                {"kind", chart.kind == ChartKind::scatter ? "scatter" : "ratios"},
                {"title", chart.title},
                {"text", chart.text},
                {"created", created},
                {"rounds", chart.rounds > 0 ? chart.rounds : rounds},
                {"x", axis(chart.x)},
                {"front", chart.front},
                {"series", all}};
    if (chart.kind == ChartKind::scatter) result["y"] = axis(chart.y);
    return result;
}

std::string as_text(const Chart& chart) {
    std::string text = fmt::format("\n{}\n", chart.title);
    for (const Series& s : chart.series) {
        for (const Point& p : s.points) {
            const std::string name = p.label.empty() ? p.settings : p.label;
            text += fmt::format("  {:<22} {:<52} {:9.4g} {} [{:.4g}, {:.4g}]", s.name, name, p.x.median, chart.x.unit,
                                p.x.low, p.x.high);
            if (chart.kind == ChartKind::scatter)
                text += fmt::format("  {} {:.3g} {}{}", chart.y.label, p.y, chart.y.unit, p.on_front ? "  front" : "");
            text += "\n";
        }
    }
    return text;
}

}  // namespace rays::bench
