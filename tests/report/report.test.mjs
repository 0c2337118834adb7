// The report page in a real browser: node --test, with RAYS_REPORT and MAKE_PICTURES naming the built programs.
import assert from "node:assert/strict";
import {existsSync, readFileSync, writeFileSync} from "node:fs";
import {join} from "node:path";
import {after, test} from "node:test";
import {COMPILER} from "./fixtures.mjs";
import {axeSource, finish, folder, look, lookThrough, open, pageOf, report, results, resultsIn, sizeOf, values} from "./browser.mjs";

after(finish);

const MEGA = 1e6;
/** How many different colours a canvas shows: an empty one has 1. */
const colorsOf = (canvas) => canvas.evaluate((c) => new Set(new Uint32Array(c.getContext("2d").getImageData(0, 0, c.width, c.height).data.buffer)).size);

/** At this width nothing is cut. Charts follow a new width after a frame or two, later on a busy machine. */
const fits = async (page, width, name) => {
    await page.setViewportSize({width, height: 800});
    await page.waitForFunction(() => document.documentElement.scrollWidth <= innerWidth, null, {timeout: 5000}).catch(() => {});
    const [scroll, inner] = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
    assert.equal(inner, width);
    assert.ok(scroll <= inner, `${name} at ${width}: ${scroll}`);
};

test("every page is under 3 MB, with 25 scenes, hostile texts of 10 MB, or noise that does not compress", async () => {
    for (const name of ["goodMany", "wrongMany", "hostile", "huge", "costs", "hostileCosts", "noisy", "hostileNoisy"]) assert.ok(sizeOf(name) < 3 * MEGA, `${name}: ${sizeOf(name)} bytes`);
    // Styles, scripts and libraries, and 12 kB for both pictures of a scene as simple as these. What real steps may take
    // stands in tests/grader/submissions_test.cpp.
    for (const name of ["goodMany", "wrongMany"]) assert.ok(sizeOf(name) < 200_000 + 25 * 12_000, `${name}: ${sizeOf(name)} bytes for 25 scenes`);
    const {page, close} = await open("huge");
    assert.ok(await page.locator(".facts .note", {hasText: "left out to keep the page small"}).count() > 0, "what is left out is said");
    assert.equal(await page.locator(".check[data-tone=bad] .stage.map").count(), 1, "the failed check keeps its pixels");
    await close();
});

test("nothing loads from outside, nothing is logged, nothing overflows on a phone", async () => {
    for (const name of ["good", "wrong", "hostile", "huge", "charted", "charts-only", "hostile-charts", "costs", "hostileCosts", "noisy", "hostileNoisy"]) {
        const {page, watch, close} = await open(name, {width: 768, height: 800});
        await page.locator(".rail-tools .quiet").click();
        await lookThrough(page);
        for (const width of [768, 390, 320]) await fits(page, width, name);
        await page.waitForTimeout(300);
        assert.deepEqual(watch, [], name);
        await close();
    }
});

