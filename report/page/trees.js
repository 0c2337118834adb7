// Two ray trees side by side; the first line that differs is what went wrong first.
R.rayTrees = (trees) => {
    const texts = ["student", "solution"].map((whose) => R.text(trees[whose]).replace(/\n$/, "").split("\n"));
    const count = Math.max(texts[0].length, texts[1].length);
    let first = 0;
    while (first < count && texts[0][first] === texts[1][first]) ++first;
    const column = (name, lines, other) => {
        const list = R.h("ol", {class: "tree", tabindex: "0", "aria-label": `Ray tree of ${name}`});
        lines.forEach((line, i) => {
            const indent = line.length - line.trimStart().length;
            const item = R.h("li", {style: {"--indent": Math.min(indent, 40)}, text: line.trim()});
            if (i === first) {
                item.classList.add("first-difference");
                item.prepend(R.h("strong", {text: "First difference "}));
            } else if (i > first && line !== other[i]) {
                item.classList.add("differs");
            }
            list.append(item);
        });
        return R.h("div", {class: "tree-column"}, R.h("h5", {text: name}), R.treePicture(lines, first, name), list);
    };
    const says = R.text(trees.first_difference);
    return R.h("section", {class: "trees"}, R.h("h4", {text: "Ray tree of the worst pixel"}),
        says && R.h("p", {class: "says", text: says}),
        texts.some((lines) => R.treePicture(lines, -1, "")) && R.treeKey(),
        R.h("div", {class: "tree-pair"}, column("the student", texts[0], texts[1]), column("the solution", texts[1], texts[0])));
};
