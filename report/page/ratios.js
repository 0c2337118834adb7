// Ratios with their intervals, a row each: a table that is a chart.
R.ratioTicks = (low, high) => {
    const ticks = [];
    for (let e = Math.floor(Math.log10(low)); e <= Math.ceil(Math.log10(high)); ++e) for (const m of [1, 2, 5]) ticks.push(m * 10 ** e);
    const inside = ticks.filter((v) => v >= low && v <= high);
    return inside.length > 7 ? inside.filter((v) => Math.abs(Math.log10(v) - Math.round(Math.log10(v))) < 1e-9) : inside;
};

R.ratios = (chart) => {
    const title = R.text(chart.title), axis = R.object(chart.x);
    const points = R.scatterPoints({series: R.list(chart.series).map(R.object).map((s) => ({...s, points: R.list(s.points).map((p) => ({...R.object(p), y: 0}))}))});
    if (points.length === 0) return R.h("figure", {class: "chart"}, R.h("figcaption", {text: title}), R.h("p", {class: "message", text: "Nothing was measured."}));
    const low = Math.min(1, ...points.map((p) => p.low)) / 1.15, high = Math.max(1, ...points.map((p) => p.high)) * 1.15;
    const percent = (v) => 100 * Math.log(v / low) / Math.log(high / low);
    const at = (v) => ({left: `${percent(v)}%`});
    const mark = (p) => [R.h("i", {class: "interval", "data-role": p.role, style: {...at(p.low), width: `${percent(p.high) - percent(p.low)}%`}}), R.h("i", {class: "dot", "data-role": p.role, style: at(p.x)})];
    const rows = [...R.groupBy(points, (p) => p.label)];
    // Where there is one series, it needs no name.
    const several = new Set(points.map((p) => p.series)).size > 1;
    const value = (p) => R.h("div", {class: "value"}, R.h("b", {text: R.number(p.x)}), ` (${R.number(p.low)} to ${R.number(p.high)})`, several && R.h("small", {"data-role": p.role}, R.h("i", {class: "dot"}), p.name));
    return R.h("figure", {class: "chart speed-chart"}, R.h("figcaption", {text: title}), R.text(chart.text) && R.h("p", {class: "says", text: R.text(chart.text)}),
        R.h("div", {class: "scroll", tabindex: "0", role: "region", "aria-label": title}, R.h("table", {class: "ratios"},
            R.h("thead", {}, R.h("tr", {}, R.h("th", {scope: "col"}, R.h("span", {class: "unseen", text: "What"})), R.h("th", {scope: "col", class: "track-cell"}, R.h("span", {text: R.withUnit(axis)}),
                R.h("div", {class: "track ticks", "aria-hidden": "true"}, ...R.ratioTicks(low, high).map((v) => R.h("span", {style: at(v), text: R.number(v, 2)})))), R.h("th", {scope: "col", text: "Median, 95 % interval"}))),
            R.h("tbody", {}, ...rows.map(([label, found]) => R.h("tr", {}, R.h("th", {scope: "row", text: label.replaceAll("_", " ")}),
                R.h("td", {class: "track-cell"}, R.h("div", {class: "track", "aria-hidden": "true"}, R.h("i", {class: "one", style: at(1)}), ...found.flatMap(mark)), ...found.map((p) => R.h("small", {text: p.settings}))),
                R.h("td", {}, ...found.map(value))))))));
};
