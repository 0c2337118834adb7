// Invented results of the grader: one run in which all is well, one that went wrong in every way, one that is hostile.
import {execFileSync} from "node:child_process";
import {mkdirSync, writeFileSync} from "node:fs";
import {join} from "node:path";

const SCENES = ["one_sphere", "concave_polygon", "polygon_with_hole", "inside_a_sphere", "far_small_sphere", "grazing_plane", "asymmetric",
    "sheared_objects", "torus_knot", "bicubic_patch", "open_cone", "quadrics", "mesh_of_triangles", "highlight_study", "shadow_study",
    "light_behind", "three_lights", "spotlight", "fading", "metallic", "checkers", "smooth_triangles", "parallel_light", "ambient_only", "blinn_and_phong"];
const TASKS = {
    1: [["1.1", "Camera rays", 6], ["1.2", "Plane", 4], ["1.3", "Sphere", 8], ["1.4", "Triangle", 6], ["1.5", "Polygon with holes", 8], ["1.6", "Quadric", 4], ["1.7", "Torus", 4]],
    2: [["2.1", "Ambient and diffuse", 10], ["2.2", "Phong highlight", 10], ["2.3", "Shadow rays", 12], ["2.4", "Spotlight and fading", 8]],
};
const TOLERANCE = 1 / 2048 + 3e-5, TOLERANCE_ABSOLUTE = 1e-5;

const tree = (kind) => ["camera ray from (0, 1, -5) along (0.124, -0.031, 0.9918): object 0 at t=4.21903, point (0.5232, 0.8692, -0.8155), normal (0.4, 0.25, -0.88) -> radiance (0.41, 0.22, 0.09)",
    `  shadow ray from (0.5232, 0.8692, -0.8155) along (0.577, 0.577, -0.577): ${kind === "student" ? "blocked" : "free"}`,
    "  shadow ray from (0.5232, 0.8692, -0.8155) along (-0.7, 0.71, 0.1): free"].join("\n") + "\n";

const sweep = (naiveBreaksAt, student) => ({
    title: "Sphere of radius 1, seen from farther and farther away", x_label: "distance / radius", y_label: "relative error of t", log_x: true, log_y: true, pass_from: 1, pass_to: 1e8,
    series: [["solution", "solution", (x) => 1.1e-16 * Math.sqrt(Math.log10(x) + 1)], ["student", "student", student], ["textbook formula", "naive", (x) => (x > naiveBreaksAt ? null : Math.min(1, 1e-16 * x * x))]]
        .map(([name, role, f]) => ({name, role, points: Array.from({length: 13}, (_, i) => [10 ** (i * 0.75), f(10 ** (i * 0.75))])})),
});

const image = (scene, number, mistake = 0) => ({
    scene: `${number < 13 ? "1_ray_casting" : "2_phong"}/${scene}.pov`, student: `pictures/student-${number}-${mistake}.exr`, reference: `pictures/reference-${number}.exr`,
    width: 160, height: 120, pixels: 19200, beyond_rounding: mistake ? 612 : 3, on_silhouettes: mistake ? 9 : 3, max_error: mistake ? 0.7013 : 0.00024, rmse: mistake ? 0.031 : 0.00006, tolerance: TOLERANCE, tolerance_absolute: TOLERANCE_ABSOLUTE,
    worst: {x: 101, y: 44, student: [0.25, 0.5, 0.125], reference: [0.2501, 0.5001, 0.1249]},
});

const questions = (task, failed) => Array.from({length: 24}, (_, i) => ({
    about: `task ${task}: ${["origin inside the sphere: the far root", "grazing within one ulp", "a miss stays a miss", "the range ends before the hit"][i % 4]}`,
    query: `nearest 0 0 ${-5 - i} 0 0 1 1e-6 inf`, scene: "camera { location <0, 0, -5> }\nsphere { <0, 0, 0>, 1 pigment { color rgb <1, 0.5, 0.2> } }\n",
    expected: `hit ${(4 + i).toFixed(12)} 0 0 -1`, answer: i < failed ? `hit ${(6 + i).toFixed(12)} 0 0 1` : `hit ${(4 + i).toFixed(12)} 0 0 -1`, ok: i >= failed,
}));

