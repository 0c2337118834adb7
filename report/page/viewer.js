// The map of errors with its legend, and the inspector of one pixel.
R.errorCanvas = (scene) => {
    const CELL = 4;  // canvas pixels a picture pixel: room for marks inside of it
    const canvas = R.h("canvas", {class: "frame", width: scene.width * CELL, height: scene.height * CELL});
    const rgba = (r, g, b) => (0xff000000 | b << 16 | g << 8 | r) >>> 0;
    const mix = (x, y, share) => Math.round(x + (y - x) * share);
    const OUTLINE = [127, 227, 255], NOT_A_NUMBER = rgba(255, 79, 216), BLACK = rgba(0, 0, 0);
    const colors = R.colors.table.map((c) => ({plain: rgba(...c), faint: rgba(...c.map((v, k) => mix(v, OUTLINE[k], 0.3)))}));

    /** What one pixel of the picture looks like: colour at (dx, dy) of its cell. */
    const cell = (i) => {
        const error = R.pixelError(scene, i);
        if (!Number.isFinite(error)) return (dx, dy) => ((dx < CELL / 2) === (dy < CELL / 2) ? BLACK : NOT_A_NUMBER);
        const {plain, faint} = colors[R.colors.index(error)];
        const border = (d) => d === 0 || d === CELL - 1;
        if (scene.outlines && scene.student.explained(i)) return (dx, dy) => (border(dx) || border(dy) ? rgba(...OUTLINE) : plain);
        if (scene.outlines && scene.reference.marked(i)) return (dx, dy) => (border(dx) || border(dy) ? plain : faint);
        return () => plain;
    };
    const draw = () => {
        if (!scene.comparable) return;
        const {width, height} = scene, context = canvas.getContext("2d");
        [canvas.width, canvas.height] = [width * CELL, height * CELL];
        const data = context.createImageData(canvas.width, canvas.height), out = new Uint32Array(data.data.buffer);
        for (let i = 0; i < width * height; ++i) {
            const color = cell(i), first = Math.floor(i / width) * CELL * canvas.width + (i % width) * CELL;
            for (let dy = 0; dy < CELL; ++dy)
                for (let dx = 0; dx < CELL; ++dx) out[first + dy * canvas.width + dx] = color(dx, dy);
        }
        context.putImageData(data, 0, 0);
    };
    scene.onChange((what) => ("comparable" in what || "outlines" in what) && draw());
    draw();
    return canvas;
};

/** Arrow keys move the pixel that is looked at, ten at a time with Shift; W goes to the worst one. */
R.movePixel = (scene, event) => {
    const step = event.shiftKey ? 10 : 1;
    const [dx, dy] = {ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, -step], ArrowDown: [0, step]}[event.key] ?? [];
    if (dx !== undefined) {
        event.preventDefault();
        scene.change({x: Math.min(scene.width - 1, Math.max(0, (scene.x ?? 0) + dx)),
                      y: Math.min(scene.height - 1, Math.max(0, (scene.y ?? 0) + dy))});
    } else if ((event.key === "w" || event.key === "W") && scene.worst) {
        scene.change({x: scene.worst.x, y: scene.worst.y});
    }
};

R.errorMap = (scene, title) => {
    const box = R.h("div", {class: "stage map", tabindex: "0", role: "application", "aria-roledescription": "pixel inspector",
        "aria-label": `${title}: error map. Arrow keys move the pixel, W goes to the worst one.`,
        style: {"aspect-ratio": `${scene.width} / ${scene.height}`}}, R.errorCanvas(scene), ...R.markers(scene));
    box.addEventListener("pointermove", (event) => scene.change(R.pixelUnder(scene, event, box)));
    box.addEventListener("keydown", (event) => R.movePixel(scene, event));
    return R.h("figure", {class: "errors"}, box, R.errorLegend(scene));
};

R.toleranceText = (scene) => {
    const fixed = scene.allowed(0), grows = scene.allowed(1) - fixed;
    return grows > 0 ? `${R.number(fixed, 2)} + ${R.number(grows)} of the reference's value` : R.number(fixed);
};

R.errorScale = (scene) => {
    const {DECADES_BELOW, DECADES_ABOVE, at} = R.colors;
    const strip = R.h("canvas", {class: "strip", width: 256, height: 1, "aria-hidden": "true"});
    const context = strip.getContext("2d");
    for (let i = 0; i < 256; ++i) {
        context.fillStyle = `rgb(${at((i + 0.5) / 256).join(" ")})`;
        context.fillRect(i, 0, 1, 1);
    }
    const tick = (at, text, name = "") => R.h("span", {class: `tick ${name}`, style: {left: `${at * 100}%`}, text});
    const ticks = [tick(0, `10${R.superscript(-DECADES_BELOW)} ×`, "first"), tick(0.5, "tolerance", "middle"), tick(1, `10${R.superscript(DECADES_ABOVE)} ×`, "last")];
    return R.h("div", {class: "scale", role: "img", "aria-label": "Colour scale of the error, logarithmic, the tolerance in the middle"}, strip, ...ticks);
};

R.errorLegend = (scene) => {
    const key = (name, text) => R.h("span", {class: "key"}, R.h("i", {class: name, "aria-hidden": "true"}), text);
    return R.h("figcaption", {class: "legend"}, R.errorScale(scene),
        R.h("p", {class: "keys"}, `Largest difference of R, G, B in linear radiance, whatever the exposure, over the tolerance (${R.toleranceText(scene)}). `,
            key("k-outline", "outline in the reference"), key("k-silhouette", "beyond tolerance, but within the reference's silhouette"),
            key("k-nan", "not a number")));
};

