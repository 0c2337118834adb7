// Error against time, or one cost against another: points with their settings, methods joined over their knob, and the
// front that nothing beats.
R.scatterPoints = (chart) => R.list(chart.series).map(R.object).flatMap((s, index) => R.list(s.points).map(R.object)
    .filter((p) => R.isNumber(p.x) && p.x > 0 && R.isNumber(p.y) && p.y >= 0)
    .map((p) => ({series: index, name: R.text(s.name), role: R.roles.includes(s.role) ? s.role : "naive", joined: s.joined === true, x: p.x, y: p.y,
        low: R.isNumber(p.x_low) && p.x_low > 0 ? p.x_low : p.x, high: R.isNumber(p.x_high) ? p.x_high : p.x,
        yLow: R.isNumber(p.y_low) && p.y_low > 0 ? p.y_low : p.y, yHigh: R.isNumber(p.y_high) ? p.y_high : p.y, label: R.text(p.label), settings: R.text(p.settings), front: p.front === true})));

/** " (590 to 640)", or nothing where there is no interval. */
R.interval = (low, high) => (low < high ? ` (${R.number(low)} to ${R.number(high)})` : "");

R.withUnit = (axis) => [R.text(axis.label), R.text(axis.unit)].filter(Boolean).join(", ");

R.scatter = (chart) => {
    const title = R.text(chart.title), xAxis = R.object(chart.x), yAxis = R.object(chart.y);
    const points = R.scatterPoints(chart);
    if (points.length === 0) return R.h("figure", {class: "chart"}, R.h("figcaption", {text: title}), R.h("p", {class: "message", text: "Nothing was measured."}));
    const errors = points.flatMap((p) => [p.y, p.yLow, p.yHigh]).filter((y) => y > 0);
    const hasZero = points.some((p) => p.y === 0);
    const least = errors.length ? Math.min(...errors) : 1e-16, most = errors.length ? Math.max(...errors) : 1e-15;
    // An error of 0 was found nowhere on a logarithm: it lies on the floor, one decade below the least.
    const floor = hasZero ? R.decade(least, Math.floor) / 10 : least / 3;
    points.forEach((p) => (p.shownY = Math.max(p.y, floor)));
    const range = {x: [Math.min(...points.map((p) => p.low)) / 1.5, Math.max(...points.map((p) => p.high)) * 1.5], y: [floor, most * 3], zero: hasZero ? floor : null};

    const holder = R.h("div", {class: "plot", tabindex: "0", role: "application", "aria-roledescription": "chart", "aria-label": `${title}. Left and right arrow keys read the points.`});
    const readout = R.h("div", {class: "readout", "aria-live": "polite"});
    const ring = R.h("div", {class: "point-ring", hidden: true});
    let plot = null, width = 0;
    const read = (point) => {
        ring.hidden = !point;
        if (!point) return readout.replaceChildren(R.h("span", {class: "at", text: "Point at a mark for its settings"}));
        if (plot) ["left", "top"].forEach((side, i) => ring.style.setProperty(side, `${plot.valToPos(i ? point.shownY : point.x, i ? "y" : "x")}px`));
        readout.replaceChildren(R.h("span", {class: "at", text: `${point.name}: ${point.settings}`}),
            R.h("span", {}, R.h("b", {text: `${R.number(point.x)} ${R.text(xAxis.unit)}`}), R.interval(point.low, point.high)),
            R.h("span", {}, `${R.text(yAxis.label)} `, R.h("b", {text: [R.number(point.y, point.yLow < point.yHigh ? 3 : 2), R.text(yAxis.unit)].filter(Boolean).join(" ")}), R.interval(point.yLow, point.yHigh)), point.front && R.h("span", {text: "on the front"}) || "");
    };
    read(null);

    const draw = () => {
        width = holder.clientWidth || 480;
        plot?.destroy();
        plot = new uPlot(R.scatterOptions({chart, points, range, width}), [range.x, [null, null]], holder);
        plot.over.append(ring);
        ring.hidden = true;
    };
    new ResizeObserver(() => holder.clientWidth && holder.clientWidth !== width && draw()).observe(holder);
    R.charts.push(draw);
    const distance = (p, x, y) => Math.hypot(plot.valToPos(p.x, "x") - x, plot.valToPos(p.shownY, "y") - y);
    holder.addEventListener("pointermove", (event) => {
        if (!plot) return;
        const box = plot.over.getBoundingClientRect(), x = event.clientX - box.left, y = event.clientY - box.top;
        const nearest = points.reduce((a, b) => (distance(a, x, y) <= distance(b, x, y) ? a : b));
        read(distance(nearest, x, y) < 40 ? nearest : null);
    });
    const inOrder = [...points].sort((a, b) => a.x - b.x);
    let at = -1;
    holder.addEventListener("keydown", (event) => {
        const step = {ArrowLeft: -1, ArrowRight: 1}[event.key];
        if (!step) return;
        event.preventDefault();
        at = Math.min(inOrder.length - 1, Math.max(0, at + step));
        read(inOrder[at]);
    });
    const legend = R.h("ul", {class: "legend"}, ...new Map(points.map((p) => [p.series, R.h("li", {}, R.legendMark(p.role, p.series), R.h("span", {text: p.name}))])).values(),
        chart.front === true && R.h("li", {}, R.h("i", {class: "front-swatch", "aria-hidden": "true"}), R.h("span", {text: "front: nothing is better in both"})));
    return R.h("figure", {class: "chart speed-chart"}, R.h("figcaption", {text: title}), R.text(chart.text) && R.h("p", {class: "says", text: R.text(chart.text)}), legend, holder, readout, R.scatterTable(points, xAxis, yAxis));
};