const base = () => ({
    schema: "raysteps-results/1", created: "2026-01-31T12:00:00Z", submission: {name: "working copy", from: "solution"},
    machine: {cpu: "AMD EPYC 7B13", cores: 2, os: "Debian GNU/Linux 12 (bookworm)"}, versions: {raysteps: "0.1.0", povray: "3.7.0.10.unofficial", compiler: "GCC 12.2.0", real: "double"},
    sandbox: {tier: "limits", limits: {cpu_s: 20, memory_mb: 2048, processes: 64, output_mb: 64}}, seed: 123, seconds: 12.34, status: "graded", message: "",
});

const check = (task, kind, title, verdict, more) => ({id: `${task}.${kind}`, task, kind, mode: "isolated", title, verdict, points: verdict === "pass" ? 4 : 0, max: 4,
    message: "", reproduce: `./rays grade ${task[0]} --seed 123`, seconds: 0.41, diagnosis: [], ...more});

const step = (number, checks) => {
    const tasks = TASKS[number].map(([id, title, max]) => {
        const bad = checks.find((c) => c.task === id && c.verdict !== "pass");
        return {id, title, max, points: bad ? 0 : max, verdict: bad ? bad.verdict : "pass", hint: "Which of the two roots is the first one in front of the origin?", file: `steps/${number}_x/file.cpp`, line: 40 + 13 * Number(id[2])};
    });
    const sum = (key) => tasks.reduce((s, t) => s + t[key], 0);
    return {id: number === 1 ? "1_ray_casting" : "2_phong", number, title: number === 1 ? "Ray casting" : "Phong", verdict: sum("points") === sum("max") ? "pass" : sum("points") ? "partial" : "fail",
        points: sum("points"), max: sum("max"), tasks, checks};
};

const finished = (results) => {
    const sum = (key) => results.steps.reduce((s, t) => s + t[key], 0);
    results.score = {points: sum("points"), max: sum("max")};
    results.rubric = [["spheres", "Spheres", 20], ["polygons", "Polygons", 20], ["phong", "Phong", 20], ["pictures", "Representative pictures", 20], ["reflection", "Recursive reflection", 20]]
        .map(([id, title, max], i) => ({id, title, max, points: i < 3 ? max * sum("points") / sum("max") : 0, extra: false, note: i < 3 ? "" : "comes with a later step"}));
    return results;
};

const numberOf = (i) => (i < 13 ? 1 : 2);
const taskOf = (i) => TASKS[numberOf(i)][i % TASKS[numberOf(i)].length][0];

/** Scenes enough of each step for what pages show; opening a page of all takes the tests' browser seconds. */
const FEW = (i) => i < 8 || (i >= 13 && i < 16);

export const good = (has = FEW) => {
    const results = base();
    results.steps = [1, 2].map((number) => step(number, [
        ...SCENES.flatMap((scene, i) => (has(i) && numberOf(i) === number ? [check(taskOf(i), "image", scene.replaceAll("_", " "), "pass", {message: "Every pixel within rounding but 3 on silhouettes.", image: image(scene, i)})] : [])),
        ...SCENES.flatMap((scene, i) => (has(i) && numberOf(i) === number ? [check(taskOf(i), "image", scene.replaceAll("_", " "), "pass", {mode: "all mine", points: 0, max: 0, message: "Every pixel within rounding but 3 on silhouettes.", image: image(scene, i)})] : [])),
        ...TASKS[number].map(([id, title]) => check(id, "unit", title, "pass", {message: "24 of 24 questions answered right.", questions: questions(id, 0)})),
        ...TASKS[number].slice(0, 3).map(([id, title]) => check(id, "stability", `${title}: distance`, "pass", {message: "Holds within the stated range.", chart: sweep(1e6, (x) => 1.4e-16 * Math.sqrt(Math.log10(x) + 1))})),
    ]));
    return finished(results);
};

