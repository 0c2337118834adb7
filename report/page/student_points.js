// The student's points in charts of speed. They were timed when the work was graded, not when the chart was measured: what
// counts is the ratio to the solution's program, run in turns with it, and it moves the solution's own point.
R.speedPoints = R.steps.flatMap((step) => R.list(step.raw.speed).map(R.object));

/** The solution's point with its time multiplied and, for pictures, the student's own error. */
R.studentPoint = (of, point) => {
    const ratio = R.object(point.ratio), {median, low, high} = ratio, good = [median, low, high].every((v) => R.isNumber(v) && v > 0);
    if (point.verdict !== "pass" || !good || !R.isNumber(of.x)) return null;
    const settings = `${R.number(median)} times the solution's time (${R.number(low)} to ${R.number(high)})${R.text(point.message) && `; ${R.text(point.message)}`}`;
    const moved = {...of, label: R.text(of.label), settings, front: false};
    if (point.time === "1/x") return {...moved, x: of.x / median, x_low: of.x / high, x_high: of.x / low};
    if (point.time === "y") return {...moved, y: of.y * median, y_low: of.y * low, y_high: of.y * high};
    return {...moved, x: of.x * median, x_low: of.x * low, x_high: of.x * high, ...(R.isNumber(point.error) ? {y: point.error} : {}), y_low: undefined, y_high: undefined};
};

/** {chart, notes}: the chart with the student's series, and what has to be said under it. */
R.withStudent = (chart) => {
    const mine = R.speedPoints.filter((p) => R.text(p.chart) !== "" && p.chart === chart.id);
    if (mine.length === 0) return {chart, notes: []};
    const all = R.list(chart.series).map(R.object), series = [], missing = [];
    const groups = R.groupBy(mine, (p) => R.text(p.series));
    for (const [name, points] of groups) {
        const solution = all.find((s) => s.name === name);
        const found = points.map((p) => {
            const at = R.list(solution?.points).map(R.object).find((q) => (R.text(p.label) ? q.label === p.label : q.x === p.at));
            const point = at ? R.studentPoint(at, p) : null;
            const where = R.text(p.label).replaceAll("_", " ") || `${name}, ${R.number(p.at)}`;
            if (!point) missing.push([where, !at ? "this chart has no such point" : p.verdict === "pass" ? "there is no ratio of times" : [R.verdict(p.verdict).label.toLowerCase(), R.text(p.message)].filter(Boolean).join(": ")]);
            return point;
        }).filter(Boolean);
        if (found.length > 0) series.push({name: groups.size > 1 ? `student: ${name}` : "student", role: "student", joined: solution.joined === true, points: found});
    }
    const notes = [], rounds = mine.find((p) => R.isNumber(p.rounds))?.rounds, against = mine.map((p) => R.text(p.against)).find(Boolean);
    if (series.length > 0) notes.push(`The student's points are not of the run that this chart shows: when the work was graded, its program and the solution's did the same in turns (${R.plural(rounds ?? 0, "round")}), and the ratio of their processor times, median and range, is applied to the solution's point.${against ? ` Errors are differences to the solution's picture at ${against}.` : ""} No grade depends on them.`);
    for (const [why, list] of R.groupBy(missing, ([, reason]) => reason)) notes.push(`No point of the student's for ${list.map(([where]) => where).join("; ")}: ${why}.`);
    return {chart: {...chart, series: [...all, ...series]}, notes};
};

R.speedChart = (measured) => {
    const {chart, notes} = R.withStudent(measured);
    const figure = chart.kind === "ratios" ? R.ratios(chart) : R.scatter(chart);
    figure.append(...notes.map((text) => R.h("p", {class: "says student-says", text})));
    return figure;
};
