// One check: what was asked, what came out, why, and how to see it again.
R.checkArticle = (step, check) => {
    const {raw} = check;
    const good = check.tone === "good";
    const scene = check.image ? R.pictureScene(check) : null;
    const more = R.h("div", {class: "more", id: `${check.anchor}-more`});
    const left = scene && R.h("div", {class: "view-left"}, R.comparison(scene, check.title));
    const views = scene && R.whenNear(R.h("div", {class: check.image.embedded?.student ? "views" : "views alone"}, left), scene);
    const article = R.h("article", {class: "check", id: check.anchor, "data-tone": check.tone, "data-state": good ? "pass" : "open", "aria-labelledby": `${check.anchor}-title`});
    const build = () => {
        if (more.hasChildNodes()) return;
        if (check.image?.embedded?.student) {
            left.append(R.h("div", {class: "look"}, R.pictureControls(scene), R.inspector(scene)));
            if (R.hasBoth(check.image)) views.append(R.mapOf(scene, check.title));
        }
        more.append(...R.checkDetails(check).filter(Boolean));
    };
    const button = R.expandButton(check, more, article, build);
    const urgent = R.isUrgent(check);
    const words = [R.text(raw.message) && R.h("p", {class: "message", text: R.text(raw.message)}), urgent && R.diagnosis(raw)];
    const shown = [scene && R.printedPair(scene, check.title), views, check.shows && R.h("p", {class: "shows", text: check.shows}), check.chart && !check.image && R.chart(check.chart, check.title)];
    // What went wrong is read before it is looked at; what went well is looked at.
    article.append(...[R.checkHead(step, check, button), ...(!urgent ? [...shown, ...words] : [...words, ...shown]), scene && R.pictureFacts(check.image, scene), more].filter(Boolean));
    return article;
};

R.expandButton = (check, more, article, build) => {
    const button = R.h("button", {type: "button", class: "expand", "aria-controls": more.id}, R.svg("svg", {viewBox: "0 0 20 20", class: "icon", "aria-hidden": "true"}, R.svg("path", {d: "M5 8l5 5 5-5"})));
    const expand = (open) => {
        if (open) build();
        more.hidden = !open;
        article.classList.toggle("open", open);
        button.setAttribute("aria-expanded", String(open));
        button.setAttribute("aria-label", `Details of ${check.title}`);
    };
    button.addEventListener("click", () => expand(more.hidden));
    R.expanders.push({expand, urgent: R.isUrgent(check)});
    expand(R.isUrgent(check));
    return button;
};

R.checkHead = (step, check, button) => {
    const {raw} = check, task = R.task(step, raw.task);
    const taskTitle = task?.title && !check.title.startsWith(R.text(task.title)) ? ` · ${R.text(task.title)}` : "";
    const tags = [raw.task && `Task ${R.text(raw.task)}${taskTitle}`, R.text(raw.mode) === "all mine" && "with all steps yours"].filter(Boolean);
    return R.h("header", {class: "check-head"}, R.badge(check.verdict, {small: true}),
        R.h("div", {class: "check-name"}, R.h("h4", {id: `${check.anchor}-title`, text: check.title}), R.h("p", {class: "tags"}, ...tags.map((tag) => R.h("span", {text: tag})))),
        R.isNumber(raw.max) && raw.max > 0 && R.h("span", {class: "points"}, R.h("b", {text: R.points(raw.points)}), ` / ${R.points(raw.max)}`), button);
};
R.expanders = [];
/** Unfolded from the start; what is merely not started can wait. */
R.isUrgent = (check) => check.tone === "bad" || check.tone === "mixed";

R.pictureFacts = (image, scene) => {
    const notes = R.list(image.embedded?.notes).map((note) => R.h("p", {class: "note", text: R.text(note)}));
    if (!R.wasCompared(image)) return R.h("div", {class: "facts"}, ...notes);
    const share = R.isNumber(image.beyond_rounding) && R.isNumber(image.pixels) && image.pixels > 0 ? ` (${R.number(100 * image.beyond_rounding / image.pixels, 2)} %)` : "";
    const facts = scene.statistics ? R.statisticsFacts(scene) : [["pixels beyond rounding", R.isNumber(image.beyond_rounding) ? `${image.beyond_rounding}${share}` : null],
                   ["of these on silhouettes", R.isNumber(image.on_silhouettes) ? String(image.on_silhouettes) : null],
                   ["largest error", "max_error" in image ? R.number(image.max_error) : null],
                   ["RMSE", "rmse" in image ? R.number(image.rmse) : null],
                   ["tolerance for a value of 1", R.isNumber(image.tolerance) ? R.number(image.tolerance) : null]];
    return R.h("div", {class: "facts"}, R.h("dl", {}, ...facts.filter(([, v]) => v !== null).map(([k, v]) => R.h("div", {}, R.h("dt", {text: k}), R.h("dd", {text: v})))), ...notes);
};

