// The cells that one camera ray visits, structure by structure, seen along the axis in which the ray moves least.
R.cellAxes = (direction) => {
    const size = direction.map(Math.abs), least = size.indexOf(Math.min(...size));
    const [a, b] = [0, 1, 2].filter((axis) => axis !== least);
    // y points up, as in the pictures.
    return a === 1 ? [b, a] : [a, b];
};

R.numbers = (list, length) => (Array.isArray(list) && list.length === length && list.every(R.isNumber) ? list : null);

/** Around all cells, a little larger, and never flatter than 1 to 3. */
R.cellFrame = (boxes, [a, b]) => {
    const range = (axis) => [Math.min(...boxes.map((box) => box[axis])), Math.max(...boxes.map((box) => box[axis + 3]))];
    const wide = (range(a)[1] - range(a)[0]) || 1e-9, high = (range(b)[1] - range(b)[0]) || 1e-9, larger = Math.max(wide, high);
    const padded = ([low, up], length) => {
        const extra = (Math.max(length, larger / 3) - length) / 2 + 0.06 * larger;
        return [low - extra, up + extra];
    };
    return [padded(range(a), wide), padded(range(b), high)];
};

R.cellDrawing = (view, map, boxes, origin, direction) => {
    const WIDTH = 320, axes = R.cellAxes(direction), [[left, right], [bottom, top]] = R.cellFrame(boxes, axes);
    const scale = WIDTH / Math.max(right - left, top - bottom), [width, height] = [(right - left) * scale, (top - bottom) * scale];
    const place = (u, v) => [((u - left) * scale).toFixed(2), ((top - v) * scale).toFixed(2)];
    const along = (t) => axes.map((axis) => origin[axis] + t * direction[axis]);
    const distance = R.object(view.cost.ray).distance, hits = R.isNumber(distance);
    // Far beyond the drawing, should the ray hit nothing; the drawing cuts it off.
    const reach = Math.hypot(...axes.map((axis, i) => Math.abs(origin[axis]) + Math.abs([left, bottom][i]) + Math.abs([right, top][i]))) / Math.hypot(...axes.map((axis) => direction[axis]));
    const from = place(...along(0)), to = place(...along(hits ? distance : reach));
    const what = map.structure === "grid" ? "cell" : "leaf", names = "xyz";
    const left_out = R.isNumber(map.raw.cells_left_out) ? map.raw.cells_left_out : 0;
    const many = R.plural(boxes.length + left_out, what, what === "leaf" ? "leaves" : "cells");
    const rects = boxes.map((box, i) => {
        const [x, y] = place(box[axes[0]], box[axes[1] + 3]), [x2, y2] = place(box[axes[0] + 3], box[axes[1]]);
        return R.svg("rect", {class: "cell", x, y, width: (x2 - x).toFixed(2), height: (y2 - y).toFixed(2)}, R.svg("title", {text: `${what} ${i + 1} of ${boxes.length + left_out}: ${box.slice(0, 3).map((v) => R.number(v, 4)).join(", ")} to ${box.slice(3).map((v) => R.number(v, 4)).join(", ")}`}));
    });
    const caption = `${many}; ${names[axes[0]]} to the right, ${names[axes[1]]} up; ${R.number(right - left, 2)} × ${R.number(top - bottom, 2)} units` + (left_out > 0 ? `; the first ${boxes.length} are drawn` : "");
    return R.h("figure", {class: "cells", "data-structure": map.structure, "data-whose": map.whose},
        R.svg("svg", {viewBox: `0 0 ${width.toFixed(2)} ${height.toFixed(2)}`, role: "img", "aria-label": `${R.whoseName(map.whose)}'s ${R.structureName(map.structure)}: the ray visits ${many}`},
            ...rects, R.svg("line", {class: "ray", x1: from[0], y1: from[1], x2: to[0], y2: to[1]}), R.svg("circle", {class: "eye", cx: from[0], cy: from[1], r: 4}), hits && R.svg("circle", {class: "hit", cx: to[0], cy: to[1], r: 4})),
        R.h("figcaption", {}, R.h("b", {text: `${R.structureName(map.structure)}${view.maps.some((m) => m.whose === "student") ? `, ${R.whoseName(map.whose).toLowerCase()}'s` : ""}`}), ` ${caption}`));
};

R.visitedCells = (view) => {
    const ray = R.object(view.cost.ray), origin = R.numbers(ray.origin, 3), direction = R.numbers(ray.direction, 3);
    if (!view.worst || !origin || !direction || direction.every((d) => d === 0)) return null;
    const boxesOf = (map) => R.list(map.raw.cells).filter((box) => R.numbers(box, 6)).slice(0, 400);
    const drawn = view.maps.filter((map) => boxesOf(map).length > 0);
    if (drawn.length === 0) return null;
    const silent = [...new Set(view.maps.filter((map) => map.raw.embedded && map.structure !== "none" && !drawn.includes(map)).map((map) => (map.whose === "student" ? "the student's " : "the solution's ") + R.structureName(map.structure).replace(/^[GO]/, (c) => c.toLowerCase())))];
    return R.h("div", {class: "visited"}, R.h("h5", {text: `What the camera ray of pixel ${view.worst.x}, ${view.worst.y} visits, each drawing at its own scale`}),
        R.h("div", {class: "cell-drawings"}, ...drawn.map((map) => R.cellDrawing(view, map, boxesOf(map), origin, direction))),
        silent.length > 0 && R.h("p", {class: "keys", text: `No drawing: ${silent.join(", ")} (a structure is drawn when it adds its boxes to effort->visited).`}));
};
