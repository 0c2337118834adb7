// The pictures of one check: student's beside POV-Ray's, the map of their difference, and what is under the pointer.
// The parts share a scene: which pixel is looked at, and how bright the pictures are shown.
R.pictureScene = (check) => {
    const image = check.image;
    const listeners = new Set();
    const worst = R.wasCompared(image) ? R.object(image.worst) : {};
    const scene = {
        image, other: check.fresh ? "Solution" : "POV-Ray", student: null, reference: null, width: 4, height: 3, exposure: 0, outlines: true,
        x: R.isNumber(worst.x) ? worst.x : null, y: R.isNumber(worst.y) ? worst.y : null,
        tolerance: R.isNumber(image.tolerance) && image.tolerance > 0 ? image.tolerance : 5e-4,
        /** By how much a value may differ from the reference's. */
        allowed: (reference) => {
            const absolute = R.isNumber(image.tolerance_absolute) ? image.tolerance_absolute : scene.tolerance;
            return absolute + (scene.tolerance - absolute) * Math.abs(reference);
        },
        worst: R.isNumber(worst.x) && R.isNumber(worst.y) ? worst : null,
        onChange: (run) => listeners.add(run),
        change: (what) => {
            Object.assign(scene, what);
            listeners.forEach((run) => run(what));
        },
    };
    const embedded = R.object(image.embedded), size = embedded.reference ?? embedded.student ?? image;
    if (R.isNumber(size.width) && R.isNumber(size.height)) [scene.width, scene.height] = [size.width, size.height];
    scene.blobs = [embedded.reference, embedded.student, R.statistics(check)?.embedded];
    scene.unpack = () => {
        const {student, reference} = R.pixels.pair(image);
        const sameSize = student && reference && student.width === reference.width && student.height === reference.height;
        scene.change({student, reference, comparable: Boolean(sameSize)});
        scene.statistics?.unpack();
    };
    R.addStatistics(scene, check);
    return scene;
};
/** The map beside the pictures: of single pixels' errors, or, where pixels are noise, of the tiles' z. */
R.mapOf = (scene, title) => (R.hasZ(scene) ? R.zMap(scene, title) : R.errorMap(scene, title));
R.hasZ = (scene) => Boolean(scene.statistics && R.text(scene.statistics.raw.z_picture));
/** Whose picture stands on the left. */
R.ownName = (scene) => (scene.statistics && R.isNumber(scene.statistics.raw.seeds) ? `${R.who}, mean of ${scene.statistics.raw.seeds}` : R.who);

/** Largest difference of a pixel's three channels in units of what is allowed; NaN when one is not a number. On which
    side of 1 it lies was decided with the full floats: the page's are rounded. */
R.pixelError = (scene, i) => {
    let error = 0;
    for (let c = 3 * i; c < 3 * i + 3; ++c) {
        const reference = scene.reference.rgb[c];
        const times = Math.abs(scene.student.rgb[c] - reference) / scene.allowed(reference);
        if (!(times <= error)) error = times;
        if (error !== error) return NaN;
    }
    return scene.student.marked(i) ? Math.max(error, 1.001) : Math.min(error, 1);
};

/** A canvas that always shows that picture at the scene's exposure. */
R.frameCanvas = (scene, whose, label) => {
    const canvas = R.h("canvas", {class: "frame", role: "img", "aria-label": label, width: scene.width, height: scene.height});
    const draw = () => {
        const picture = scene[whose];
        if (!picture) return;
        [canvas.width, canvas.height] = [picture.width, picture.height];
        const context = canvas.getContext("2d");
        const data = context.createImageData(picture.width, picture.height);
        const gain = 2 ** scene.exposure;
        for (let i = 0, n = picture.width * picture.height; i < n; ++i) {
            for (let c = 0; c < 3; ++c) data.data[4 * i + c] = R.colors.toByte(picture.rgb[3 * i + c], gain);
            data.data[4 * i + 3] = 255;
        }
        context.putImageData(data, 0, 0);
    };
    draw();
    scene.onChange((what) => ("exposure" in what || whose in what) && draw());
    return canvas;
};

/** The pixel of a pointer event over a box that shows the whole picture. */
R.pixelUnder = (scene, event, box) => {
    const area = box.getBoundingClientRect();
    const x = Math.floor((event.clientX - area.left) / area.width * scene.width);
    const y = Math.floor((event.clientY - area.top) / area.height * scene.height);
    return {x: Math.min(scene.width - 1, Math.max(0, x)), y: Math.min(scene.height - 1, Math.max(0, y))};
};

