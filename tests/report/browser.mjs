// What the tests of the page share: the pages made once, and a Chromium that reaches no network.
import assert from "node:assert/strict";
import {spawnSync} from "node:child_process";
import {existsSync, mkdtempSync, readFileSync, rmSync, statSync} from "node:fs";
import {createRequire} from "node:module";
import {tmpdir} from "node:os";
import {dirname, join} from "node:path";
import {fileURLToPath, pathToFileURL} from "node:url";
import {inflateSync} from "node:zlib";
import {writeFixtures} from "./fixtures.mjs";

const reportFolder = join(dirname(fileURLToPath(import.meta.url)), "../../report");
const requirePackage = createRequire(join(reportFolder, "package.json"));
const program = (name) => {
    const path = process.env[name];
    assert.ok(path && existsSync(path), `${name} must name a built program (ctest sets it)`);
    return path;
};
const chromiumPath = process.env.CHROMIUM ?? "/usr/bin/chromium";
assert.ok(existsSync(chromiumPath), `no browser at ${chromiumPath}: install Debian's chromium, or name one in CHROMIUM`);
assert.ok(existsSync(join(reportFolder, "node_modules/playwright-core")), "the JavaScript packages are missing: run 'npm ci' in report/");
const {chromium} = requirePackage("playwright-core");
export const axeSource = readFileSync(requirePackage.resolve("axe-core/axe.min.js"), "utf8");

export const folder = mkdtempSync(join(tmpdir(), "raysteps-report-"));
export const results = await writeFixtures(folder, program("MAKE_PICTURES"));
export const values = JSON.parse(readFileSync(join(folder, "pictures/values.json"), "utf8"));

export const report = (from, to) => spawnSync(program("RAYS_REPORT"), [from, to], {encoding: "utf8"});

const pages = new Map();
/** The page of these results; made once. */
export const pageOf = (name) => {
    if (!pages.has(name)) {
        const html = join(folder, `${name}.html`);
        const run = report(results[name], html);
        assert.equal(run.status, 0, run.stderr);
        pages.set(name, html);
    }
    return pages.get(name);
};
export const sizeOf = (name) => statSync(pageOf(name)).size;

/** The results that a page carries: base 91 (report/encoding.h), deflated. */
export const resultsIn = (html) => {
    const text = readFileSync(html, "utf8").match(/<script type="text\/plain" id="results">([^<]*)<\/script>/)[1];
    const digits = [...text].map((c) => c.charCodeAt(0) - 35 - (c > "<" ? 1 : 0));
    let bits = "";
    for (let i = 0; i < digits.length; i += 2) bits += i + 1 < digits.length ? (91 * digits[i] + digits[i + 1]).toString(2).padStart(13, "0") : digits[i].toString(2).padStart(6, "0");
    return JSON.parse(inflateSync(Buffer.from(bits.match(/.{8}/g).map((byte) => parseInt(byte, 2)))).toString());
};

// A fresh profile each time: playwright makes one and removes it.
const browser = await chromium.launch({executablePath: chromiumPath, headless: true, args: ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
    "--disable-background-networking", "--disable-component-update", "--disable-sync"]});

/** Opens a page; `watch` lists what must stay empty: console errors, exceptions, requests for anything but the page. */
export const open = async (name, {width = 1280, height = 900, ...options} = {}) => {
    const context = await browser.newContext({viewport: {width, height}, colorScheme: "light", reducedMotion: "reduce", ...options});
    const page = await context.newPage();
    const url = pathToFileURL(pageOf(name)).href;
    const watch = [];
    page.on("console", (message) => ["error", "warning"].includes(message.type()) && watch.push(`console: ${message.text()}`));
    page.on("pageerror", (error) => watch.push(`exception: ${error.message}`));
    page.on("dialog", (dialog) => watch.push(`dialog: ${dialog.message()}`));
    await context.route("**", (route) => {
        if (route.request().url().split("#")[0] === url) return route.continue();
        if (!route.request().url().startsWith("data:")) watch.push(`request: ${route.request().url()}`);
        return route.abort();
    });
    await page.goto(url);
    await page.waitForSelector("html[data-ready]", {state: "attached"});
    return {page, watch, close: () => context.close()};
};

/** Until what is seen is drawn. All who watch where boxes are hear of it before the next frame: this, and the page itself. */
const drawn = (page) => page.evaluate(async () => {
    await new Promise((told) => new IntersectionObserver(told).observe(document.body));
    do await new Promise(requestAnimationFrame);
    while (!document.documentElement.hasAttribute("data-ready"));
});

/** Brings a box into view, and the pictures there with it. */
export const look = async (box) => {
    await box.scrollIntoViewIfNeeded();
    await drawn(box.page());
};

/** The whole page, window by window, and back to its top. */
export const lookThrough = async (page) => {
    const scroll = (y) => page.evaluate((top) => scrollTo(0, top), y);
    const [height, window] = await page.evaluate(() => [document.documentElement.scrollHeight, innerHeight]);
    for (let y = 0; y < height; y += window) {
        await scroll(y);
        await drawn(page);
    }
    await scroll(0);
};

export const finish = async () => {
    await browser.close();
    rmSync(folder, {recursive: true, force: true});
};
