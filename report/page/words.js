// How verdicts, numbers and times are written.
R.verdicts = {
    "pass": {tone: "good", label: "Passed", icon: "M4 10.5l4 4 8-9"},
    "partial": {tone: "mixed", label: "Partly passed", icon: "M10 4a6 6 0 1 0 0 12 6 6 0 1 0 0-12", filled: "M10 4a6 6 0 0 0 0 12z"},
    "fail": {tone: "bad", label: "Failed", icon: "M5 5l10 10M15 5L5 15"},
    "crash": {tone: "bad", label: "Crashed", icon: "M11 3l-6 8h5l-1 6 6-8h-5z"},
    "time-out": {tone: "bad", label: "Out of time", icon: "M10 5v5l3.5 3M10 2.5a7.5 7.5 0 1 0 0 15 7.5 7.5 0 0 0 0-15"},
    "build error": {tone: "bad", label: "Does not build", icon: "M12.5 4.5a4 4 0 0 0-4.8 5L3.5 13.8l2.7 2.7 4.3-4.2a4 4 0 0 0 5-4.8l-2.5 2.5-2.7-2.7z"},
    "not started": {tone: "idle", label: "Not started", icon: "M10 4.5a5.5 5.5 0 1 0 0 11 5.5 5.5 0 0 0 0-11"},
    "infrastructure error": {tone: "idle", label: "Not judged", icon: "M10 4v7.5M10 15v.2"},
};
R.verdict = (name) => R.verdicts[name] ?? {tone: "idle", label: R.text(name) || "No verdict", icon: "M5 10h10"};

R.badge = (name, {small = false} = {}) => {
    const v = R.verdict(name);
    const icon = R.svg("svg", {viewBox: "0 0 20 20", "aria-hidden": "true", class: "icon"}, R.svg("path", {d: v.icon}), v.filled && R.svg("path", {d: v.filled, class: "filled"}));
    return R.h("span", {class: small ? "badge small" : "badge", "data-tone": v.tone, title: v.label}, icon,
               R.h("span", {class: small ? "unseen" : "label", text: v.label}));
};

R.isNumber = (value) => typeof value === "number" && Number.isFinite(value);
const superscripts = {"-": "⁻", 0: "⁰", 1: "¹", 2: "²", 3: "³", 4: "⁴", 5: "⁵", 6: "⁶", 7: "⁷", 8: "⁸", 9: "⁹"};

R.superscript = (integer) => String(integer).replace(/[-0-9]/g, (c) => superscripts[c]);

/** 0.00012 -> 1.2 × 10⁻⁴; digits are significant ones. */
R.number = (value, digits = 3) => {
    if (value === null || value === undefined) return "–";
    if (typeof value !== "number") return R.text(value);
    if (Number.isNaN(value)) return "NaN";
    if (!Number.isFinite(value)) return value > 0 ? "+Inf" : "−Inf";
    if (value === 0) return "0";
    const size = Math.abs(value);
    if (size >= 1e-3 && size < 1e6) return Number(value.toPrecision(digits)).toString().replace("-", "−");
    const [mantissa, exponent] = value.toExponential(digits - 1).split("e");
    const power = R.superscript(exponent.replace("+", ""));
    const factor = mantissa.replace(/\.?0+$/, "");
    return factor === "1" ? `10${power}` : `${factor.replace("-", "−")} × 10${power}`;
};

/** Values of pixels: as many digits as were kept, and for what is tiny a power of ten. */
R.pixelNumber = (value, digits = 5) => {
    if (!Number.isFinite(value) || value === 0) return R.number(value);
    const size = Math.abs(value);
    return size < 0.002 || size >= 1e5 ? R.number(value, digits - 1) : value.toPrecision(digits).replace("-", "−");
};

R.points = (value) => (R.isNumber(value) ? Number(value.toFixed(2)).toString() : "–");
R.plural = (count, one, many = one + "s") => `${count} ${count === 1 ? one : many}`;
R.seconds = (value) => (!R.isNumber(value) ? "" : value < 10 ? `${value.toFixed(1)} s` : value < 90 ? `${Math.round(value)} s` : `${Math.floor(value / 60)} min ${Math.round(value % 60)} s`);

R.when = (text) => {
    const date = new Date(R.text(text));
    if (Number.isNaN(date.getTime())) return R.text(text);
    return new Intl.DateTimeFormat("en-GB", {dateStyle: "long", timeStyle: "short", timeZone: "UTC"}).format(date) + " UTC";
};

/** "pass" of a full score, a share otherwise; for bars and rings. */
R.share = (points, max) => (R.isNumber(points) && R.isNumber(max) && max > 0 ? Math.min(1, Math.max(0, points / max)) : 0);

R.bar = (points, max, label) =>
    R.h("span", {class: "bar", role: "img", "aria-label": `${label}: ${R.points(points)} of ${R.points(max)} points`},
        R.h("span", {class: "bar-fill", style: {width: `${100 * R.share(points, max)}%`}}));
