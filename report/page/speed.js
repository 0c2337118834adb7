// The section "Speed against accuracy": what ./rays chart has measured, by step.
R.measured = R.object(R.results.measured);
R.hasSpeed = R.list(R.measured.charts).length > 0 || Boolean(R.text(R.measured.problem));

R.speed = ({heading = "h2"} = {}) => {
    if (!R.hasSpeed) return null;
    const charts = R.list(R.measured.charts).map(R.object), machine = R.object(R.measured.machine), versions = R.object(R.measured.versions);
    const facts = [[R.text(machine.cpu), R.isNumber(machine.cores) && R.plural(machine.cores, "core")].filter(Boolean).join(", "), R.text(versions.compiler), versions.povray && `POV-Ray ${R.text(versions.povray)}`,
        charts.length > 0 && R.when(charts.at(-1).created)].filter(Boolean).join(" · ");
    return R.h("section", {class: "step speed", id: "speed", "data-state": "pass", "aria-labelledby": "speed-title"},
        R.h("div", {class: "section-head step-head"}, R.h("div", {}, R.h("p", {class: "kicker", text: facts}), R.h(heading, {id: "speed-title", text: "Speed against accuracy"}))),
        R.text(R.measured.problem) && R.h("p", {class: "notice", text: R.text(R.measured.problem)}),
        ...[...R.groupBy(charts, (c) => c.step)].map(([step, list]) => R.h("div", {class: "group"}, R.h("h3", {text: `Step ${R.text(step)}`}),
            R.h("div", {class: "checks charts"}, ...list.map((chart) => R.h("div", {class: "check"}, R.speedChart(chart)))))));
};
