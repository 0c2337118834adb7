// What a pixel costs in each structure: maps side by side on one colour scale, and one pixel that is looked at in all.
R.costScenes = (step) => R.list(step.raw.cost_maps).map(R.object).filter((cost) => R.list(cost.maps).length > 0);
R.hasCosts = (step) => !R.doesNotCompile(step) && R.costScenes(step).length > 0;

R.costKinds = [{key: "tests", lane: 0, unit: "tests a pixel"}, {key: "nodes", lane: 1, unit: "nodes a pixel"}];
R.structureName = (name) => ({none: "No structure", grid: "Grid", octree: "Octree", bvh: "BVH"}[name] ?? R.text(name));
R.count = (v) => (R.isNumber(v) && v < 1e6 ? String(Math.round(v)) : R.number(v, 4));
R.counted = (v, one) => `${R.count(v)} ${v === 1 ? one : one + "s"}`;
R.whoseName = (whose) => (whose === "student" ? "Student" : "Solution");

/** What the maps of a scene share: size, the pixel that is looked at, the top of the scale. */
R.costView = (cost) => {
    const listeners = new Set(), ray = R.object(cost.ray);
    const maps = R.list(cost.maps).map(R.object).slice(0, 16).map((map) => ({raw: map, structure: R.text(map.structure), whose: map.whose === "student" ? "student" : "solution", picture: null}));
    const size = maps.map((map) => map.raw.embedded).find((blob) => blob && R.isNumber(blob.width) && R.isNumber(blob.height)) ?? {width: 4, height: 3};
    const inside = R.isNumber(ray.x) && R.isNumber(ray.y) && ray.x >= 0 && ray.y >= 0 && ray.x < size.width && ray.y < size.height;
    const view = {
        cost, maps, width: size.width, height: size.height, top: 10, x: null, y: null, worst: inside ? {x: ray.x, y: ray.y} : null,
        onChange: (run) => listeners.add(run),
        change: (what) => {
            Object.assign(view, what);
            listeners.forEach((run) => run(what));
        },
        at: (map, lane) => (map.picture && view.x !== null ? map.picture.rgb[3 * (view.y * view.width + view.x) + lane] : null),
        blobs: maps.map((map) => map.raw.embedded),
        unpack: () => {
            let top = 10;
            for (const map of maps) {
                const picture = R.pixels.get(map.raw.embedded);
                if (!picture || picture.width !== view.width || picture.height !== view.height) continue;
                map.picture = picture;
                for (const v of picture.rgb) if (v > top && Number.isFinite(v)) top = v;
            }
            view.change({top, ready: true, ...(view.worst ?? {})});
        },
    };
    return view;
};

R.costCanvas = (view, map, kind) => {
    const spread = R.object(map.raw[kind.key]);
    const canvas = R.h("canvas", {class: "frame", width: view.width, height: view.height, role: "img",
        "aria-label": `${R.whoseName(map.whose)}, ${R.structureName(map.structure)}: ${kind.unit}, mean ${R.number(spread.mean, 4)}, at most ${R.count(spread.max)}`});
    view.onChange((what) => {
        if (!("ready" in what) || !map.picture) return;
        const context = canvas.getContext("2d"), data = context.createImageData(view.width, view.height);
        for (let i = 0; i < view.width * view.height; ++i) data.data.set([...R.colors.cost(map.picture.rgb[3 * i + kind.lane], view.top), 255], 4 * i);
        context.putImageData(data, 0, 0);
    });
    return canvas;
};

/** Why there is nothing to draw, if there is not. */
R.costMissing = (map, kind) => {
    if (!map.raw.embedded) return [R.verdict(map.raw.verdict).tone === "good" ? "" : R.verdict(map.raw.verdict).label, R.text(map.raw.note) || R.text(map.raw.message) || "there is no map"].filter(Boolean).join(": ");
    if (kind.key === "nodes" && !(R.object(map.raw.nodes).max > 0)) return map.structure === "none" ? "Nothing to visit" : "Not counted (effort.h says how)";
    return "";
};

R.costFigure = (view, map, kind) => {
    const missing = R.costMissing(map, kind), spread = R.object(map.raw[kind.key]);
    const box = R.h("div", {class: "stage", style: {"aspect-ratio": `${view.width} / ${view.height}`}});
    const here = R.h("span", {class: "here-value"});
    if (missing) box.append(R.h("span", {class: "missing", text: missing}));
    else {
        box.append(R.costCanvas(view, map, kind), ...R.markers(view));
        box.addEventListener("pointermove", (event) => view.change(R.pixelUnder(view, event, box)));
        view.onChange(() => (here.textContent = R.isNumber(view.at(map, kind.lane)) ? R.count(view.at(map, kind.lane)) : ""));
    }
    return R.h("figure", {"data-structure": map.structure, "data-whose": map.whose}, box, R.h("figcaption", {}, R.h("span", {class: "cost-head"}, R.h("b", {text: R.structureName(map.structure)}), here),
        R.h("span", {text: missing ? "" : `mean ${R.number(spread.mean, 4)}, at most ${R.count(spread.max)}`})));
};