/** Values of the pixel that is looked at, and its neighbourhood in both pictures. */
R.inspector = (scene) => {
    const rows = [["student", R.who], ["reference", scene.other], ["difference", "Difference"]].map(([whose, name]) => {
        const cells = [0, 1, 2].map(() => R.h("td"));
        return {whose, cells, row: R.h("tr", {class: whose}, R.h("th", {scope: "row", text: name}), ...cells)};
    });
    const where = R.h("caption", {text: "Point at a picture"});
    const verdict = R.h("p", {class: "pixel-verdict", "aria-live": "polite"});
    const lenses = ["student", "reference"].map((whose) => ({whose, canvas: R.h("canvas", {class: "lens", width: 9, height: 9, role: "img", "aria-label": `${whose === "student" ? R.who : scene.other}: 9 by 9 pixels around`})}));

    const valuesAt = (i) => {
        const w = scene.worst;
        // The grader's own numbers for the worst pixel have all their digits.
        const exact = w && w.x === scene.x && w.y === scene.y;
        const of = (whose) => {
            const given = exact ? R.list(w[whose]) : [];
            if (given.length === 3 && given.every(R.isNumber)) return given;
            return scene[whose] ? [...scene[whose].rgb.subarray(3 * i, 3 * i + 3)] : null;
        };
        return {student: of("student"), reference: of("reference")};
    };
    const drawLens = ({whose, canvas}) => {
        const picture = scene[whose], context = canvas.getContext("2d");
        context.clearRect(0, 0, 9, 9);
        if (!picture) return;
        const gain = 2 ** scene.exposure;
        for (let dy = -4; dy <= 4; ++dy)
            for (let dx = -4; dx <= 4; ++dx) {
                const x = scene.x + dx, y = scene.y + dy;
                if (x < 0 || y < 0 || x >= picture.width || y >= picture.height) continue;
                const i = 3 * (y * picture.width + x);
                context.fillStyle = `rgb(${[0, 1, 2].map((c) => R.colors.toByte(picture.rgb[i + c], gain)).join(" ")})`;
                context.fillRect(dx + 4, dy + 4, 1, 1);
            }
    };
    const judge = (i) => {
        if (R.hasZ(scene)) return R.zVerdict(scene, i);
        const times = R.pixelError(scene, i);
        if (scene.student.explained(i)) return ["mixed", "Beyond tolerance, but within the silhouette here"];
        // Such a pixel is kept as the reference's: a difference of 0 would say too much.
        const same = [0, 1, 2].every((c) => scene.student.planes[c][i] === scene.reference.planes[c][i]);
        if (!scene.student.marked(i)) return ["good", same ? "Within tolerance, equal after rounding" : "Within tolerance"];
        return ["bad", Number.isFinite(times) ? `${R.number(times, 2)} × the tolerance` : "Not a finite number"];
    };
    const show = () => {
        if (scene.x === null || scene.y === null || !(scene.student || scene.reference)) return;
        const i = scene.y * scene.width + scene.x;
        const values = valuesAt(i);
        values.difference = scene.comparable ? values.student.map((v, c) => v - values.reference[c]) : null;
        where.textContent = `Pixel ${scene.x}, ${scene.y}` + (scene.worst?.x === scene.x && scene.worst?.y === scene.y ? " (the worst)" : "");
        // Pictures with nothing to compare are kept in fewer bits.
        const digits = (scene.reference ?? scene.student).mantissa < 10 ? 3 : 5;
        for (const {whose, cells} of rows)
            cells.forEach((cell, c) => {
                cell.textContent = values[whose] ? R.pixelNumber(values[whose][c], digits) : "–";
                const beyond = whose === "difference" && !R.hasZ(scene) && values[whose] && !(Math.abs(values[whose][c]) <= scene.allowed(values.reference[c]));
                cell.classList.toggle("beyond", Boolean(beyond));
            });
        const [tone, words] = scene.comparable ? judge(i) : ["idle", "Nothing to compare with"];
        verdict.textContent = words;
        verdict.dataset.tone = tone;
        lenses.forEach(drawLens);
    };
    scene.onChange((what) => ("x" in what || "comparable" in what || "exposure" in what || "z" in what) && show());
    show();
    const head = R.h("thead", {}, R.h("tr", {}, R.h("th", {scope: "col"}, R.h("span", {class: "unseen", text: "Picture"})), ...["R", "G", "B"].map((c) => R.h("th", {scope: "col", text: c}))));
    return R.h("div", {class: "inspector"}, R.h("div", {class: "values"}, R.h("table", {class: "pixel"}, where, head, R.h("tbody", {}, ...rows.map((r) => r.row))), verdict),
        R.h("div", {class: "lenses"}, ...lenses.map(({whose, canvas}) => R.h("figure", {}, canvas, R.h("figcaption", {text: whose === "student" ? R.who : scene.other})))));
};

R.pictureControls = (scene) => {
    const output = R.h("output", {text: "0 EV"});
    const exposure = R.h("input", {type: "range", min: "-6", max: "6", step: "0.5", value: "0", "aria-label": "Exposure of both pictures, in stops", on: {input: () => {
        output.textContent = `${exposure.value > 0 ? "+" : ""}${exposure.value} EV`.replace("-", "−");
        scene.change({exposure: Number(exposure.value)});
    }}});
    const outlines = R.h("input", {type: "checkbox", on: {change: () => scene.change({outlines: outlines.checked})}});
    outlines.checked = true;
    const worst = scene.worst && R.h("button", {type: "button", class: "quiet", text: R.hasZ(scene) ? "Go to the worst tile" : "Go to the worst pixel", on: {click: () => scene.change({x: scene.worst.x, y: scene.worst.y})}});
    return R.h("div", {class: "controls"}, R.h("label", {}, "Exposure ", exposure, output),
        !R.hasZ(scene) && R.h("label", {}, outlines, " Mark silhouettes"), worst);
};
