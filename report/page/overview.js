// The top of the page: the score, what it is made of, the pictures, and with what it was made.
R.ring = (points, max) => {
    const circumference = 2 * Math.PI * 52, share = R.share(points, max);
    const arc = R.svg("circle", {class: "ring-arc", cx: 60, cy: 60, r: 52, "stroke-dasharray": `${circumference * share} ${circumference}`, transform: "rotate(-90 60 60)"});
    return R.h("div", {class: "ring", role: "img", "aria-label": `Score: ${R.points(points)} of ${R.points(max)} points`},
        R.svg("svg", {viewBox: "0 0 120 120", "aria-hidden": "true"}, R.svg("circle", {class: "ring-track", cx: 60, cy: 60, r: 52}), share > 0 && arc),
        R.h("p", {"aria-hidden": "true"}, R.h("b", {text: R.isNumber(points) ? R.points(Number(points.toFixed(1))) : "–"}), R.h("span", {text: `of ${R.points(max)}`})));
};

R.sentence = () => {
    const count = R.checks.length, open = R.needAttention.length;
    if (R.results.status === "infrastructure error") return ["idle", "Not graded: the grader itself had a problem"];
    const broken = R.steps.filter(R.doesNotCompile).map((step) => step.name);
    if (broken.length > 0) return ["bad", broken.length === 1 ? `${broken[0]} does not compile` : `${R.plural(broken.length, "step")} do not compile`];
    if (count === 0) return ["idle", "Nothing has been checked yet"];
    if (open === 0) return ["good", count === 1 ? "The check passed" : `All ${count} checks passed`];
    if (R.checks.every((check) => check.verdict === "not started")) return ["idle", "Nothing has been started yet"];
    return [R.needAttention.some((check) => check.tone === "bad") ? "bad" : "mixed", `${count - open} of ${R.plural(count, "check")} passed`];
};

R.hero = () => {
    const {results} = R;
    const submission = R.object(results.submission), score = R.object(results.score);
    const [tone, words] = R.sentence();
    const from = {student: "the student's steps", solution: "the solutions"}[submission.from] ?? R.text(submission.from);
    return R.h("header", {class: "hero", id: "overview"}, R.ring(score.points, score.max),
        R.h("div", {class: "hero-words"}, R.h("p", {class: "kicker", text: "Raysteps report"}),
            R.h("h1", {text: words, "data-tone": tone}),
            R.h("p", {class: "who"}, R.h("span", {class: "name", text: R.text(submission.name) || "submission"}), from && R.h("span", {text: from}),
                R.h("span", {text: R.when(results.created)}), R.isNumber(results.seconds) && R.h("span", {text: `graded in ${R.seconds(results.seconds)}`})),
            results.complete === false && R.h("p", {class: "notice", role: "note", text: "Grading has not finished: this is what is known so far."}),
            R.text(results.message) && R.h("p", {class: "notice", role: "note", text: R.text(results.message)})),
        R.h("div", {class: "hero-steps"}, ...R.steps.map((step) => R.h("a", {href: `#${step.anchor}`, class: "hero-step"},
            R.h("span", {class: "hero-step-name", text: `${step.name} · ${step.title}`}), R.h("span", {class: "points"}, R.h("b", {text: R.points(step.raw.points)}), ` / ${R.points(step.raw.max)}`),
            R.bar(step.raw.points, step.raw.max, step.title)))));
};

// The solutions' page shows what each step is for.
R.heroes = () => {
    const words = ["Ray casting", "Light and shadow", "Mirrors and glass", "Eighty thousand spheres", "Lens, lamps, motion"];
    const pictures = [...document.getElementById("heroes").querySelectorAll("img")];
    if (pictures.length === 0) return null;
    return R.h("section", {class: "heroes", "aria-label": "A picture for each step"}, ...pictures.map((img) => {
        const step = Number(img.dataset.step), text = `Step ${step}: ${words[step - 1] ?? ""}`;
        img.alt = text;
        return R.h("figure", {}, img, R.h("figcaption", {text}));
    }));
};

R.galleryWall = () => {
    const checks = R.gallery();
    if (checks.length === 0) return null;
    const tiles = checks.map((check, index) => {
        const scene = R.pictureScene(check);
        const whose = check.image.embedded.student ? "student" : "reference";
        const name = check.title;
        return R.h("li", {"data-state": check.tone === "good" ? "pass" : "open"}, R.h("button", {type: "button", class: "tile", "data-tone": check.tone, "aria-label": `Show ${name}: ${R.verdict(check.verdict).label}`, on: {click: () => R.show(checks, index)}},
            R.whenNear(R.frameCanvas(scene, whose, name), scene), R.h("span", {class: "tile-name"}, R.badge(check.verdict, {small: true}), R.h("span", {text: name}), whose === "reference" && R.h("em", {text: "POV-Ray's"}))));
    });
    return R.h("section", {class: "gallery", id: "pictures", "aria-labelledby": "pictures-title"},
        R.h("div", {class: "section-head"}, R.h("h2", {id: "pictures-title", text: "Pictures"}),
            R.h("button", {type: "button", class: "quiet", text: "Show them large", on: {click: () => R.show(checks, 0)}})),
        R.h("ul", {class: "wall"}, ...tiles));
};

