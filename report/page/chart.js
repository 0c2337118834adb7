// A sweep: error over a parameter. Where a program failed there is a cross at the top.
R.chart = (chart, title) => {
    const series = R.list(chart.series).map(R.object).map((s) => ({
        name: R.text(s.name), role: ["solution", "student", "naive"].includes(s.role) ? s.role : "naive",
        points: new Map(R.list(s.points).filter((p) => Array.isArray(p) && R.isNumber(p[0])).map((p) => [p[0], R.isNumber(p[1]) ? p[1] : null])),
    }));
    const logX = chart.log_x === true, logY = chart.log_y === true;
    const xs = [...new Set(series.flatMap((s) => [...s.points.keys()]))].filter((x) => !logX || x > 0).sort((a, b) => a - b);
    const positive = series.flatMap((s) => [...s.points.values()]).filter((y) => y !== null && (!logY || y > 0));
    if (xs.length === 0) return R.h("p", {class: "message", text: "The sweep has no points."});

    // An exact answer has error 0, which no logarithm shows: it lies on the floor, one decade below the least error.
    const low = positive.length ? Math.min(...positive) : logY ? 1e-16 : 0, high = positive.length ? Math.max(...positive) : 1;
    const floor = logY ? R.decade(low, Math.floor) / 10 : Math.min(0, low);
    const ceiling = logY ? Math.max(R.decade(high, Math.ceil) * 100, floor * 1e3) : high * 1.1 || 1;
    const ys = series.map((s) => xs.map((x) => !s.points.has(x) ? undefined : s.points.get(x) === null ? null : Math.max(floor, s.points.get(x))));
    const left = logX ? xs[0] / 1.5 : xs[0], right = logX ? xs.at(-1) * 1.5 : xs.at(-1);

    const holder = R.h("div", {class: "plot", tabindex: "0", role: "application", "aria-roledescription": "chart",
        "aria-label": `${title}. Left and right arrow keys read the values.`});
    const readout = R.h("div", {class: "readout", "aria-live": "polite"});
    const readAt = (index) => {
        readout.replaceChildren(R.h("span", {class: "at", text: index === null ? "Point at the chart for values" : `${R.text(chart.x_label) || "x"} = ${R.number(xs[index])}`}));
        for (const s of series) {
            const value = index === null ? undefined : s.points.get(xs[index]);
            readout.append(R.h("span", {class: "series", "data-role": s.role}, R.h("i", {"aria-hidden": "true"}), R.h("b", {text: s.name}),
                index === null ? null : R.h("span", {class: value === null ? "failed" : "", text: value === undefined ? "–" : value === null ? "failed" : R.number(value)})));
        }
    };
    readAt(null);

    let plot = null, width = 0;
    const draw = () => {
        width = holder.clientWidth || 480;
        plot?.destroy();
        plot = new uPlot(R.chartOptions({chart, series, xs, ys, logX, logY, x: [left, right], y: [floor, ceiling], width, readAt}), [xs, ...ys], holder);
    };
    new ResizeObserver(() => holder.clientWidth && holder.clientWidth !== width && draw()).observe(holder);
    R.charts.push(draw);
    let at = -1;
    holder.addEventListener("keydown", (event) => {
        const step = {ArrowLeft: -1, ArrowRight: 1}[event.key];
        if (!step || !plot) return;
        event.preventDefault();
        at = Math.min(xs.length - 1, Math.max(0, at + step));
        plot.setCursor({left: plot.valToPos(xs[at], "x"), top: plot.height / 3});
        readAt(at);
    });
    return R.h("figure", {class: "chart"}, R.h("figcaption", {class: R.text(chart.title) === title ? "unseen" : null, text: R.text(chart.title) || title}), holder, readout, R.chartTable(chart, series, xs));
};

R.chartTable = (chart, series, xs) =>
    R.h("details", {class: "numbers"}, R.h("summary", {text: "Values as a table"}),
        R.h("div", {class: "scroll", tabindex: "0"}, R.h("table", {},
            R.h("thead", {}, R.h("tr", {}, R.h("th", {scope: "col", text: R.text(chart.x_label) || "x"}), ...series.map((s) => R.h("th", {scope: "col", text: s.name})))),
            R.h("tbody", {}, ...xs.map((x) => R.h("tr", {}, R.h("th", {scope: "row", text: R.number(x)}),
                ...series.map((s) => R.h("td", {text: !s.points.has(x) ? "–" : s.points.get(x) === null ? "failed" : R.number(s.points.get(x))}))))))));

R.chartOptions = ({chart, series, xs, ys, logX, logY, x, y, width, readAt}) => {
    const ink = R.color("--ink-2"), range = R.color("--range"), paper = R.color("--panel");
    const color = (role) => R.color(`--series-${role}`);
    const shadeRange = (u) => {
        if (!R.isNumber(chart.pass_from) || !R.isNumber(chart.pass_to)) return;
        const {ctx, bbox} = u;
        const clampX = (v) => Math.min(bbox.left + bbox.width, Math.max(bbox.left, u.valToPos(Math.max(v, logX ? x[0] : v), "x", true)));
        const from = clampX(chart.pass_from), to = clampX(chart.pass_to);
        ctx.save();
        ctx.fillStyle = range;
        ctx.fillRect(from, bbox.top, to - from, bbox.height);
        ctx.fillStyle = ink;
        ctx.font = `${11 * devicePixelRatio}px ${getComputedStyle(document.body).fontFamily}`;
        ctx.textAlign = "left";
        ctx.textBaseline = "top";
        if (to - from > 90 * devicePixelRatio) ctx.fillText("must hold here", from + 6 * devicePixelRatio, bbox.top + 5 * devicePixelRatio);
        ctx.restore();
    };
    const crossFailures = (u) => {
        const {ctx, bbox} = u, d = devicePixelRatio;
        ctx.save();
        ctx.lineWidth = 2 * d;
        series.forEach((s, k) => xs.forEach((value, i) => {
            if (ys[k][i] !== null) return;
            const cx = u.valToPos(value, "x", true), cy = bbox.top + (26 + 11 * k) * d, r = 3.5 * d;
            ctx.strokeStyle = color(s.role);
            ctx.beginPath();
            ctx.moveTo(cx - r, cy - r);
            ctx.lineTo(cx + r, cy + r);
            ctx.moveTo(cx + r, cy - r);
            ctx.lineTo(cx - r, cy + r);
            ctx.stroke();
        }));
        ctx.restore();
    };
    const look = {solution: {width: 2, points: {size: 7, width: 2}}, student: {width: 2.5, points: {size: 6}}, naive: {width: 1.5, dash: [5, 4], points: {size: 5}}};
    return {
        width, height: Math.max(220, Math.min(320, Math.round(width * 0.55))), legend: {show: false}, padding: [10, 12, 0, 0],
        cursor: {drag: {x: false, y: false}, points: {size: 9}},
        scales: {x: {time: false, distr: logX ? 3 : 1, range: x}, y: {distr: logY ? 3 : 1, range: y}},
        axes: [R.plotAxis(R.text(chart.x_label), logX, 34), R.plotAxis(R.text(chart.y_label), logY, 58)],
        series: [{}, ...series.map((s) => ({label: s.name, stroke: color(s.role), ...look[s.role], spanGaps: false,
            points: {show: true, fill: s.role === "solution" ? paper : color(s.role), stroke: color(s.role), ...look[s.role].points}}))],
        hooks: {drawClear: [shadeRange], draw: [crossFailures], setCursor: [(u) => readAt(u.cursor.idx ?? null)]},
    };
};