export const wrong = (has = FEW) => {
    const results = good(has);
    results.submission = {name: "ada", from: "student"};
    const [one, two] = results.steps.map((s) => s.checks);
    const break_ = (list, kind, nth, verdict, change) => {
        const found = list.filter((c) => c.kind === kind)[nth];
        Object.assign(found, {verdict, points: 0}, change);
        return found;
    };
    const sphere = break_(one, "image", 0, "fail", {message: "612 of 19200 pixels differ by more than rounding, 9 of them on silhouettes; the largest difference is 0.7013 at pixel (101, 44).",
        diagnosis: [{kind: "mutant", mutant: "M2.4", text: "The picture equals the one obtained when the highlight is left out."}, {kind: "tree", text: "depth 1: the shadow ray is blocked, the solution's is free"}, {kind: "hint", text: "What is the sign of the dot product at the terminator?"}]});
    sphere.image = {...image(SCENES[0], 0, 1), trees: {student: tree("student"), solution: tree("solution"), first_difference: "depth 1: shadow ray to light 0: the student's is blocked, the solution's is free"}};
    break_(one, "image", 1, "fail", {message: "The picture is shifted by one pixel to the left.", diagnosis: [{kind: "picture", text: "The best integer shift is (1, 0): rays start at pixel corners."}]}).image = image(SCENES[1], 1, 2);
    break_(one, "unit", 2, "fail", {message: "17 of 24 questions answered right.", questions: questions("1.3", 7)});
    break_(one, "unit", 5, "not started", {message: "unfinished 1.6 steps/1_ray_casting/ray_casting.cpp:118", questions: []});
    break_(one, "unit", 6, "crash", {message: "The program ended by signal 11 (segmentation fault) after 3 answers."});
    break_(one, "stability", 0, "fail", {message: "Fails from a distance of 1e6 on; the stated range ends at 1e8.", chart: sweep(1e5, (x) => (x > 2e6 ? null : 3e-16 * x))});
    break_(two, "image", 0, "partial", {points: 2, message: "The highlight is too wide."}).image = {...image(SCENES[13], 13), student: "pictures/student-1-1.exr", reference: "pictures/reference-1.exr", beyond_rounding: 2031, max_error: 0.61};
    break_(two, "unit", 1, "time-out", {message: "No answer within 20 s of processor time."});
    break_(two, "unit", 2, "infrastructure error", {message: "The sandbox could not be started; this costs no points."});
    results.steps = [step(1, one), step(2, two)];
    return finished(results);
};

export const HOSTILE = `</script><script>globalThis.pwned=1</script><img src=x onerror="globalThis.pwned=1"><style>*{display:none}</style>{{results}}<!--\u2028\u2029\u001b[31mred\u001b[0m\u202egnp.exe\u0000\u0007&lt;b&gt;`;

