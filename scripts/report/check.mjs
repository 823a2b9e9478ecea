// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// Opens a report page in headless Chromium with the network off and compares it with its run: positions within half a quantum, no message in
// the console, no request, a panel that fits, a still, frames a second of replay; pictures at four times.
// usage: node check.mjs PAGE.html RUN.h5 [FOLDER for pictures] (needs chromium and hdf5-tools)
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { chromium } from "playwright-core";

const [page_file, run_file, pictures = mkdtempSync(join(tmpdir(), "report-"))] = process.argv.slice(2);
const scratch = mkdtempSync(join(tmpdir(), "report-"));
const faults = [];

/** Positions of a frame as the run has them, float32. */
function frameOf(frame, elements) {
  const out = join(scratch, "frame");
  execFileSync("h5dump", ["-d", "/frames/position", "-s", `${frame},0,0`, "-c", `1,${elements},3`, "-b", "LE", "-o", out, run_file]);
  const bytes = readFileSync(out);
  return new Float32Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
}

const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
});
const context = await browser.newContext({ viewport: { width: 1280, height: 720 }, offline: true, colorScheme: process.env.SCHEME ?? "light" });
const page = await context.newPage();
page.on("console", (m) => ["error", "warning"].includes(m.type()) && !/GPU stall|Automatic fallback/.test(m.text()) && faults.push(m.text()));
page.on("pageerror", (e) => faults.push(e.message));
page.on("request", (r) => /^(file|data|blob):/.test(r.url()) || faults.push(`asks for ${r.url()}`));
const start = performance.now();
await page.goto("file://" + resolve(page_file));
await page.locator("#status").waitFor({ state: "hidden", timeout: 60000 });
console.log(`loaded in ${((performance.now() - start) / 1000).toFixed(1)} s`);

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
const rate = await page.evaluate(`new Promise((done) => {
  report.show(0);
  const before = report.house.renderer.info.render.frame, start = performance.now();
  report.play(true);
  setTimeout(() => { report.play(false); done((report.house.renderer.info.render.frame - before) / ((performance.now() - start) / 1000)); }, 4000);
})`);
console.log(`replay: ${rate.toFixed(1)} frames/s at 1280 x 720`);
await browser.close();
for (const f of faults) console.log(`FAULT ${f}`);
console.log(`pictures in ${pictures}`);
process.exit(faults.length > 0 ? 1 : 0);
