// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// Opens a report page in headless Chromium with the network off and compares it with its run: positions within half a quantum, no message in
// the console, no request, a panel that fits, a still, a film's picture, frames a second of replay; pictures at four times. Then what anyone
// may ask of a page: axe-core without findings in light and dark, on a desk and on a phone; targets of 44 pixels there; keys that turn the
// house; cracks that are seen while it stands (RED=1.8: at least 2,000 red pixels at that time in the corner view, under 5 % of the picture).
// usage: node check.mjs PAGE.html RUN.h5 [FOLDER for pictures] (needs chromium and hdf5-tools)
//        node check.mjs COMPARISON.html [FOLDER for pictures]: a page of two runs: one clock, one camera, both in each plot and in the tables
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, statSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { chromium } from "playwright-core";

const [page_file, ...others] = process.argv.slice(2), run_file = others[0]?.endsWith(".h5") ? others.shift() : null;
const pictures = others[0] ?? mkdtempSync(join(tmpdir(), "report-"));
const scratch = mkdtempSync(join(tmpdir(), "report-"));
const faults = [];

/** Numbers of a dataset of the run, as an array of the kind. */
function numbers(kind, dataset, ...rows) {
  const out = join(scratch, "frame");
  execFileSync("h5dump", ["-d", dataset, ...rows, "-b", "LE", "-o", out, run_file]);
  const bytes = readFileSync(out);
  return new kind(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
}

/** Positions in a frame, relative to the run's origin, as those of the page are. */
function frameOf(frame, elements) {
  const start = numbers(Float64Array, "/model/element/position0");
  return numbers(Float32Array, "/frames/displacement", "-s", `${frame},0,0`, "-c", `1,${elements},3`).map((u, i) => u + start[i]);
}

const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
});
/** The page in a window of its own. */
async function opened(options, fragment = "") {
  const context = await browser.newContext({ viewport: { width: 1280, height: 720 }, offline: true, colorScheme: process.env.SCHEME ?? "light", ...options });
  const page = await context.newPage();
  page.on("console", (m) => ["error", "warning"].includes(m.type()) && !/GPU stall|Automatic fallback/.test(m.text()) && faults.push(m.text()));
  page.on("pageerror", (e) => faults.push(e.message));
  page.on("request", (r) => /^(file|data|blob):/.test(r.url()) || faults.push(`asks for ${r.url()}`));
  await page.goto("file://" + resolve(page_file) + fragment);
  await page.locator("#status").waitFor({ state: "hidden", timeout: 120000 });
  return page;
}

const megabytes = statSync(page_file).size / 1e6;
const most = 25; // of one run or of two
if (megabytes >= most) faults.push(`the page has ${megabytes.toFixed(1)} MB, more than ${most}`);
const start = performance.now();
const page = await opened({}, "#motion=1");
console.log(`${megabytes.toFixed(1)} MB, loaded in ${((performance.now() - start) / 1000).toFixed(1)} s`);

