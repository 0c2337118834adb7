// What all plots share: axes with whole decades, and colours of the theme in force.
R.charts = [];

R.decade = (value, round) => 10 ** round(Math.log10(value));

R.plotFont = (pixels) => `${pixels}px ${getComputedStyle(document.body).fontFamily}`;

/** 2·10³: the ticks between whole decades have 2 or 5 before the power. */
R.inPowers = (v) => {
    const exponent = Math.floor(Math.log10(v) + 1e-9), digit = Math.round(v / 10 ** exponent);
    return `${digit === 1 ? "" : `${digit}·`}10${R.superscript(exponent)}`;
};

/** uPlot's options of one axis. size in CSS pixels; `zero`: the place on a logarithmic axis that stands for 0. */
R.plotAxis = (label, log, size, zero = null) => {
    const font = R.plotFont(12), ink = R.color("--ink-2");
    const tenPower = (v) => (zero !== null && v <= zero * 1.001 ? "0" : v >= 0.01 && v <= 1000 ? R.number(v, 2) : R.inPowers(v));
    const decades = (u, i, min, max) => {
        const from = Math.ceil(Math.log10(min) - 1e-9), to = Math.floor(Math.log10(max) + 1e-9);
        const stride = Math.max(1, Math.ceil((to - from) / 8));
        const list = [];
        // Less than two decades need numbers in between.
        for (let e = from - 1; e <= to; e += stride) for (const m of to - from < 2 ? [1, 2, 5] : [1]) list.push(m * 10 ** e);
        return list.filter((v) => v >= min * (1 - 1e-9) && v <= max * (1 + 1e-9));
    };
    return {label, labelFont: font, font, stroke: ink, size, labelSize: 22, gap: 4, grid: {stroke: R.color("--grid"), width: 1}, ticks: {show: false},
        ...(log ? {splits: decades, filter: (u, list) => list, values: (u, list) => list.map(tenPower)} : {values: (u, list) => list.map((v) => R.number(v))})};
};
