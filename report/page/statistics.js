// Noisy pictures: where the mean over many seeds departs from the reference, by how many standard errors, tile by tile.
R.statistics = (check) => (check.raw.statistics ? R.object(check.raw.statistics) : null);

/** The scale of the map: what is beyond is drawn as its ends. */
R.Z_RANGE = 5;

/** What the picture's parts know of the statistics: z of every pixel's tile once it is decoded. */
R.addStatistics = (scene, check) => {
    const raw = R.statistics(check);
    if (!raw) return;
    const worst = R.object(raw.worst), noise = R.object(raw.noise);
    const given = ["x", "y", "width", "height"].every((key) => R.isNumber(worst[key]));
    scene.statistics = {raw, noise, whole: R.list(raw.whole).map(R.object), worst: given ? worst : null, z: null,
        /** Of a pixel's tile: the value of the channel that departs most. */
        at: (i) => {
            const z = scene.statistics.z?.rgb;
            return z ? [z[3 * i], z[3 * i + 1], z[3 * i + 2]].reduce((most, v) => (Math.abs(v) > Math.abs(most) ? v : most)) : 0;
        },
        unpack: () => {
            const z = R.pixels.get(raw.embedded);
            if (z && z.width === scene.width && z.height === scene.height) scene.statistics.z = z;
            scene.change({z: true});
        }};
};

R.zCanvas = (scene) => {
    const canvas = R.h("canvas", {class: "frame z-map", width: scene.width, height: scene.height, role: "img", "aria-label": "Standard errors beyond the margin, tile by tile"});
    const draw = () => {
        const {z} = scene.statistics;
        if (!z) return;
        const context = canvas.getContext("2d"), data = context.createImageData(z.width, z.height), dark = R.isDark();
        for (let i = 0; i < z.width * z.height; ++i) data.data.set([...R.colors.diverging(scene.statistics.at(i) / R.Z_RANGE, dark), 255], 4 * i);
        context.putImageData(data, 0, 0);
    };
    scene.onChange((what) => "z" in what && draw());
    R.charts.push(draw);  // drawn again in another theme
    draw();
    return canvas;
};

R.zScale = () => {
    const strip = R.h("canvas", {class: "strip", width: 255, height: 1, "aria-hidden": "true"});
    const draw = () => {
        const context = strip.getContext("2d");
        for (let i = 0; i < 255; ++i) {
            context.fillStyle = `rgb(${R.colors.diverging((i - 127) / 127, R.isDark()).join(" ")})`;
            context.fillRect(i, 0, 1, 1);
        }
    };
    R.charts.push(draw);
    draw();
    const tick = (z, text, name = "") => R.h("span", {class: `tick ${name}`, style: {left: `${50 + 50 * z / R.Z_RANGE}%`}, text});
    return R.h("div", {class: "scale", role: "img", "aria-label": `Colour scale of z from −${R.Z_RANGE}, too dark, to ${R.Z_RANGE}, too bright`}, strip,
        tick(-R.Z_RANGE, `−${R.Z_RANGE} too dark`, "first"), tick(0, "0", "middle"), tick(R.Z_RANGE, `${R.Z_RANGE} too bright`, "last"));
};

/** A frame around the tile that departs most. */
R.worstTile = (scene) => {
    const {worst} = scene.statistics;
    if (!worst) return null;
    const share = (part, whole) => `${100 * part / whole}%`;
    return R.h("span", {class: "worst-tile", "aria-hidden": "true", style: {left: share(worst.x, scene.width), top: share(worst.y, scene.height), width: share(worst.width, scene.width), height: share(worst.height, scene.height)}});
};

R.zSentence = (scene) => {
    const {raw, worst} = scene.statistics;
    const margin = R.isNumber(raw.tile_margin) ? `${R.number(100 * raw.tile_margin)} %` : "the margin";
    const limit = worst && R.isNumber(worst.limit) ? ` A tile is wrong beyond ${R.number(worst.limit, 2)}.` : "";
    return `By how many standard errors the mean of ${R.plural(raw.seeds, "picture")} goes beyond ${margin} of the level, in the channel where it does so most; grey is within.${limit}`;
};

R.zMap = (scene, title) => {
    const box = R.h("div", {class: "stage map", tabindex: "0", role: "application", "aria-roledescription": "pixel inspector",
        "aria-label": `${title}: map of z. Arrow keys move the pixel, W goes to the worst tile.`,
        style: {"aspect-ratio": `${scene.width} / ${scene.height}`}}, R.zCanvas(scene), R.worstTile(scene), ...R.markers({...scene, worst: null}));
    box.addEventListener("pointermove", (event) => scene.change(R.pixelUnder(scene, event, box)));
    box.addEventListener("keydown", (event) => R.movePixel(scene, event));
    const missing = R.text(scene.statistics.raw.note);
    if (missing) box.append(R.h("span", {class: "missing", text: missing}));
    return R.h("figure", {class: "errors"}, box, R.h("figcaption", {class: "legend"}, R.zScale(), R.h("p", {class: "keys"}, `${R.zSentence(scene)} `,
        scene.statistics.worst && R.h("span", {class: "key"}, R.h("i", {class: "k-tile", "aria-hidden": "true"}), "the tile that departs most"))));
};

/** What the pixel that is looked at says of its tile. */
R.zVerdict = (scene, i) => {
    const {statistics} = scene;
    if (!statistics.z) return ["idle", "Nothing to compare with"];
    const z = statistics.at(i), limit = R.isNumber(statistics.worst?.limit) ? statistics.worst.limit : Infinity;
    if (z === 0) return ["good", "Tile within the margin"];
    const words = `Tile ${z > 0 ? "brighter" : "darker"} than the margin allows by ${Math.abs(z) >= 999 ? "endlessly many" : R.number(Math.abs(z), 2)} standard errors`;
    return Math.abs(z) <= limit ? ["good", `${words}: noise`] : [R.number(statistics.raw.tiles_wrong) === "0" ? "mixed" : "bad", words];
};

R.percent = (value, of) => (R.isNumber(value) && R.isNumber(of) && of !== 0 ? `${value > 0 ? "+" : ""}${R.number(100 * value / of, 2)} %` : "–");

R.statisticsFacts = (scene) => {
    const {raw, noise, whole} = scene.statistics;
    const ratio = R.isNumber(noise.ratio) ? `${R.number(noise.ratio)} (full points up to ${R.number(noise.full)}, none from ${R.number(noise.none)})` : null;
    return [["seeds", R.isNumber(raw.seeds) ? `${raw.seeds}${raw.batches === 2 ? ", a second batch" : ""}` : null],
            ["samples a pixel", R.isNumber(raw.samples) ? String(raw.samples) : null],
            ["tiles wrong", R.isNumber(raw.tiles) && raw.tiles > 0 ? `${raw.tiles_wrong} of ${raw.tiles}` : null],
            ["whole picture, R G B", whole.length === 3 ? whole.map((d) => R.percent(d.difference, d.reference)).join(", ") : null],
            ["noise over the solution's", ratio],
            ["false alarms, by design", R.isNumber(raw.alarm_rate) && raw.alarm_rate > 0 ? `${R.number(100 * raw.alarm_rate)} %` : null]];
};