test("the policy forbids the network and foreign scripts", async () => {
    const {page, close} = await open("good");
    const policy = await page.locator("meta[http-equiv=Content-Security-Policy]").getAttribute("content");
    assert.match(policy, /default-src 'none'/);
    assert.match(policy, /script-src 'sha256-/);
    assert.match(policy, /style-src 'sha256-/);
    assert.doesNotMatch(policy, /unsafe|https?:|\*/);
    const outcome = await page.evaluate(async () => {
        const violations = [];
        document.addEventListener("securitypolicyviolation", (event) => violations.push(event.effectiveDirective));
        const fetched = await fetch("http://127.0.0.1:9/").then(() => "fetched", () => "refused");
        const script = document.createElement("script");
        script.textContent = "globalThis.foreign = 1";
        document.body.append(script);
        const image = document.createElement("img");
        image.src = "http://127.0.0.1:9/x.png";
        document.body.append(image);
        document.body.insertAdjacentHTML("beforeend", "<p onclick='globalThis.foreign = 2' id=clickme>x</p>");
        document.getElementById("clickme").click();
        await new Promise((done) => setTimeout(done, 200));
        return {fetched, foreign: globalThis.foreign, violations};
    });
    assert.equal(outcome.fetched, "refused");
    assert.equal(outcome.foreign, undefined);
    for (const directive of ["connect-src", "img-src", "script-src-elem", "script-src-attr"]) assert.ok(outcome.violations.includes(directive), `${directive} in ${outcome.violations}`);
    await close();
});

test("the solutions' page shows the gallery, a student's does not", async () => {
    const {page, close} = await open("good");
    assert.equal(await page.locator(".heroes img").count(), 5);
    assert.ok(await page.locator(".heroes img").evaluateAll((all) => all.every((img) => img.naturalWidth > 0 && img.alt)));
    await close();
    const student = await open("wrong");
    assert.equal(await student.page.locator("img[src^='data:image/jpeg']").count(), 0);
    await student.close();
});

test("the slider moves by keyboard and by pointer and says where it is", async () => {
    const {page, close} = await open("wrong");
    const slider = page.locator(".check[data-tone=bad] img-comparison-slider").first();
    await slider.scrollIntoViewIfNeeded();
    await slider.focus();
    const value = () => slider.evaluate((s) => s.value);
    const split = () => slider.evaluate((s) => parseFloat(getComputedStyle(s.shadowRoot.getElementById("first")).getPropertyValue("--exposure")));
    assert.equal(await value(), 50);
    await page.keyboard.down("ArrowRight");
    await page.waitForTimeout(250);
    await page.keyboard.up("ArrowRight");
    const moved = await value();
    assert.ok(moved > 51, `arrow key: ${moved}`);
    assert.ok(Math.abs(100 - await split() - moved) < 1, "what is seen follows the value");
    assert.equal(await slider.getAttribute("aria-valuenow"), String(Math.round(moved)));
    await page.keyboard.press("Home");
    assert.equal(await value(), 0);
    await page.keyboard.press("End");
    assert.equal(await value(), 100);
    const box = await slider.boundingBox();
    await page.mouse.move(box.x + 0.8 * box.width, box.y + 0.5 * box.height);
    await page.mouse.down();
    await page.mouse.move(box.x + 0.25 * box.width, box.y + 0.5 * box.height, {steps: 5});
    await page.mouse.up();
    assert.ok(Math.abs(await value() - 25) < 1, `pointer: ${await value()}`);
    assert.equal(await slider.getAttribute("role"), "slider");
    await close();
});

/** Does a value round to another half float than the reference's? Nearly a tie may go either way. */
const differs = (student, reference) => student.some((v, c) => !(Math.abs(v - reference[c]) <= 1.001 * 2 ** -11 * Math.abs(v)));

test("pixels arrive whole: the reference exactly, the student's as half floats, where they differ to an eighth of their rounding", async () => {
    const {page, close} = await open("wrong");
    for (const [name, pixels] of Object.entries(values)) {
        const shown = await page.evaluate(async ({name, pixels}) => {
            const image = R.checks.map((check) => check.image).find((i) => i?.student === `pictures/${name}` && i.reference === `pictures/reference-${name.split("-")[1]}.exr`);
            if (!image) return null;
            const {student, reference} = await R.pixels.pair(image);
            const at = (picture, {x, y}) => [...picture.rgb.subarray(3 * (y * picture.width + x), 3 * (y * picture.width + x) + 3)];
            return pixels.map((pixel) => ({student: at(student, pixel), reference: at(reference, pixel)}));
        }, {name, pixels});
        if (!shown) continue;
        pixels.forEach((pixel, i) => [0, 1, 2].forEach((c) => {
            // 10 bits of mantissa, rounded to nearest; 13 of a student's pixel that differs from the reference by more than that.
            assert.ok(Math.abs(shown[i].student[c] - pixel.student[c]) <= (differs(pixel.student, shown[i].reference) ? 2 ** -14 : 2 ** -11) * Math.abs(pixel.student[c]), `${name} student ${shown[i].student[c]} ${pixel.student[c]}`);
            assert.ok(Math.abs(shown[i].reference[c] - pixel.reference[c]) <= 2 ** -11 * Math.abs(pixel.reference[c]), `${name} reference`);
        }));
    }
    await close();
});

test("the inspector shows the values under the pointer, and arrow keys move it", async () => {
    const {page, close} = await open("wrong");
    const check = page.locator(".check", {hasText: "612 of 19200"}).first();
    const stage = check.locator(".stage").first();
    await look(stage);
    const number = (text) => Number(text.replace("−", "-").replace(/ × 10(.*)/, (_, e) => "e" + [...e].map((c) => ({"⁻": "-"}[c] ?? "⁰¹²³⁴⁵⁶⁷⁸⁹".indexOf(c))).join("")));
    const row = async (whose) => (await check.locator(`tr.${whose} td`).allTextContents()).map(number);
    for (const pixel of values["student-0-1.exr"]) {
        const box = await stage.boundingBox();
        await page.mouse.move(box.x + (pixel.x + 0.5) / 160 * box.width, box.y + (pixel.y + 0.5) / 120 * box.height);
        assert.match(await check.locator(".pixel caption").textContent(), new RegExp(`^Pixel ${pixel.x}, ${pixel.y}`));
        if (pixel.x === 101) continue;  // the worst pixel: there the grader's own numbers stand, tested below
        const [student, reference, difference] = [await row("student"), await row("reference"), await row("difference")];
        [0, 1, 2].forEach((c) => {
            // Five digits of a value with 10 bits of mantissa, or 13 where the pictures differ.
            assert.ok(Math.abs(student[c] - pixel.student[c]) <= (differs(pixel.student, reference) ? 1.2e-4 : 5.5e-4) * Math.abs(pixel.student[c]), `student ${student[c]} ${pixel.student[c]}`);
            assert.ok(Math.abs(reference[c] - pixel.reference[c]) <= 5.5e-4 * Math.abs(pixel.reference[c]), `reference ${reference[c]} ${pixel.reference[c]}`);
            assert.ok(Math.abs(difference[c] - (student[c] - reference[c])) <= 2e-5, `difference ${difference[c]}`);
        });
    }
    await check.getByRole("button", {name: "Go to the worst pixel"}).click();
    assert.deepEqual(await row("student"), [0.25, 0.5, 0.125], "the grader's own numbers");
    assert.match(await check.locator(".pixel caption").textContent(), /^Pixel 101, 44 \(the worst\)/);
    const map = check.locator(".stage.map");
    await map.focus();
    for (const key of ["ArrowRight", "ArrowDown", "Shift+ArrowLeft"]) await page.keyboard.press(key);
    assert.match(await check.locator(".pixel caption").textContent(), /^Pixel 92, 45$/);
    await page.keyboard.press("w");
    assert.match(await check.locator(".pixel caption").textContent(), /^Pixel 101, 44/);
    await close();
});

test("the error map shows the mistake and does not depend on the exposure", async () => {
    const {page, close} = await open("wrong");
    const check = page.locator(".check", {hasText: "612 of 19200"}).first();
    const map = check.locator(".stage.map canvas"), student = check.locator("canvas[slot=first]");
    await look(map);
    const bytes = (canvas) => canvas.evaluate((c) => Array.from(c.getContext("2d").getImageData(0, 0, c.width, c.height).data).reduce((h, v) => (h * 31 + v) | 0, 7));
    assert.ok(await colorsOf(map) > 50);
    const [mapBefore, studentBefore] = [await bytes(map), await bytes(student)];
    const exposure = check.getByRole("slider", {name: /Exposure/});
    await exposure.focus();
    await page.keyboard.press("ArrowRight");
    assert.notEqual(await bytes(student), studentBefore, "brighter");
    assert.equal(await bytes(map), mapBefore);
    // The missing highlight of the fixture lies around (84, 34): loud there, quiet at the picture's corner.
    const lightness = (x, y) => map.evaluate((c, [px, py]) => [...c.getContext("2d").getImageData(4 * px + 2, 4 * py + 2, 1, 1).data].slice(0, 3).reduce((a, b) => a + b), [x, y]);
    assert.ok(await lightness(88, 41) > await lightness(2, 2) + 150, `${await lightness(88, 41)} ${await lightness(2, 2)}`);
    await close();
});

test("the error scale is even and rises in lightness", async () => {
    const {page, close} = await open("good");
    const lab = await page.evaluate(() => R.colors.lab);
    const positions = await page.evaluate(() => [0, NaN, 1e-9, 1e-3, 1, 1e3, 1e9].map(R.colors.position));
    assert.deepEqual(positions, [0, 0, 0, 0, 0.5, 1, 1]);
    for (const half of [lab.slice(0, 128), lab.slice(128)]) {
        const steps = half.slice(1).map((c, i) => Math.hypot(...c.map((v, k) => v - half[i][k])));
        assert.ok(Math.max(...steps) < 1.1 * Math.min(...steps), "equal steps look equal (Oklab distance)");
        half.slice(1).forEach((c, i) => assert.ok(c[0] > half[i][0], "lightness rises"));
    }
    assert.ok(lab[128][0] > lab[127][0] + 0.04, "the tolerance is a visible edge");
    await close();
});

test("charts are drawn, read by pointer and by keyboard, and also stand as a table", async () => {
    const {page, close} = await open("wrong");
    const chart = page.locator(".check[data-tone=bad] .chart").first();
    await chart.scrollIntoViewIfNeeded();
    const canvas = chart.locator("canvas");
    assert.ok(await colorsOf(canvas) > 20);
    for (const role of ["solution", "student", "naive"]) {
        const found = await canvas.evaluate((c, name) => {
            const [r, g, b] = R.color(`--series-${name}`).match(/[\d.]+/g).map(Number);
            const data = c.getContext("2d").getImageData(0, 0, c.width, c.height).data;
            let count = 0;
            for (let i = 0; i < data.length; i += 4) count += data[i] === r && data[i + 1] === g && data[i + 2] === b && data[i + 3] === 255;
            return count;
        }, role);
        assert.ok(found > 20, `${role}: ${found} pixels`);
    }
    const plot = chart.locator(".plot");
    await plot.focus();
    await page.keyboard.press("ArrowRight");
    assert.match(await chart.locator(".readout .at").textContent(), /distance \/ radius = 1$/);
    const over = await chart.locator(".u-over").boundingBox();
    await page.mouse.move(over.x + over.width - 3, over.y + over.height / 2);
    assert.match(await chart.locator(".readout").textContent(), /student *failed/);
    await chart.locator("summary").click();
    assert.equal(await chart.locator("tbody tr").count(), 13);
    assert.ok(await chart.locator("td", {hasText: "failed"}).count() >= 4);
    await close();
});

/** How many pixels of a canvas have a colour of the style sheet. */
const pixelsOf = (canvas, name) => canvas.evaluate((c, color) => {
    const [r, g, b] = R.color(color).match(/[\d.]+/g).map(Number);
    const data = c.getContext("2d").getImageData(0, 0, c.width, c.height).data;
    let count = 0;
    for (let i = 0; i < data.length; i += 4) count += data[i] === r && data[i + 1] === g && data[i + 2] === b && data[i + 3] === 255;
    return count;
}, name);

test("speed against accuracy: points with settings, the front, ratios, tables; after the grades or alone", async () => {
    for (const name of ["charted", "charts-only"]) {
        const {page, close} = await open(name, {width: 1400});
        const section = page.locator("#speed");
        assert.match(await section.locator("#speed-title").textContent(), /^Speed against accuracy$/);
        assert.equal(await page.locator("h1").count(), 1, "one main heading");
        assert.equal(await page.locator(".rail a[href='#speed']").count(), 1);
        assert.equal(await page.locator(".ring").count(), name === "charted" ? 1 : 0, "no score where nothing was graded");
        const chart = section.locator(".speed-chart").first();
        const canvas = chart.locator("canvas");
        for (const role of ["solution", "float", "naive"]) assert.ok(await pixelsOf(canvas, `--series-${role}`) > 10, role);
        const withFront = await colorsOf(canvas);
        assert.ok(withFront > 20);
        const plot = chart.locator(".plot");
        await plot.focus();
        await page.keyboard.press("ArrowRight");
        assert.match(await chart.locator(".readout").textContent(), /float: subdivision in float.*600 ns \(590 to 640\).*on the front/);
        for (let i = 0; i < 9; ++i) await page.keyboard.press("ArrowRight");
        assert.match(await chart.locator(".readout .at").textContent(), /Newton: 3 x 3 starts$/);
        // Under the pointer: the mark where the ring stands, after the keyboard has left it there.
        const ring = await chart.locator(".point-ring").boundingBox();
        await page.keyboard.press("ArrowLeft");
        await page.mouse.move(ring.x + ring.width / 2, ring.y + ring.height / 2);
        assert.match(await chart.locator(".readout .at").textContent(), /Newton: 3 x 3 starts$/);
        await chart.locator("summary").click();
        assert.equal(await chart.locator("tbody tr").count(), 5);
        assert.match(await chart.locator("tbody tr").first().textContent(), /^certified: patch800790 to 8300yessubdivision$/);
        // Two costs: the other axis has its name, its unit and its interval, drawn as a line.
        const costs = section.locator(".speed-chart", {hasText: "Two costs."});
        await costs.locator(".plot").focus();
        await page.keyboard.press("ArrowRight");
        assert.match(await costs.locator(".readout").textContent(), /octree: 60 bytes60 bytestime of a ray 2500 ns \(1250 to 5000\)on the front$/);
        for (const role of ["octree", "embree"]) assert.ok(await pixelsOf(costs.locator("canvas"), `--series-${role}`) > 10, role);
const at = await costs.locator(".point-ring").boundingBox(), sheet = await costs.locator("canvas").boundingBox();
        const [x, y] = [at.x + at.width / 2 - sheet.x, at.y + at.height / 2 - sheet.y];
        // The canvas is clear where nothing is drawn. 15 pixels from the middle a mark has ended, and so has the front's line below.
        const ink = (dx, dy) => costs.locator("canvas").evaluate((c, [left, top]) => {
            const scale = c.width / c.getBoundingClientRect().width;
            return Math.max(...[-1, 0, 1].map((i) => c.getContext("2d").getImageData(Math.round(left * scale) + i, Math.round(top * scale), 1, 1).data[3]));
        }, [x + dx, y + dy]);
        assert.ok(await ink(0, 15) > 100 && await ink(-12, 15) === 0, "the interval is drawn below the mark");
        const rows = section.locator(".ratios tbody tr");
        assert.deepEqual(await rows.locator("th").allTextContents(), ["one sphere", "meshes"]);
        assert.match(await rows.first().locator(".value").textContent(), /^7.5 \(6.75 to 8.25\)$/);
        const dot = async (row) => { const box = await rows.nth(row).locator(".dot").boundingBox(); return box.x + box.width / 2; };
        const one = await rows.first().locator(".one").boundingBox();
        assert.ok(await dot(0) > one.x && await dot(1) < one.x, "above and below 1");
        assert.match(await section.textContent(), /Nothing was measured/);
        await close();
    }
});

test("the student's points: the solution's moved by the ratio of times, with what has to be said", async () => {
    const {page, watch, close} = await open("timed", {width: 1400});
    const series = (id) => page.evaluate((wanted) => R.withStudent(R.measured.charts.find((chart) => chart.id === wanted)).chart.series.filter((s) => s.role === "student"), id);
    const near = (point, wanted) => Object.entries(wanted).forEach(([key, v]) => assert.ok(Math.abs(point[key] - v) <= 1e-9 * v, `${key}: ${point[key]}, not ${v}`));
    const [patch] = await series("1.patch"), [picture] = await series("1.povray"), [octree] = await series("4.knobs");
    near(patch.points[0], {x: 3200, x_low: 800 * 3.6, x_high: 4000, y: 0.02});
    near(picture.points[0], {x: 2.5, x_low: 7.5 / 3.75, x_high: 7.5 / 2.7});
    near(octree.points[0], {x: 100, y: 1800, y_low: 900 * 1.8, y_high: 2250});
    assert.deepEqual([patch, picture, octree].map((s) => s.points.length), [1, 1, 1], "what crashed, is nowhere in the chart or no number has no point");
    const chart = page.locator("#speed .check", {hasText: "A patch in several ways"});
    assert.ok(await pixelsOf(chart.locator("canvas"), "--series-student") > 10);
    assert.match(await chart.locator(".student-says").textContent(), /not of the run.*in turns \(5 rounds\).*applied to the solution's point.*max_trace_level 20.*No grade/);
    await chart.locator("summary").click();
    assert.match(await chart.locator("tbody").textContent(), /student: patch3200.*4 times the solution's time/);
    const ratios = page.locator("#speed .check", {hasText: "Pictures beside POV-Ray"});
    assert.match(await ratios.locator("tbody").textContent(), /one.sphere.*2\.5 \(2 to 2\.78\)student/);
    assert.match(await ratios.locator(".student-says").last().textContent(), /No point of the student's for meshes: crashed: crashed: signal 11/);
    const knobs = page.locator("#speed .check", {hasText: "Knobs"});
    const said = (await knobs.locator(".student-says").allTextContents()).join(" ");
    assert.match(said, /No point of the student's for octree, 77; none, 60: this chart has no such point\./);
    assert.match(said, /No point of the student's for octree, 60: there is no ratio of times\./);
    assert.match(await knobs.locator("tbody").textContent(), /3 of 20 rays are answered otherwise/);
    await fits(page, 390, "timed");
    for (const colorScheme of ["light", "dark"]) {
        await page.emulateMedia({colorScheme});
        await page.evaluate(axeSource);
        const found = await page.evaluate(() => axe.run("#speed").then((r) => r.violations.map((v) => `${v.id}: ${v.nodes[0].target}`)));
        assert.deepEqual(found, [], colorScheme);
    }
    assert.deepEqual(watch, []);
    await close();
    const hostile = await open("hostile-timed");
    assert.equal(await hostile.page.evaluate(() => globalThis.pwned), undefined);
    assert.ok((await hostile.page.locator(".student-says").allTextContents()).join().includes("</script><script>globalThis.pwned=1</script>"), "shown as it was written");
    assert.deepEqual(hostile.watch, []);
    await hostile.close();
});

test("charts: hostile texts stay texts, a broken file is a notice, nothing overflows, axe finds nothing", async () => {
    const hostile = await open("hostile-charts");
    const seen = await hostile.page.evaluate(() => ({pwned: globalThis.pwned, images: document.querySelectorAll("img:not(#heroes img, .heroes img)").length, text: document.querySelector("#speed").innerText}));
    assert.equal(seen.pwned, undefined);
    assert.equal(seen.images, 0);
    assert.ok(seen.text.includes("</script><script>globalThis.pwned=1</script>"));
    for (const width of [768, 320]) {
        await fits(hostile.page, width, "hostile charts");
    }
    await hostile.close();
    const broken = await open("broken-charts");
    assert.match(await broken.page.locator("#speed .notice").textContent(), /charts\.json: not JSON; run '\.\/rays chart' again/);
    await broken.close();
    for (const colorScheme of ["light", "dark"]) {
        const {page, close} = await open("charted", {colorScheme, bypassCSP: true});
        await page.evaluate(axeSource);
        const findings = await page.evaluate(async () => (await axe.run(document, {runOnly: ["wcag2a", "wcag2aa", "wcag21aa", "best-practice"]})).violations.map((v) => `${v.id}: ${v.nodes[0].html.slice(0, 200)} ${v.nodes[0].failureSummary}`));
        assert.deepEqual(findings, [], colorScheme);
        await close();
    }
});

test("cost maps: one scale for all, values under the pointer, what is missing is said", async () => {
    const {page, close} = await open("costs", {width: 1400});
    const costs = page.locator(".costs");
    assert.equal(await costs.count(), 1);
    await look(costs.locator(".cost-board"));
    assert.equal(await page.locator(".rail a[href='#step-0-costs']").count(), 1);
    assert.deepEqual(await costs.locator(".cost-row h5").allTextContents(), ["Student: tests a pixel", "Solution: tests a pixel", "Student: nodes a pixel", "Solution: nodes a pixel"]);
    const figure = (kind, whose, structure) => costs.locator(`[data-kind=${kind}][data-whose=${whose}] figure[data-structure=${structure}]`);
    // The formulas of make_pictures.cpp.
    const tests = {student: {grid: (x, y) => 1 + x + 160 * y}, solution: {grid: (x) => 1 + x, octree: (x, y) => y % 10}}, TOP = 19200;
    for (const [whose, structures] of Object.entries(tests)) for (const [structure, count] of Object.entries(structures)) {
        const [shown, expected] = await figure("tests", whose, structure).locator("canvas").evaluate((c, {values, top}) => [values.map(([x, y]) => [...c.getContext("2d").getImageData(x, y, 1, 1).data].slice(0, 3)), values.map(([, , v]) => R.colors.cost(v, top))],
            {values: [[0, 0], [5, 0], [159, 0], [30, 40], [7, 119], [159, 119]].map(([x, y]) => [x, y, count(x, y)]), top: TOP});
        assert.deepEqual(shown, expected, `${whose} ${structure}`);
    }
    assert.equal(await figure("tests", "student", "octree").locator(".missing").textContent(), "Not started: waits for task 4.6");
    assert.match(await figure("nodes", "student", "grid").locator(".missing").textContent(), /^Not counted/);
    assert.equal(await costs.locator(".cost-maps canvas").count(), 5);
    assert.match(await figure("tests", "solution", "grid").locator("figcaption").textContent(), /mean 9601, at most 19200/);

    assert.deepEqual(await costs.locator(".tick").allTextContents(), ["1", "10", "100", "1000", "19200"]);
    assert.match(await costs.locator(".legend").textContent(), /Tests a pixel.*nodes a pixel.*one logarithmic scale/);
    const tick = await costs.locator(".tick", {hasText: "100"}).first().evaluate((t) => parseFloat(t.style.left));
    assert.ok(Math.abs(tick - 100 * 2 / Math.log10(TOP)) < 0.01, `the tick of 100 stands at ${tick} %`);

    const here = (...which) => figure(...which).locator(".here-value").textContent();
    assert.equal(await here("tests", "solution", "grid"), "101", "at first the worst pixel");
    const stage = figure("tests", "solution", "grid").locator(".stage");
    await stage.scrollIntoViewIfNeeded();
    const box = await stage.boundingBox();
    await page.mouse.move(box.x + 30.5 / 160 * box.width, box.y + 43.5 / 120 * box.height);
    assert.equal(await here("tests", "solution", "grid"), "31");
    assert.equal(await here("tests", "student", "grid"), "6911", "the same pixel in all maps");
    assert.equal(await here("tests", "solution", "octree"), "3");
    assert.equal(await here("nodes", "solution", "octree"), "4");
    const readout = costs.locator(".cost-readout");
    assert.equal(await readout.textContent(), "Pixel 30, 43 Student's grid 6911 tests; Solution's grid 31 tests, 3 nodes; Solution's octree 3 tests, 4 nodes");
    await costs.locator(".cost-board").focus();
    for (const key of ["Shift+ArrowDown", "ArrowLeft"]) await page.keyboard.press(key);
    assert.match(await readout.textContent(), /^Pixel 29, 53 /);
    await page.keyboard.press("w");
    assert.match(await readout.textContent(), /^Pixel 100, 30 \(the worst\)/);
    await page.emulateMedia({media: "print"});
    const [panel, group] = [await costs.boundingBox(), await page.locator("#step-0-costs").boundingBox()];
    assert.ok(panel.width > 0.95 * group.width, "on paper the maps have the whole width");
    await close();
});

test("cost maps: the cells of a ray, seen where the ray moves most", async () => {
    const {page, close} = await open("costs", {width: 1400});
    const drawing = page.locator(".cells[data-structure=grid]");
    assert.equal(await page.locator(".cells").count(), 2);
    assert.equal(await drawing.locator("rect").count(), 5);
    assert.match(await drawing.locator("figcaption").textContent(), /^Grid, solution's 8 cells; x to the right, z up; .*the first 5 are drawn$/);
    assert.equal(await drawing.locator("rect title").first().textContent(), "cell 1 of 8: 0, 0, −4 to 2, 2, −2");
    // The fixture's ray begins in the first cell and passes through each in turn: the line must cross every rectangle drawn.
    const crossed = await drawing.evaluate((figure) => {
        const n = (e, name) => Number(e.getAttribute(name)), line = figure.querySelector("line");
        const at = (t) => [n(line, "x1") + t * (n(line, "x2") - n(line, "x1")), n(line, "y1") + t * (n(line, "y2") - n(line, "y1"))];
        return [...figure.querySelectorAll("rect")].map((r) => Array.from({length: 1001}, (_, i) => at(i / 1000)).findIndex(([x, y]) => x >= n(r, "x") && y >= n(r, "y") && x <= n(r, "x") + n(r, "width") && y <= n(r, "y") + n(r, "height")));
    });
    assert.ok(crossed[0] === 0 && crossed.every((t, i) => i === 0 || t > crossed[i - 1]), `entered at ${crossed}`);
    await close();
});

test("cost maps: an enemy's words stay words, broken files leave out their own map", async () => {
    const {page, close} = await open("hostileCosts");
    const seen = await page.evaluate(() => ({pwned: globalThis.pwned, images: document.querySelectorAll("img, iframe").length, text: document.querySelector(".costs").innerText}));
    assert.equal(seen.pwned, undefined);
    assert.equal(seen.images, 0);
    assert.ok(seen.text.includes("</script><script>globalThis.pwned=1</script>"), "shown as it was written");
    for (const note of ["there is no picture", "the picture's file is empty", "lacks one of the channels tests, nodes", "not a picture that can be read"]) assert.ok(seen.text.includes(note), note);
    const canvas = page.locator(".costs [data-kind=tests][data-whose=solution] figure[data-structure=grid] canvas");
    await look(canvas);
    assert.ok(await colorsOf(canvas) > 50, "the maps that are whole are drawn");
    await close();
});

test("the scale of costs is even, rises in lightness, and shows 0 apart", async () => {
    const {page, close} = await open("good");
    const {lab, colors} = await page.evaluate(() => ({lab: R.colors.costLab, colors: [0, 1, 10, 100, 1e9].map((v) => R.colors.cost(v, 100))}));
    const steps = lab.slice(1).map((c, i) => Math.hypot(...c.map((v, k) => v - lab[i][k])));
    assert.ok(Math.max(...steps) < 1.1 * Math.min(...steps), "equal steps look equal (Oklab distance)");
    lab.slice(1).forEach((c, i) => assert.ok(c[0] > lab[i][0], "lightness rises"));
    const sum = (c) => c.reduce((a, b) => a + b);
    assert.ok(sum(colors[0]) < sum(colors[1]) - 30 && sum(colors[1]) < sum(colors[2]) && sum(colors[2]) < sum(colors[3]), `${colors}`);
    assert.deepEqual(colors[3], colors[4], "nothing lies beyond the top");
    await close();
});

test("hostile texts stay texts", async () => {
    const {page, watch, close} = await open("hostile");
    await lookThrough(page);
    await page.waitForTimeout(300);
    const seen = await page.evaluate(() => ({pwned: globalThis.pwned, images: document.querySelectorAll("img, iframe, object, embed").length, scripts: document.querySelectorAll("script:not([type])").length,
        styles: document.querySelectorAll("style").length, text: document.body.innerText, html: document.documentElement.outerHTML.length, handlers: document.querySelectorAll("[onerror],[onclick],[onload]").length}));
    assert.equal(seen.pwned, undefined);
    assert.equal(seen.images, 0);
    assert.equal(seen.handlers, 0);
    assert.equal(seen.scripts, 2);
    assert.equal(seen.styles, 3);
    assert.ok(seen.text.includes("</script><script>globalThis.pwned=1</script>"), "shown as it was written");
    assert.ok(seen.text.includes("␛[31mred"), "escape sequences are visible");
    assert.doesNotMatch(seen.text, /[\u0000-\u0008\u000b-\u001f\u007f-\u009f\u202a-\u202e\u2066-\u2069]/);
    assert.match(seen.text, /more bytes cut\)/);
    assert.deepEqual(watch, []);
    const file = readFileSync(pageOf("hostile"), "utf8");
    assert.doesNotMatch(file, /<script>globalThis/);
    assert.equal(file.match(/\u2028|\u2029/g), null);
    await close();
});

test("pictures that are missing, broken, absurd or of another size are named; NaN and Inf are shown", async () => {
    const {page, close} = await open("hostile");
    const notes = await page.locator(".facts .note").allTextContents();
    for (const expected of [/student's picture: there is no picture/, /file is empty/, /not a picture that can be read/, /damaged or cut off|not a picture/, /POV-Ray's picture: there is no picture/, /has 80 x 60 pixels, POV-Ray's 160 x 120/])
        assert.ok(notes.some((note) => expected.test(note)), `${expected} in ${JSON.stringify(notes)}`);
    assert.ok(notes.some((note) => /claims to have|not a picture/.test(note)), "absurd header");
    const check = page.locator("#check-0-0");
    const stage = check.locator(".stage.map");
    await look(stage);
    const box = await stage.boundingBox();
    const under = async (x, y) => {
        await page.mouse.move(box.x + (x + 0.5) / 160 * box.width, box.y + (y + 0.5) / 120 * box.height);
        return (await check.locator("tr.student td").allTextContents()).join(" ");
    };
    assert.equal(await under(80, 60), "NaN NaN NaN");
    assert.equal(await check.locator(".pixel-verdict").textContent(), "Not a finite number");
    assert.match(await under(10, 20), /^\+Inf /);
    await close();
});

test("light and dark follow the system and the switch", async () => {
    const background = (page) => page.evaluate(() => getComputedStyle(document.body).backgroundColor.match(/\d+/g).slice(0, 3).reduce((a, b) => a + Number(b), 0));
    const light = await open("good"), dark = await open("good", {colorScheme: "dark"});
    assert.ok(await background(light.page) > 650);
    assert.ok(await background(dark.page) < 120);
    await light.page.locator("input[name=theme][value=dark]").check({force: true});
    assert.ok(await background(light.page) < 120);
    await light.page.reload();
    await light.page.waitForSelector("html[data-ready]", {state: "attached"});
    assert.ok(await background(light.page) < 120, "remembered");
    await dark.page.locator("input[name=theme][value=light]").check({force: true});
    assert.ok(await background(dark.page) > 650);
    await light.close();
    await dark.close();
});

test("accessibility: no finding of axe in light and dark", async () => {
    for (const [name, colorScheme] of [["wrong", "light"], ["wrong", "dark"], ["half", "light"], ["unbuilt", "dark"], ["costs", "light"], ["costs", "dark"]]) {
        const {page, close} = await open(name, {colorScheme, bypassCSP: true});
        await lookThrough(page);
        await page.evaluate(axeSource);
        const findings = await page.evaluate(async () => (await axe.run(document, {runOnly: ["wcag2a", "wcag2aa", "wcag21aa", "best-practice"]})).violations.map((v) => `${v.id}: ${v.nodes.length} × ${v.nodes[0].html.slice(0, 200)} ${v.nodes[0].failureSummary}`));
        assert.deepEqual(findings, [], `${name} ${colorScheme}`);
        await close();
    }
});

test("the keyboard reaches everything and the focus is seen", async () => {
    const {page, close} = await open("wrong");
    await page.keyboard.press("Tab");
    assert.equal(await page.evaluate(() => document.activeElement.className), "skip");
    assert.ok((await page.locator(".skip").boundingBox()).y >= 0, "the skip link comes into view");
    const passed = page.locator(".texts .check[data-tone=good] .expand").first();
    await passed.focus();
    await page.keyboard.press("Enter");
    assert.equal(await passed.getAttribute("aria-expanded"), "true");
    assert.ok(await page.locator(".check.open[data-tone=good] .command").first().isVisible());
    assert.notEqual(await passed.evaluate((b) => getComputedStyle(b).outlineStyle), "none");
    await page.locator(".tile").first().focus();
    await page.keyboard.press("Enter");
    assert.ok(await page.locator("dialog.show[open]").isVisible());
    await page.keyboard.press("n");
    assert.match(await page.locator("dialog .count").textContent(), /^2 \/ 11$/);
    await page.keyboard.press("Escape");
    await page.locator("dialog.show").waitFor({state: "detached"});  // the browser says later that it has closed
    await close();
});

test("the filter leaves only what failed; when nothing failed it says so", async () => {
    const wrong = await open("wrong");
    const visible = (page, selector) => page.locator(selector).evaluateAll((list) => list.filter((e) => e.checkVisibility()).length);
    assert.ok(await visible(wrong.page, ".check[data-tone=good]") > 20);
    await wrong.page.locator("#only-failed").check({force: true});
    assert.equal(await visible(wrong.page, ".check[data-tone=good]"), 0);
    assert.equal(await visible(wrong.page, ".check:not([data-tone=good])"), 9);
    await wrong.close();
    const good = await open("good");
    await good.page.locator("#only-failed").check({force: true});
    assert.equal(await visible(good.page, ".check"), 0);
    assert.ok(await good.page.locator(".nothing-failed").isVisible());
    await good.close();
});

test("diagnosis, trees, questions and commands are there", async () => {
    const {page, close} = await open("wrong");
    const text = await page.locator("main").innerText();
    for (const part of ["highlight is left out", "M2.4", "terminator", "7 questions answered wrong", "hit 6.000000000000 0 0 1", "Crashed", "Out of time", "Not started", "Not judged", "32", "of 80"])
        assert.ok(text.includes(part), part);
    assert.equal(await page.locator(".tree .first-difference").count(), 2);
    assert.match(await page.locator(".tree .first-difference").first().textContent(), /First difference.*blocked/);
    const command = page.locator(".check[data-tone=bad] .command").first();
    await command.locator("button").click();
    await command.locator("button", {hasText: /Copied|Selected/}).waitFor();  // the clipboard answers when it likes
    assert.equal(await command.locator("code").textContent(), "./rays grade 1 --seed 123");
    const machine = await page.locator("#machine").textContent();
    for (const part of ["EPYC", "3.7.0.10", "GCC 12.2.0", "double", "limits", "memory mb 2048", "123", "Dmitry Snisarenko", "Leon Sorokin"]) assert.ok(machine.includes(part), part);
    await close();
});

test("a table of pixels overflows on no phone, whatever its values", async () => {
    // Tiny values are long: 1.234 x 10^-4 in every column.
    const {page, close} = await open("wrong", {width: 390, height: 800});
    const table = page.locator("#check-0-0 .values");
    await look(table);
    await table.evaluate((box) => box.querySelectorAll("td").forEach((cell) => (cell.textContent = "−1.234 × 10⁻⁴")));
    const [wide, shown] = await table.evaluate((box) => [box.scrollWidth, box.clientWidth]);
    assert.ok(wide <= shown, `pixel table: ${wide} of ${shown}`);
    await close();
});

test("half-finished work: what is not started is folded, what waits is not wrong, a crash shows no zeros", async () => {
    const {page, watch, close} = await open("half");
    const visible = (selector) => page.locator(selector).evaluateAll((list) => list.filter((e) => e.checkVisibility()).length);
    assert.equal(await page.locator(".ring b").textContent(), "11.1", "one decimal fits into the ring");
    assert.equal(await visible(".check"), 2);
    const fold = page.locator("details.waiting");
    assert.equal(await fold.locator("> summary").textContent(), "6 checks not started");
    await page.locator(".rail-tasks a", {hasText: "1.5"}).click();
    await page.waitForFunction(() => document.querySelector("details.waiting").open);
    assert.equal(await visible(".check"), 8, "a link opens the fold around its target");
    await page.locator(".rail-tools .quiet").click();
    await page.locator(".rail-tools .quiet").click();
    assert.equal(await visible(".check"), 2, "fold again");
    const crashed = page.locator("#check-0-0");
    assert.doesNotMatch(await crashed.innerText(), /largest error|the worst|Pixel 0/);
    assert.equal(await crashed.locator(".inspector").count(), 0);
    assert.equal(await crashed.locator(".marker.worst").evaluateAll((list) => list.filter((e) => e.checkVisibility()).length), 0);
    const shown = crashed.locator("canvas").first();
    await look(shown);
    assert.ok(await colorsOf(shown) > 50, "POV-Ray's picture is still shown");
    assert.match(await page.locator(".check[data-tone=mixed]").innerText(), /6 questions without an answer/);
    assert.deepEqual(watch, []);
    await close();
});

test("a step that does not compile: the compiler's words once, its columns aligned, no hints", async () => {
    const {page, watch, close} = await open("unbuilt");
    assert.equal(await page.locator("h1").textContent(), "Step 1 does not compile");
    const message = page.locator(".compiler pre");
    assert.equal(await message.innerText(), COMPILER);
    assert.equal((await page.locator("main").innerText()).split("centre'").length, 2, "told once");
    const wide = (text) => message.evaluate((pre, t) => {
        const ruler = pre.appendChild(document.createElement("span"));
        ruler.textContent = t;
        const width = ruler.getBoundingClientRect().width;
        ruler.remove();
        return width;
    }, text);
    assert.ok(Math.abs(await wide("iiiiiiiiii") - await wide("MMMMMMMMMM")) < 0.1, "monospace");
    assert.equal(await page.locator(".check, .hint").count(), 0);
    await page.locator(".rail-tasks a").first().click();
    assert.equal(new URL(page.url()).hash, "#step-0");
    assert.deepEqual(watch, []);
    await close();
});

test("what was handed in: verdicts and reasons, pictures against the solution's, the prose as text and nothing else", async () => {
    const {page, watch, close} = await open("handedIn");
    const section = page.locator(".step", {has: page.getByRole("heading", {name: "Pictures and report"})});
    assert.equal(await section.locator(".kicker").first().textContent(), "Handed in");
    assert.equal(await section.locator(".check").count(), 4);
    const picture = section.locator(".check", {hasText: "not reproduced: 612 of 19200 pixels differ"});
    assert.equal(await picture.getAttribute("data-tone"), "bad");
    assert.ok(await picture.locator("canvas").count() > 0, "the picture is shown");
    assert.match(await picture.textContent(), /Solution/);
    assert.doesNotMatch(await picture.textContent(), /POV-Ray/);
    const prose = section.locator(".group", {has: page.getByRole("heading", {name: "The report as it was handed in"})}).locator(".notice");
    assert.match(await prose.textContent(), /# My report[^]*<script>globalThis\.pwned=1<\/script>[^]*The end\./);
    assert.equal(await prose.locator("*").count(), 0, "no markup of the student's");
    assert.equal(await page.evaluate(() => globalThis.pwned), undefined);
    assert.deepEqual(watch, []);
    await close();
});

test("a picture is unpacked when it comes near or its fold is opened, and not before", async () => {
    const {page, close} = await open("good");
    const below = page.locator(".check canvas[slot=first]").last();
    assert.ok(await colorsOf(page.locator(".tile canvas").first()) > 50, "what is seen at first is drawn");
    await page.waitForTimeout(500);
    assert.equal(await colorsOf(below), 1, "far below");
    await look(below);
    assert.ok(await colorsOf(below) > 50, "scrolled to");
    await close();
    const untouched = await open("untouched");
    const summary = untouched.page.locator("details.waiting > summary"), folded = untouched.page.locator("details.waiting canvas.frame").first();
    await look(summary);
    await untouched.page.waitForTimeout(500);
    assert.equal(await colorsOf(folded), 1, "in a fold");
    await summary.click();
    await look(folded);
    assert.ok(await colorsOf(folded) > 50, "unfolded");
    await untouched.close();
});

test("who prints has every picture at once, without having seen them", async () => {
    for (const name of ["good", "untouched", "costs"]) {
        const {page, close} = await open(name, {height: 300});
        const [before, after] = await page.evaluate(() => {
            const blank = () => [...document.querySelectorAll("canvas.frame")].filter((c) => c.getContext("2d").getImageData(0, 0, 1, 1).data[3] === 0).length;
            const first = blank();
            dispatchEvent(new Event("beforeprint"));
            return [first, blank()];
        });
        assert.ok(before > 0, `${name}: none was left`);
        assert.equal(after, 0, name);
        await close();
    }
});

test("on paper both pictures stand beside each other, light, without controls", async () => {
    const {page, close} = await open("wrong", {colorScheme: "dark"});
    await page.emulateMedia({media: "print"});
    await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
    const pair = page.locator("#check-0-0 .printed figure");
    assert.equal(await pair.count(), 3);
    for (let i = 0; i < 3; ++i) {
        assert.ok(await pair.nth(i).isVisible());
        assert.ok(await colorsOf(pair.nth(i).locator("canvas").first()) > 50);
    }
    for (const selector of [".compare", ".rail", ".controls", ".copy", ".expand"]) assert.equal(await page.locator(selector).first().isVisible(), false, selector);
    const background = await page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    assert.equal(background, "rgb(255, 255, 255)");
    const pdf = await page.pdf({format: "A4", printBackground: true});
    assert.equal(pdf.subarray(0, 5).toString(), "%PDF-");
    await close();
});

test("bad input is an error that says what to do, and leaves no page", () => {
    const html = join(folder, "never.html");
    const attempt = (name, text) => {
        const file = join(folder, name);
        if (text !== null) writeFileSync(file, text);
        const run = report(file, html);
        assert.equal(run.status, 2, name);
        assert.equal(existsSync(html) || existsSync(`${html}.partial`), false, name);
        return run.stderr;
    };
    assert.match(attempt("absent.json", null), /cannot be read.*rays grade/);
    assert.match(attempt("empty.json", ""), /not JSON/);
    assert.match(attempt("cut.json", readFileSync(results.good).subarray(0, 5000)), /not JSON/);
    assert.match(attempt("other.json", '{"schema":"something/9"}'), /schema is 'something\/9'/);
    assert.match(attempt("deep.json", "[".repeat(200_000)), /not JSON/);
    const unwritable = report(results.good, "/dev/null/page.html");
    assert.equal(unwritable.status, 2);
    assert.match(unwritable.stderr, /cannot be written/);
});

test("results with odd bytes and nothing in them still make a page", async () => {
    const file = join(folder, "odd.json"), html = join(folder, "odd.html");
    writeFileSync(file, Buffer.concat([Buffer.from('{"schema":"raysteps-results/1","submission":{"name":"a'), Buffer.from([0xff, 0xc0, 0xed, 0xa0, 0x80]), Buffer.from('b"},"extra":' + "[".repeat(2000) + "]".repeat(2000) + "}")]));
    const run = report(file, html);
    assert.equal(run.status, 0, run.stderr);
    assert.ok(resultsIn(html).submission.name.startsWith("a\ufffd\ufffd"));
});

test("a noisy picture shows its mean beside the reference, and a diverging map of z", async () => {
    const {page, close} = await open("noisy", {width: 1400});
    const check = (name) => page.locator(".check", {has: page.getByRole("heading", {name, exact: true})});
    const wrong = check("Focus near");
    assert.match(await wrong.locator(".tag.left").textContent(), /^Student, mean of 16$/);
    assert.match(await wrong.locator(".facts").textContent(), /tiles wrong4 of 300/);
    assert.match(await wrong.locator(".facts").textContent(), /whole picture, R G B−0.02 %, 0 %, \+0.02 %/);
    assert.match(await wrong.locator(".legend").textContent(), /standard errors the mean of 16 pictures goes beyond 1 % of the level.*wrong beyond 4.2/);
    assert.deepEqual(await wrong.locator(".tick").allTextContents(), ["−5 too dark", "0", "5 too bright"]);
    const canvas = wrong.locator("canvas.z-map");
    await look(canvas);
    const color = (x, y) => canvas.evaluate((c, [px, py]) => [...c.getContext("2d").getImageData(px, py, 1, 1).data].slice(0, 3), [x, y]);
    const [middle, dark] = [await color(8, 0), await color(70, 45)];
    assert.ok(Math.max(...middle) - Math.min(...middle) < 12 && middle[0] > 200, `${middle}: grey, bright on a bright page`);
    assert.ok(dark[2] > dark[0] + 60, `${dark}: what is too dark is blue`);
    const bright = await page.evaluate(() => R.colors.diverging(1, false));
    assert.ok(bright[0] > bright[2] + 60, `${bright}: what is too bright is orange`);
    const box = await wrong.locator(".worst-tile").boundingBox(), map = await canvas.boundingBox();
    assert.ok(Math.abs((box.x - map.x) / map.width - 64 / 160) < 0.01 && Math.abs(box.width / map.width - 8 / 160) < 0.01, "the worst tile is framed");
    await wrong.getByRole("button", {name: "Go to the worst tile"}).click();
    assert.match(await wrong.locator(".pixel-verdict").textContent(), /Tile darker than the margin allows by 9 standard errors/);
    await page.locator("input[name=theme][value=dark]").check();
    const night = await color(8, 0);
    assert.ok(night[0] < 80, `${night}: grey, dark on a dark page`);
    assert.match(await check("Glossy floor").locator(".facts").textContent(), /noise over the solution's2.1 \(full points up to 1.75, none from 2.5\)/);
    assert.equal(await check("Shutter").locator("canvas.z-map").count(), 0, "without numbers there is no z: the map of errors shows where they are missing");
    assert.equal(await check("Shutter").locator(".errors canvas.frame").count(), 1);
    await page.getByRole("button", {name: "Show them large"}).click();
    assert.ok(await page.locator("dialog .z-map").count() <= 1);
    for (const width of [390, 1400]) {
        await page.keyboard.press("Escape");
        await fits(page, width, "noisy");
    }
    await close();
});