export const hostile = () => {
    const results = wrong();
    const poison = (value, key = "") => {
        if (typeof value === "string") return ["schema", "verdict", "student", "reference", "kind", "role", "status", "mode"].includes(key) ? value : HOSTILE + value;
        if (Array.isArray(value)) return value.map((item) => poison(item, key));
        if (value && typeof value === "object") return Object.fromEntries(Object.entries(value).map(([k, v]) => [k, poison(v, k)]));
        return value;
    };
    const poisoned = poison(results);
    poisoned.steps[0].tasks.forEach((t, i) => (t.id = results.steps[0].tasks[i].id));
    const [one, two] = poisoned.steps.map((s) => s.checks);
    const images = one.filter((c) => c.image);
    images[0].image.student = "pictures/student-0-3.exr";  // NaN and Inf
    images[1].image.student = "pictures/absent.exr";
    images[2].image.student = "pictures/empty.exr";
    images[3].image.student = "pictures/not-a-picture.exr";
    images[4].image.student = "pictures/absurd.exr";
    images[5].image.student = "pictures/cut.exr";
    images[6].image.reference = "pictures/absent.exr";
    images[7].image.student = "pictures/other-size.exr";
    images.slice(0, 8).forEach((c) => (c.verdict = "fail"));
    one.find((c) => c.kind === "unit").message = "A".repeat(10_000_000);
    two.find((c) => c.kind === "unit").questions[0].answer = "\u001b]0;title\u0007" + "B".repeat(10_000_000);
    two.find((c) => c.kind === "unit").verdict = "a verdict nobody knows";
    poisoned.steps.push({id: 7, title: null, checks: [null, 3, {title: ["x"], verdict: {}, image: {}, chart: {series: [{points: [[null, 1], ["x"], 4]}]}, questions: [null, "q"], diagnosis: "d"}], tasks: [null]}, "step", null);
    poisoned.machine = null;
    poisoned.__proto__x = {"<img>": "</script>"};
    return poisoned;
};

/** Pictures and a report that were handed in, the report by an enemy. */
export const handedIn = () => {
    const results = good();
    const demonstration = (number, verdict, message) => check("", "demonstration", `pictures/${number}.png`, verdict, {id: `handed_in.${number}.png`, mode: "all mine", points: 0, max: 0, message,
        image: image(SCENES[number], number, verdict === "pass" ? 0 : 1), questions: [{about: "shows spheres", query: "counted", scene: "", expected: "at least 0.2 % of the pixels", answer: "12 %", ok: verdict === "pass"}]});
    results.handed_in = {id: "handed_in", title: "Pictures and report", verdict: "partial", points: 12, max: 30, report: `# My report\n${HOSTILE}\nThe end.`, checks: [
        check("", "demonstration", "spheres demonstrated", "pass", {id: "pictures.spheres", points: 5, max: 5, message: "shown by pictures/0.png: 12 %"}),
        check("", "report", "Every command reproduces its picture", "fail", {id: "report.commands", message: "1 of 2 commands and pictures go together"}),
        demonstration(0, "pass", "reproduced, and as the solution's; shows spheres"), demonstration(2, "fail", "not reproduced: 612 of 19200 pixels differ")]};
    return results;
};

/** More pixels than a page may hold: 20 pairs of noise, each different. */
export const huge = () => {
    const results = base();
    results.steps = [step(1, Array.from({length: 20}, (_, i) => check(taskOf(i % 7), "image", `noise ${i}`, i === 19 ? "fail" : "pass",
        {image: {...image(`noise_${i}`, i), student: `pictures/noise-${2 * i}.exr`, reference: `pictures/noise-${2 * i + 1}.exr`}})))];
    return finished(results);
};

/** Half-finished work: tasks that are not started, one that waits, and a picture that a crash has prevented. */
export const half = () => {
    const results = base();
    results.submission = {name: "ada", from: "student"};
    const nothing = {pixels: 0, beyond_rounding: 0, on_silhouettes: 0, max_error: 0, rmse: 0, tolerance: 0, tolerance_absolute: 0, worst: {x: 0, y: 0, student: [0, 0, 0], reference: [0, 0, 0]}};
    const {student, ...unseen} = {...image(SCENES[0], 0), ...nothing};
    results.steps = [step(1, [check("1.3", "image", "one sphere", "crash", {message: "crashed: signal 11", image: unseen}),
        ...TASKS[1].filter(([id]) => id !== "1.1").map(([id, title]) => check(id, "unit", title, "not started", {message: `all 24 questions wait for task ${id}`})),
        check("1.1", "unit", "Camera rays", "partial", {message: "18 of 18 answered questions right; 6 wait for task 1.7", questions: questions("1.1", 6).map((q) => (q.ok ? q : {...q, answer: "unfinished 1.7"}))})])];
    return {...finished(results), score: {points: 11.06, max: 40}};
};