/** Rings around the worst pixel and the one that is looked at. */
R.markers = (scene) => {
    const ring = (name) => R.h("span", {class: `marker ${name}`, "aria-hidden": "true"});
    const place = (element, x, y) => {
        element.hidden = x === null || y === null;
        element.style.left = `${(x + 0.5) / scene.width * 100}%`;
        element.style.top = `${(y + 0.5) / scene.height * 100}%`;
    };
    const here = ring("here"), worst = ring("worst");
    place(worst, scene.worst?.x ?? null, scene.worst?.y ?? null);
    place(here, null, null);
    scene.onChange((what) => "x" in what && place(here, scene.x, scene.y));
    return [worst, here];
};

/** The slider's handle: dark with a light rim, so that it is seen on any picture. */
R.handle = () => R.h("span", {slot: "handle", class: "handle", "aria-hidden": "true"},
    R.svg("svg", {viewBox: "0 0 34 34"}, R.svg("circle", {cx: 17, cy: 17, r: 15}), R.svg("path", {d: "M13 11l-6 6 6 6M21 11l6 6-6 6"})));

/** Both pictures under one slider. Arrow keys, Home and End move it, as does dragging. */
R.comparison = (scene, title) => {
    const both = R.hasBoth(scene.image);
    const student = R.frameCanvas(scene, "student", `${title}: the picture to judge`);
    const reference = R.frameCanvas(scene, "reference", `${title}: the picture of ${scene.other}`);
    const box = R.h("div", {class: "stage", style: {"aspect-ratio": `${scene.width} / ${scene.height}`}});
    if (!both) {
        const only = scene.image.embedded?.reference ? reference : scene.image.embedded?.student ? student : null;
        box.append(only ?? R.h("span", {class: "missing", text: "No picture"}));
        box.append(R.h("span", {class: "tag right", text: !only ? "" : only === reference ? scene.other : R.who}));
        if (only !== student) box.append(R.h("span", {class: "tag left missing-tag", text: "Nothing to compare"}));
        return R.h("div", {class: "compare"}, box);
    }
    student.setAttribute("slot", "first");
    reference.setAttribute("slot", "second");
    const slider = R.h("img-comparison-slider", {role: "slider", tabindex: "0", "aria-label": `${title}: ${R.who} on the left, ${scene.other} on the right`,
        "aria-valuemin": "0", "aria-valuemax": "100", "aria-valuenow": "50", "aria-valuetext": `50 % ${R.who}`, value: "50"}, student, reference, R.handle());
    const announce = () => {
        const value = Math.round(slider.value);
        slider.setAttribute("aria-valuenow", value);
        slider.setAttribute("aria-valuetext", `${value} % ${R.who}`);
        box.style.setProperty("--split", `${slider.value}%`);
    };
    slider.addEventListener("slide", announce);
    slider.addEventListener("keydown", (event) => {
        const to = {Home: 0, End: 100, PageUp: slider.value + 10, PageDown: slider.value - 10}[event.key];
        if (to === undefined) return;
        event.preventDefault();
        slider.value = Math.min(100, Math.max(0, to));
        announce();
    });
    box.append(slider, R.h("span", {class: "tag left", text: R.ownName(scene)}), R.h("span", {class: "tag right", text: scene.other}), ...R.markers(scene));
    box.addEventListener("pointermove", (event) => scene.change(R.pixelUnder(scene, event, box)));
    return R.h("div", {class: "compare"}, box);
};

/** For paper, where nothing slides: both pictures and the error map in a row. Drawn when it is printed. */
R.printedPair = (scene, title) => {
    const box = R.h("div", {class: "printed", "aria-hidden": "true"});
    const figure = (name, ...content) => R.h("figure", {}, ...content, R.h("figcaption", {text: name}));
    addEventListener("beforeprint", () => {
        const frames = [["student", R.who], ["reference", scene.other]].filter(([whose]) => scene.image.embedded?.[whose])
            .map(([whose, name]) => figure(name, R.frameCanvas(scene, whose, title)));
        const errors = R.hasBoth(scene.image) && [R.hasZ(scene) ? figure("Standard errors beyond the margin, from too dark to too bright", R.zCanvas(scene), R.zScale())
            : figure("Error, the tolerance in the middle of the scale", R.errorCanvas(scene), R.errorScale(scene))];
        box.append(...frames, ...(errors || []));
    }, {once: true});
    return box;
};