R.scatterTable = (points, xAxis, yAxis) => R.h("details", {class: "numbers"}, R.h("summary", {text: "Values as a table"}),
    R.h("div", {class: "scroll", tabindex: "0"}, R.h("table", {},
        R.h("thead", {}, R.h("tr", {}, ...["Method", R.withUnit(xAxis), "95 % interval", R.withUnit(yAxis), "Front", "Settings"].map((text) => R.h("th", {scope: "col", text})))),
        R.h("tbody", {}, ...points.map((p) => R.h("tr", {}, R.h("th", {scope: "row", text: p.label ? `${p.name}: ${p.label}` : p.name}), R.h("td", {text: R.number(p.x)}), R.h("td", {text: `${R.number(p.low)} to ${R.number(p.high)}`}),
            R.h("td", {text: `${R.number(p.y, p.yLow < p.yHigh ? 3 : 2)}${R.interval(p.yLow, p.yHigh)}`}), R.h("td", {text: p.front ? "yes" : ""}), R.h("td", {class: "settings", text: p.settings})))))));

R.scatterOptions = ({chart, points, range, width}) => {
    const paint = (u) => {
        const {ctx, bbox} = u, d = devicePixelRatio;
        const place = (p) => [u.valToPos(p.x, "x", true), u.valToPos(p.shownY, "y", true)];
        const line = (list, color, lineWidth, dash = []) => {
            ctx.beginPath();
            list.forEach(([x, y], i) => (i ? ctx.lineTo(x, y) : ctx.moveTo(x, y)));
            Object.assign(ctx, {strokeStyle: color, lineWidth: lineWidth * d});
            ctx.setLineDash(dash.map((v) => v * d));
            ctx.stroke();
            ctx.setLineDash([]);
        };
        ctx.save();
        if (chart.front === true) R.paintFront(u, points.filter((p) => p.front).sort((a, b) => a.x - b.x).map(place), line);
        const labelled = R.groupBy(points, (p) => p.label);
        labelled.forEach((list, label) => label && list.length > 1 && line(list.map(place), R.color("--line"), 1.5));
        R.groupBy(points.filter((p) => p.joined), (p) => p.series).forEach((list) => line(list.map(place), R.color(`--series-${list[0].role}`), 1.2, [5, 4]));
        ctx.lineWidth = 1.6 * d;
        for (const p of points) {
            const [x, y] = place(p);
            line([[u.valToPos(p.low, "x", true), y], [u.valToPos(p.high, "x", true), y]], R.color(`--series-${p.role}`), 1.6);
            if (p.yLow < p.yHigh) line([[x, u.valToPos(p.yLow, "y", true)], [x, u.valToPos(p.yHigh, "y", true)]], R.color(`--series-${p.role}`), 1.6);
            R.paintMark(ctx, p.role, p.series, x, y, 4.2 * d);
        }
        R.paintLabels(ctx, bbox, [...R.groupBy(points.filter((p) => p.label), (p) => p.label).values()].map(([p]) => ({x: place(p)[0], y: place(p)[1], text: p.label})));
        ctx.restore();
    };
    return {
        width, height: Math.max(290, Math.min(360, Math.round(width * 0.62))), legend: {show: false}, padding: [10, 12, 0, 0],
        cursor: {show: false}, scales: {x: {time: false, distr: 3, range: range.x}, y: {distr: 3, range: range.y}},
        axes: [R.plotAxis(R.withUnit(R.object(chart.x)), true, 34), R.plotAxis(R.withUnit(R.object(chart.y)), true, 58, range.zero)],
        series: [{}, {show: false}], hooks: {draw: [paint]},
    };
};

/** Above and right of these steps everything is beaten by a point of the front. */
R.paintFront = (u, front, line) => {
    if (front.length === 0) return;
    const {bbox} = u, steps = [[front[0][0], bbox.top]];
    front.forEach(([x, y], i) => steps.push([x, i ? front[i - 1][1] : bbox.top], [x, y]));
    steps.push([bbox.left + bbox.width, front.at(-1)[1]]);
    line(steps, R.color("--accent-front"), 5);
};

R.groupBy = (list, key) => list.reduce((groups, item) => groups.set(key(item), [...(groups.get(key(item)) ?? []), item]), new Map());