R.costScale = (view) => {
    const strip = R.h("canvas", {class: "strip", width: 256, height: 1, "aria-hidden": "true"}), ticks = R.h("span", {class: "ticks"});
    const context = strip.getContext("2d");
    R.colors.costTable.forEach((color, i) => {
        context.fillStyle = `rgb(${color.join(" ")})`;
        context.fillRect(i, 0, 1, 1);
    });
    const scale = R.h("div", {class: "scale", role: "img"}, strip, ticks);
    view.onChange((what) => {
        if (!("ready" in what)) return;
        const decades = Math.log10(view.top), tick = (v, name = "") => R.h("span", {class: `tick ${name}`, style: {left: `${100 * Math.log10(v) / decades}%`}, text: R.count(v)});
        // A power of ten close to the end would stand in the way of the end's own number.
        const powers = Array.from({length: Math.ceil(decades)}, (_, e) => 10 ** e).filter((v) => v > 1 && Math.log10(v) < 0.86 * decades);
        ticks.replaceChildren(tick(1, "first"), ...powers.map((v) => tick(v)), tick(view.top, "last"));
        scale.setAttribute("aria-label", `Colour scale of tests and nodes a pixel, logarithmic, from 1 to ${R.count(view.top)}`);
    });
    return R.h("div", {class: "legend"}, scale, R.h("p", {class: "keys"}, "Tests a pixel (primitives asked) and nodes a pixel (cells or nodes visited), by all of its rays; one logarithmic scale for all of these maps. ",
        R.h("span", {class: "key"}, R.h("i", {class: "k-none", "aria-hidden": "true"}), "none"), view.worst && R.h("span", {class: "key"}, R.h("i", {class: "k-worst", "aria-hidden": "true"}), "the pixel that costs most in all structures together")));
};

R.costReadout = (view) => {
    const readout = R.h("p", {class: "cost-readout", "aria-live": "polite"});
    view.onChange(() => {
        if (view.x === null) return;
        const worst = view.worst?.x === view.x && view.worst?.y === view.y ? " (the worst)" : "";
        const sides = [...new Set(view.maps.map((map) => map.whose))];
        const values = view.maps.filter((map) => map.picture).map((map) => `${sides.length > 1 ? `${R.whoseName(map.whose)}'s ` : ""}${R.structureName(map.structure).toLowerCase().replace("bvh", "BVH")} ${R.costKinds.filter((kind) => !R.costMissing(map, kind)).map((kind) => R.counted(view.at(map, kind.lane), kind.key.slice(0, -1))).join(", ")}`);
        readout.replaceChildren(R.h("b", {text: `Pixel ${view.x}, ${view.y}${worst}`}), ` ${values.join("; ")}`);
    });
    return readout;
};

R.costBoard = (view, title) => {
    const columns = [...new Set(view.maps.map((map) => map.structure))];
    const sides = ["student", "solution"].filter((whose) => view.maps.some((map) => map.whose === whose));
    const row = (kind, whose) => R.h("div", {class: "cost-row", "data-kind": kind.key, "data-whose": whose}, R.h("h5", {text: sides.length > 1 ? `${R.whoseName(whose)}: ${kind.unit}` : kind.unit[0].toUpperCase() + kind.unit.slice(1)}),
        R.h("div", {class: "cost-maps"}, ...columns.map((structure) => view.maps.find((map) => map.structure === structure && map.whose === whose)).filter(Boolean).map((map) => R.costFigure(view, map, kind))));
    const board = R.h("div", {class: "cost-board", tabindex: "0", role: "application", "aria-roledescription": "pixel inspector", style: {"--columns": columns.length},
        "aria-label": `${title}: cost maps. Arrow keys move the pixel, W goes to the worst one.`}, ...R.costKinds.flatMap((kind) => sides.map((whose) => row(kind, whose))));
    board.addEventListener("keydown", (event) => R.movePixel(view, event));
    return board;
};

R.costMaps = (step) => {
    if (!R.hasCosts(step)) return null;
    return R.h("div", {class: "group", "data-state": "pass", id: `${step.anchor}-costs`}, R.h("h3", {text: "What a pixel costs, structure by structure"}),
        R.h("div", {class: "checks cost-scenes"}, ...R.costScenes(step).map((cost) => {
            const view = R.costView(cost), name = R.sceneName(cost.scene), title = name && name[0].toUpperCase() + name.slice(1);
            return R.h("section", {class: "panel costs"}, R.h("h4", {text: title}), R.whenNear(R.costBoard(view, title), view), R.costReadout(view), R.costScale(view), R.visitedCells(view));
        })));
};