/** Nothing begun: the pictures are behind a fold. */
export const untouched = () => finished({...base(), steps: [step(1, SCENES.slice(0, 5).map((scene, i) => check("1.1", "image", scene, "not started", {message: "unfinished 1.1", image: image(scene, i)})))]});

/** A student of step 4 whose octree is not written; the maps are make_pictures.cpp's. */
export const costs = (text = (t) => t) => {
    const map = (structure, whose, file, more = {}) => ({structure, whose, verdict: "pass", file, tests: {mean: 9600.5, max: 19200}, nodes: {mean: 3.957, max: 7}, cells: [], ...more});
    const step4 = {id: "4_partitioning", number: 4, title: "Spatial partitioning", verdict: "pass", points: 4, max: 4, tasks: [], checks: [check("4.3", "unit", "The grid", "pass", {questions: questions("4.3", 0)})],
        cost_maps: [{scene: text("4_partitioning/sphereflake_3.pov"), width: 160, height: 120, ray: {x: 100, y: 30, origin: [0.5, 0.5, -4], direction: [0.6, 0, 0.8], distance: 10}, maps: [
            map("grid", "student", "pictures/costs-0.exr", {nodes: {mean: 0, max: 0}}),
            {structure: "octree", whose: "student", verdict: "not started", message: text("waits for task 4.6")},
            map("grid", "solution", "pictures/costs-1.exr", {cells: [[0, 0, -4, 2, 2, -2], [2, 0, -2, 4, 2, 0], [2, 0, 0, 4, 2, 2], [4, 0, 2, 6, 2, 4], [6, 0, 2, 8, 2, 4]], cells_left_out: 3}),
            map("octree", "solution", "pictures/costs-2.exr", {cells: [[0, 0, -4, 8, 8, 4]]})]}]};
    return {...base(), submission: {name: "ada", from: "student"}, score: {points: 4, max: 4}, rubric: [], steps: [step4]};
};

/** The same by an enemy: files that are none, boxes that are none, words that are markup. */
export const hostileCosts = () => {
    const results = costs((t) => HOSTILE + t), [scene] = results.steps[0].cost_maps;
    const broken = ["absent", "empty", "not-a-picture", "absurd", "student-0-0"].map((name) => ({...scene.maps[2], structure: HOSTILE + name, file: `pictures/${name}.exr`}));
    scene.maps.push(...broken, null, 7, {structure: 3, cells: "x", tests: [], file: 4, embedded: {id: "results", width: 1e9, height: 1e9}});
    scene.maps[2].cells.push(null, [1, 2], ["<b>", 0, 0, 1, 1, 1], [0, 0, 0, 1e308, 1e308, 1e308], "x");
    results.steps[0].cost_maps.push(null, {}, {maps: 3}, {scene: [], ray: {x: -5, y: 1e9, direction: ["a"]}, maps: [{}]});
    return results;
};

