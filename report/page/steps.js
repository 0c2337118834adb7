// The steps: tasks with their points, then pictures, sweeps and questions.
R.taskTable = (step) => {
    if (step.tasks.length === 0) return null;
    return R.h("div", {class: "scroll"}, R.h("table", {class: "score tasks"},
        R.h("thead", {}, R.h("tr", {}, ...["Task", "Verdict", "Points", "", "Where to write"].map((text) => R.h("th", {scope: "col"}, text || R.h("span", {class: "unseen", text: "Share of the points"}))))),
        R.h("tbody", {}, ...step.tasks.map((task) => {
            const tone = R.verdict(task.verdict).tone, file = R.text(task.file);
            return R.h("tr", {"data-tone": tone, "data-state": tone === "good" ? "pass" : "open"},
                R.h("th", {scope: "row"}, R.h("span", {class: "task-id", text: R.text(task.id)}), R.text(task.title)),
                R.h("td", {}, R.badge(task.verdict)), R.h("td", {class: "points"}, R.h("b", {text: R.points(task.points)}), ` / ${R.points(task.max)}`),
                R.h("td", {class: "bar-cell"}, R.bar(task.points, task.max, R.text(task.title))),
                R.h("td", {class: "where"}, file && R.h("code", {text: file.split("/").pop() + (R.isNumber(task.line) && task.line > 0 ? `:${task.line}` : ""), title: file}), (tone === "bad" || tone === "mixed") && !R.doesNotCompile(step) && R.text(task.hint) && R.h("p", {class: "hint", text: R.text(task.hint)})));
        }))));
};

/** The same for every check of the step, so told once, and as the compiler wrote it: its arrows point at columns. */
R.compilerMessage = (step) => R.doesNotCompile(step) && R.h("div", {class: "panel compiler"}, R.h("h3", {text: `${step.name} does not compile`}),
    R.h("pre", {tabindex: "0", text: R.text(step.checks[0]?.raw.message) || "The compiler said nothing."}));

/** Most of a page on unfinished work would be about what is not there yet: more than a few of these go behind a fold. */
R.folded = (checks) => {
    const FEW = 3, plain = (box) => box;
    const waiting = checks.filter((check) => check.verdict === "not started");
    if (waiting.length <= FEW) return [[checks, plain]];
    const others = checks.filter((check) => check.verdict !== "not started");
    const fold = (box) => {
        const details = R.h("details", {class: "waiting"}, R.h("summary", {text: `${R.plural(waiting.length, "check")} not started`}), box);
        R.expanders.push({expand: (open) => (details.open = open), urgent: false});
        return details;
    };
    return [...(others.length > 0 ? [[others, plain]] : []), [waiting, fold]];
};

R.stepSection = (step) => {
    const groups = [["Pictures against POV-Ray's", "pictures", (c) => c.image && !c.fresh], ["Where the method must hold", "charts", (c) => c.chart && !c.image], [step.raw === R.results.handed_in ? "What they have to show, and the report" : "Questions and fresh scenes", "texts", (c) => !c.demonstration && (c.fresh || (!c.image && !c.chart))],
        ["Pictures handed in, rendered again and against the solution's", "pictures", (c) => c.demonstration]];
    const section = R.h("section", {class: "step", id: step.anchor, "aria-labelledby": `${step.anchor}-title`},
        R.h("div", {class: "section-head step-head"}, R.h("div", {}, R.h("p", {class: "kicker", text: step.name}), R.h("h2", {id: `${step.anchor}-title`, text: step.title})),
            R.h("div", {class: "step-score"}, R.badge(step.verdict), R.h("span", {class: "points"}, R.h("b", {text: R.points(step.raw.points)}), ` / ${R.points(step.raw.max)}`))),
        R.text(step.raw.message) && R.h("p", {class: "notice", text: R.text(step.raw.message)}), R.compilerMessage(step), R.taskTable(step));
    if (R.doesNotCompile(step)) return section;
    const together = R.together(step.checks);
    const order = {bad: 0, mixed: 1, idle: 2, good: 3};
    for (const [title, name, belongs] of groups) {
        const checks = together.filter(belongs).sort((a, b) => order[a.tone] - order[b.tone]);
        if (checks.length === 0) continue;
        const good = checks.every((check) => check.tone === "good");
        section.append(R.h("div", {class: "group", "data-state": good ? "pass" : "open"},
            R.h("h3", {text: title}), ...R.folded(checks).map(([list, wrap]) => wrap(R.h("div", {class: `checks ${name}`}, ...list.map((check) => R.checkArticle(step, check)))))));
    }
    const costs = R.costMaps(step);
    if (costs) section.append(costs);
    if (R.text(step.raw.report)) section.append(R.h("div", {class: "group", "data-state": "open"}, R.h("h3", {text: "The report as it was handed in"}), R.h("div", {class: "notice", text: R.text(step.raw.report)})));
    if (step.checks.length > 0 && step.checks.every((check) => check.tone === "good")) section.append(R.h("p", {class: "all-passed", text: "Everything in this step passed."}));
    return section;
};

R.rail = () => {
    const link = (href, ...content) => R.h("a", {href}, ...content);
    return [R.h("p", {class: "brand"}, R.svg("svg", {viewBox: "0 0 32 32", "aria-hidden": "true"}, R.svg("circle", {cx: 19, cy: 18, r: 8, class: "brand-ball"}), R.svg("path", {d: "M3 5l10 8.500M13 13.500l-9 13", class: "brand-ray"})), "Raysteps"),
        R.h("ul", {class: "rail-list"},
            (R.steps.length > 0 || !R.hasSpeed) && R.h("li", {}, link("#overview", R.h("span", {text: "Score"}))),
            R.gallery().length > 0 && R.h("li", {}, link("#pictures", R.h("span", {text: "Pictures"}))),
            ...R.steps.map((step) => R.h("li", {}, link(`#${step.anchor}`, R.badge(step.verdict, {small: true}), R.h("span", {text: `${step.name} · ${step.title}`})),
                R.h("ul", {class: "rail-tasks"}, ...step.tasks.map((task) => {
                    const check = !R.doesNotCompile(step) && (step.checks.find((c) => c.raw.task === task.id && c.tone !== "good") ?? step.checks.find((c) => c.raw.task === task.id));
                    const tone = R.verdict(task.verdict).tone;
                    return R.h("li", {"data-state": tone === "good" ? "pass" : "open"}, link(check ? `#${check.anchor}` : `#${step.anchor}`, R.badge(task.verdict, {small: true}),
                        R.h("span", {text: `${R.text(task.id)} ${R.text(task.title)}`})));
                }), R.hasCosts(step) && R.h("li", {"data-state": "pass"}, link(`#${step.anchor}-costs`, R.h("span", {text: "What a pixel costs"})))))),
            R.hasSpeed && R.h("li", {"data-state": "pass"}, link("#speed", R.h("span", {text: "Speed against accuracy"}))),
            R.h("li", {}, link("#machine", R.h("span", {text: "Machine and versions"})))),
        R.h("div", {class: "rail-tools"}, R.filterSwitch(), R.expandSwitch(), R.themeSwitch())];
};