/** One picture after the other, as large as the window: for a lecture hall. */
R.show = (checks, start) => {
    let index = start;
    const body = R.h("div", {class: "show-body"});
    const dialog = R.h("dialog", {class: "show", "aria-label": "Pictures, large"});
    const go = (by) => {
        index = (index + by + checks.length) % checks.length;
        const check = checks[index], scene = R.pictureScene(check);
        const map = R.hasBoth(check.image) && R.mapOf(scene, check.title);
        const size = {"--ratio": scene.width / scene.height};
        body.replaceChildren(
            R.h("header", {}, R.badge(check.verdict), R.h("div", {}, R.h("h2", {text: check.title}), check.shows && R.h("p", {class: "shows", text: check.shows})), R.h("span", {class: "count", text: `${index + 1} / ${checks.length}`})),
            R.h("div", {class: map ? "show-stage two" : "show-stage", style: size},
                R.h("div", {class: "view-left"}, R.comparison(scene, check.title), R.h("div", {class: "look"}, R.pictureControls(scene), R.inspector(scene))), map || null));
        scene.unpack();
    };
    const button = (text, label, run) => R.h("button", {type: "button", text, "aria-label": label, on: {click: run}});
    dialog.append(body, R.h("div", {class: "show-buttons"}, button("‹", "Previous picture", () => go(-1)), button("›", "Next picture", () => go(1)), button("✕", "Close", () => dialog.close())));
    dialog.addEventListener("keydown", (event) => {
        const by = {PageDown: 1, PageUp: -1, n: 1, p: -1}[event.key];
        if (!by || event.target.closest("img-comparison-slider") && event.key.startsWith("Page")) return;
        event.preventDefault();
        go(by);
    });
    dialog.addEventListener("close", () => dialog.remove());
    document.body.append(dialog);
    go(0);
    dialog.showModal();
};

R.rubric = () => {
    const rows = R.list(R.results.rubric).map(R.object);
    if (rows.length === 0) return null;
    return R.h("section", {class: "panel"}, R.h("h2", {text: "Rubric"}), R.h("div", {class: "scroll"}, R.h("table", {class: "score"},
        R.h("thead", {}, R.h("tr", {}, ...["Row", "Points", "", "Counts"].map((text) => R.h("th", {scope: "col"}, text || R.h("span", {class: "unseen", text: "Share of the points"}))))),
        R.h("tbody", {}, ...rows.map((row) => R.h("tr", {class: row.graded === false ? "ungraded" : null}, R.h("th", {scope: "row"}, R.text(row.title) || R.text(row.id), row.extra === true && R.h("span", {class: "extra", text: "extra"})),
            R.h("td", {class: "points"}, row.graded === false ? "–" : R.h("b", {text: R.points(row.points)}), ` / ${R.points(row.max)}`), R.h("td", {class: "bar-cell"}, row.graded === false ? null : R.bar(row.points, row.max, R.text(row.title))), R.h("td", {class: "note", text: R.text(row.note)})))))));
};

R.colophon = () => {
    const {results} = R;
    const versions = R.object(results.versions), machine = R.object(results.machine), sandbox = R.object(results.sandbox);
    const limits = Object.entries(R.object(sandbox.limits)).map(([key, value]) => `${key.replaceAll("_", " ")} ${R.text(value)}`).join(", ");
    const facts = [["Processor", [R.text(machine.cpu), R.isNumber(machine.cores) && R.plural(machine.cores, "core")].filter(Boolean).join(", ")], ["System", R.text(machine.os)],
        ...Object.entries(versions).map(([key, value]) => [{raysteps: "Raysteps", povray: "POV-Ray", compiler: "Compiler", real: "Geometry in"}[key] ?? key, R.text(value)]),
        ["Sandbox", [R.text(sandbox.tier), limits].filter(Boolean).join(": ")], ["Seed", R.text(results.seed)], ["Schema", R.text(results.schema)]];
    return R.h("section", {class: "panel colophon", id: "machine"}, R.h("h2", {text: "Machine and versions"}),
        R.h("dl", {}, ...facts.filter(([, value]) => value).map(([key, value]) => R.h("div", {}, R.h("dt", {text: key}), R.h("dd", {text: value})))),
        R.h("details", {}, R.h("summary", {text: "Licences of the libraries in this page"}), R.h("pre", {tabindex: "0", text: document.getElementById("notices").textContent})));
};
