// Colours of pictures and of errors.
// The error scale is built in Oklab (B. Ottosson, 2020), where equal distances look equally different: a path of
// rising lightness, walked at even speed. So it reads the same without colour vision and in a grey print.
R.colors = (() => {
    const linear = (L, a, b) => {
        const l = (L + 0.3963377774 * a + 0.2158037573 * b) ** 3;
        const m = (L - 0.1055613458 * a - 0.0638541728 * b) ** 3;
        const s = (L - 0.0894841775 * a - 1.2914855480 * b) ** 3;
        return [4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
                -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
                -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s];
    };
    const encode = (v) => {
        const c = Math.min(1, Math.max(0, v));
        return c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055;
    };
    const lch = (L, C, degrees) => [L, C * Math.cos(degrees * Math.PI / 180), C * Math.sin(degrees * Math.PI / 180)];
    const mix = (p, q, t) => p.map((v, i) => v + (q[i] - v) * t);
    const distance = (p, q) => Math.hypot(...p.map((v, i) => v - q[i]));

    /** n colours at even distances along the path through the points. */
    const walk = (points, n) => {
        const fine = [];
        for (let i = 0; i + 1 < points.length; ++i)
            for (let k = 0; k < 200; ++k) fine.push(mix(points[i], points[i + 1], k / 200));
        fine.push(points.at(-1));
        const along = [0];
        for (let i = 1; i < fine.length; ++i) along.push(along[i - 1] + distance(fine[i - 1], fine[i]));
        const colors = [];
        for (let i = 0, j = 0; i < n; ++i) {
            const wanted = along.at(-1) * i / (n - 1);
            while (j + 2 < fine.length && along[j + 1] < wanted) ++j;
            colors.push(mix(fine[j], fine[j + 1], Math.min(1, (wanted - along[j]) / (along[j + 1] - along[j]))));
        }
        return colors;
    };

    // Below the tolerance: rounding, in quiet slate. Above: what matters, from violet to pale yellow.
    const quiet = walk([lch(0.16, 0.02, 260), lch(0.36, 0.045, 255)], 128);
    const loud = walk([lch(0.42, 0.15, 295), lch(0.56, 0.19, 345), lch(0.68, 0.17, 35), lch(0.8, 0.14, 70), lch(0.96, 0.08, 105)], 128);
    const lab = [...quiet, ...loud];
    const table = lab.map(([L, a, b]) => linear(L, a, b).map((v) => Math.round(255 * encode(v))));

    const DECADES_BELOW = 3, DECADES_ABOVE = 3;
    /** 0..1 on the scale for an error in units of the tolerance, which is the middle. */
    const position = (error) => {
        if (!(error > 0)) return 0;
        const decades = Math.log10(error);
        const t = decades <= 0 ? 0.5 * (1 + decades / DECADES_BELOW) : 0.5 * (1 + decades / DECADES_ABOVE);
        return Math.min(1, Math.max(0, t));
    };
    const at = (t) => table[Math.min(255, Math.max(0, Math.floor(t * 256)))];
    const index = (error) => (error <= 1 ? Math.min(127, Math.floor(position(error) * 256)) : Math.min(255, Math.floor(position(error) * 256)));

    // What a pixel costs: the same walk from further down, and nearly black for what costs nothing at all.
    const costLab = walk([lch(0.24, 0.09, 280), lch(0.42, 0.15, 300), lch(0.56, 0.19, 345), lch(0.68, 0.17, 35), lch(0.8, 0.14, 70), lch(0.96, 0.08, 105)], 256);
    const costTable = costLab.map(([L, a, b]) => linear(L, a, b).map((v) => Math.round(255 * encode(v))));
    const NO_COST = [14, 15, 18];
    /** The colour of a count on the logarithmic scale from 1 to `top`. */
    const cost = (count, top) => (count > 0 ? costTable[Math.min(255, Math.max(0, Math.floor(256 * Math.log(count) / Math.log(top))))] : NO_COST);

    // Departures either way: blue for too dark, orange for too bright, and between them a grey that recedes into the page.
    const rgbOf = (point) => linear(...point).map((v) => Math.round(255 * encode(v)));
    const ends = {light: [lch(0.4, 0.15, 262), lch(0.92, 0.004, 90), lch(0.55, 0.17, 42)], dark: [lch(0.78, 0.13, 245), lch(0.27, 0.008, 260), lch(0.8, 0.14, 65)]};
    const steps = Object.fromEntries(Object.entries(ends).map(([name, [low, middle, high]]) => [name, Array.from({length: 129}, (_, i) => rgbOf(i < 64 ? mix(middle, low, (64 - i) / 64) : mix(middle, high, (i - 64) / 64)))]));
    /** t from -1 to 1, 0 in the middle. */
    const diverging = (t, dark) => steps[dark ? "dark" : "light"][Math.round(64 + 64 * Math.min(1, Math.max(-1, t)))];

    // Linear radiance to a byte: 4096 steps are finer than a display's 256 even in the shadows, where encode() is steepest.
    const bytes = Uint8Array.from({length: 4097}, (_, i) => Math.round(255 * encode(i / 4096)));
    const toByte = (value, gain) => (value !== value ? 0 : bytes[Math.round(4096 * Math.min(1, Math.max(0, value * gain)))]);

    return {lab, table, position, at, index, costLab, costTable, cost, diverging, toByte, DECADES_BELOW, DECADES_ABOVE};
})();