/** A page of two runs; of one, without its run to compare with, the same but for these. */
async function checkTwo(page) {
  const two = await page.evaluate(`({ panes: report.panes.length, last: report.last })`);
  if (two.panes !== 2) return faults.push(`${two.panes} houses, not two; a page of one run needs its run.h5`);
  const letters = await page.locator(".pane .letter").allTextContents();
  if (letters.map((l) => l[0]).join() !== "A,B") faults.push(`houses have the letters ${letters.join()}, not A,B`);
  for (const part of [0.2, 0.6, 1]) {
    await page.locator("#time").fill(String(Math.round(part * two.last)));
    const now = await page.evaluate("report.time()"), ends = await page.evaluate("report.panes.map(({ times }) => times.at(-1))");
    const said = await page.locator(".pane .letter").allTextContents();
    ends.forEach((end, i) => said[i].includes("at its end") === now > end + 5e-3 || faults.push(`at ${now} s the run that ends at ${end} s is called "${said[i]}"`));
    const beyond = await page.evaluate(`report.plots.filter((p) => p.raw).flatMap((p) => p.raw.slice(1).map(([t], k) => [t.at(-1) + (t.at(-1) - t[0]) / (t.length - 1) < report.time() - 1e-9, p.series[k + 1].label, [...p.holder.querySelectorAll(".u-legend .u-series")][k + 1]?.querySelector(".u-value")?.textContent, p.inView && !p.curves])).filter(([past, , value, seen]) => seen && past && value !== "–").map(([, label]) => label)`);
    if (beyond.length > 0) faults.push(`curves that have ended show a value at ${now} s: ${beyond}`);
    const times = (await page.evaluate(`report.panes.map(({ house, times }) => times[Math.floor(house.at)] + (house.at % 1) * ((times[Math.floor(house.at) + 1] ?? 0) - times[Math.floor(house.at)]))`)).map((t, i) => (now > ends[i] ? now : t));
    if (Math.abs(times[0] - times[1]) > 1e-6) faults.push(`one clock, but the houses are at ${times} s`);
    await page.waitForTimeout(300);
    await page.screenshot({ path: join(pictures, `two-${part}.png`) });
  }
  await page.locator("canvas.view").nth(1).focus();
  await page.keyboard.press("ArrowLeft");
  const cameras = await page.evaluate("report.panes.map(({ house }) => [...house.camera.position, ...house.controls.target].map((x) => x.toFixed(3)).join())");
  if (cameras[0] !== cameras[1]) faults.push(`one camera, but they are at ${cameras.join(" and ")}`);
  const alone = await page.evaluate(`report.plots.filter((p) => report.runs.every((r) => r.facts.plots.some((q) => q.title === p.title)) && !["A", "B"].every((run) => p.series?.some((s) => s.label?.endsWith(" " + run)))).map((p) => p.title)`);
  if (alone.length > 0) faults.push(`not of both runs: ${alone}`);
  const keys = await page.evaluate(`[...document.querySelectorAll("#keys > div")].map((tile) => [...tile.querySelectorAll("dd")].map((line) => line.textContent[0]).join(""))`);
  if (keys.length < 2 || keys.some((letters) => letters !== "AB")) faults.push(`key figures are not of A and B: ${keys}`);
  const heads = await page.evaluate(`[...document.querySelector("#summary table").querySelectorAll("th[scope=col]")].map((h) => h.textContent).join("")`);
  if (heads !== "AB") faults.push(`the first table is not of A and B: ${heads}`);
  const wide = await page.evaluate(`(({ scrollWidth, clientWidth }) => scrollWidth - clientWidth)(document.querySelector("aside"))`);
  if (wide > 0) faults.push(`the side panel is ${wide} pixels too wide`);
}

/** The button that records, until there is a film: a WebM begins with the mark of EBML. */
async function checkRecorder(page) {
  await page.evaluate("report.show(0)");
  await page.evaluate(`document.getElementById("more").open = true`);
  await page.locator("#record").click();
  await page.waitForTimeout(2500);
  await page.locator("#record").click();
  for (let i = 0; i < 100 && !(await page.evaluate("Boolean(report.film)")); ++i) await page.waitForTimeout(200);
  const start = await page.evaluate("report.film ? report.film.slice(0, 4).arrayBuffer().then((b) => [...new Uint8Array(b)].join()) : null");
  if (start !== "26,69,223,163") faults.push(`what is recorded is no WebM: it begins with ${start}`);
  console.log(`recorded: ${await page.evaluate("report.film?.size ?? 0")} bytes`);
}

const end = async () => {
  await browser.close();
  for (const f of faults) console.log(`FAULT ${f}`);
  console.log(`pictures in ${pictures}`);
  process.exit(faults.length > 0 ? 1 : 0);
};
if (run_file === null) {
  await checkTwo(page);
  await checkRecorder(page);
  await end();
}

