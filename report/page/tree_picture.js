// A ray tree as a picture: a branch for every ray, as wide as the share of the pixel that it may carry, its end in the
// colour that it brought home. Drawn from the lines of the tree's text.
R.treeRays = (lines) => {
    const rays = [];
    const above = [];
    lines.forEach((line, i) => {
        const found = /^( *)(\w+) ray from .*?: (.*)$/.exec(line);
        if (!found) return;
        const depth = found[1].length / 2;
        const brought = /-> radiance \(([^)]*)\), weight ([-+.\deE]+)/.exec(found[3]);
        const ray = {
            line: i, kind: found[2], depth, text: line.trim(), children: [],
            radiance: brought ? brought[1].split(",").map(Number) : null,
            weight: brought ? Number(brought[2]) : 0,
            pruned: found[3].startsWith("not traced"),
            blocked: found[3].startsWith("blocked"),
        };
        above.length = depth;
        above[depth - 1]?.children.push(ray);
        above[depth] = ray;
        rays.push(ray);
    });
    return rays;
};

// Leaves side by side (shadow rays closer), everything else above the middle of its children.
R.placeTree = (root) => {
    let leaves = 0, depth = 0;
    const place = (ray) => {
        depth = Math.max(depth, ray.depth);
        ray.children.forEach(place);
        const last = ray.children.length - 1;
        const room = ray.kind === "shadow" ? 0.5 : 1;
        ray.x = last < 0 ? (leaves += room) - room / 2 : (ray.children[0].x + ray.children[last].x) / 2;
    };
    place(root);
    return {leaves, depth};
};

R.treePicture = (lines, firstDifference, whose) => {
    const rays = R.treeRays(lines);
    // A shadow ray alone makes no tree, and thousands of rays no picture.
    if (rays.length < 3 || rays.length > 600 || rays[0].depth !== 0) return null;
    const {leaves, depth} = R.placeTree(rays[0]);
    const across = Math.max(14, Math.min(44, 560 / leaves)), down = 42, edge = 16;
    const at = (ray) => [edge + ray.x * across, edge + ray.depth * down];
    const shown = (v) => Math.round(255 * Math.min(1, Math.max(0, Number.isFinite(v) ? v : 0)) ** (1 / 2.2));
    const branches = [], ends = [];
    for (const ray of rays) {
        const [x, y] = at(ray);
        for (const child of ray.children) {
            const [cx, cy] = at(child);
            branches.push(R.svg("path", {
                class: "branch", d: `M${x} ${y}C${x} ${y + down / 2} ${cx} ${cy - down / 2} ${cx} ${cy}`,
                "data-kind": child.kind, "data-cut": child.pruned || child.blocked,
                "stroke-width": child.kind === "shadow" ? 1 : (1 + 6 * Math.sqrt(Math.min(1, Math.max(0, child.weight)))).toFixed(2),
            }));
        }
        const dot = R.svg("circle", {
            cx: x, cy: y, r: ray.kind === "shadow" ? 3 : 6, class: ray.line === firstDifference ? "end first-difference" : "end",
            "data-kind": ray.kind, "data-cut": ray.pruned || ray.blocked,
            style: ray.radiance && !ray.pruned ? {fill: `rgb(${ray.radiance.map(shown).join(" ")})`} : {},
        }, R.svg("title", {text: ray.text}));
        ends.push(dot);
    }
    const width = 2 * edge + leaves * across, height = 2 * edge + depth * down;
    return R.h("figure", {class: "tree-picture"},
        R.svg("svg", {viewBox: `0 0 ${width} ${height}`, width, height, role: "img",
            "aria-label": `Picture of the ray tree of ${whose}: ${rays.length} rays, ${rays.filter((ray) => ray.pruned).length} of them not traced`},
        ...branches, ...ends));
};

R.treeKey = () => R.h("p", {class: "tree-key"}, ...["reflected", "refracted", "transmitted", "shadow"].map((kind) =>
    R.h("span", {data: {kind}, text: kind})), R.h("span", {data: {cut: "true"}, text: "not traced, or blocked"}),
    R.h("span", {class: "hint", text: "width: share of the pixel at most; dot: what came back"}));