/** Noisy scenes: right, too dark in one place, too noisy, and with numbers that are none. */
export const noisy = (text = (t) => t) => {
    const difference = (channel, value, z, wrong) => ({channel, difference: value, reference: 0.5, margin: 0.005, standard_error: 0.002, z, limit: 4.2, wrong});
    const statistics = (more) => ({samples: 16, seeds: 8, batches: 1, alarm_rate: 0.0005, not_finite: 0, tiles: 300, tiles_wrong: 0, tile_margin: 0.01, whole_margin: 0.005,
        worst: {x: 16, y: 8, width: 8, height: 8, ...difference("G", 0.006, 1.5, false)}, whole: ["R", "G", "B"].map((c, i) => difference(c, 0.0001 * (i - 1), 0, false)),
        noise: {variance: 0.001, solution: 0.00095, ratio: 1.05, full: 1.75, none: 2.5}, z_picture: "pictures/z.exr", ...more});
    const wrong = {batches: 2, seeds: 16, tiles_wrong: 4, worst: {x: 64, y: 40, width: 8, height: 8, ...difference("G", -0.05, -9, true)}, noise: {variance: 0.001, full: 1.75, none: 2.5}};
    const scene = (name, number, mistake, verdict, message, more) => check("1.1", "statistical", text(name.replaceAll("_", " ")), verdict,
        {id: `5.picture.${name}`, message: text(message), image: {...image(name, number, mistake), scene: `5_distributed/${name}.pov`, tolerance: 0.01, tolerance_absolute: 0, worst: {x: 68, y: 44, student: [0.4, 0.4, 0.4], reference: [0.5, 0.5, 0.5]}}, ...more});
    const {worst, z_picture, ...nothing} = statistics({not_finite: 21, tiles: 0, whole: []});
    const step5 = {id: "5_distributed", number: 5, title: "Distributed ray tracing", verdict: "partial", points: 6, max: 16, tasks: [], checks: [
        scene("soft_shadow", 2, 0, "pass", "the mean of 8 seeds is right in all of 300 tiles and as a whole; the noise (mean variance) is 1.05 times the solution's at as many samples", {statistics: statistics({})}),
        scene("focus_near", 0, 1, "fail", "the mean is wrong in 8 seeds and then 16 others: 4 of 300 tiles wrong, most of all at pixels (64, 40) to (71, 47), left: G is too dark by 10 %", {statistics: statistics(wrong), diagnosis: [{kind: "picture", text: text("every value is 0.9 times the right one")}]}),
        scene("glossy_floor", 3, 0, "partial", "right, but the noise is 2.1 times the solution's", {points: 3.4, statistics: statistics({noise: {variance: 0.002, solution: 0.00095, ratio: 2.1, full: 1.75, none: 2.5}})}),
        scene("shutter", 0, 3, "fail", "21 pixels of 8 pictures are not finite (NaN or infinite)", {statistics: nothing})]};
    return {...base(), submission: {name: "ada", from: "student"}, score: {points: 6, max: 16}, rubric: [], steps: [step5]};
};

/** The same by an enemy: numbers that are none, and a map that is none. */
export const hostileNoisy = () => {
    const results = noisy((t) => HOSTILE + t), {checks} = results.steps[0];
    Object.assign(checks[0].statistics, {z_picture: "pictures/not-a-picture.exr", whole: "x", worst: {x: "<b>", y: null}, seeds: HOSTILE, noise: 3, tiles: {}});
    Object.assign(checks[1].statistics, {z_picture: "pictures/other-size.exr", worst: {x: 1e9, y: -5, width: 1e308, height: -1, limit: "x"}, whole: [null, 1, {difference: HOSTILE, reference: 0}]});
    checks[2].statistics = {embedded: {id: "results", width: 1e9, height: 1e9}, z_picture: {}};
    checks[3].statistics = [HOSTILE];
    return results;
};

export const COMPILER = "steps/1_x/file.cpp:57:41: error: 'struct Sphere' has no member named 'centre'\n   57 | int f(Sphere s) { return s.centre; }\n      |                            ^~~~~~\n";

/** The compiler stopped: the same text in every check. */
export const unbuilt = () => {
    const results = base();
    results.steps = [step(1, TASKS[1].map(([id, title]) => check(id, "unit", title, "build error", {message: COMPILER})))];
    results.steps[0].verdict = "build error";
    return finished(results);
};