const { last, n, quantum } = await page.evaluate("({ last: report.last, n: report.run.frames.n, quantum: report.run.facts.quantum })");
for (const part of [0.2, 0.45, 0.6, 1]) {
  const frame = Math.round(part * last);
  await page.locator("#time").fill(String(frame));
  // what is drawn: the first three of twelve numbers an element
  const drawn = await page.evaluate("Array.from({ length: 3 * report.run.frames.n }, (_, i) => report.house.state[12 * Math.floor(i / 3) + (i % 3)])");
  const run = frameOf(frame, n);
  const worst = run.reduce((w, x, i) => Math.max(w, Math.abs(x - drawn[i])), 0);
  console.log(`frame ${frame}: positions within ${(1000 * worst).toFixed(4)} mm of the run, quantum ${(1000 * quantum).toFixed(4)} mm`);
  if (!(worst <= 0.5 * quantum + 2e-6)) faults.push(`frame ${frame}: a position is off by ${worst} m`); // 2 um: two roundings to float32 at 10 m
  await page.waitForTimeout(300);
  await page.screenshot({ path: join(pictures, `frame-${String(frame).padStart(4, "0")}.png`) });
}
// every element is in the order, from wherever it is looked at
const lost = await page.evaluate(`Array.from({ length: 40 }, (_, i) => {
  report.house.camera.position.set(20 * Math.cos(0.37 * i), 20 * Math.sin(0.37 * i), 3 + 0.3 * i);
  report.house.draw();
  return report.run.frames.n - new Set(report.house.order.sorted).size;
}).reduce((a, b) => Math.max(a, b))`);
if (lost > 0) faults.push(`${lost} of the elements are not drawn from some side`);
const panel = await page.evaluate(`(({ scrollWidth, clientWidth }) => [scrollWidth, clientWidth])(document.querySelector("aside"))`);
if (panel[0] > panel[1]) faults.push(`the side panel is ${panel[0]} pixels wide, with room for ${panel[1]}`);
const still = Buffer.from(await page.evaluate(`report.still(report.times[report.last], "front", 640, 400)`), "base64");
if (still.toString("latin1", 1, 4) !== "PNG" || still.readUInt32BE(16) !== 640 || still.readUInt32BE(20) !== 400) faults.push("a still is no PNG of 640 by 400 pixels");
// while it plays, faces that others hide are left out; next to nothing of the picture may be missing
const missing = await page.evaluate(`[0.1, 0.4, 0.6, 1].map((part) => {
  const { house } = report, { width, height } = house.canvas, gl = house.renderer.getContext(), pixels = () => {
    const all = new Uint8Array(4 * width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, all);
    return new Uint32Array(all.buffer);
  };
  report.show(Math.round(part * report.last));
  house.shadow && (house.shadow.visible = false);
  const picture = (moving) => (house.chooseFaces(moving), house.renderer.render(house.scene, house.camera), pixels());
  const whole = picture(false), coarse = picture(true);
  return whole.reduce((n, x, i) => n + (x !== coarse[i] ? 1 : 0), 0) / whole.length;
})`);
console.log(`pixels that differ while it plays: ${missing.map((m) => (100 * m).toFixed(3)).join(", ")} %`);
if (Math.max(...missing) > 0.002) faults.push(`while it plays, ${(100 * Math.max(...missing)).toFixed(2)} % of the picture differ; 0.2 % may`);

/** Frames a second of replay, from a time on. */
const rateFrom = (page, t) => page.evaluate(`new Promise((done) => {
  report.seek(${t});
  const before = report.house.renderer.info.render.frame, start = performance.now();
  report.play(true);
  setTimeout(() => { report.play(false); done((report.house.renderer.info.render.frame - before) / ((performance.now() - start) / 1000)); }, 3000);
})`);
const from = await page.evaluate("[report.times[0], 0.35, 0.8].map((t, i) => (i === 0 ? t : t * report.times[report.last]))");
for (const [name, size] of [["1280 x 720", null], ["1920 x 1080", { width: 1920, height: 1080 }]]) { // one after the other: two pages open would share the processor
  const p = size ? await opened({ viewport: size }, "#motion=1") : page, rates = [];
  for (const t of from) rates.push(await rateFrom(p, t));
  console.log(`replay at ${name}: ${rates.map((r, i) => `${r.toFixed(1)} frames/s from ${from[i].toFixed(1)} s`).join(", ")}`);
  if (size) await p.close();
}
await page.bringToFront();
await checkRecorder(page);
const shot = Buffer.from(await page.evaluate(`report.shot(report.times[report.last], "front", 640, 360)`), "base64");
if (shot.readUInt16BE(0) !== 0xffd8) faults.push("a picture of a film is no JPEG");
await page.close();