R.checkDetails = (check) => {
    const {raw} = check;
    return [
        !R.isUrgent(check) && R.diagnosis(raw),
        check.chart && check.image && R.chart(check.chart, check.title),
        R.questions(raw),
        check.image?.trees && R.rayTrees(R.object(check.image.trees)),
        R.reproduce([check, ...check.same]),
    ];
};

R.diagnosis = (raw) => {
    const entries = R.list(raw.diagnosis).map(R.object).filter((d) => R.text(d.text));
    if (entries.length === 0) return null;
    const names = {mutant: "Looks like this mistake", tree: "First difference of the rays", picture: "What the picture shows", hint: "Hint"};
    return R.h("ul", {class: "diagnosis", "aria-label": "Diagnosis"}, ...entries.map((d) =>
        R.h("li", {"data-kind": R.text(d.kind)}, R.h("span", {class: "what", text: (names[d.kind] ?? "Note") + (d.mutant ? ` · ${R.text(d.mutant)}` : "")}), R.h("p", {text: R.text(d.text)}))));
};

R.questions = (raw) => {
    const all = R.list(raw.questions).map(R.object);
    if (all.length === 0) return null;
    const failed = all.filter((q) => q.ok !== true), passed = all.filter((q) => q.ok === true);
    const waiting = failed.every((q) => R.text(q.answer).startsWith("unfinished "));
    const line = (name, value, tone) => R.text(value) && [R.h("dt", {text: name}), R.h("dd", {"data-tone": tone}, R.h("code", {text: R.text(value)}))];
    const one = (q) => R.h("li", {class: "question"}, R.h("p", {class: "claim"}, R.badge(q.ok === true ? "pass" : "fail", {small: true}), R.h("span", {text: R.text(q.about) || "A question"})),
        R.h("dl", {}, line("asked", q.query), line("expected", q.expected), line(q.ok === true ? "answered" : "got", q.answer === "" ? "(nothing)" : q.answer, q.ok === true ? null : "bad")),
        R.text(q.scene) && R.h("details", {}, R.h("summary", {text: "The scene"}), R.h("pre", {tabindex: "0", text: R.text(q.scene)})));
    const total = (q, count) => (R.isNumber(count) ? count : q.length);
    const nFailed = total(failed, raw.questions_failed), nPassed = total(passed, raw.questions_passed);
    return R.h("section", {class: "questions"},
        failed.length > 0 && R.h("h4", {text: `${R.plural(nFailed, "question")} ${waiting ? "without an answer" : "answered wrong"}` + (nFailed > failed.length ? `, the first ${failed.length} of them` : "")}),
        failed.length > 0 && R.h("ul", {}, ...failed.map(one)),
        passed.length > 0 && R.h("details", {class: "passed"}, R.h("summary", {text: `${R.plural(nPassed, "question")} answered right` + (nPassed > passed.length ? `, ${passed.length} of them as examples` : "")}), R.h("ul", {}, ...passed.map(one))));
};

/** The command of each check that this article stands for. */
R.reproduce = (checks) => {
    const rows = checks.map((check) => check.raw).filter((raw) => R.text(raw.reproduce));
    if (rows.length === 0) return null;
    return R.h("section", {class: "reproduce"}, R.h("h4", {text: "See it again"}), ...rows.map((raw) => R.h("div", {},
        R.h("div", {class: "command"}, R.h("code", {text: R.text(raw.reproduce)}), R.copyButton(R.text(raw.reproduce), "Copy the command")),
        R.h("p", {class: "took", text: [R.text(raw.id), rows.length > 1 && (R.text(raw.mode) === "isolated" ? "this step alone" : R.text(raw.mode)), R.isNumber(raw.seconds) && `took ${R.seconds(raw.seconds)}`].filter(Boolean).join(", ")}))));
};
