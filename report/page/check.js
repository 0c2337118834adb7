// One check: what was asked, what came out, why, and how to see it again.
R.checkArticle = (step, check) => {
    const {raw} = check;
    const good = check.tone === "good";
    const scene = check.image ? R.pictureScene(check) : null;
    const more = R.h("div", {class: "more", id: `${check.anchor}-more`});
    const article = R.h("article", {class: "check", id: check.anchor, "data-tone": check.tone, "data-state": good ? "pass" : "open",
        "data-shows": check.image ? "picture" : check.chart ? "chart" : "text", "aria-labelledby": `${check.anchor}-title`});

    let built = false;
    const build = () => {
        if (built) return;
        built = true;
        more.append(...R.checkDetails(check, scene).filter(Boolean));
    };
    const button = R.h("button", {type: "button", class: "expand", "aria-controls": more.id, "aria-expanded": "false"});
    const expand = (open) => {
        if (open) build();
        more.hidden = !open;
        article.classList.toggle("open", open);
        button.setAttribute("aria-expanded", String(open));
        button.textContent = open ? "Less" : "Details";
        button.setAttribute("aria-label", `${open ? "Less" : "Details"} of ${check.title}`);
    };
    button.addEventListener("click", () => expand(more.hidden));
    R.expanders.push({expand, isOpen: () => !more.hidden, good});

    const task = R.task(step, raw.task);
    const tags = [raw.task && `task ${R.text(raw.task)}${task?.title ? ` · ${R.text(task.title)}` : ""}`, R.text(raw.kind), R.text(raw.mode) === "isolated" ? "this step alone" : R.text(raw.mode)].filter(Boolean);
    article.append(
        R.h("header", {class: "check-head"}, R.badge(check.verdict, {small: true}),
            R.h("div", {class: "check-name"}, R.h("h4", {id: `${check.anchor}-title`, text: check.title}),
                R.h("p", {class: "tags"}, ...tags.map((tag) => R.h("span", {text: tag})))),
            R.isNumber(raw.max) && R.h("span", {class: "points"}, R.h("b", {text: R.points(raw.points)}), ` / ${R.points(raw.max)}`)));
    if (scene) article.append(R.comparison(scene, check.title), R.printedPair(scene, check.title));
    if (check.chart && !check.image) article.append(R.chart(check.chart, check.title));
    if (R.text(raw.message)) article.append(R.h("p", {class: "message", text: R.text(raw.message)}));
    if (scene) article.append(R.pictureFacts(check.image));
    article.append(R.h("div", {class: "check-foot"}, button), more);
    expand(!good);
    return article;
};
R.expanders = [];

R.pictureFacts = (image) => {
    const share = R.isNumber(image.beyond_rounding) && R.isNumber(image.pixels) && image.pixels > 0 ? ` (${R.number(100 * image.beyond_rounding / image.pixels, 2)} %)` : "";
    const facts = [["pixels beyond rounding", R.isNumber(image.beyond_rounding) ? `${image.beyond_rounding}${share}` : null],
                   ["of these on silhouettes", R.isNumber(image.on_silhouettes) ? String(image.on_silhouettes) : null],
                   ["largest error", "max_error" in image ? R.number(image.max_error) : null],
                   ["RMSE", "rmse" in image ? R.number(image.rmse) : null],
                   ["tolerance", R.isNumber(image.tolerance) ? R.number(image.tolerance) : null]];
    const notes = R.list(image.embedded?.notes).map((note) => R.h("p", {class: "note", text: R.text(note)}));
    return R.h("div", {class: "facts"}, R.h("dl", {}, ...facts.filter(([, v]) => v !== null).map(([k, v]) => R.h("div", {}, R.h("dt", {text: k}), R.h("dd", {text: v})))), ...notes);
};

R.checkDetails = (check, scene) => {
    const {raw} = check;
    return [
        R.diagnosis(raw),
        scene && R.h("section", {class: "look"},
            scene.image.embedded?.student && scene.image.embedded?.reference ? R.errorMap(scene, check.title) : null,
            R.h("div", {class: "look-side"}, R.pictureControls(scene), R.inspector(scene))),
        check.chart && check.image && R.chart(check.chart, check.title),
        R.questions(raw),
        check.image?.trees && R.rayTrees(R.object(check.image.trees)),
        R.reproduce(raw),
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
    const line = (name, value, tone) => R.text(value) && [R.h("dt", {text: name}), R.h("dd", {"data-tone": tone}, R.h("code", {text: R.text(value)}))];
    const one = (q) => R.h("li", {class: "question"}, R.h("p", {class: "claim"}, R.badge(q.ok === true ? "pass" : "fail", {small: true}), R.h("span", {text: R.text(q.about) || "A question"})),
        R.h("dl", {}, line("asked", q.query), line("expected", q.expected), line(q.ok === true ? "answered" : "got", q.answer === "" ? "(nothing)" : q.answer, q.ok === true ? null : "bad")),
        R.text(q.scene) && R.h("details", {}, R.h("summary", {text: "The scene"}), R.h("pre", {tabindex: "0", text: R.text(q.scene)})));
    const total = (q, count) => (R.isNumber(count) ? count : q.length);
    const nFailed = total(failed, raw.questions_failed), nPassed = total(passed, raw.questions_passed);
    return R.h("section", {class: "questions"},
        failed.length > 0 && R.h("h4", {text: `${R.plural(nFailed, "question")} answered wrong` + (nFailed > failed.length ? `, the first ${failed.length} of them` : "")}),
        failed.length > 0 && R.h("ul", {}, ...failed.map(one)),
        passed.length > 0 && R.h("details", {class: "passed"}, R.h("summary", {text: `${R.plural(nPassed, "question")} answered right` + (nPassed > passed.length ? `, ${passed.length} of them as examples` : "")}), R.h("ul", {}, ...passed.map(one))));
};

R.reproduce = (raw) => {
    const command = R.text(raw.reproduce);
    if (!command) return null;
    return R.h("section", {class: "reproduce"}, R.h("h4", {text: "See it again"}),
        R.h("div", {class: "command"}, R.h("code", {text: command}), R.copyButton(command, "Copy the command")),
        R.isNumber(raw.seconds) && R.h("p", {class: "took", text: `took ${R.seconds(raw.seconds)}`}));
};