/** What ./rays chart writes: a front, linked labels, a joined knob, an error of 0, ratios; and texts that are hostile. */
export const charts = (text = (t) => t) => ({
    schema: "raysteps-charts/1", machine: {cpu: "AMD EPYC 7B13", cores: 2, os: "Debian GNU/Linux 12 (bookworm)"}, versions: {raysteps: "0.1.0", povray: "3.7.0.10", compiler: "GNU 12.2.0"},
    charts: [
        {id: "1.patch", step: 1, kind: "scatter", title: text("A patch in several ways"), text: text("Few starts miss roots."), created: "2026-01-31T12:00:00Z", rounds: 11, front: true,
            x: {label: "CPU time of a ray", unit: "ns", log: true}, y: {label: text("mean error"), unit: "sizes of the shape", log: true},
            series: [{name: "certified", role: "solution", joined: false, points: [{x: 800, x_low: 790, x_high: 830, y: 0, label: "patch", settings: text("subdivision"), front: true}]},
                {name: "float", role: "float", joined: false, points: [{x: 600, x_low: 590, x_high: 640, y: 7e-7, label: "patch", settings: "subdivision in float", front: true}]},
                {name: text("Newton"), role: "naive", joined: true, points: [[1, 700, 0.069], [2, 2900, 8.6e-3], [3, 6500, 1e-9]].map(([n, x, y]) => ({x, x_low: x * 0.95, x_high: x * 1.1, y, label: "", settings: `${n} x ${n} starts`, front: false}))}]},
        {id: "1.povray", step: 1, kind: "ratios", title: text("Pictures beside POV-Ray"), text: "Pairs in turns.", created: "2026-01-31T12:10:00Z", rounds: 11, front: false, x: {label: "POV-Ray's time / ours", unit: "", log: true},
            series: [{name: "Raysteps", role: "solution", joined: false, points: [["one_sphere", 7.5], ["meshes", 0.5]].map(([label, x]) => ({x, x_low: x * 0.9, x_high: x * 1.1, label: text(label), settings: text("0.7 s and 0.1 s"), front: false}))}]},
        {id: "4.knobs", step: 4, kind: "scatter", title: text("Knobs"), text: "Two costs.", created: "2026-01-31T12:20:00Z", rounds: 3, front: true,
            x: {label: "memory", unit: "bytes", log: true}, y: {label: text("time of a ray"), unit: "ns", log: true},
            series: [{name: "octree", role: "octree", joined: true, points: [[60, 2500], [100, 900]].map(([x, y]) => ({x, x_low: x, x_high: x, y, y_low: y * 0.5, y_high: y * 2, label: "", settings: `${x} bytes`, front: true}))},
                {name: "Embree", role: "embree", joined: false, points: [{x: 70, x_low: 70, x_high: 70, y: 600, label: "", settings: "single rays", front: true}]}]},
        {id: "2.empty", step: 2, kind: "scatter", title: "Nothing", text: "", created: "x", rounds: 1, front: true, x: {label: "t", unit: "s", log: true}, y: {label: "e", unit: "", log: true}, series: [{name: "none", role: "odd", points: [{x: null, y: 1}, null]}]},
    ],
});

/** What the grader timed for the charts above. */
export const speed = (text = (t) => t) => {
    const ratio = (median) => ({ratio: {median, low: median * 0.9, high: median * 1.25}, rounds: 5, verdict: "pass"});
    return [
        {chart: "1.patch", series: "certified", label: "patch", time: "x", ...ratio(4), error: 0.02, against: text("max_trace_level 20")},
        {chart: "1.povray", series: "Raysteps", label: text("one_sphere"), time: "1/x", ...ratio(3)},
        {chart: "1.povray", series: "Raysteps", label: text("meshes"), time: "1/x", verdict: "crash", message: text("crashed: signal 11")},
        {chart: "4.knobs", series: "octree", at: 100, time: "y", ...ratio(2), message: text("3 of 20 rays are answered otherwise than by asking all")},
        {chart: "4.knobs", series: "octree", at: 77, time: "y", ...ratio(2)},
        {chart: "4.knobs", series: text("none"), at: 60, time: "y", ...ratio(2)},
        {chart: "4.knobs", series: "octree", at: 60, time: "y", verdict: "pass", ratio: {median: -1, low: null, high: "x"}},
        {chart: text("9.none"), series: "x", time: "x", ...ratio(2)}, null, 7,
    ];
};

