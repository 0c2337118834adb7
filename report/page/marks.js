// The marks of a scatter: a shape for each series, a colour for each role; in the legend and on the canvas alike.
R.roles = ["solution", "float", "student", "naive", "povray", "embree", "grid", "octree"];

/** Outlines around (0, 0) in units of the mark's radius, closed. */
R.markShapes = [
    Array.from({length: 16}, (_, i) => [Math.cos(i * Math.PI / 8), Math.sin(i * Math.PI / 8)]),
    [[-0.9, -0.9], [0.9, -0.9], [0.9, 0.9], [-0.9, 0.9]],
    [[0, -1.15], [1.1, 0.8], [-1.1, 0.8]],
    [[0, -1.25], [1.25, 0], [0, 1.25], [-1.25, 0]],
    [[0, 1.15], [1.1, -0.8], [-1.1, -0.8]],
];

R.markShape = (index) => R.markShapes[index % R.markShapes.length];

R.legendMark = (role, index) => R.svg("svg", {viewBox: "-8 -8 16 16", class: "mark", "data-role": role, "aria-hidden": "true"},
    R.svg("path", {d: `M${R.markShape(index).map(([x, y]) => `${(5 * x).toFixed(2)} ${(5 * y).toFixed(2)}`).join("L")}Z`}));

/** On a canvas, at device pixels. */
R.paintMark = (ctx, role, index, x, y, radius) => {
    ctx.beginPath();
    R.markShape(index).forEach(([dx, dy], i) => (i ? ctx.lineTo(x + radius * dx, y + radius * dy) : ctx.moveTo(x + radius * dx, y + radius * dy)));
    ctx.closePath();
    ctx.strokeStyle = R.color(`--series-${role}`);
    ctx.fillStyle = role === "naive" ? R.color("--panel") : ctx.strokeStyle;
    ctx.fill();
    ctx.stroke();
};

/** Writes labels beside points, each where it covers nothing that was written before; else not at all. */
R.paintLabels = (ctx, box, labels) => {
    const d = devicePixelRatio, taken = labels.map(({x, y}) => [x - 5 * d, y - 5 * d, x + 5 * d, y + 5 * d]);
    ctx.font = R.plotFont(11 * d);
    ctx.fillStyle = R.color("--ink-2");
    ctx.textBaseline = "middle";
    ctx.textAlign = "left";
    for (const {x, y, text} of labels) {
        const w = ctx.measureText(text).width, h = 13 * d, gap = 8 * d;
        const places = [[x + gap, y], [x - gap - w, y], [x - w / 2, y - gap - h / 2], [x - w / 2, y + gap + h / 2], [x + gap, y - h], [x + gap, y + h], [x - gap - w, y - h], [x - gap - w, y + h]];
        const free = places.map(([left, middle]) => [left, middle - h / 2, left + w, middle + h / 2]).find((r) =>
            r[0] >= box.left && r[2] <= box.left + box.width && r[1] >= box.top && r[3] <= box.top + box.height && taken.every((t) => r[2] < t[0] || r[0] > t[2] || r[3] < t[1] || r[1] > t[3]));
        if (!free) continue;
        taken.push(free);
        ctx.fillText(text, free[0], (free[1] + free[3]) / 2);
    }
};
