// The results, and what the page asks of them.
/** Base 91: 13 bits in two digits, the characters from # to ~ but for <; a last digit alone has 6 bits. */
R.unpack91 = (text) => {
    const pairs = text.length >> 1, alone = text.length & 1, bytes = new Uint8Array((13 * pairs + 6 * alone) >> 3), digit = (i) => text.charCodeAt(i) - 35 - (text.charCodeAt(i) > 60 ? 1 : 0);
    let at = 0, bits = 0, count = 0;
    const put = (group, size) => {
        bits = (bits & 0xff) << size | group;
        for (count += size; count >= 8; count -= 8) bytes[at++] = bits >> (count - 8);
    };
    for (let i = 0; i < pairs; ++i) put(91 * digit(2 * i) + digit(2 * i + 1), 13);
    if (alone) put(digit(2 * pairs), 6);
    return bytes;
};

R.inflated = async (bytes) => new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"))).text();

// Nothing below has anything to show before; a module may wait.
R.results = R.object(JSON.parse(await R.inflated(R.unpack91(document.getElementById("results").textContent))));

/** Whose pictures stand beside POV-Ray's. */
R.who = R.object(R.results.submission).from === "solution" ? "Solution" : "Student";

/** 1_ray_casting/one_sphere.pov -> one sphere */
R.sceneName = (path) => R.text(path).split("/").pop().replace(/\.pov$/, "").replaceAll("_", " ");

/** A picture is called as its scene; what the check calls itself then says what the scene shows. */
R.names = (check) => {
    const title = R.text(check.title) || R.text(check.id);
    const scene = ["image", "statistical"].includes(check.kind) ? R.sceneName(R.object(check.image).scene) : "";
    if (!scene) return {title, shows: ""};
    return {title: scene[0].toUpperCase() + scene.slice(1), shows: title.toLowerCase() === scene.toLowerCase() ? "" : title};
};

/** The steps, and after them what was handed in: pictures and report, judged by checks of the same form. */
R.steps = [...R.list(R.results.steps), ...(R.results.handed_in ? [R.results.handed_in] : [])].map(R.object).map((step, index) => ({
    raw: step,
    anchor: `step-${index}`,
    name: R.isNumber(step.number) ? `Step ${step.number}` : step === R.results.handed_in ? "Handed in" : R.text(step.id),
    title: R.text(step.title) || R.text(step.id),
    verdict: R.text(step.verdict),
    tasks: R.list(step.tasks).map(R.object),
    checks: R.list(step.checks).map(R.object).map((check, number) => ({
        raw: check,
        anchor: `check-${index}-${number}`,
        ...R.names(check),
        verdict: R.text(check.verdict),
        tone: R.verdict(check.verdict).tone,
        // A scene made for this run, or the student's own: the truth is the solution's picture, not POV-Ray's.
        fresh: check.kind === "fresh" || check.kind === "demonstration",
        demonstration: check.kind === "demonstration" && Boolean(check.image),
        image: check.image ? R.object(check.image) : null,
        chart: check.chart ? R.object(check.chart) : null,
        same: [],  // passed checks with the very same picture, shown with this one
    })),
}));

R.checks = R.steps.flatMap((step) => step.checks);
R.needAttention = R.checks.filter((check) => check.tone !== "good");

/** The checks of a step, those that passed with the very same picture (alone and with all steps) taken together. */
R.together = (checks) => {
    const first = new Map();
    return checks.filter((check) => {
        const picture = check.image?.embedded?.student?.id;
        if (check.tone !== "good" || !picture) return true;
        const key = `${R.text(check.image.scene)} ${picture}`;
        if (!first.has(key)) return first.set(key, check);
        first.get(key).same.push(check);
        return false;
    });
};

/** The task of a step by its id. */
R.task = (step, id) => step.tasks.find((task) => task.id === id);

R.hasBoth = (image) => Boolean(image.embedded?.student && image.embedded?.reference);

/** A program that crashed left no picture: then the numbers of the comparison are zeros that mean nothing. */
R.wasCompared = (image) => R.text(image.student) !== "" && image.pixels !== 0;

/** Nothing of such a step could be run: its checks all say the same. */
R.doesNotCompile = (step) => step.verdict === "build error";

/** One check a scene for the gallery: the one that went worst. */
R.gallery = () => {
    // Among the others' steps a picture that waits hides no picture that is right by this step alone.
    const order = {bad: 0, mixed: 1, good: 2, idle: 3};
    const scenes = new Map();
    for (const check of R.checks) {
        if (!check.image || check.fresh || !(check.image.embedded?.student || check.image.embedded?.reference)) continue;
        const key = R.text(check.image.scene) || check.anchor;
        const known = scenes.get(key);
        if (!known || order[check.tone] < order[known.tone]) scenes.set(key, check);
    }
    return [...scenes.values()];
};