/** An EXR file that promises 10^9 x 10^9 pixels: its header alone, valid up to there. */
const absurdExr = () => {
    const parts = [Buffer.from([0x76, 0x2f, 0x31, 0x01, 2, 0, 0, 0])];
    const attribute = (name, type, value) => {
        const size = Buffer.alloc(4);
        size.writeInt32LE(value.length);
        parts.push(Buffer.from(`${name}\0${type}\0`), size, value);
    };
    const ints = (...list) => Buffer.from(new Int32Array(list).buffer);
    const channel = (name) => Buffer.concat([Buffer.from(`${name}\0`), ints(2, 0, 1, 1)]);
    attribute("channels", "chlist", Buffer.concat([channel("B"), channel("G"), channel("R"), Buffer.from([0])]));
    attribute("compression", "compression", Buffer.from([0]));
    for (const box of ["dataWindow", "displayWindow"]) attribute(box, "box2i", ints(0, 0, 999_999_999, 999_999_999));
    attribute("lineOrder", "lineOrder", Buffer.from([0]));
    attribute("pixelAspectRatio", "float", Buffer.from(new Float32Array([1]).buffer));
    attribute("screenWindowCenter", "v2f", Buffer.from(new Float32Array([0, 0]).buffer));
    attribute("screenWindowWidth", "float", Buffer.from(new Float32Array([1]).buffer));
    return Buffer.concat([...parts, Buffer.from([0])]);
};

/** Writes the pictures and the three results below the folder; returns their paths by name. */
export const writeFixtures = async (folder, makePictures) => {
    const {readFileSync} = await import("node:fs");
    const pictures = join(folder, "pictures");
    mkdirSync(pictures, {recursive: true});
    execFileSync(makePictures, [pictures], {stdio: "inherit"});
    writeFileSync(join(pictures, "empty.exr"), "");
    writeFileSync(join(pictures, "not-a-picture.exr"), "<script>alert(1)</script>".repeat(1000));
    writeFileSync(join(pictures, "absurd.exr"), absurdExr());
    writeFileSync(join(pictures, "cut.exr"), readFileSync(join(pictures, "student-2-0.exr")).subarray(0, 3000));
    const paths = {};
    const goodMany = () => good(() => true), wrongMany = () => wrong(() => true);
    for (const [name, make] of Object.entries({good, wrong, goodMany, wrongMany, hostile, huge, half, untouched, unbuilt, handedIn, costs, hostileCosts, noisy, hostileNoisy})) {
        paths[name] = join(folder, `${name}.json`);
        writeFileSync(paths[name], JSON.stringify(make()));
    }
    // Charts stand beside the result they belong to: folders of their own.
    const withCharts = (name, result, text) => {
        mkdirSync(join(folder, name));
        writeFileSync(join(folder, name, "charts.json"), text);
        paths[name] = join(folder, name, "results.json");
        if (result) writeFileSync(paths[name], JSON.stringify(result));
    };
    withCharts("charted", finished({...base(), steps: [step(1, [check("1.3", "unit", "Sphere", "pass", {questions: questions("1.3", 0)})])]}), JSON.stringify(charts()));
    const timed = (more) => finished({...base(), steps: [{...step(1, [check("1.3", "unit", "Sphere", "pass", {questions: questions("1.3", 0)})]), speed: speed(more)}]});
    withCharts("timed", timed((t) => t), JSON.stringify(charts()));
    withCharts("hostile-timed", timed((t) => HOSTILE + t), JSON.stringify(charts((t) => HOSTILE + t)));
    withCharts("charts-only", null, JSON.stringify(charts()));
    withCharts("hostile-charts", base(), JSON.stringify(charts((t) => HOSTILE + t)));
    withCharts("broken-charts", base(), '{"schema":"raysteps-charts/1",');
    return paths;
};

if (process.argv[1] === new URL(import.meta.url).pathname) console.log(await writeFixtures(process.argv[2], process.argv[3]));