/** Red pixels of a picture, counted by the browser. */
const redOf = (page, png) => page.evaluate(async (png) => {
  const image = new Image();
  image.src = "data:image/png;base64," + png;
  await image.decode();
  const canvas = Object.assign(document.createElement("canvas"), { width: image.width, height: image.height }), c = canvas.getContext("2d");
  c.drawImage(image, 0, 0);
  const { data } = c.getImageData(0, 0, image.width, image.height);
  let red = 0;
  for (let i = 0; i < data.length; i += 4) if (data[i] > 140 && data[i + 1] < 100 && data[i + 2] < 100 && data[i] - data[i + 1] > 70) ++red;
  return [red, red / (data.length / 4)];
}, png);
if (process.env.RED) {
  const red_page = await opened({}, `#t=${process.env.RED}&view=corner`);
  const [red, part] = await redOf(red_page, (await red_page.locator("#stage").screenshot()).toString("base64"));
  console.log(`red pixels at ${process.env.RED} s: ${red}, ${(100 * part).toFixed(2)} % of the picture of the house`);
  if (red < 2000 || part > 0.05) faults.push(`${red} red pixels at ${process.env.RED} s, ${(100 * part).toFixed(2)} %; at least 2000 and under 5 % are asked for`);
  await red_page.close();
}

const axe = readFileSync(new URL("node_modules/axe-core/axe.min.js", import.meta.url), "utf8");
for (const [name, options] of [["desk, light", { colorScheme: "light" }], ["desk, dark", { colorScheme: "dark" }], ["large", { viewport: { width: 1920, height: 1080 } }], ["phone", { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true }]]) {
  const other = await opened(options);
  await other.evaluate(`document.getElementById("more").open = document.getElementById("provenance").open = true`);
  await other.evaluate(axe);
  const { violations } = await other.evaluate("axe.run()");
  console.log(`axe-core, ${name}: ${violations.length} findings`);
  for (const v of violations) faults.push(`${name}: ${v.id} (${v.impact}): ${v.help}: ${v.nodes.map((n) => n.html.slice(0, 120)).join(" ")}`);
  const wide = await other.evaluate("document.documentElement.scrollWidth - innerWidth");
  if (wide > 0) faults.push(`${name}: the page is ${wide} pixels wider than the window`);
  if (name === "phone") {
    const small = await other.evaluate(`[...document.querySelectorAll("button:not(.tick), select, summary, input[type=range]")].filter((e) => e.offsetHeight > 0 && e.offsetHeight < 44).map((e) => e.id || e.textContent)`);
    if (small.length > 0) faults.push(`phone: lower than 44 pixels: ${small}`);
    const over = await other.evaluate(`(() => {
      const boxes = [...document.querySelectorAll(".tick")].map((e) => e.getBoundingClientRect());
      return boxes.flatMap((a, i) => boxes.slice(i + 1).filter((b) => Math.abs(a.top - b.top) < 5 && a.left < b.right && b.left < a.right)).length;
    })()`);
    if (over > 0) faults.push(`phone: ${over} pairs of texts on the slider lie over each other`);
    await other.evaluate("scrollTo(0, 1500)");
    const top = await other.evaluate(`document.getElementById("transport").getBoundingClientRect().top`);
    if (top < -1 || top > 1) faults.push(`phone: the transport bar does not stay in view: it is at ${top}`);
    if (await other.evaluate(`document.getElementById("view").style.touchAction`) !== "pan-y") faults.push("phone: a finger on the house does not move the page");
  }
  await other.close();
}

const keys = await opened({});
await keys.locator("#view").focus();
const cameras = [];
for (const key of ["", "ArrowLeft", "ArrowUp", "+"]) {
  if (key) await keys.keyboard.press(key);
  cameras.push(await keys.evaluate("[...report.house.camera.position].map((x) => x.toFixed(3)).join()"));
}
if (new Set(cameras).size < 4) faults.push("a key on the house does not turn it or bring it nearer");
await keys.waitForTimeout(700);
const address = await keys.evaluate("location.hash");
if (!/camera=[-0-9.,]+/.test(address)) faults.push(`the camera is not in the address: ${address}`);
await keys.close();
await end();
